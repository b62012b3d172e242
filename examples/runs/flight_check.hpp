// Checks a run of balls in a box independently of the run: did a ball pass through another, or bounce off nothing?
#pragma once

#include <graze/run/outcome.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

// When a flight ends, it is compared with every other flight for the time that both lasted. So every pair is checked at
// all times, in plain doubles, at a cost of O(balls) for each event.
//
// The depth that rounding explains, for u = 2^-53, lengths below L, speeds below V, and times until t: an event rounds
// its time, which moves a ball by at most u V t, and each coordinate of its position, by at most u L. So two balls that
// leave a contact overlap by at most 2 (√N u L + u V t). An event with a third ball may move each as far again, and
// balls that approach after that are resolved at once: 4 √N u (L + V t) in all. The doubles of this check are off by
// less than ten roundings of numbers below L + V t. 16 √N u (L + V t) covers both.
template <int N>
class flight_check {
  public:
    flight_check(const graze::scene<N>& scene, double length) : planes_(scene.planes.begin(), scene.planes.end()) {
        length_ = length;
        for (const auto& b : scene.balls) {
            flights_.push_back({b, 0});
            energy_ += energy_of(b);
        }
        start_energy_ = energy_;
        speed_ = std::sqrt(2 * energy_); // of one ball of mass 1 that has all of the energy
    }

    template <class Event>
    bool operator()(const Event& e) {
        const auto a = static_cast<std::size_t>(e.who.a);
        const double now = e.after_a.since;
        ++events_;
        latest_ = std::max(latest_, now);
        depth_allowed_ = 16 * std::sqrt(double{N}) * 0x1p-53 * (length_ + speed_ * latest_);
        if (e.who.with == graze::partner::ball) {
            const auto b = static_cast<std::size_t>(e.who.b);
            require_contact(distance(flights_[a], flights_[b], now) - (radius(a) + radius(b)));
            look_back(a, now);
            look_back(b, now);
            replace(a, e.after_a);
            replace(b, *e.after_b);
        } else {
            const auto& p = planes_[static_cast<std::size_t>(e.who.b)];
            require_contact(std::fabs(height(flights_[a], p, now)) - radius(a));
            look_back(a, now);
            replace(a, e.after_a);
        }
        return true;
    }

    // From now on times count from `by`.
    void set_clock_back(double by) {
        for (auto& f : flights_) {
            f.since -= by; // exact, as the run promises
        }
    }

    [[nodiscard]] double deepest() const noexcept { return deepest_; }
    [[nodiscard]] double depth_allowed() const noexcept { return depth_allowed_; }
    // |E - E₀| / E₀. An event's exact velocities conserve energy. Rounding a component once changes its square by at
    // most 2u of itself, and so the energy of the event's balls by at most 2^-52 of that energy.
    [[nodiscard]] double energy_drift() const {
        double energy = 0;
        for (const auto& f : flights_) {
            energy += energy_of(f.state);
        }
        return std::fabs(energy - start_energy_) / start_energy_;
    }
    [[nodiscard]] double drift_allowed() const {
        const double summing = 4 * static_cast<double>(flights_.size()) * 0x1p-53; // of the two sums compared
        return rounded_energy_ * 0x1p-52 / start_energy_ + summing;
    }

  private:
    using flight = graze::flight<N, double>;

    [[nodiscard]] static double energy_of(const graze::ball<N>& b) {
        return 0.5 * b.mass * graze::squared_norm(b.velocity);
    }
    [[nodiscard]] double radius(std::size_t i) const { return flights_[i].state.radius; }
    [[nodiscard]] static graze::vec<N, double> at(const flight& f, double t) {
        return f.state.position + (t - f.since) * f.state.velocity;
    }
    [[nodiscard]] static double distance(const flight& f, const flight& g, double t) {
        return std::sqrt(graze::squared_norm(at(f, t) - at(g, t)));
    }
    [[nodiscard]] static double height(const flight& f, const graze::plane<N>& p, double t) {
        return graze::dot(at(f, t) - p.point, p.normal) / std::sqrt(graze::squared_norm(p.normal));
    }

    // The least distance of two flights while both lasted, up to now.
    [[nodiscard]] static double least_distance(const flight& f, const flight& g, double now) {
        const double from = std::max(f.since, g.since);
        const auto dx = at(f, from) - at(g, from);
        const auto du = f.state.velocity - g.state.velocity;
        const double a = graze::squared_norm(du);
        const double nearest = a > 0 ? std::clamp(-graze::dot(dx, du) / a, 0.0, std::max(0.0, now - from)) : 0.0;
        return std::sqrt(graze::squared_norm(dx + nearest * du));
    }
    void look_back(std::size_t i, double now) {
        for (std::size_t j = 0; j < flights_.size(); ++j) {
            if (j != i) {
                require_depth(radius(i) + radius(j) - least_distance(flights_[i], flights_[j], now));
            }
        }
        for (const auto& p : planes_) { // its way is straight, so it is deepest at an end
            require_depth(radius(i) - std::fabs(height(flights_[i], p, now)));
        }
    }
    void require_depth(double depth) {
        deepest_ = std::max(deepest_, depth);
        if (!(depth <= depth_allowed_)) {
            throw std::runtime_error("an event was missed before event " + std::to_string(events_));
        }
    }
    void require_contact(double gap) const {
        if (!(std::fabs(gap) <= depth_allowed_)) {
            throw std::runtime_error("event " + std::to_string(events_) + " is invented");
        }
    }
    void replace(std::size_t i, const flight& f) {
        flights_[i] = f;
        rounded_energy_ += energy_of(f.state);
    }

    std::vector<flight> flights_;
    std::vector<graze::plane<N>> planes_;
    double length_ = 0, speed_ = 0;
    double energy_ = 0, start_energy_ = 0, rounded_energy_ = 0;
    double latest_ = 0; // the largest time so far, on the current clock
    double deepest_ = 0, depth_allowed_ = 0;
    std::uint64_t events_ = 0;
};
