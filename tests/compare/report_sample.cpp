#include "report_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace compare;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct family {
    const char* name;
    const char* hardness_name;
    int first, last;
    double time_slope, discriminant_slope; // bits of condition for each step of k
    bool lagrange_helps;
};

const std::vector<family> families = {
    {"pool <script>alert(1)</script> & 'break' \"~3~\"\nset output 'x'", "", -1, -1, 0, 0, true},
    {"grazing", "k of (R² − m²)/R² = 2⁻ᵏ", 1, 53, 0.5, 1, true},
    {"far", "k of distance/R = 2ᵏ", 1, 48, 1, 2, true},
    {"near_contact", "k of gap/R = 2⁻ᵏ", 1, 56, 1, 0, false},
};

type_information type_of(const char* name, const char* library, int digits, std::size_t bytes, bool heap = false) {
    type_information t;
    t.name = name, t.library = library, t.digits = digits, t.bytes = t.real_bytes = bytes, t.uses_heap = heap;
    t.has_sqrt = digits > 0, t.is_exact = digits == 0;
    return t;
}

double cost_of(const std::string& type) {
    const std::vector<std::pair<std::string, double>> costs = {{"float", 14},
                                                               {"double", 18},
                                                               {"long double", 46},
                                                               {"float128", 1900},
                                                               {"dd_real", 310},
                                                               {"cpp_bin_float_50", 9000},
                                                               {"mpfr_float_50", 6100},
                                                               {"cpp_dec_float_50", 21000},
                                                               {"cpp_bin_float_100", 15000},
                                                               {"Interval_nt", 120},
                                                               {"Lazy_exact_nt", 5200},
                                                               {"cpp_rational", 250000},
                                                               {"mpq_rational", 61000},
                                                               {"mpq_class", 48000},
                                                               {"Gmpq", 66000},
                                                               {"CORE::Expr", 90000}};
    for (const auto& [name, ns] : costs) {
        if (name == type) {
            return ns;
        }
    }
    return 100;
}

// The error of a value with the condition number 2^condition, in units of the last place of a double.
double error_of(const type_information& t, double condition) {
    return t.is_exact ? 0 : std::exp2(52 - t.digits + condition);
}

error_statistics errors_of(const type_information& t, double condition, std::size_t count) {
    error_statistics e;
    e.count = count;
    e.largest = error_of(t, condition), e.median = error_of(t, condition / 2 - 1);
    e.fewest_bits = t.is_exact ? infinite : 52 - std::log2(e.largest);
    e.median_bits = t.is_exact ? infinite : 52 - std::log2(e.median);
    if (t.is_exact) {
        e.exact = e.correctly_rounded = count;
        return e;
    }
    e.exact = count / 10;
    e.correctly_rounded = e.largest < 1 ? count : count / 6;
    const int lowest = static_cast<int>(std::floor(std::log2(e.median))) - 6;
    const int highest = static_cast<int>(std::floor(std::log2(e.largest)));
    const auto bins = static_cast<std::size_t>(highest - lowest + 1);
    for (int b = lowest; b <= highest; ++b) {
        e.histogram[b] = (count - e.exact) / bins;
    }
    for (std::size_t i = 0; i < quantile_shares.size(); ++i) {
        e.quantiles[i] = quantile_shares[i] <= 0.1 ? 0 : error_of(t, condition * quantile_shares[i]);
    }
    return e;
}

constexpr std::size_t pairs_of_a_group = 60;

std::size_t number_of(const family& f, std::size_t i) {
    return static_cast<std::size_t>(&f - families.data()) * pairs_of_a_group + i + 1;
}

