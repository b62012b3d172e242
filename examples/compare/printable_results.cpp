#include "printable_results.hpp"

#include "input_error.hpp"
#include "json_fields.hpp"

#include <string_view>
#include <utility>

namespace compare {

namespace {

constexpr std::size_t longest_string = 4096;

// Cleans every text field, whatever its name.
struct text_cleaner {
    void clean(std::string& text) { text = printable(text, longest_string); }
    template <class T>
    void clean(std::vector<T>& all) {
        for (T& one : all) {
            clean(one);
        }
    }
    template <class T>
    void clean(std::optional<T>& x) {
        if (x) {
            clean(*x);
        }
    }
    void clean(std::map<std::string, std::size_t>& counts) {
        std::map<std::string, std::size_t> cleaned;
        for (const auto& [name, count] : counts) {
            cleaned[printable(name, longest_string)] += count;
        }
        counts = std::move(cleaned);
    }
    template <class T>
    void clean(T& x) {
        if constexpr (requires { fields(*this, x); }) {
            fields(*this, x);
        }
    }
    template <class T>
    void operator()(const char* name, T& x) {
        if (std::string_view(name) != "scene") { // lines of ASCII already, see scene_of_pair
            clean(x);
        }
    }
    template <class T>
    void operator()(const char*, where_known<T> x) {
        clean(x.value);
    }
    template <class T>
    void operator()(const char*, since_2<T> x) {
        clean(x.value);
    }
};

} // namespace

results with_printable_texts(results found) {
    text_cleaner cleaner;
    fields(cleaner, found);
    return found;
}

} // namespace compare
