// The answers of a number type, compared with the truth.
#pragma once

#include "results.hpp"
#include "solver.hpp"
#include "statistics.hpp"
#include "truth.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace compare {

// A type's answer to one pair. Vectors are laid end to end, as in truth.
struct answer {
    outcome how = outcome::answered;
    graze::encounter what = graze::encounter::recede;
    graze::feature where = graze::feature::face;
    int index = 0;
    std::optional<computed> discriminant, time;
    std::vector<computed> positions, velocities;
};

// Whether the type made a decision and it is the true one.
[[nodiscard]] bool same_decision(const answer& given, const truth& right);

// Collects the answers behind one row.
class row_score {
  public:
    // `right` must outlive the score. number: the pair's.
    void add(const answer& given, const truth& right, int hardness, std::size_t number = 0);
    // Fills in the row except for its names and times.
    void write_to(row& result) const;

  private:
    struct part {
        std::size_t evaluated = 0, wrong = 0, undecided = 0;
        std::vector<double> times, discriminants;
    };

    // The pair on which the row is worst so far, and by how much.
    struct extreme {
        double measure;
        std::size_t number;
        const truth* right;
        answer given;
    };

    void add_decision(const answer& given, const truth& right, part& cell, std::size_t number);
    void note_wrong(const char* kind, double distance, const answer& given, const truth& right, std::size_t number);
    // error: empty if the exact value is 0. Empty and infinite errors are worse than any number.
    void note_error(quantity which, std::optional<double> error, const answer& given, const truth& right,
                    std::size_t number);
    std::optional<double> add_scalar(quantity which, const computed& given, const true_value& right);
    std::optional<double> add_vector(quantity which, const std::vector<computed>& given,
                                     const std::vector<true_value>& right);
    void add_width(const computed& given, const true_value& right);
    void add_conservation(const answer& given, const truth& right);
    error_sample& sample(quantity q) { return errors_[static_cast<std::size_t>(q)]; }

    decision_counts decisions_;
    std::array<error_sample, quantity_count> errors_;
    error_sample width_;
    std::size_t not_enclosed_ = 0;
    defect_sample momentum_, energy_;
    std::map<std::pair<pair_kind, int>, part> parts_;
    std::array<std::optional<extreme>, quantity_count> worst_;
    std::map<std::string, std::pair<extreme, extreme>> wrong_; // the nearest and the farthest, by kind
    std::vector<float> dots_;
};

} // namespace compare