// The first pair is each row's worst; the second is decided wrongly.
void add_pairs(row& r, const type_information& t, const family& f) {
    for (std::size_t i = 0; i < pairs_of_a_group; ++i) {
        const double error = error_of(t, static_cast<double>(i % 17) / 2);
        r.dots.push_back(i == 1 && !t.is_exact ? dot_wrong : i % 5 == 4 ? dot_absent : static_cast<float>(error));
    }
    if (!t.is_exact) {
        r.extremes = {{"time", "largest", number_of(f, 0), error_of(t, 9), "1.25", "1.26"},
                      {"hit_or_miss", "nearest", number_of(f, 1), 0, "hit", "<miss>"}};
    }
}

row row_of(const type_information& t, const std::string& variant, const std::string& root, const family& f) {
    row r;
    r.type = t.name, r.variant = variant, r.root = root, r.group = f.name;
    const double variant_cost = variant == "textbook" ? 1
                                : variant == "halved" ? 0.92
                                : variant == "kahan"  ? 1.2
                                                      : 1.35;
    r.nanoseconds = cost_of(t.name) * variant_cost * (root == "printed" ? 1.03 : 1);
    r.nanoseconds_low = *r.nanoseconds * 0.97, r.nanoseconds_high = *r.nanoseconds * 1.05;
    r.timed_pairs = 256, r.repeats = 9;
    r.decisions.evaluated = 2000;
    const bool helped = variant == "lagrange" && f.lagrange_helps;
    double worst = 2;
    for (int k = f.first; k <= f.last && f.first > 0; ++k) {
        cell c;
        c.kind = "ball_ball", c.hardness = k, c.evaluated = 40;
        const double lost = (helped ? 0.3 : 1) * f.discriminant_slope * k;
        const double time_lost = f.time_slope * k * (helped ? 0.6 : 1) + 1;
        c.wrong = !t.is_exact && lost > t.digits - 1 ? 17 : 0;
        c.undecided = t.is_interval && lost > 45 ? 12 : 0;
        c.wrong = t.is_interval ? 0 : c.wrong;
        r.decisions.hit_or_miss += c.wrong, r.decisions.undecided += c.undecided;
        if (c.wrong == 0) {
            c.time_largest = error_of(t, time_lost), c.time_median = error_of(t, time_lost - 2);
            c.discriminant_largest = error_of(t, lost + 1), c.discriminant_median = error_of(t, lost - 1);
            worst = std::max(worst, time_lost);
        }
        r.cells.push_back(c);
    }
    r.error(quantity::time) = errors_of(t, worst, 1200);
    r.error(quantity::discriminant) = errors_of(t, worst + 1, 2000);
    r.error(quantity::position) = errors_of(t, worst / 2, 1200);
    r.error(quantity::velocity) = errors_of(t, worst / 2 + 2, 1200);
    add_pairs(r, t, f);
    r.momentum = {1200, 700, t.is_exact ? 0 : 1e-17, t.is_exact ? 0 : 3e-16};
    r.energy = {1200, 100, t.is_exact ? 0 : 1e-16, t.is_exact ? 0 : 9e-15};
    return r;
}

group_information group_of(const family& f) {
    group_information g;
    g.name = f.name, g.description = "What makes it hard <b>is</b> said here & there.", g.dimension = 2;
    g.pairs = 2000, g.pairs_of = 124750, g.hardness_name = f.hardness_name;
    g.kinds = {{"ball_ball", 2000}};
    g.encounters = {{"recede", 1000}, {"miss", 400}, {"graze", 100}, {"hit", 500}};
    for (std::size_t i = 0; i < pairs_of_a_group; ++i) {
        const int k = f.first > 0 ? f.first + static_cast<int>(i) % (f.last - f.first + 1) : -1;
        g.places.push_back({number_of(f, i), "ball <" + std::to_string(i) + "> and wall 0", k,
                            i % 5 == 4 ? std::nullopt : std::optional(0.1 * static_cast<double>(i + 1)),
                            std::exp2(-static_cast<double>(i))});
    }
    for (std::size_t i = 0; i < 2; ++i) {
        pair_information p;
        p.number = number_of(f, i), p.name = g.places[i].name, p.kind = "ball_ball", p.hardness = g.places[i].hardness;
        p.encounter = "hit", p.time = "1.25", p.border = g.places[i].border;
        p.numbers = {{"a position", "1, 0", "0x1p+0, 0x0p+0"}};
        p.scene =
            R"({"dimension": 2, "name": "a </script> pair", "balls": [{"position": ["0x1p+0", "0x0p+0"], "velocity":
            ["1/3", "0x0p+0"], "radius": "0x1p-1", "mass": "inf"}]})";
        g.shown.push_back(p);
    }
    for (int k = f.first; k <= f.last && f.first > 0; ++k) {
        conditioning c;
        c.kind = "ball_ball", c.hardness = k, c.count = 40;
        c.time_largest = std::exp2(f.time_slope * k + 3), c.time_median = std::exp2(f.time_slope * k + 1);
        c.discriminant_largest = std::exp2(f.discriminant_slope * k + 3);
        c.discriminant_median = std::exp2(f.discriminant_slope * k + 1);
        g.conditions.push_back(c);
    }
    return g;
}

} // namespace

