#include "sequence.hpp"

#include "../exact_access.hpp"
#include "../types/gmp_exact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace compare::run {

namespace {

wide wide_of_interval(const certified& x) {
    if (x.is_rational()) {
        return to_wide(exact_of(fraction_of(x.rational().get_mpq_t())));
    }
    mpfr_t middle;
    const mpfi_interval around = x.around(wide_digits + 64);
    mpfr_init2(middle, around.bits() + 2);
    mpfi_mid(middle, around.get());
    wide result = 0;
    if (mpfr_number_p(middle) != 0 && mpfr_zero_p(middle) == 0) {
        mpz_t significand;
        mpz_init(significand);
        const mpfr_exp_t exponent = mpfr_get_z_2exp(significand, middle);
        result = ldexp(wide(integer_of(whole_of(significand))), exponent);
        mpz_clear(significand);
    }
    mpfr_clear(middle);
    return result;
}

template <int N>
graze::vec<N, wide> place_of(const graze::ball<N, certified>& b) {
    return graze::make_vec<N>([&](int i) { return wide_of_interval(b.position[i]); });
}

// The correct decimal digits of something of this size that has this error.
double digits_left(const wide& error, const wide& size) {
    constexpr double all = wide_digits * 0.30102999566398120;
    return error == 0 ? all : std::clamp(static_cast<double>(-log10(wide(error / size))), 0.0, all);
}

template <int N>
double digits_left(const graze::vec<N, wide>& found, const graze::vec<N, wide>& right, const true_sequence<N>& truth) {
    wide error = 0;
    for (int i = 0; i < N; ++i) {
        wide off = found[i] - right[i];
        if (truth.period[i] > 0) {
            off -= truth.period[i] * floor(wide(off / truth.period[i] + 0.5));
        }
        error = std::max(error, wide(abs(off)));
    }
    return digits_left(error, wide(truth.size));
}

template <int N>
wide distance_from_origin(const graze::vec<N, wide>& x) {
    return sqrt(graze::squared_norm(x));
}

} // namespace

template <int N>
true_sequence<N> sequence_of(const certified_result<N>& proved, const exact_scene<N>& scene) {
    true_sequence<N> result;
    result.period = graze::make_vec<N>([&](int i) { return to_wide(scene.period[i]); });
    for (const certified_event<N>& e : proved.events) {
        result.steps.push_back({e.who, e.tied || e.either_order, place_of<N>(e.a), place_of<N>(e.b ? *e.b : e.a)});
    }
    if (proved.problem.empty()) {
        for (const auto& b : proved.balls) {
            result.end.push_back(place_of<N>(b));
        }
    }
    double size = 0;
    for (int i = 0; i < N; ++i) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        const auto take = [&](const wide& x) {
            low = std::min(low, static_cast<double>(x));
            high = std::max(high, static_cast<double>(x));
        };
        for (std::size_t k = 0; k < scene.balls.size(); ++k) {
            if (!scene.balls[k].inverse_mass.is_zero()) {
                take(to_wide(scene.balls[k].shape.position[i]));
                take(wide_of_interval(proved.balls[k].position[i]));
            }
        }
        for (const true_step<N>& s : result.steps) {
            if (!scene.balls[static_cast<std::size_t>(s.who.a)].inverse_mass.is_zero()) {
                take(s.a[i]);
            }
            if (s.who.with == graze::partner::ball &&
                !scene.balls[static_cast<std::size_t>(s.who.b)].inverse_mass.is_zero()) {
                take(s.b[i]);
            }
        }
        size = std::max(size, high - low);
    }
    result.size = size > 0 && std::isfinite(size) ? size : 1;
    return result;
}

template <int N>
void judge<N>::event(graze::scene_pair who, double time, const place& a, const place& b) {
    const std::size_t k = found_.events.size();
    found_.events.push_back(who);
    found_.times.push_back(time);
    taken_.resize(truth_.steps.size());
    if (!right_ || k >= truth_.steps.size()) {
        right_ = false;
        return;
    }
    // The first true event that has not come yet, or a later one that may come in its place.
    std::size_t first = static_cast<std::size_t>(std::find(taken_.begin(), taken_.end(), false) - taken_.begin());
    std::size_t step = first;
    while (step < truth_.steps.size() && (taken_[step] || truth_.steps[step].who != who)) {
        ++step;
        if (step < truth_.steps.size() && !truth_.steps[step].exchangeable) {
            step = truth_.steps.size();
        }
    }
    if (step >= truth_.steps.size()) {
        right_ = false;
        return;
    }
    taken_[step] = true;
    const true_step<N>& s = truth_.steps[step];
    found_.digits.push_back(a && b ? std::min(digits_left<N>(*a, s.a, truth_), digits_left<N>(*b, s.b, truth_)) : 0);
}

