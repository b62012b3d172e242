// Where to cut space into cells.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace graze::inline v0_1::detail {

// The faces between cells along one axis, ascending: cell i lies between faces i - 1 and i, the first and the last one
// reach to infinity, so that what flies off needs no further cells.
using cell_faces = std::vector<double>;

// At most wanted - 1 faces, at least spacing apart, with about equally many of the coordinates between two of them.
// Sorts the coordinates.
[[nodiscard]] inline cell_faces faces_among(std::span<double> coordinates, std::size_t wanted, double spacing) {
    std::sort(coordinates.begin(), coordinates.end());
    cell_faces faces;
    for (std::size_t i = 1; i < wanted; ++i) {
        const double quantile = coordinates[coordinates.size() * i / wanted];
        const double face = faces.empty() ? std::max(quantile, coordinates.front() + spacing / 2)
                                          : std::max(quantile, faces.back() + spacing);
        if (!(face < coordinates.back())) {
            break;
        }
        faces.push_back(face);
    }
    return faces;
}

// How many cells along each axis, about `cells` in all, where no more than most[i] fit.
template <std::size_t N>
[[nodiscard]] std::array<std::size_t, N> cells_along(const std::array<double, N>& most, double cells) {
    std::array<std::size_t, N> result{};
    std::array<std::size_t, N> axes{};
    for (std::size_t i = 0; i < N; ++i) {
        axes[i] = i;
    }
    std::sort(axes.begin(), axes.end(), [&](std::size_t i, std::size_t j) { return most[i] < most[j]; });
    for (std::size_t k = 0; k < N; ++k) { // what a narrow axis cannot take is left to the wider ones
        const double share = std::pow(cells, 1.0 / static_cast<double>(N - k));
        const double along = std::max(1.0, std::floor(std::min(most[axes[k]], share)));
        result[axes[k]] = static_cast<std::size_t>(along);
        cells /= along;
    }
    return result;
}

} // namespace graze::inline v0_1::detail