results sample_results() {
    results found;
    found.program = "graze-compare", found.inputs = " 'a <scene>.json'";
    found.command = "graze-compare --report report.html \"a <scene>.json\"";
    found.machine = {"Intel(R) Xeon(R) Processor", "g++ 12.2.0", "-O2", "Linux x86_64", "2025-11-22", "0.1.0"};
    found.source = "default", found.as = "double", found.seed = 1, found.seconds = 73;
    found.types = {type_of("float", "built in", 24, 4),
                   type_of("double", "built in", 53, 8),
                   type_of("long double", "built in", 64, 16),
                   type_of("float128", "GCC", 113, 16),
                   type_of("dd_real", "QD", 104, 16),
                   type_of("cpp_bin_float_50", "Boost", 168, 40),
                   type_of("mpfr_float_50", "MPFR", 167, 64),
                   type_of("cpp_dec_float_50", "Boost", 182, 48),
                   type_of("cpp_bin_float_100", "Boost", 334, 64),
                   type_of("Interval_nt", "CGAL", 53, 16),
                   type_of("Lazy_exact_nt", "CGAL", 0, 8, true),
                   type_of("cpp_rational", "Boost", 0, 64, true),
                   type_of("mpq_rational", "Boost", 0, 32, true),
                   type_of("mpq_class", "GMP", 0, 32, true),
                   type_of("Gmpq", "CGAL", 0, 8, true),
                   type_of("CORE::Expr", "CGAL", 0, 8, true)};
    found.types[9].is_interval = true;
    found.missing = {{"a <missing> type", "its library is not installed"}};
    for (const auto& f : families) {
        found.groups.push_back(group_of(f));
        for (const auto& t : found.types) {
            for (const char* variant : {"textbook", "halved", "kahan", "lagrange"}) {
                if (std::string(variant) == "kahan" && (t.is_exact || t.is_interval)) {
                    continue;
                }
                found.rows.push_back(row_of(t, variant, "printed", f));
                found.rows.push_back(row_of(t, variant, "stable", f));
            }
        }
    }
    for (const int digits : {3, 6, 9, 12, 15, 18, 30, 50, 90}) {
        const char* type = digits <= 15   ? "dd_real"
                           : digits <= 30 ? "float128"
                           : digits <= 30 ? "cpp_bin_float_50"
                                          : "cpp_bin_float_100";
        found.matrix.push_back({digits, choice{type, "lagrange", "stable", cost_of(type) * 1.35}});
    }
    found.matrix.push_back({120, std::nullopt});
    found.good_enough = choice{"dd_real", "lagrange", "stable", 418};
    found.exact = choice{"Lazy_exact_nt", "halved", "stable", 4784};
    found.sentence = "On <this> scene the cheapest type with no wrong decision and τ good to 15 digits is dd_real "
                     "(lagrange, stable root) at 418 ns; the cheapest exact one is Lazy_exact_nt at 4.8 µs.";
    return found;
}
