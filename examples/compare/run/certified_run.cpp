#include "certified_run.hpp"

#include "../input_error.hpp"
#include "../stopwatch.hpp"
#include "interruption.hpp"
#include "scene_in.hpp"

#include <graze/run/run.hpp>

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

// The digits after the point if x > 0 is written with `digits` digits, counted from its first one.
long decimals_from(double x, int digits) { return digits - 1 - static_cast<long>(std::floor(std::log10(x))); }

// The largest component of the positions or velocities of moving balls.
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

// The digits known of all of them, counted from the first digit of the largest.
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

    // Runs the scene. Returns whether every decision was certain.
    bool make(certified_result<N>& found) {
        found = {};
        found.bits = bits_;
        last_.reset();
        std::optional<graze::run<certified_mechanics<N>>> run;
        event_check<N> check(scene_);
        bool certain = true;
        try {
            run.emplace(scene_.view());
            graze::run_limits<certified> limits;
            if (how_far_.until) {
                limits.time = certified(*how_far_.until, bits_);
            }
            limits.events = how_far_.events.value_or(limits.events);
            limits.jam = how_far_.jam;
            const graze::outcome done = run->advance(limits, [&](const auto& e) { return note(found, check, e); });
            found.why = done.why;
            found.jammed = done.jammed;
        } catch (const graze::undecided& error) {
            found.problem = text_of(error);
            certain = false;
        } catch (const std::domain_error& error) {
            found.problem = error.what();
        } catch (const std::range_error& error) { // which period a ball is in: narrower intervals may tell
            found.problem = error.what();
            certain = false;
        }
        const bool to_the_end = how_far_.until && found.problem.empty() &&
                                (found.why == graze::ending::time || found.why == graze::ending::exhausted);
        found.end = to_the_end             ? certified(*how_far_.until, bits_)
                    : found.events.empty() ? certified(0)
                                           : found.events.back().time;
        try {
            if (found.why == graze::ending::exhausted && found.problem.empty()) {
                check.end_of_all();
            } else if (run) {
                check.end(found.end);
            }
        } catch (const graze::undecided& error) {
            found.problem = found.problem.empty() ? text_of(error) : found.problem;
            certain = false;
        }
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

    static std::optional<int> known_order_of(const certified_time& s, const certified_time& t) {
        try {
            return order_of(s, t);
        } catch (const graze::undecided&) { // one follows from the other, or they share no ball
            return {};
        }
    }
    // Whether the two have a ball in common that is not a mirror.
    [[nodiscard]] bool share_a_ball(const graze::scene_pair& x, const graze::scene_pair& y) const {
        const auto is_shared = [&](int a) {
            return !scene_.balls[static_cast<std::size_t>(a)].mass.is_infinite() &&
                   (a == y.a || (y.with == graze::partner::ball && a == y.b));
        };
        return is_shared(x.a) || (x.with == graze::partner::ball && is_shared(x.b));
    }

    template <class Event>
    bool note(certified_result<N>& found, event_check<N>& check, const Event& e) {
        check.event(e.who, e.when.value, e.after_a, e.after_b);
        const std::optional<int> order = last_ ? known_order_of(*last_, e.when) : std::optional(-1);
        last_ = e.when;
        const bool either_order = !order && !share_a_ball(e.who, found.events.back().who);
        found.events.push_back({e.who, e.when.value, order == 0, either_order, e.chosen, e.after_a.state, {}});
        if (e.after_b != nullptr) {
            found.events.back().b = e.after_b->state;
        }
        if (found.events.size() % 64 == 0) {
            line_.show("proving, with " + std::to_string(bits_) +
                       " bits: " + progress_of(how_far_, found.events.size(), near_double(e.when.value)));
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
    if (x.is_exact()) {
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
    const mpfi_interval around =
        x.around(128 + static_cast<long>(bits_a_digit * static_cast<double>(std::max(decimals, 0L))) +
                 std::max(0L, static_cast<long>(std::ilogb(near_double(x)))));
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
