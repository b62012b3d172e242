// The results of a comparison: plain data, which the table, the JSON file, the report and the diff all read.
// docs/reference/compare-json.md describes the same fields as JSON.
#pragma once

#include "type_information.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace compare {

inline constexpr int schema_version = 2;

// discriminant: D. time: τ of two balls. crossing: the time at which a ball meets a plane, a wall or a triangle.
// position: of the centres at the contact. velocity: of the balls after the contact.
enum class quantity { discriminant, time, crossing, position, velocity };
inline constexpr std::array<const char*, 5> quantity_names = {"discriminant", "time", "crossing", "position",
                                                              "velocity"};
inline constexpr std::array<const char*, 5> quantity_words = {"the discriminant", "the time at which two balls touch",
                                                              "the time at which a ball touches a plane or wall",
                                                              "the positions", "the velocities"};
inline constexpr std::size_t quantity_count = quantity_names.size();

// quantiles[i] is an error that this share of the values does not exceed.
inline constexpr std::array<double, 9> quantile_shares = {0.0, 0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 1.0};

// Errors |computed - exact| against the exact real value, in fractional units of the last place that the exact value
// has as a double: 2^(floor(log2|exact|) - 52), for any exponent. For a vector: the largest component's error, in units
// of the last place of the exact vector's largest component (of both balls' vectors together).
struct error_statistics {
    std::size_t count = 0;             // values measured, including not_finite, not including unscaled
    std::size_t exact = 0;             // those of them without any error
    std::size_t correctly_rounded = 0; // those of them whose nearest double is that of the exact value
    std::size_t not_finite = 0;        // a NaN, an infinity or nothing where a number was due; error infinite
    std::size_t unscaled = 0;          // the exact value is 0, the computed one is not
    double median = 0;                 // units of the last place
    double largest = 0;                // units of the last place; may be infinite
    double median_bits = 0;            // correct bits, -log2(|computed - exact|/|exact|); infinite without an error
    double fewest_bits = 0;            // correct bits of the worst value
    std::array<double, quantile_shares.size()> quantiles{}; // units of the last place
    std::map<int, std::size_t> histogram; // b -> errors in [2^b, 2^(b+1)) units of the last place; finite, not zero
};

// The change of a conserved quantity in the collision, from exact sums of the computed velocities: |after - before|
// over the sum of the magnitudes before.
struct defect_statistics {
    std::size_t count = 0;
    std::size_t zero = 0;
    double median = 0;
    double largest = 0;
};

// Decisions that differ from the truth. A pair counts once, in the first of these that applies.
struct decision_counts {
    std::size_t evaluated = 0;
    std::size_t undecided = 0;   // the type said that it cannot tell (intervals)
    std::size_t approaching = 0; // wrong about whether the two come closer
    std::size_t overlap = 0;     // wrong about whether they overlap
    std::size_t hit_or_miss = 0; // wrong among miss, graze and hit
    std::size_t feature = 0;     // right encounter, but with another face, edge or corner
    std::size_t failed = 0;      // no answer: the type threw (overflow, division by zero)
    [[nodiscard]] std::size_t wrong() const { return approaching + overlap + hit_or_miss + feature + failed; }
};

// Part of a row: the pairs of one kind and one hardness.
struct cell {
    std::string kind;  // "ball_ball", "ball_plane", "ball_wall", "ball_triangle"
    int hardness = -1; // the family's k; -1 where there is none
    std::size_t evaluated = 0, wrong = 0, undecided = 0;
    // Errors in units of the last place; absent if nothing was measured. A time is τ or the crossing, by kind.
    std::optional<double> time_median, time_largest;
    std::optional<double> discriminant_median, discriminant_largest;
};

// Instead of an error, for pairs whose time has none.
inline constexpr float dot_absent = -1.0F; // there is no time, or the pair was not measured
inline constexpr float dot_wrong = -2.0F, dot_open = -3.0F;

// A pair on which a row is at its worst.
struct extreme_pair {
    std::string what;        // a quantity or a kind of wrong decision: "approaching", "overlap", "hit_or_miss", ...
    std::string which;       // of a quantity "largest"; of a wrong decision "nearest" or "farthest" from the border
    std::size_t pair = 0;    // its number, as in pair_information
    double error = 0;        // of a quantity, in units of the last place; infinite if it is not a finite number
    std::string right, said; // the true answer and the type's
};

