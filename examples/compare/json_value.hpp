// A value of a JSON file, its place in the file, and the checks that a scene needs.
#pragma once

#include "json_tree.hpp"
#include "problem.hpp"

#include <initializer_list>
#include <string>

namespace compare {

// Which numbers will do.
struct number_rule {
    bool (*is_good)(const exact&);
    const char* otherwise; // what it is then called
};

// Every function throws input_error that names the file and the JSON pointer if the value is not what is asked for.
class json_value {
  public:
    // The whole of a file's tree. file and root must outlive the value. as_double: numbers are rounded to the nearest
    // double.
    json_value(const std::string& file, const json_node& root, bool as_double)
        : file_(&file), node_(&root), as_double_(as_double) {}

    [[noreturn]] void fail(const std::string& what) const;

    // Of an object: every key is one of these, and the required ones are there.
    void expect_keys(std::initializer_list<const char*> required, std::initializer_list<const char*> optional) const;
    [[nodiscard]] bool has(const std::string& key) const;
    [[nodiscard]] json_value at(const std::string& key) const; // a key that it has

    // Of an array.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] json_value at(std::size_t index) const;

    [[nodiscard]] const std::string& text() const;

    // Whether it is a string that says infinity.
    [[nodiscard]] bool is_infinite() const;

    // A number, or a string that parse_exact reads. It is good both as written and as rounded, and does not overflow.
    [[nodiscard]] exact number(const number_rule& rule) const;
    [[nodiscard]] exact number() const;

    template <int N>
    [[nodiscard]] graze::vec<N, exact> vector() const {
        expect_components(N);
        return graze::make_vec<N>([&](int i) { return at(static_cast<std::size_t>(i)).number(); });
    }

    // Not of length 0, once rounded.
    template <int N>
    [[nodiscard]] graze::vec<N, exact> vector_not_zero(const char* otherwise) const {
        const auto result = vector<N>();
        if (graze::sign(graze::squared_norm(result)) == 0) {
            fail(otherwise);
        }
        return result;
    }

  private:
    void expect(json_type type) const;
    void expect_components(std::size_t dimension) const;
    [[nodiscard]] json_value part(const json_node& node, std::string pointer) const;
    [[nodiscard]] exact number_as_written() const;

    const std::string* file_;
    const json_node* node_;
    std::string pointer_;
    bool as_double_;
};

} // namespace compare
