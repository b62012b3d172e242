#include "answer_reader.hpp"

#include "exact_access.hpp"

#include <deque>
#include <utility>

namespace compare {

namespace {

wide wide_of(const binary_number& x) { return ldexp(wide(integer_of(x.significand)), x.exponent); }

wide power_of_ten(unsigned long exponent) {
    return wide(boost::multiprecision::pow(exact_integer(10), static_cast<unsigned>(exponent)));
}

class answer_reader final : public answer_sink {
  public:
    explicit answer_reader(const truth& right) : right_(right) {}

    bool decided(graze::encounter what, graze::feature where, int index) override {
        given_.what = what;
        given_.where = where;
        given_.index = index;
        return same_decision(given_, right_) && graze::is_collision(right_.what);
    }
    [[nodiscard]] bool has_discriminant() const override { return right_.discriminant.has_value(); }
    request discriminant() override { return {due(*right_.discriminant), discriminant_.emplace()}; }
    request time() override { return {due(right_.time), time_.emplace()}; }
    request position() override { return component(positions_, right_.positions); }
    request velocity() override { return component(velocities_, right_.velocities); }

    // To be called once.
    [[nodiscard]] answer ended(outcome how) {
        if (how != outcome::answered) {
            answer none;
            none.how = how;
            return none;
        }
        if (discriminant_) {
            given_.discriminant = discriminant_->value();
        }
        if (time_) {
            given_.time = time_->value();
        }
        for (const computed_sink& x : positions_) {
            given_.positions.push_back(x.value());
        }
        for (const computed_sink& x : velocities_) {
            given_.velocities.push_back(x.value());
        }
        return std::move(given_);
    }

  private:
    [[nodiscard]] static due_number due(const true_value& x) {
        const exact_real& value = x.exactly();
        return {exact_access::view(value.p()), exact_access::view(value.q()), exact_access::view(value.d())};
    }
    [[nodiscard]] static request component(std::deque<computed_sink>& given, const std::vector<true_value>& right) {
        const true_value& one = right.at(given.size());
        return {due(one), given.emplace_back()};
    }

    const truth& right_;
    answer given_;
    std::optional<computed_sink> discriminant_, time_;
    std::deque<computed_sink> positions_, velocities_; // deques: requests keep references to the elements
};

} // namespace

void computed_sink::not_finite() { value_ = compare::not_finite{}; }
void computed_sink::exactly_right() { value_ = compare::exactly_right{}; }
void computed_sink::number(const binary_number& x) { value_ = wide_of(x); }
void computed_sink::sum(const binary_number& x, const binary_number& y) { value_ = wide(wide_of(x) + wide_of(y)); }
void computed_sink::interval(const binary_number& low, const binary_number& high) {
    value_ = compare::interval{wide_of(low), wide_of(high)};
}

// digits · 10^exponent, rounded once.
void computed_sink::decimal(bool negative, const std::string& digits, long exponent) {
    const wide whole(exact_integer{digits});
    const auto places = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent);
    const wide size = exponent < 0 ? wide(whole / power_of_ten(places)) : wide(whole * power_of_ten(places));
    value_ = negative ? wide(-size) : size;
}

void computed_sink::surd(const fraction& p, const fraction& q, const fraction& d) {
    value_ = q.numerator.digits.empty() ? exact_real(exact_of(p)) : exact_real(exact_of(p), exact_of(q), exact_of(d));
}

answer read_answer(solver& of, std::size_t how, std::size_t pair, const truth& right) {
    answer_reader reads(right);
    const outcome ended = of.answer_to(how, pair, reads);
    return reads.ended(ended);
}

} // namespace compare
