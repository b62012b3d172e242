// Three bounds of each quantity's rounding error side by side: the compiler's, Gappa's, and the largest error found.
//   error-bounds scripts DIRECTORY        writes the Gappa scripts, each by the formula itself
//   error-bounds table DIRECTORY GAPPA    runs them and prints the table of docs/reference/error-bounds.md
//   error-bounds check DIRECTORY GAPPA    the same with a short search, without the table and Gappa's part for float
// table and check fail unless compiler's >= Gappa's >= found, in every row.
#include "search.hpp"

#include <graze/analysis/error_bound.hpp>

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

template <class Q, int N, int Digits>
constexpr double compiled = [] {
    double worst = 0;
    for (int slice = 0; slice < slices_of<Q>; ++slice) {
        compiled_source<Digits> s;
        worst = std::max(worst, run_slice<Q, N>(s, slice).error * graze::error_bound_slack);
    }
    return worst;
}();

template <class Q, int N, class T>
std::string script(int slice) {
    gappa_source s(std::is_same_v<T, float> ? "1b-23" : "1b-52");
    const auto result = run_slice<Q, N>(s, slice);
    return std::string("# ") + Q::name + ", " + std::to_string(N) + "D, " + graze::number_traits<T>::name +
           (slices_of<Q> > 1 ? ", slice " + std::to_string(slice) : "") + '\n' + s.script(result);
}

struct row {
    std::string name;
    int dimensions;
    std::vector<std::string> parts;
    double compiler, gappa, found; // in double
    double compiler_float, gappa_float, found_float;

    [[nodiscard]] double slack() const { return std::max(compiler / found, compiler_float / found_float); }
};

template <class T>
std::string file_name(const std::string& directory, std::size_t index, int dimensions, int slice) {
    return directory + '/' + (index < 10 ? "0" : "") + std::to_string(index) + '_' + std::to_string(dimensions) + "d_" +
           graze::number_traits<T>::name + '_' + std::to_string(slice) + ".g";
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
    return std::ldexp(significand, exponent) / u * (1 + 0x1p-40);
}

template <class Q, int N>
row row_of(std::size_t index, const std::string& directory, const std::string& gappa, bool with_float, int starts,
           int steps) {
    row r{Q::name, N, {}, compiled<Q, N, 53>, 0, 0, compiled<Q, N, 24>, 0, 0};
    [&]<class... P>(std::tuple<P...>*) { (r.parts.push_back(P::name), ...); }(static_cast<typename Q::parts*>(nullptr));
    if (!gappa.empty()) {
        for (int slice = 0; slice < slices_of<Q>; ++slice) {
            r.gappa = std::max(r.gappa, proved(gappa, file_name<double>(directory, index, N, slice), unit<double>));
            if (with_float) {
                r.gappa_float =
                    std::max(r.gappa_float, proved(gappa, file_name<float>(directory, index, N, slice), unit<float>));
            }
        }
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
        for (int slice = 0; slice < slices_of<Q>; ++slice) {
            write(file_name<double>(directory, index, 2, slice), script<Q, 2, double>(slice));
            write(file_name<double>(directory, index, 3, slice), script<Q, 3, double>(slice));
            write(file_name<float>(directory, index, 2, slice), script<Q, 2, float>(slice));
            write(file_name<float>(directory, index, 3, slice), script<Q, 3, float>(slice));
        }
        ++index;
    });
}

std::vector<row> rows(const std::string& directory, const std::string& gappa, bool with_float, int starts, int steps) {
    std::vector<row> all_rows;
    std::size_t index = 0;
    for_each_quantity([&]<class Q> {
        all_rows.push_back(row_of<Q, 2>(index, directory, gappa, with_float, starts, steps));
        all_rows.push_back(row_of<Q, 3>(index, directory, gappa, with_float, starts, steps));
        ++index;
    });
    std::stable_sort(all_rows.begin(), all_rows.end(),
                     [](const row& x, const row& y) { return x.dimensions < y.dimensions; });
    return all_rows;
}

// Of the steps that lead to r, the one at which bound and found part most.
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
    return std::max(worst, {r.slack() / before, r.name});
}

// Gappa's bound is 0 where it was not asked.
bool in_order(const row& r) {
    const auto ordered = [](double compiler, double gappa, double found) {
        return compiler >= found && (gappa == 0 || (compiler >= gappa && gappa >= found)) && found > 0;
    };
    if (ordered(r.compiler, r.gappa, r.found) && ordered(r.compiler_float, r.gappa_float, r.found_float)) {
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
    std::cout << "| | | double: compiler | Gappa | found | float: compiler | Gappa | found | slack | lost at |\n"
                 "|---|---|--:|--:|--:|--:|--:|--:|--:|---|\n";
    for (const row& r : all_rows) {
        std::cout << "| " << r.name << " | " << r.dimensions << "D | " << shown(r.compiler) << " | " << shown(r.gappa)
                  << " | " << shown(r.found) << " | " << shown(r.compiler_float) << " | " << shown(r.gappa_float)
                  << " | " << shown(r.found_float) << " | " << shown(r.slack()) << " | "
                  << (r.slack() > 4 ? loss(all_rows, r).second : "") << " |\n";
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
    const auto all_rows = rows(arguments[1], gappa, !check, check ? 8 : 80, check ? 40 : 800);
    bool ordered = true;
    for (const row& r : all_rows) {
        ordered = in_order(r) && ordered;
    }
    if (!ordered) {
        std::cout << "a bound is below an error, or one of Gappa's above the compiler's\n";
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
