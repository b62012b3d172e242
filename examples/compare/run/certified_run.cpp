#include "certified_run.hpp"

#include "../input_error.hpp"
#include "../stopwatch.hpp"
#include "interruption.hpp"
#include "scene_in.hpp"

#include <graze/scene/run.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace compare::run {

namespace {

constexpr double bits_a_digit = 3.3219280948873626; // log2(10), rounded up

template <int N>
graze::ball<N, certified> ball_at(const graze::run<certified_mechanics<N>>& run, int i, const certified& t) {
    return run.rules().immovable(run.in_flight(i)) ? run.in_flight(i).state : run.rules().ball_at(run.in_flight(i), t);
}

// Digits after the point that D digits, counted from the first one of x, are; x > 0.
long decimals_from(double x, int digits) { return digits - 1 - static_cast<long>(std::floor(std::log10(x))); }

// The largest component of a moving ball's position or velocity.
template <int N, class Part>
double largest(const std::vector<graze::ball<N, certified>>& balls, Part part) {
    double result = 0;
    for (const auto& b : balls) {
        for (int i = 0; i < N && !b.mass.is_infinite(); ++i) {
            result = std::max(result, std::abs(near_double((b.*part)[i])));
        }
    }
    return result;
}

// The digits that all of them have, counted from the first one of the largest.
template <int N, class Part>
long digits_of(const std::vector<graze::ball<N, certified>>& balls, Part part) {
    const double size = largest(balls, part);
    long decimals = std::numeric_limits<int>::max();
    for (const auto& b : balls) {
        for (int i = 0; i < N && !b.mass.is_infinite(); ++i) {
            decimals = std::min(decimals, decimals_of((b.*part)[i]));
        }
    }
    return size > 0 ? decimals - decimals_from(size, 0) : decimals;
}

template <int N>
class attempt {
  public:
    attempt(const exact_scene<N>& scene, const extent& how_far, long bits, const progress_line& line)
        : how_far_(how_far), bits_(bits), line_(line),
          scene_(
              scene_in<certified>(scene, certified::infinity(), [&](const exact& x) { return certified(x, bits); })) {}

    // Whether every decision was certain, as far as it went.
    bool make(certified_result<N>& found) {
        found = {};
        found.bits = bits_;
        std::optional<graze::run<certified_mechanics<N>>> run;
        bool certain = true;
        try {
            run.emplace(scene_.view());
            graze::run_limits<certified> limits;
            if (how_far_.until) {
                limits.time = certified(*how_far_.until, bits_);
            }
            limits.events = how_far_.events.value_or(limits.events);
            const graze::outcome done = run->advance(limits, [&](const auto& e) { return note(found, e); });
            found.why = done.why;
        } catch (const graze::undecided& error) {
            found.problem = text_of(error);
            certain = false;
        } catch (const std::domain_error& error) {
            found.problem = error.what();
        }
        const bool to_the_end = how_far_.until && found.problem.empty() &&
                                (found.why == graze::ending::time || found.why == graze::ending::exhausted);
        found.end = to_the_end             ? certified(*how_far_.until, bits_)
                    : found.events.empty() ? certified(0)
                                           : found.events.back().time;
        for (std::size_t i = 0; i < scene_.balls.size(); ++i) {
            found.balls.push_back(run ? ball_at<N>(*run, static_cast<int>(i), found.end) : scene_.balls[i]);
        }
        found.digits =
            static_cast<int>(std::clamp(std::min(digits_of<N>(found.balls, &graze::ball<N, certified>::position),
                                                 digits_of<N>(found.balls, &graze::ball<N, certified>::velocity)),
                                        0L, static_cast<long>(std::numeric_limits<int>::max())));
        return certain;
    }

  private:
    const extent& how_far_;
    long bits_;
    const progress_line& line_;
    owned_scene<N, certified> scene_;

    std::optional<certified_time> last_;

    static bool are_tied(const certified_time& s, const certified_time& t) {
        try {
            return order_of(s, t) == 0;
        } catch (const graze::undecided&) { // then one follows from the other: they have not been compared
            return false;
        }
    }

    template <class Event>
    bool note(certified_result<N>& found, const Event& e) {
        const bool tied = last_ && are_tied(*last_, e.when);
        last_ = e.when;
        found.events.push_back({e.who, e.when.value, tied, e.chosen, e.after_a.state, {}});
        if (e.after_b != nullptr) {
            found.events.back().b = e.after_b->state;
        }
        if (found.events.size() % 64 == 0) {
            line_.show("proving, with " + std::to_string(bits_) + " bits: event " +
                       std::to_string(found.events.size()));
        }
        return !interrupted();
    }

    static std::string text_of(const graze::undecided& error) {
        std::string text = error.what();
        if (error.first()) {
            text += ", of " + to_string(*error.first());
        }
        if (error.second()) {
            text += " and of " + to_string(*error.second());
        }
        return text + ", at about t = " + std::to_string(error.about());
    }
};

} // namespace

long decimals_of(const certified& x) {
    if (x.is_rational()) {
        return std::numeric_limits<int>::max();
    }
    const mpfi_interval around = x.interval();
    mpfr_t width;
    mpfr_init2(width, 64);
    mpfr_sub(width, around.upper(), around.lower(), MPFR_RNDU);
    long result = std::numeric_limits<int>::max();
    if (mpfr_number_p(width) == 0) {
        result = std::numeric_limits<int>::min();
    } else if (mpfr_zero_p(width) == 0) { // width < 2^exponent <= 10^-result
        result = static_cast<long>(std::floor(-static_cast<double>(mpfr_get_exp(width)) / bits_a_digit));
    }
    mpfr_clear(width);
    return result;
}

std::string decimal_text(const certified& x, long decimals) {
    mpfr_t middle;
    mpfi_interval around =
        x.is_rational()
            ? mpfi_interval(std::max(64L, static_cast<long>(static_cast<double>(decimals) * bits_a_digit) + 128),
                            x.rational().get_mpq_t())
            : x.interval();
    mpfr_init2(middle, around.bits() + 2);
    mpfi_mid(middle, around.get());
    char* text = nullptr;
    mpfr_asprintf(&text, "%.*Rf", static_cast<int>(std::max(decimals, 0L)), middle);
    std::string result(text);
    mpfr_free_str(text);
    mpfr_clear(middle);
    return result.find_first_not_of("-0.") == std::string::npos && result.front() == '-' ? result.substr(1) : result;
}

template <int N>
certified_result<N> certified_run(const exact_scene<N>& scene, const extent& how_far, const certainty& wanted,
                                  const progress_line& line) {
    const stopwatch watch;
    certified_result<N> found;
    long bits = std::min(wanted.most_bits, 64 + static_cast<long>(wanted.digits * bits_a_digit));
    for (int attempts = 1;; ++attempts) {
        line.show("proving, with " + std::to_string(bits) + " bits");
        const bool certain = attempt<N>(scene, how_far, bits, line).make(found);
        found.attempts = attempts;
        const bool enough = certain && found.digits >= wanted.digits;
        if (enough || interrupted() || bits >= wanted.most_bits) {
            break;
        }
        const long missing = static_cast<long>((wanted.digits - found.digits) * bits_a_digit) + 32;
        bits = std::min(wanted.most_bits, certain ? bits + missing : 2 * bits);
    }
    found.seconds = watch.seconds();
    line.show("");
    return found;
}

template certified_result<2> certified_run(const exact_scene<2>&, const extent&, const certainty&,
                                           const progress_line&);
template certified_result<3> certified_run(const exact_scene<3>&, const extent&, const certainty&,
                                           const progress_line&);

} // namespace compare::run
