// What pictures and tables take from the results, collected once.
#pragma once

#include "../results.hpp"
#include "picture.hpp"

#include <optional>
#include <string>
#include <vector>

namespace compare::report {

// A type in one variant and root form, over one or more groups.
struct candidate {
    std::string type, variant, root;
    const type_information* information = nullptr; // null if the results do not describe the type
    std::optional<double> nanoseconds; // the mean over the groups, weighted by their pairs; absent if untimed
    std::size_t wrong = 0, undecided = 0;
    std::size_t times = 0;  // values of τ and of crossings that were measured
    double imperfect = 0;   // share of the pairs whose decision or time is not right to the last bit of a double
    double fewest_bits = 0; // correct bits of the worst of these times; infinite without any error, or without times
    bool on_front = false;  // among those without a wrong or open decision, if there are any, nothing is both cheaper
                            // and better

    [[nodiscard]] bool decides_right() const { return wrong == 0 && undecided == 0; }
    [[nodiscard]] bool is_exact() const { return information != nullptr && information->is_exact; }
    [[nodiscard]] std::string name() const;
};

// "double · lagrange"; with the printed root "double · lagrange/printed", as in the option --variants; without a
// variant, only the type.
[[nodiscard]] std::string name_of(const std::string& type, const std::string& variant, const std::string& root);

// The name without its namespace, for narrow pictures.
[[nodiscard]] std::string short_name_of(const std::string& type);

[[nodiscard]] const type_information* information_of(const results& found, const std::string& type);

// The candidates measured in every group, or in the one named, in the order of the rows, with the front marked.
[[nodiscard]] std::vector<candidate> candidates(const results& found, const std::string& group = {});

// Whether this is what a programmer writes first: double, b² - 4ac, the root as printed.
[[nodiscard]] bool is_plain_double(const std::string& type, const std::string& variant, const std::string& root);

// The lines of a picture with a line for each type: the first few of the results' types, each in a typical variant.
struct line {
    std::string type, variant, root;
    int digits = 0;
    ink colour = ink::muted;
    bool dashed = false;
    [[nodiscard]] bool is(const row& r) const { return r.type == type && r.variant == variant && r.root == root; }
};
[[nodiscard]] std::vector<line> chosen_lines(const results& found);

} // namespace compare::report
