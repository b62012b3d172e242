// The planes and walls near a point.
#pragma once

#include <graze/scene/body.hpp>
#include <graze/scene/box_walk.hpp>
#include <graze/scene/records.hpp>
#include <graze/scene/standing_extent.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace graze::inline v0_1::detail {

// The planes and walls numbered from `first` on. Planes are examined one by one; if there are many walls, they are in a
// grid of cells over all of them.
template <int N>
class standing_cells {
  public:
    using point = vec<N, double>;

    standing_cells() = default;
    standing_cells(records<standing_extent<N>> extents, body first) : parts_(std::move(extents)), first_(first) {
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            standing_extent<N>& p = parts_[i];
            double largest = 0;
            for (int k = 0; k < N; ++k) {
                largest = std::max(largest, std::fabs(p.n[k]));
            }
            for (int k = 0; k < N; ++k) {
                const double off = 0x1p-44 * (std::fabs(p.low[k]) + std::fabs(p.high[k]));
                p.n.component[k] /= largest;
                p.low.component[k] -= off;
                p.high.component[k] += off;
            }
            (p.is_bounded() ? bounded_ : endless_).push_back(static_cast<body>(i));
        }
        if (bounded_.size() > 8) {
            lay_cells();
        }
    }

    // f(b) for all that may be within `reach` of x, each once.
    template <class F>
    void planes_around(const point& x, double reach, F f) const {
        for (const body i : endless_) {
            if (is_near(parts_[i], x, reach)) {
                f(first_ + i);
            }
        }
    }
    template <class F>
    void walls_around(const point& x, double reach, F f) const {
        const auto look = [&](body i) {
            if (is_near(parts_[i], x, reach)) {
                f(first_ + i);
            }
        };
        if (along_ == 0) {
            std::for_each(bounded_.begin(), bounded_.end(), look);
            return;
        }
        place low, high;
        for (int k = 0; k < N; ++k) {
            const double wide = 1.001 * reach + 0x1p-44 * std::fabs(x[k]);
            low[static_cast<std::size_t>(k)] = cell_along(x[k] - wide, k);
            high[static_cast<std::size_t>(k)] = cell_along(x[k] + wide, k);
        }
        for_each_cell(low, high, [&](const place& c, std::size_t cell) {
            for (std::size_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
                const body b = inside_[i];
                bool is_first = true; // of the cells that both share
                for (int k = 0; k < N; ++k) {
                    const auto axis = static_cast<std::size_t>(k);
                    is_first = is_first && c[axis] == std::max(low[axis], cell_along(parts_[b].low[k], k));
                }
                if (is_first) {
                    look(b);
                }
            }
        });
    }

    // f(place, image) for each place from which walls_around finds the images that may be within `reach` of x; for x
    // itself where there is no period.
    template <class F>
    void for_each_image(const point& x, double reach, const point& period, F f) const {
        whole_periods low{}, high{};
        for (int k = 0; k < N; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            if (period[k] > 0 && !bounded_.empty()) {
                double first = standing_extent<N>::endless, last = -first;
                for (const body b : bounded_) {
                    first = std::min(first, parts_[b].low[k]);
                    last = std::max(last, parts_[b].high[k]);
                }
                const double wide = 1.001 * reach + 0x1p-40 * (period[k] + std::fabs(first) + std::fabs(last));
                low[axis] = static_cast<std::int32_t>(std::ceil((x[k] - wide - last) / period[k]));
                high[axis] = static_cast<std::int32_t>(std::floor((x[k] + wide - first) / period[k]));
            }
        }
        for_each_in_box(low, high, [&](const whole_periods& image) {
            point from = x;
            for (int k = 0; k < N; ++k) {
                from.component[k] -= image[static_cast<std::size_t>(k)] * period[k];
            }
            f(from, image);
        });
    }

  private:
    using place = std::array<std::size_t, N>;

    // False if it certainly is not. Boxes are wider than necessary by more than their rounding. The product with n, no
    // component of which is above 1, is right to 2^-47 of the sum of all numbers in it.
    [[nodiscard]] static bool is_near(const standing_extent<N>& p, const point& x, double reach) noexcept {
        double far = reach;
        bool inside = true;
        for (int k = 0; k < N; ++k) {
            far += std::fabs(x[k]) + std::fabs(p.point[k]);
            const double wide = 1.001 * reach + 0x1p-44 * std::fabs(x[k]);
            inside = inside && !(x[k] + wide < p.low[k]) && !(x[k] - wide > p.high[k]);
        }
        const double height = std::fabs(graze::dot(x - p.point, p.n));
        return inside && !(height > (reach + 0x1p-44 * far) * (1.0000001 * std::sqrt(graze::squared_norm(p.n))));
    }

    [[nodiscard]] std::size_t cell_along(double x, int axis) const noexcept {
        const double c = (x - low_[axis]) * per_length_[axis];
        const auto last = static_cast<double>(along_ - 1);
        return !(c > 0) ? 0 : c < last ? static_cast<std::size_t>(c) : along_ - 1;
    }
    template <class F>
    void for_each_cell(const place& low, const place& high, F f) const {
        for_each_in_box(low, high, [&](const place& c) {
            std::size_t cell = 0;
            for (std::size_t k = 0; k < N; ++k) {
                cell = cell * along_ + c[k];
            }
            f(c, cell);
        });
    }
    template <class F>
    void for_each_entry(F f) const {
        for (const body b : bounded_) {
            place low, high;
            for (int k = 0; k < N; ++k) {
                low[static_cast<std::size_t>(k)] = cell_along(parts_[b].low[k], k);
                high[static_cast<std::size_t>(k)] = cell_along(parts_[b].high[k], k);
            }
            for_each_cell(low, high, [&](const place&, std::size_t cell) { f(b, cell); });
        }
    }
    // About as many cells as walls, or fewer where many walls are wide.
    void lay_cells() {
        low_ = parts_[bounded_.front()].low;
        point high = parts_[bounded_.front()].high;
        for (const body b : bounded_) {
            for (int k = 0; k < N; ++k) {
                low_.component[k] = std::min(low_[k], parts_[b].low[k]);
                high.component[k] = std::max(high[k], parts_[b].high[k]);
            }
        }
        const double side = std::pow(static_cast<double>(bounded_.size()), 1.0 / N);
        for (along_ = static_cast<std::size_t>(side) + 1; along_ > 1; along_ /= 2) {
            for (int k = 0; k < N; ++k) {
                const double length = high[k] - low_[k];
                const double cells = static_cast<double>(along_) / length;
                per_length_.component[k] = length > 0 && cells < standing_extent<N>::endless ? cells : 0;
            }
            std::size_t entries = 0;
            for_each_entry([&](body, std::size_t) { ++entries; });
            if (entries <= 16 * bounded_.size()) {
                break;
            }
        }
        std::size_t cells = 1;
        for (int k = 0; k < N; ++k) {
            cells *= along_;
        }
        starts_.assign(cells + 2, 0);
        for_each_entry([&](body, std::size_t cell) { ++starts_[cell + 2]; });
        for (std::size_t i = 2; i < starts_.size(); ++i) {
            starts_[i] += starts_[i - 1];
        }
        inside_.resize(starts_.back());
        for_each_entry([&](body b, std::size_t cell) { inside_[starts_[cell + 1]++] = b; });
    }

    records<standing_extent<N>> parts_;
    records<body> endless_, bounded_;
    body first_ = 0;
    std::size_t along_ = 0; // the number of cells along each axis
    point low_{}, per_length_{};
    records<std::size_t> starts_; // of each cell in the following
    records<body> inside_;
};

} // namespace graze::inline v0_1::detail
