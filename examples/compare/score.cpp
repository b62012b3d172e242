#include "score.hpp"

#include "told.hpp"

#include <limits>

namespace compare {

namespace {

// A defect smaller than this, but not 0, would need more digits than any number type has that fits into `wide`.
constexpr long least_defect = -880;

bool is_exactly(const computed& given, const true_value& right) {
    return std::holds_alternative<exactly_right>(given.value()) ||
           (std::holds_alternative<exact_real>(given.value()) && *distance(given, right) == 0);
}

double relative(const wide& defect, const wide& size) {
    if (defect == 0 || exponent_of(defect) < exponent_of(size) + least_defect) {
        return 0.0;
    }
    return scaled(wide(abs(defect) / size), 0);
}

} // namespace

bool same_decision(const answer& given, const truth& right) {
    if (given.how != outcome::answered || given.what != right.what) {
        return false;
    }
    const bool on_wall = has_features(right.kind) && graze::is_collision(right.what);
    return !on_wall || (given.where == right.where && given.index == right.index);
}

void row_score::note_wrong(const char* kind, double distance, const answer& given, const truth& right,
                           std::size_t number) {
    const extreme here{distance, number, &right, given};
    const auto [at, is_first] = wrong_.try_emplace(kind, here, here);
    if (!is_first && distance < at->second.first.measure) {
        at->second.first = here;
    }
    if (!is_first && distance > at->second.second.measure) {
        at->second.second = here;
    }
}

void row_score::note_error(quantity which, std::optional<double> error, const answer& given, const truth& right,
                           std::size_t number) {
    const double measure = error.value_or(std::numeric_limits<double>::infinity());
    auto& worst = worst_[static_cast<std::size_t>(which)];
    if (measure > 0 && (!worst || measure > worst->measure)) {
        worst = extreme{measure, number, &right, given};
    }
}

void row_score::add_decision(const answer& given, const truth& right, part& cell, std::size_t number) {
    using graze::encounter;
    const double nearest = nearest_border(right.what, right.borders);
    ++decisions_.evaluated;
    ++cell.evaluated;
    if (given.how == outcome::undecided) {
        ++decisions_.undecided;
        ++cell.undecided;
        note_wrong("undecided", nearest, given, right, number);
        return;
    }
    if (same_decision(given, right)) {
        return;
    }
    ++cell.wrong;
    if (given.how == outcome::failed) {
        ++decisions_.failed;
        note_wrong("failed", nearest, given, right, number);
    } else if ((given.what == encounter::recede) != (right.what == encounter::recede)) {
        ++decisions_.approaching;
        note_wrong("approaching", right.borders.receding, given, right, number);
    } else if ((given.what == encounter::overlap) != (right.what == encounter::overlap)) {
        ++decisions_.overlap;
        note_wrong("overlap", right.borders.overlapping, given, right, number);
    } else if (given.what != right.what) {
        ++decisions_.hit_or_miss;
        note_wrong("hit_or_miss", right.borders.hitting, given, right, number);
    } else {
        ++decisions_.feature;
        note_wrong("feature", nearest, given, right, number);
    }
}

std::optional<double> row_score::add_scalar(quantity which, const computed& given, const true_value& right) {
    const auto apart = distance(given, right);
    if (!apart) {
        sample(which).add_not_finite();
        return std::numeric_limits<double>::infinity();
    }
    if (const interval* between = std::get_if<interval>(&given.value());
        between != nullptr && !encloses(*between, right)) {
        ++not_enclosed_;
    }
    return sample(which).add(*apart, abs(right.value()), rounds_correctly(given, right));
}

std::optional<double> row_score::add_vector(quantity which, const std::vector<computed>& given,
                                            const std::vector<true_value>& right) {
    wide farthest = 0, size = 0;
    bool rounded = true;
    for (std::size_t i = 0; i < right.size(); ++i) {
        const auto apart = distance(given[i], right[i]);
        if (!apart) {
            sample(which).add_not_finite();
            return std::numeric_limits<double>::infinity();
        }
        if (const interval* between = std::get_if<interval>(&given[i].value());
            between != nullptr && !encloses(*between, right[i])) {
            ++not_enclosed_;
        }
        farthest = *apart > farthest ? *apart : farthest;
        const wide length = abs(right[i].value());
        size = length > size ? length : size;
        rounded = rounded && rounds_correctly(given[i], right[i]);
    }
    return sample(which).add(farthest, size, rounded);
}

void row_score::add_width(const computed& given, const true_value& right) {
    if (const interval* between = std::get_if<interval>(&given.value())) {
        width_.add(between->high - between->low, abs(right.value()), false);
    }
}

void row_score::add_conservation(const answer& given, const truth& right) {
    const before_impact& before = right.before;
    if (right.what == graze::encounter::graze || !(before.momentum || before.energy)) {
        return;
    }
    // The truth conserves both. So an answer that equals the truth has no defect.
    bool exact_answer = true;
    for (std::size_t i = 0; i < given.velocities.size(); ++i) {
        const computed& v = given.velocities[i];
        if (std::holds_alternative<interval>(v.value()) || std::holds_alternative<not_finite>(v.value())) {
            return;
        }
        exact_answer = exact_answer && is_exactly(v, right.velocities[i]);
    }
    const auto dimension = static_cast<std::size_t>(before.dimension);
    wide gained = 0, energy = 0, lost = 0, momentum = 0;
    if (!exact_answer) {
        std::vector<wide> kick(dimension, wide(0)), size(dimension, wide(0));
        for (std::size_t i = 0; i < given.velocities.size(); ++i) {
            const wide& mass = i < dimension ? before.mass_a : before.mass_b;
            const wide& u = before.velocities[i];
            const wide v = middle(given.velocities[i], right.velocities[i]);
            energy += mass * u * u;
            gained += mass * (v * v - u * u);
            kick[i % dimension] += mass * (v - u);
            size[i % dimension] += mass * abs(u);
        }
        for (std::size_t i = 0; i < dimension; ++i) {
            const wide off = abs(kick[i]);
            lost = off > lost ? off : lost;
            momentum = size[i] > momentum ? size[i] : momentum;
        }
    }
    if (before.energy) {
        energy_.add(exact_answer ? 0.0 : relative(gained, energy));
    }
    if (before.momentum) {
        momentum_.add(exact_answer ? 0.0 : relative(lost, momentum));
    }
}

void row_score::add(const answer& given, const truth& right, int hardness, std::size_t number) {
    part& cell = parts_[{right.kind, hardness}];
    add_decision(given, right, cell, number);
    const bool same = same_decision(given, right);
    dots_.push_back(same ? dot_absent : given.how == outcome::undecided ? dot_open : dot_wrong);
    const auto note = [&](quantity which, std::optional<double> error) {
        note_error(which, error, given, right, number);
    };
    // Two balls have a D whatever was decided; a wall has one if the right edge or corner was met.
    if (right.discriminant && given.discriminant && (right.kind == pair_kind::ball_ball || same)) {
        const auto error = add_scalar(quantity::discriminant, *given.discriminant, *right.discriminant);
        if (error) {
            cell.discriminants.push_back(*error);
        }
        note(quantity::discriminant, error);
    }
    if (!same || !graze::is_collision(right.what)) {
        return;
    }
    if (right.what != graze::encounter::overlap) {
        const quantity which = right.kind == pair_kind::ball_ball ? quantity::time : quantity::crossing;
        const auto error = add_scalar(which, *given.time, right.time);
        if (error) {
            cell.times.push_back(*error);
        }
        note(which, error);
        dots_.back() = static_cast<float>(error.value_or(std::numeric_limits<double>::infinity()));
        add_width(*given.time, right.time);
    }
    note(quantity::position, add_vector(quantity::position, given.positions, right.positions));
    note(quantity::velocity, add_vector(quantity::velocity, given.velocities, right.velocities));
    add_conservation(given, right);
}

void row_score::write_to(row& result) const {
    result.decisions = decisions_;
    for (std::size_t i = 0; i < quantity_count; ++i) {
        result.errors[i] = errors_[i].summary();
    }
    result.width = width_.summary();
    result.not_enclosed = not_enclosed_;
    result.momentum = momentum_.summary();
    result.energy = energy_.summary();
    result.dots = dots_;
    for (std::size_t i = 0; i < quantity_count; ++i) {
        if (worst_[i]) {
            const extreme& e = *worst_[i];
            const auto which = static_cast<quantity>(i);
            result.extremes.push_back({quantity_names[i], "largest", e.number, e.measure, told_value(which, *e.right),
                                       told_value(which, e.given, *e.right)});
        }
    }
    for (const auto& [kind, both] : wrong_) {
        for (const auto& [which, e] : {std::pair("nearest", &both.first), std::pair("farthest", &both.second)}) {
            if (e == &both.first || both.second.number != both.first.number) {
                result.extremes.push_back(
                    {kind, which, e->number, 0, told_decision(*e->right), told_decision(e->given)});
            }
        }
    }
    for (const auto& [key, measured] : parts_) {
        cell written;
        written.kind = key_of(key.first);
        written.hardness = key.second;
        written.evaluated = measured.evaluated;
        written.wrong = measured.wrong;
        written.undecided = measured.undecided;
        const auto summarise = [](std::vector<double> values, std::optional<double>& middle_one,
                                  std::optional<double>& largest) {
            if (!values.empty()) {
                middle_one = median(values);
                largest = values.back();
            }
        };
        summarise(measured.times, written.time_median, written.time_largest);
        summarise(measured.discriminants, written.discriminant_median, written.discriminant_largest);
        result.cells.push_back(std::move(written));
    }
}

} // namespace compare
