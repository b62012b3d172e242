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
// position: of the centres at contact. velocity: of the balls after it.
enum class quantity { discriminant, time, crossing, position, velocity };
inline constexpr std::array<const char*, 5> quantity_names = {"discriminant", "time", "crossing", "position",
                                                              "velocity"};
inline constexpr std::array<const char*, 5> quantity_words = {"the discriminant", "the time at which two balls touch",
                                                              "the time at which a ball touches what stands",
                                                              "the positions", "the velocities"};
inline constexpr std::size_t quantity_count = quantity_names.size();

// The shares of the values whose error is at most quantiles[i].
inline constexpr std::array<double, 9> quantile_shares = {0.0, 0.05, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 1.0};

// Errors |computed - exact| against the exact real value, in fractional units of the last place that the exact value
// has as a double: 2^(floor(log2|exact|) - 52), for any exponent. For a vector: the largest component's error, in units
// of the last place of the exact vector's largest component (of both balls' vectors together).
struct error_statistics {
    std::size_t count = 0;             // values measured; those of not_finite are among them, those of unscaled not
    std::size_t exact = 0;             // of these without any error
    std::size_t correctly_rounded = 0; // of these: the nearest double of the computed value is that of the exact one
    std::size_t not_finite = 0;        // a NaN, an infinity or nothing where a number was due; error infinite
    std::size_t unscaled = 0;          // the exact value is 0, the computed one is not
    double median = 0;                 // units of the last place
    double largest = 0;                // units of the last place; may be infinite
    double median_bits = 0;            // correct bits, -log2(|computed - exact|/|exact|); infinite when without error
    double fewest_bits = 0;            // the worst value's
    std::array<double, quantile_shares.size()> quantiles{}; // units of the last place
    std::map<int, std::size_t> histogram; // b -> errors in [2^b, 2^(b+1)) units of the last place; finite, not zero
};

// By how much a conserved quantity changes in the collision: |after - before| over the sum of the magnitudes before,
// from exact sums of the computed velocities.
struct defect_statistics {
    std::size_t count = 0;
    std::size_t zero = 0;
    double median = 0;
    double largest = 0;
};

// Decisions that differ from the truth. A pair is counted once, in the first that applies.
struct decision_counts {
    std::size_t evaluated = 0;
    std::size_t undecided = 0;   // the type said that it cannot tell (intervals)
    std::size_t approaching = 0; // wrong on whether the two come closer
    std::size_t overlap = 0;     // wrong on whether they overlap
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
    // Errors in units of the last place; absent where nothing was measured. A time is τ or the crossing, by kind.
    std::optional<double> time_median, time_largest;
    std::optional<double> discriminant_median, discriminant_largest;
};

// Where a pair has no error of its time.
inline constexpr float dot_absent = -1.0F; // no time is due, or the pair was not measured
inline constexpr float dot_wrong = -2.0F, dot_open = -3.0F;

// A pair on which a row is at its worst.
struct extreme_pair {
    std::string what;        // a quantity, or a kind of wrong decision: "approaching", "overlap", "hit_or_miss", ...
    std::string which;       // of a quantity "largest"; of a wrong decision "nearest" and "farthest", from the border
    std::size_t pair = 0;    // its number, as in pair_information
    double error = 0;        // of a quantity, units of the last place; infinite where there is no finite number
    std::string right, said; // the true answer and the type's
};

// One number type in one variant of the formulas on one group of pairs.
struct row {
    std::string type;    // type_information::name
    std::string variant; // "textbook", "halved", "kahan", "lagrange"
    std::string root;    // "printed", "stable"
    std::string group;   // group_information::name
    decision_counts decisions;
    std::array<error_statistics, quantity_count> errors; // of pairs whose decision is right; D of all balls' pairs
    error_statistics width;       // intervals only: the width of τ and crossings, in the same units
    std::size_t not_enclosed = 0; // intervals only: values outside the interval that should hold them
    defect_statistics momentum, energy;
    std::optional<double> nanoseconds;                // of a whole solve: median of the repeats
    double nanoseconds_low = 0, nanoseconds_high = 0; // the quartiles of the repeats
    std::size_t timed_pairs = 0, repeats = 0;
    std::vector<double> repeated; // nanoseconds of each repeat, in the order of measurement
    std::vector<cell> cells;
    std::vector<extreme_pair> extremes;
    // The error of τ or the crossing of each pair, in the order of group_information::places; in units of the last
    // place, or a dot_* below. A report draws them; the JSON leaves them out.
    std::vector<float> dots;
    bool on_front = false; // in this group nothing is both faster and better (wrong decisions, then the largest error)
    [[nodiscard]] const error_statistics& error(quantity q) const { return errors[static_cast<std::size_t>(q)]; }
    [[nodiscard]] error_statistics& error(quantity q) { return errors[static_cast<std::size_t>(q)]; }
};

struct missing_type {
    std::string name, reason;
};

// How hard the pairs of one group, kind and hardness are by themselves: relative condition numbers, the sum of
// |input ∂f/∂input|/|f| over all coordinates, radii and so on. An error of κ/2 units of the last place or so is what
// rounding the inputs alone would do.
struct conditioning {
    std::string kind;
    int hardness = -1;
    std::size_t count = 0;
    std::optional<double> time_median, time_largest;
    std::optional<double> discriminant_median, discriminant_largest;
};

// A number of a pair: exact decimals or a fraction, and the hexadecimal float where it is a double.
struct named_number {
    std::string name, decimal, hexadecimal;
};

// A pair that some row is at its worst on.
struct pair_information {
    std::size_t number = 0; // for --pair: counted over all groups from 1 on
    std::string name;       // "ball 3 and wall 0"; of a family "pair 17"
    std::string kind;       // "ball_ball", "ball_plane", "ball_wall", "ball_triangle"
    int hardness = -1;
    std::string encounter; // in truth
    std::string time;      // in decimals; empty where there is none
    double border = 0;     // the relative distance from where the decision changes
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
    std::size_t pairs_of = 0;                      // of how many: more when sampled
    std::map<std::string, std::size_t> kinds;      // "ball_ball" -> pairs
    std::map<std::string, std::size_t> encounters; // "overlap", "recede", "miss", "graze", "hit" -> pairs, in truth
    std::string hardness_name;                     // what k means ("bits lost"), empty where no pair has one
    std::vector<conditioning> conditions;
    std::vector<pair_information> shown; // the extremes of its rows, by number
    std::vector<pair_place> places;      // of all pairs; the JSON leaves them out
};

// A choice of type, variant and root, over all groups.
struct choice {
    std::string type, variant, root;
    double nanoseconds = 0; // the mean of the groups, weighted by their pairs
};

// The cheapest choice without a wrong or open decision whose every time is right to so many decimal digits: relative
// error at most 10^-digits. Empty where none is.
struct digits_wanted {
    int digits = 0;
    std::optional<choice> cheapest;
};

struct machine_information {
    std::string processor, compiler, flags, system, date, graze;
};

struct results {
    std::string command; // the arguments as they were typed, program name first; empty where unknown
    std::string program; // how the user calls it: "graze-compare"
    std::string inputs;  // the options that choose the pairs, quoted for a shell, each after a space
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
    std::vector<digits_wanted> matrix;        // by rising digits, --digits among them
    std::optional<choice> good_enough, exact; // the answer
    std::string sentence;                     // the same in words
};

} // namespace compare
