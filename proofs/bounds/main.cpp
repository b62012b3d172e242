// Three bounds of each quantity's rounding error side by side: the compiler's, Gappa's, and the largest error found.
//   error-bounds scripts DIRECTORY        writes the Gappa scripts, each by the formula itself
//   error-bounds table DIRECTORY GAPPA    runs them and prints the table of docs/reference/error-bounds.md
//   error-bounds check DIRECTORY GAPPA    the same with a short search, without the table
// table and check fail unless compiler's >= Gappa's >= found, in every row, and the compiler's is close to Gappa's.
#include "search.hpp"

#include <graze/predicate/classify_balls.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace {

using namespace bounds;

template <class F>
void for_each_quantity(F f) {
    [&]<class... Q>(std::tuple<Q...>*) { (f.template operator()<Q>(), ...); }(static_cast<all*>(nullptr));
}

// The constants of this table are those of the filters.
template <int N>
constexpr bool are_the_filters = [] {
    using filter = graze::detail::ball_filter<N, double>;
    constexpr double u = graze::error_bound::unit;
    return constant<halved, N, 53> * u == filter::discriminant && constant<h, N, 53> * u == filter::h &&
           constant<c, N, 53> * u == filter::c &&
           constant<lagrange, N, 53> * u ==
               graze::filter_constant(graze::discriminant_lagrange{}, graze::detail::ball_bounds<N, double>::value()) &&
           constant<clearance, N, 53> * u ==
               graze::filter_constant(graze::plane_clearance{}, graze::detail::plane_bounds<N, double>::value());
}();
static_assert(are_the_filters<2> && are_the_filters<3>);

template <class Q, int N, class T>
std::string script() {
    constexpr int digits = std::numeric_limits<T>::digits;
    const std::string unit = "1b-" + std::to_string(digits - 1);
    const std::string title =
        std::string("# ") + Q::name + ", " + std::to_string(N) + "D, " + graze::number_traits<T>::name + '\n';
    if constexpr (requires { Q::template script<N, digits>(unit); }) {
        return title + "#@ -Eprecision=128\n" + Q::template script<N, digits>(unit); // Gappa reads this
    } else {
        gappa_source s(unit);
        const auto result = Q::template run<N>(s);
        return title + s.script(result);
    }
}

// The factor from Gappa's bound to the table's. A time's script is about norms, since the bounds of c, h and D are.
template <class Q, int N>
constexpr double gappa_factor = [] {
    if constexpr (requires { Q::template compiled<N, 53>(); }) {
        return norm_factor<Q, N>;
    } else {
        return 1.0;
    }
}();

// The largest allowed quotient of the compiler's bound and Gappa's. Norms say less than components. In two steps both
// start from the same bounds.
template <class Q, int N>
constexpr double apart = [] {
    if constexpr (requires { Q::template compiled<N, 53>(); }) {
        return 1.125;
    } else {
        return 2.0;
    }
}();

struct row {
    std::string name;
    std::string step; // its last step: how it is made of its parts
    int dimensions;
    std::vector<std::string> parts;
    double at_most;                // for compiler / gappa
    double constant;               // relative to norms, in double
    double compiler, gappa, found; // relative to components, in double
    double compiler_float, gappa_float, found_float;

    [[nodiscard]] double slack() const { return std::max(compiler / found, compiler_float / found_float); }
};

template <class T>
std::string file_name(const std::string& directory, std::size_t index, int dimensions) {
    return directory + '/' + (index < 10 ? "0" : "") + std::to_string(index) + '_' + std::to_string(dimensions) + "d_" +
           graze::number_traits<T>::name + ".g";
}

// The upper end of the interval that Gappa prints, "... in [0, 123b-45 {...}]", in units u.
double proved(const std::string& gappa, const std::string& file, double u) {
    const std::string output = file + ".out";
    if (std::system((gappa + ' ' + file + " > " + output + " 2>&1").c_str()) != 0) {
        throw std::runtime_error("gappa does not prove " + file);
    }
    std::ifstream in(output);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto from = text.find("in [0, ");
    if (from == std::string::npos) {
        throw std::runtime_error("no bound in " + output);
    }
    std::size_t used = 0;
    const double significand = std::stod(text.substr(from + 7), &used);
    const std::string rest = text.substr(from + 7 + used);
    const int exponent = rest.starts_with('b') ? std::stoi(rest.substr(1)) : 0;
    return std::ldexp(significand, exponent) / u * (1 + 0x1p-50);
}

template <class Q, int N>
row row_of(std::size_t index, const std::string& directory, const std::string& gappa, int starts, int steps) {
    row r{Q::name, Q::name, N, {}, apart<Q, N>, constant<Q, N, 53>, compiled<Q, N, 53>, 0, 0, compiled<Q, N, 24>, 0, 0};
    [&]<class... P>(std::tuple<P...>*) { (r.parts.push_back(P::name), ...); }(static_cast<typename Q::parts*>(nullptr));
    if constexpr (requires { Q::step; }) {
        r.step = Q::step;
    }
    if (!gappa.empty()) {
        constexpr double factor = gappa_factor<Q, N>;
        r.gappa = factor * proved(gappa, file_name<double>(directory, index, N), unit<double>);
        r.gappa_float = factor * proved(gappa, file_name<float>(directory, index, N), unit<float>);
    }
    r.found = worst_error<Q, N, double>(starts, steps);
    r.found_float = worst_error<Q, N, float>(starts, steps);
    return r;
}

