// What a number type is to the comparison, and the comparison to it. A type's translation unit sees no more than this,
// so that it holds the formulas in that type and little else.
#pragma once

#include "pair_numbers.hpp"
#include "type_information.hpp"

#include <graze/formula/discriminant.hpp>
#include <graze/formula/encounter.hpp>
#include <graze/formula/roots.hpp>
#include <graze/formula/wall_encounter.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace compare {

// A variant of the formulas.
struct method {
    graze::variant variant;
    graze::root_form root;
    friend bool operator==(const method&, const method&) = default;
};

// Where a computed number goes, exactly, in one of the forms that types have.
class number_sink {
  public:
    number_sink() = default;
    number_sink(const number_sink&) = delete;
    number_sink& operator=(const number_sink&) = delete;
    virtual ~number_sink() = default;
    virtual void not_finite() = 0;
    virtual void exactly_right() = 0; // what was due, exactly
    virtual void number(const binary_number& x) = 0;
    virtual void sum(const binary_number& x, const binary_number& y) = 0;
    virtual void interval(const binary_number& low, const binary_number& high) = 0;
    virtual void decimal(bool negative, const std::string& digits, long exponent) = 0; // digits · 10^exponent
    virtual void surd(const fraction& p, const fraction& q, const fraction& d) = 0;    // p + q√d
};

// What is due: p + q√d.
struct due_number {
    exact_view p, q, d;
};

// A number that was asked for.
struct request {
    due_number due;
    number_sink& to;
};

// Where the answer to one pair goes: first the decision, then the numbers that are due. A vector's components, and
// those of several vectors, are given one after the other.
class answer_sink {
  public:
    answer_sink() = default;
    answer_sink(const answer_sink&) = delete;
    answer_sink& operator=(const answer_sink&) = delete;
    virtual ~answer_sink() = default;
    // Whether time, positions and velocities are due: it is a collision and rightly decided.
    virtual bool decided(graze::encounter what, graze::feature where = graze::feature::face, int index = 0) = 0;
    [[nodiscard]] virtual bool has_discriminant() const = 0;
    virtual request discriminant() = 0;
    virtual request time() = 0;
    virtual request position() = 0;
    virtual request velocity() = 0;
};

enum class outcome { answered, undecided, failed };

// Solves the pairs of one list, converted to its number type beforehand, by each of its methods.
class solver {
  public:
    solver() = default;
    solver(const solver&) = delete;
    solver& operator=(const solver&) = delete;
    virtual ~solver() = default;
    [[nodiscard]] virtual std::vector<method> methods() const = 0;
    // Solves the first `count` pairs by methods()[how] and forgets the solutions.
    virtual void run(std::size_t how, std::size_t count) = 0;
    // Solves one and tells the solution. What was told is void unless it answered.
    virtual outcome answer_to(std::size_t how, std::size_t pair, answer_sink& to) = 0;
};

// One number type, or another way to solve pairs.
struct measurable {
    type_information information;
    std::unique_ptr<solver> (*prepare)(const pair_list& pairs) = nullptr; // null where the type is another's name
    bool takes_long = false;                                              // to be measured after the others
};

} // namespace compare
