// The interface between the comparison and a number type. A type's translation unit includes no more than this, so that
// it compiles the formulas in that type and little else.
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

// Receives a computed number exactly, in one of the forms that types have.
class number_sink {
  public:
    number_sink() = default;
    number_sink(const number_sink&) = delete;
    number_sink& operator=(const number_sink&) = delete;
    virtual ~number_sink() = default;
    virtual void not_finite() = 0;
    virtual void exactly_right() = 0; // the number that was due, exactly
    virtual void number(const binary_number& x) = 0;
    virtual void sum(const binary_number& x, const binary_number& y) = 0;
    virtual void interval(const binary_number& low, const binary_number& high) = 0;
    virtual void decimal(bool negative, const std::string& digits, long exponent) = 0; // digits · 10^exponent
    virtual void surd(const fraction& p, const fraction& q, const fraction& d) = 0;    // p + q√d
};

// The true number, p + q√d.
struct due_number {
    exact_view p, q, d;
};

// A request for a number: its true value, and where the computed one goes.
struct request {
    due_number due;
    number_sink& to;
};

// Receives the answer to one pair: first the decision, then the numbers that are due. The components of a vector, and
// several vectors, follow one another.
class answer_sink {
  public:
    answer_sink() = default;
    answer_sink(const answer_sink&) = delete;
    answer_sink& operator=(const answer_sink&) = delete;
    virtual ~answer_sink() = default;
    // Returns whether time, positions and velocities are due: if it is a collision, and the decision is right.
    virtual bool decided(graze::encounter what, graze::feature where = graze::feature::face, int index = 0) = 0;
    [[nodiscard]] virtual bool has_discriminant() const = 0;
    virtual request discriminant() = 0;
    virtual request time() = 0;
    virtual request position() = 0;
    virtual request velocity() = 0;
};

enum class outcome { answered, undecided, failed };

// Solves the pairs of one list by each of its methods. The pairs have been converted to its number type.
class solver {
  public:
    solver() = default;
    solver(const solver&) = delete;
    solver& operator=(const solver&) = delete;
    virtual ~solver() = default;
    [[nodiscard]] virtual std::vector<method> methods() const = 0;
    // Solves the first `count` pairs by methods()[how] and drops the solutions.
    virtual void run(std::size_t how, std::size_t count) = 0;
    // Solves one pair and passes the solution on. Unless the outcome is `answered`, what was passed on is void.
    virtual outcome answer_to(std::size_t how, std::size_t pair, answer_sink& to) = 0;
};

// One number type, or another way to solve pairs.
struct measurable {
    type_information information;
    std::unique_ptr<solver> (*prepare)(const pair_list& pairs) = nullptr; // null if the type is an alias
    bool takes_long = false;                                              // measured after the others
};

} // namespace compare
