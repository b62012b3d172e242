#include "told.hpp"

#include <graze/formula/encounter.hpp>

namespace compare {

namespace {

constexpr int digits_told = 24;

std::string told(const wide& x) {
    if (x == 0) {
        return "0";
    }
    std::string text = x.str(digits_told, std::ios_base::scientific); // 1.2500e+00
    const auto e = text.find('e');
    const long exponent = std::stol(text.substr(e + 1));
    std::string digits = text.substr(0, e);
    digits.erase(digits.find_last_not_of('0') + 1);
    digits.erase(digits.find_last_not_of('.') + 1);
    if (exponent == 0) {
        return digits;
    }
    if (exponent > -5 && exponent < 16) { // in plain decimals
        const bool negative = digits.front() == '-';
        std::string bare;
        for (const char c : digits) {
            bare += c >= '0' && c <= '9' ? std::string(1, c) : "";
        }
        const auto whole = static_cast<std::size_t>(exponent < 0 ? 0 : exponent + 1);
        if (exponent < 0) {
            bare.insert(0, static_cast<std::size_t>(-exponent), '0');
            bare.insert(1, ".");
        } else if (bare.size() <= whole) {
            bare.append(whole - bare.size(), '0');
        } else {
            bare.insert(whole, ".");
        }
        return (negative ? "-" : "") + bare;
    }
    return digits + "e" + std::to_string(exponent);
}

std::string told(const computed& x, const true_value& right) {
    if (const interval* i = std::get_if<interval>(&x.value())) {
        return "[" + told(i->low) + ", " + told(i->high) + "]";
    }
    if (std::holds_alternative<not_finite>(x.value())) {
        return "no finite number";
    }
    return told(middle(x, right));
}

template <class Number>
std::string joined(std::size_t count, Number number) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += (i == 0 ? "(" : ", ") + number(i);
    }
    return text + ")";
}

std::string on_feature(graze::feature where, int index) {
    return where == graze::feature::face   ? " of the face"
           : where == graze::feature::edge ? " of edge " + std::to_string(index)
                                           : " of corner " + std::to_string(index);
}

} // namespace

std::string told_decision(const truth& right) {
    const bool has_feature = has_features(right.kind) && graze::is_collision(right.what);
    return graze::to_string(right.what) + (has_feature ? on_feature(right.where, right.index) : std::string());
}

std::string told_decision(const answer& given) {
    if (given.how != outcome::answered) {
        return given.how == outcome::undecided ? "undecided" : "no answer";
    }
    const bool has_feature =
        graze::is_collision(given.what) && (given.where != graze::feature::face || given.index != 0);
    return graze::to_string(given.what) + (has_feature ? on_feature(given.where, given.index) : std::string());
}

std::string told_number(const true_value& x) { return told(x.value()); }

std::string told_value(quantity which, const truth& right) {
    const auto vector = [](const std::vector<true_value>& all) {
        return joined(all.size(), [&](std::size_t i) { return told_number(all[i]); });
    };
    switch (which) {
    case quantity::discriminant:
        return told_number(*right.discriminant);
    case quantity::position:
        return vector(right.positions);
    case quantity::velocity:
        return vector(right.velocities);
    default:
        return told_number(right.time);
    }
}

std::string told_value(quantity which, const answer& given, const truth& right) {
    const auto vector = [](const std::vector<computed>& all, const std::vector<true_value>& beside) {
        return joined(all.size(), [&](std::size_t i) { return told(all[i], beside[i]); });
    };
    switch (which) {
    case quantity::discriminant:
        return told(*given.discriminant, *right.discriminant);
    case quantity::position:
        return vector(given.positions, right.positions);
    case quantity::velocity:
        return vector(given.velocities, right.velocities);
    default:
        return told(*given.time, right.time);
    }
}

} // namespace compare