void write(const std::string& file, const std::string& text) {
    std::ofstream out(file);
    if (!(out << text)) {
        throw std::runtime_error("cannot write " + file);
    }
}

void write_scripts(const std::string& directory) {
    std::size_t index = 0;
    for_each_quantity([&]<class Q> {
        write(file_name<double>(directory, index, 2), script<Q, 2, double>());
        write(file_name<double>(directory, index, 3), script<Q, 3, double>());
        write(file_name<float>(directory, index, 2), script<Q, 2, float>());
        write(file_name<float>(directory, index, 3), script<Q, 3, float>());
        ++index;
    });
}

std::vector<row> rows(const std::string& directory, const std::string& gappa, int starts, int steps) {
    std::vector<row> all_rows;
    std::size_t index = 0;
    for_each_quantity([&]<class Q> {
        all_rows.push_back(row_of<Q, 2>(index, directory, gappa, starts, steps));
        all_rows.push_back(row_of<Q, 3>(index, directory, gappa, starts, steps));
        ++index;
    });
    std::stable_sort(all_rows.begin(), all_rows.end(),
                     [](const row& x, const row& y) { return x.dimensions < y.dimensions; });
    return all_rows;
}

// Of the steps to r, the one at which the bound and the error found diverge most.
std::pair<double, std::string> loss(const std::vector<row>& all_rows, const row& r) {
    double before = 1;
    std::pair<double, std::string> worst{0, ""};
    for (const std::string& part : r.parts) {
        for (const row& p : all_rows) {
            if (p.name == part && p.dimensions == r.dimensions) {
                before = std::max(before, p.slack());
                worst = std::max(worst, loss(all_rows, p));
            }
        }
    }
    return std::max(worst, {r.slack() / before, r.step});
}

// Gappa's bound is 0 if Gappa was not run. The compiler's and Gappa's bounds may be equal up to terms of second order
// in u, where each keeps different ones: a relative 64 u covers them.
bool in_order(const row& r) {
    const auto ordered = [&](double compiler, double gappa, double found, double u) {
        return compiler >= found && found > 0 &&
               (gappa == 0 || (compiler * (1 + 64 * u) >= gappa && gappa >= found && compiler <= r.at_most * gappa));
    };
    if (ordered(r.compiler, r.gappa, r.found, unit<double>) &&
        ordered(r.compiler_float, r.gappa_float, r.found_float, unit<float>)) {
        return true;
    }
    std::cerr << r.name << ", " << r.dimensions << "D: " << r.compiler << ' ' << r.gappa << ' ' << r.found << " / "
              << r.compiler_float << ' ' << r.gappa_float << ' ' << r.found_float << '\n';
    return false;
}

std::string shown(double x) {
    std::ostringstream s;
    s << std::setprecision(3) << x;
    return s.str();
}

void print(const std::vector<row>& all_rows) {
    std::cout << "| | | K | double: compiler | Gappa | found | float: compiler | Gappa | found | slack | lost at |\n"
                 "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|---|\n";
    for (const row& r : all_rows) {
        std::cout << "| " << r.name << " | " << r.dimensions << "D | " << shown(r.constant) << " | "
                  << shown(r.compiler) << " | " << shown(r.gappa) << " | " << shown(r.found) << " | "
                  << shown(r.compiler_float) << " | " << shown(r.gappa_float) << " | " << shown(r.found_float) << " | "
                  << shown(r.slack()) << " | " << (r.slack() > 4 ? loss(all_rows, r).second : "") << " |\n";
    }
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() == 2 && arguments[0] == "scripts") {
        write_scripts(arguments[1]);
        return 0;
    }
    if (arguments.size() < 2 || arguments.size() > 3 || (arguments[0] != "table" && arguments[0] != "check")) {
        throw std::runtime_error("usage: error-bounds scripts|table|check DIRECTORY [GAPPA]");
    }
    const std::string gappa = arguments.size() == 3 ? arguments[2] : "";
    const bool check = arguments[0] == "check";
    write_scripts(arguments[1]);
    const auto all_rows = rows(arguments[1], gappa, check ? 8 : 80, check ? 40 : 800);
    bool ordered = true;
    for (const row& r : all_rows) {
        ordered = in_order(r) && ordered;
    }
    if (!ordered) {
        std::cout << "a bound is below an error, or one of Gappa's above the compiler's or far below it\n";
    } else if (gappa.empty()) {
        std::cout << "SKIPPED: no gappa; the compiler's bounds are at least the errors found\n";
    } else if (!check) {
        print(all_rows);
    }
    return ordered ? 0 : 1;
}

} // namespace

int main(int count, char** arguments) {
    try {
        return run({arguments + 1, arguments + count});
    } catch (const std::exception& e) {
        std::cerr << "error-bounds: " << e.what() << '\n';
        return 2;
    }
}
