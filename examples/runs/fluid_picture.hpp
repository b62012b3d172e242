// Known values of the hard-sphere fluid, and a picture of them with the measured values.
#pragma once

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

struct with_error {
    double value, error;

    // The difference from `other`, in per cent of it.
    [[nodiscard]] with_error relative_to(double other) const {
        return {100 * (value / other - 1), 100 * error / other};
    }
};

// The excess pressure Z - 1 = p/(ρkT) - 1, and a ball's rate of collisions in units of √(kT/m)/σ.
struct measured_fluid {
    double packing;
    with_error excess, rate;
};

// J. Chem. Phys. 51, 635 (1969).
[[nodiscard]] inline double carnahan_starling(double eta) {
    return (1 + eta + eta * eta - eta * eta * eta) / std::pow(1 - eta, 3) - 1;
}
// 4 ρ σ² χ √(π kT/m), with ρ σ³ = 6 η/π and the contact value χ that follows from that pressure.
[[nodiscard]] inline double enskog(double eta) {
    const double chi = (1 - eta / 2) / std::pow(1 - eta, 3);
    return 24 * eta * chi / std::sqrt(std::numbers::pi);
}

// Known values are lines, measured ones dots. Below: the differences in per cent, with their errors.
[[nodiscard]] inline std::string picture_of(const std::vector<measured_fluid>& all) {
    constexpr double left = 60, width = 420, top = 30, middle = 330, bottom = 450, most = 0.5;
    const auto x = [&](double eta) { return left + width * eta / most; };
    const auto y = [&](double value) { return middle - 40 - (middle - 40 - top) * value / 40; };
    const auto off = [&](double percent) { return (middle + bottom) / 2 - 25 * percent; };
    std::ostringstream svg;
    svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 520 490' font-family='sans-serif' font-size='12'>\n"
        << "<rect width='520' height='490' fill='white'/>\n"
        << "<g stroke='#bbb'><path d='M" << left << ' ' << y(0) << 'h' << width << 'M' << left << ' ' << off(0) << 'h'
        << width << "'/><path stroke-dasharray='3 3' d='M" << left << ' ' << off(1) << 'h' << width << 'M' << left
        << ' ' << off(-1) << 'h' << width << "'/></g>\n";
    for (int i = 0; i <= 5; ++i) {
        svg << "<text text-anchor='middle' x='" << x(i * 0.1) << "' y='" << bottom + 18 << "'>0." << i << "</text>\n";
    }
    for (int i = 0; i <= 4; ++i) {
        svg << "<text text-anchor='end' x='" << left - 6 << "' y='" << y(i * 10) + 4 << "'>" << i * 10 << "</text>\n";
    }
    for (int i = -1; i <= 1; ++i) {
        svg << "<text text-anchor='end' x='" << left - 6 << "' y='" << off(i) + 4 << "'>" << i << " %</text>\n";
    }
    svg << "<text text-anchor='middle' x='" << left + width / 2 << "' y='" << bottom + 36
        << "'>packing fraction</text>\n";
    const auto draw = [&](const char* colour, const char* name, double height, auto known, auto measured,
                          double shift) {
        svg << "<text fill='" << colour << "' x='" << left + 12 << "' y='" << height << "'>" << name << "</text>\n"
            << "<path fill='none' stroke='" << colour << "' d='M";
        for (int i = 0; i <= 96; ++i) {
            svg << (i == 0 ? "" : " L") << x(i * 0.005) << ' ' << y(known(i * 0.005));
        }
        svg << "'/>\n<g fill='" << colour << "' stroke='" << colour << "'>";
        for (const measured_fluid& m : all) {
            const with_error value = measured(m), percent = value.relative_to(known(m.packing));
            svg << "<circle r='3' cx='" << x(m.packing) << "' cy='" << y(value.value) << "'/><circle r='2.5' cx='"
                << x(m.packing) + shift << "' cy='" << off(percent.value) << "'/><path d='M" << x(m.packing) + shift
                << ' ' << off(percent.value - percent.error) << 'V' << off(percent.value + percent.error) << "'/>";
        }
        svg << "</g>\n";
    };
    draw(
        "#1f5fa8", "collisions of a ball (line: Enskog)", 40, enskog, [](const auto& m) { return m.rate; }, -3);
    draw(
        "#b03a2e", "excess pressure Z − 1 (line: Carnahan and Starling)", 58, carnahan_starling,
        [](const auto& m) { return m.excess; }, 3);
    svg << "</svg>\n";
    return svg.str();
}
