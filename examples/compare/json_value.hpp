// A value of a JSON file, its place in the file, and the checks that a scene needs.
#pragma once

#include "json_tree.hpp"
#include "problem.hpp"

#include <initializer_list>
#include <string>

namespace compare {

// Which numbers are allowed.
struct number_rule {
    bool (*is_good)(const exact&);
    const char* otherwise; // what a message calls any other number
};

// Where a value is not what a function expects, it throws input_error, which names the file and the JSON pointer.
class json_value {
  public:
    // The whole of a file's tree. file and root must outlive the value. as_double: numbers are rounded to the nearest
    // double.
    json_value(const std::string& file, const json_node& root, bool as_double)
        : file_(&file), node_(&root), as_double_(as_double) {}

    [[noreturn]] void fail(const std::string& what) const;

    // For an object: checks that every key is one of these and that the required ones are present.
    void expect_keys(std::initializer_list<const char*> required, std::initializer_list<const char*> optional) const;
    [[nodiscard]] bool has(const std::string& key) const;
    [[nodiscard]] json_value at(const std::string& key) const; // the key must be present

    // For an array.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] json_value at(std::size_t index) const;

    [[nodiscard]] const std::string& text() const;

    // Whether it is a string that says infinity (see is_infinity).
    [[nodiscard]] bool is_infinite() const;

    // A number, or a string for parse_exact. It must obey the rule both as written and as rounded, and not overflow.
    [[nodiscard]] exact number(const number_rule& rule) const;
    [[nodiscard]] exact number() const;

    template <int N>
    [[nodiscard]] graze::vec<N, exact> vector() const {
        expect_components(N);
        return graze::make_vec<N>([&](int i) { return at(static_cast<std::size_t>(i)).number(); });
    }

    // Must not have length 0, even after rounding. otherwise: what a message calls such a vector.
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