template <int N>
void judge<N>::end(const std::vector<place>& balls) {
    if (found_.digits.size() != truth_.steps.size() || found_.events.size() != truth_.steps.size() ||
        truth_.end.size() != balls.size()) {
        return;
    }
    if (truth_.distance_of) {
        const place& ball = balls[*truth_.distance_of];
        const wide right = distance_from_origin(truth_.end[*truth_.distance_of]);
        found_.end_digits = ball && right > 0 ? digits_left(wide(abs(distance_from_origin(*ball) - right)), right) : 0;
        return;
    }
    double digits = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        digits = std::min(digits, balls[i] ? digits_left<N>(*balls[i], truth_.end[i], truth_) : 0);
    }
    found_.end_digits = digits;
}

const char* to_string(comparison c) noexcept {
    return c == comparison::whole ? "whole" : c == comparison::part ? "part" : "none";
}

const char* to_string(mistake m) noexcept {
    switch (m) {
    case mistake::none:
        return "none";
    case mistake::missed:
        return "missed";
    case mistake::invented:
        return "invented";
    case mistake::out_of_order:
        return "out of order";
    case mistake::other:
        return "other";
    }
    return "unknown";
}

template <int N>
first_mistake first_mistake_of(const history& found, const certified_result<N>& proved) {
    const std::size_t at = found.digits.size(), all = proved.events.size();
    const bool known_further =
        proved.problem.empty() && proved.why != graze::ending::stopped && proved.why != graze::ending::cascade;
    if (found.compared == comparison::none || (at >= all && (found.events.size() <= all || !known_further))) {
        return {mistake::none, at, 0, ""};
    }
    // Whether `who` is among the next 64 events. Before `at`, both sequences have the same events, but for exchanged
    // ones.
    const auto comes = [](const auto& events, std::size_t from, const graze::scene_pair& who, auto name) {
        const std::size_t to = std::min(events.size(), from + 64);
        for (std::size_t i = from; i < to; ++i) {
            if (name(events[i]) == who) {
                return true;
            }
        }
        return false;
    };
    const auto own = [](const graze::scene_pair& m) { return m; };
    const auto true_name = [](const certified_event<N>& e) { return e.who; };
    if (at >= found.events.size()) {
        if (found.compared == comparison::part) {
            return {mistake::none, at, 0, ""};
        }
        const certified_event<N>& due = proved.events[at];
        return {found.problem.empty() ? mistake::missed : mistake::other, at, near_double(due.time),
                to_string(due.who) + (found.problem.empty() ? " is missed" : ": " + found.problem)};
    }
    const graze::scene_pair has = found.events[at];
    if (at >= all) {
        return {mistake::invented, at, found.times[at], to_string(has) + " is invented"};
    }
    const certified_event<N>& due = proved.events[at];
    const double due_at = near_double(due.time);
    // What comes after the end of the proof may happen, and what is due may come after the end of the type's run.
    const bool happens = comes(proved.events, at, has, true_name) ||
                         (!known_further && found.times[at] >= near_double(proved.events.back().time));
    const bool is_had = comes(found.events, at, due.who, own) || found.compared == comparison::part || !known_further;
    if (happens && is_had) {
        return {mistake::out_of_order, at, std::min(found.times[at], due_at),
                to_string(has) + " comes before " + to_string(due.who)};
    }
    if (is_had) {
        return {mistake::invented, at, found.times[at], to_string(has) + " is invented"};
    }
    if (happens) {
        return {mistake::missed, at, due_at, to_string(due.who) + " is missed"};
    }
    return {mistake::other, at, std::min(found.times[at], due_at),
            to_string(has) + " instead of " + to_string(due.who)};
}

template true_sequence<2> sequence_of(const certified_result<2>&, const exact_scene<2>&);
template true_sequence<3> sequence_of(const certified_result<3>&, const exact_scene<3>&);
template class judge<2>;
template class judge<3>;
template first_mistake first_mistake_of(const history&, const certified_result<2>&);
template first_mistake first_mistake_of(const history&, const certified_result<3>&);

} // namespace compare::run