// One number type in one variant of the formulas on one group of pairs.
struct row {
    std::string type;    // type_information::name
    std::string variant; // "textbook", "halved", "kahan", "lagrange"
    std::string root;    // "printed", "stable"
    std::string group;   // group_information::name
    decision_counts decisions;
    std::array<error_statistics, quantity_count> errors; // of pairs decided correctly; D of all pairs of balls
    error_statistics width;       // intervals only: the width of τ and crossings, in the same units
    std::size_t not_enclosed = 0; // intervals only: values outside the interval that should hold them
    defect_statistics momentum, energy;
    std::optional<double> nanoseconds;                // of a whole solve: median of the repeats
    double nanoseconds_low = 0, nanoseconds_high = 0; // the quartiles of the repeats
    std::size_t timed_pairs = 0, repeats = 0;
    std::vector<double> repeated; // nanoseconds of each repeat, in the order of measurement
    std::vector<cell> cells;
    std::vector<extreme_pair> extremes;
    // The error of each pair's τ or crossing in units of the last place, in the order of group_information::places, or
    // a dot_* above. For the report; not in the JSON.
    std::vector<float> dots;
    bool on_front = false; // nothing in the group is both faster and better (decisions first, then errors)
    [[nodiscard]] const error_statistics& error(quantity q) const { return errors[static_cast<std::size_t>(q)]; }
    [[nodiscard]] error_statistics& error(quantity q) { return errors[static_cast<std::size_t>(q)]; }
};

struct missing_type {
    std::string name, reason;
};

// How hard the pairs of one group, kind and hardness are in themselves: the relative condition number κ, which is the
// sum of |input ∂f/∂input|/|f| over all coordinates, radii and so on. Rounding the inputs alone makes an error of about
// κ/2 units of the last place.
struct conditioning {
    std::string kind;
    int hardness = -1;
    std::size_t count = 0;
    std::optional<double> time_median, time_largest;
    std::optional<double> discriminant_median, discriminant_largest;
};

// A number of a pair: an exact decimal or a fraction and, if it is a double, the hexadecimal float.
struct named_number {
    std::string name, decimal, hexadecimal;
};

// A pair on which some row is at its worst.
struct pair_information {
    std::size_t number = 0; // for --pair: counted across all groups, from 1
    std::string name;       // "ball 3 and wall 0"; of a family "pair 17"
    std::string kind;       // "ball_ball", "ball_plane", "ball_wall", "ball_triangle"
    int hardness = -1;
    std::string encounter; // the true one
    std::string time;      // the true one, in decimals; empty if there is none
    double border = 0;     // the relative distance from the nearest border
    std::vector<named_number> numbers;
    std::string scene; // a scene file with this pair alone
};

// Where a pair's dot stands in the report.
struct pair_place {
    std::size_t number = 0;
    std::string name;
    int hardness = -1;
    std::optional<double> time;
    double border = 0;
};

struct group_information {
    std::string name;
    std::string description; // what the scene is, or what makes the family hard
    int dimension = 0;
    std::size_t pairs = 0;                         // measured
    std::size_t pairs_of = 0;                      // the pairs that these were drawn from
    std::map<std::string, std::size_t> kinds;      // "ball_ball" -> pairs
    std::map<std::string, std::size_t> encounters; // "overlap", "recede", "miss", "graze", "hit" -> pairs, in truth
    std::string hardness_name;                     // what k means ("bits lost"); empty if no pair has one
    std::vector<conditioning> conditions;
    std::vector<pair_information> shown; // those on which a row is at its worst, by number
    std::vector<pair_place> places;      // of all pairs; not in the JSON
};

// A choice of type, variant and root, over all groups.
struct choice {
    std::string type, variant, root;
    double nanoseconds = 0; // the mean over the groups, weighted by their pairs
};

// The cheapest choice without wrong or open decisions whose times are all right to this many decimal digits: relative
// error at most 10^-digits. Empty if there is none.
struct digits_wanted {
    int digits = 0;
    std::optional<choice> cheapest;
};

struct machine_information {
    std::string processor, compiler, flags, system, date, graze;
};

struct results {
    std::string command; // the arguments as typed, program name first; empty if unknown
    std::string program; // how the user calls it: "graze-compare"
    std::string inputs;  // the options that select the pairs, quoted for a shell, each after a space
    machine_information machine;
    std::string source; // the scene file, the family, or "default"
    std::string as;     // "double" or "exact"
    unsigned long long seed = 0;
    int digits = 15; // --digits
    double seconds = 0;
    std::vector<group_information> groups;
    std::vector<type_information> types;
    std::vector<missing_type> missing;
    std::vector<row> rows;
    std::vector<digits_wanted> matrix;        // by increasing digits, --digits among them
    std::optional<choice> good_enough, exact; // the answer
    std::string sentence;                     // the same in words
};

} // namespace compare
