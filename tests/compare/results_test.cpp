// Results to JSON and back, the conclusions from them, and the differences between two results.
#include "answer.hpp"
#include "diff.hpp"
#include "input_error.hpp"
#include "json_results.hpp"
#include "report_sample.hpp"
#include "significance.hpp"
#include "whole_file.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace compare;

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

class temporary_file {
  public:
    temporary_file() {
        const int file = mkstemp(path.data());
        REQUIRE(file >= 0);
        close(file);
    }
    temporary_file(const temporary_file&) = delete;
    temporary_file& operator=(const temporary_file&) = delete;
    ~temporary_file() { std::filesystem::remove(path); }

    std::string path = (std::filesystem::temp_directory_path() / "graze-results-XXXXXX").string();
};

std::string error_of(const std::string& text) {
    const temporary_file file;
    write_whole_file(file.path, text);
    try {
        static_cast<void>(read_results(file.path));
    } catch (const input_error& error) {
        return std::string(error.what()).substr(file.path.size());
    }
    return "";
}

row row_of(const char* type, const char* variant, double nanoseconds, std::size_t wrong, double largest, double bits) {
    row r;
    r.type = type;
    r.variant = variant;
    r.root = "stable";
    r.group = "g";
    r.decisions.evaluated = 100;
    r.decisions.hit_or_miss = wrong;
    r.nanoseconds = nanoseconds;
    error_statistics& e = r.error(quantity::time);
    e.count = 50;
    e.exact = largest == 0 ? 50 : 0;
    e.largest = largest;
    e.fewest_bits = bits;
    return r;
}

results small_results() {
    results found;
    found.digits = 15;
    found.groups.push_back({});
    found.groups[0].name = "g";
    found.groups[0].pairs = 100;
    found.groups[0].encounters = {{"miss", 50}, {"hit", 50}};
    type_information binary, rational;
    binary.name = "double";
    rational.name = "rational";
    rational.is_exact = true;
    found.types = {binary, rational};
    found.rows = {row_of("double", "textbook", 10, 3, 40, 47), row_of("double", "lagrange", 20, 0, 2, 51),
                  row_of("double", "kahan", 25, 0, 2, 51), row_of("rational", "halved", 900, 0, 0, unbounded),
                  row_of("rational", "lagrange", 800, 0, 0, unbounded)};
    return found;
}

} // namespace

TEST_CASE("what is written is read again") {
    results found = sample_results();
    found.rows[0].error(quantity::time).largest = unbounded;
    found.rows[0].error(quantity::time).fewest_bits = -unbounded;
    found.rows[0].nanoseconds.reset();
    const std::string text = to_json(found);
    const temporary_file file;
    write_whole_file(file.path, text);
    const results again = read_results(file.path);
    CHECK(to_json(again) == text);
    CHECK(again.rows.size() == found.rows.size());
    CHECK(again.rows[0].error(quantity::time).largest == unbounded);
    CHECK_FALSE(again.rows[0].nanoseconds);
    CHECK(again.rows[1].nanoseconds == found.rows[1].nanoseconds);
    CHECK(again.groups[0].name == found.groups[0].name);
    const difference none = compare_results(found, again);
    CHECK(none.worse.empty());
    CHECK(none.same == found.rows.size());
}

TEST_CASE("files that are no results say where they are wrong") {
    CHECK(error_of("{").find("line 1") != std::string::npos);
    CHECK(error_of("[]") == ": an object expected");
    CHECK(error_of("{}") == ": the key \"schema\" is missing");
    CHECK(error_of(R"({"schema": "other"})") == ": /schema: \"graze-compare\" expected: not a comparison");
    CHECK(error_of(R"({"schema": "graze-compare", "version": 3})") == ": /version: versions 1 to 2 can be read, not 3");
    std::string text = to_json(small_results());
    const auto place = text.find("\"pairs\": 100");
    REQUIRE(place != std::string::npos);
    text.replace(place, 12, "\"pairs\": -1");
    CHECK(error_of(text) == ": /groups/0/pairs: not a whole number in range");
    CHECK_THROWS_AS(static_cast<void>(read_results("/nonexistent/file.json")), input_error);
}

TEST_CASE("the answer is the cheapest that is good enough, and the cheapest with exact values") {
    results found = small_results();
    draw_conclusions(found);
    REQUIRE(found.good_enough);
    CHECK(found.good_enough->type == "double");
    CHECK(found.good_enough->variant == "lagrange");
    REQUIRE(found.exact);
    CHECK(found.exact->variant == "lagrange");
    CHECK(found.sentence ==
          "The cheapest type with no wrong decision and every time right to 15 digits is double "
          "(lagrange, stable root, 20.0 ns a pair); the cheapest with exact values is rational (lagrange, "
          "stable root, 800 ns a pair).");
    const std::vector<bool> front = {true, true, false, false, true};
    for (std::size_t i = 0; i < front.size(); ++i) {
        CHECK(found.rows[i].on_front == front[i]);
    }
    found.digits = 16; // 51 bits are 15.35 digits
    draw_conclusions(found);
    CHECK(found.good_enough->type == "rational");
    CHECK(found.sentence.find("rational (lagrange, stable root, 800 ns a pair), and its values are exact.") !=
          std::string::npos);
    found.rows.resize(1);
    draw_conclusions(found);
    CHECK_FALSE(found.good_enough);
    CHECK_FALSE(found.exact);
    CHECK(found.matrix.front().digits == 3);
    CHECK_FALSE(found.matrix.front().cheapest);
}

TEST_CASE("an open decision is none, and a type must have been tried everywhere") {
    results found = small_results();
    found.rows[1].decisions.undecided = 1;
    draw_conclusions(found);
    CHECK(found.good_enough->variant == "kahan");
    found.groups.push_back({});
    found.groups[1].name = "other";
    draw_conclusions(found);
    CHECK_FALSE(found.good_enough);
}

namespace {

std::string told(const change& c) { return c.row + ": " + c.what + " " + c.before + " -> " + c.after; }

// Fifteen repeats around a time, not sorted by size.
std::vector<double> repeats_about(double time) {
    std::vector<double> all;
    for (int i = 0; i < 15; ++i) {
        all.push_back(time * (1 + 0.002 * (i * 7 % 15)));
    }
    return all;
}

} // namespace

TEST_CASE("differences") {
    const results before = small_results();
    results after = before;
    CHECK(compare_results(before, after).same == 5);
    after.rows[1].decisions.overlap = 1;
    after.rows[0].error(quantity::time).largest = 39.5;
    difference d = compare_results(before, after);
    REQUIRE(d.worse.size() == 1);
    CHECK(told(d.worse[0]) == "g: double lagrange/stable: wrong on overlap 0 -> 1");
    REQUIRE(d.better.size() == 1);
    CHECK(told(d.better[0]) == "g: double textbook/stable: time, largest error 40.0 -> 39.5");
    after = before;
    after.rows[2].error(quantity::time).median = 0.75;
    CHECK(compare_results(before, after).worse.size() == 1);
    after = before;
    after.rows[3].decisions.evaluated = 90;
    after.rows[4].type = "another";
    d = compare_results(before, after);
    CHECK(d.compared == 3);
    CHECK(d.not_comparable.size() == 1);
    CHECK(d.only_old.size() == 1);
    CHECK(d.only_new.size() == 1);
}

TEST_CASE("what moved most comes first, and figures that print alike get more digits") {
    results before = small_results();
    before.rows[0].error(quantity::time).largest = 1.9e12;
    results after = before;
    after.rows[0].error(quantity::time).largest = 1.901e12;
    after.rows[1].error(quantity::time).largest = 200;
    const difference d = compare_results(before, after);
    REQUIRE(d.worse.size() == 2);
    CHECK(told(d.worse[0]) == "g: double lagrange/stable: time, largest error 2.00 -> 200");
    CHECK(told(d.worse[1]) == "g: double textbook/stable: time, largest error 1.9e+12 -> 1.901e+12");
}

TEST_CASE("other settings are told first") {
    const results before = small_results();
    results after = before;
    after.as = "exact", after.seed = 7, after.source = "elsewhere", after.machine.compiler = "another";
    after.groups[0].encounters["hit"] = 3;
    const std::string text = to_text(compare_results(before, after));
    CHECK(text.starts_with("The settings differ."));
    for (const char* said : {"--as: none -> exact", "--seed: 0 -> 7", "source: none -> elsewhere",
                             "pairs of g: the same number of other pairs", "compiler: none -> another"}) {
        CAPTURE(said);
        CHECK(text.find(said) != std::string::npos);
    }
    CHECK(text.find("settings differ") < text.find("rows compared"));
    CHECK(to_text(compare_results(before, before)).starts_with("5 rows compared: 5 the same"));
}

TEST_CASE("times differ where their repeats do, less what the whole machine does") {
    results before = small_results();
    for (row& r : before.rows) {
        r.repeated = repeats_about(*r.nanoseconds);
    }
    results after = before;
    CHECK(compare_results(before, after).slower.empty());
    CHECK(compare_results(before, after).times_compared == 5);
    *after.rows[0].nanoseconds *= 1.5;
    after.rows[0].repeated = repeats_about(*after.rows[0].nanoseconds);
    difference d = compare_results(before, after);
    REQUIRE(d.slower.size() == 1);
    CHECK(told(d.slower[0]) == "g: double textbook/stable: time 10.0 ns -> 15.0 ns");
    CHECK(compare_results(after, before).faster.size() == 1);
    // One or two slow repeats are noise. So is a change of 4%, however significant.
    after = before;
    after.rows[0].repeated[3] *= 50, after.rows[0].repeated[9] *= 50;
    after.rows[1].repeated = repeats_about(1.04 * 20);
    after.rows[1].nanoseconds = 1.04 * 20;
    d = compare_results(before, after);
    CHECK(d.slower.empty());
    // On a busy machine every row takes longer. One row has slowed down more than the rest.
    for (int copy = 0; copy < 2; ++copy) {
        for (int i = 0; i < 5; ++i) {
            row r = before.rows[static_cast<std::size_t>(i)];
            r.type += std::to_string(copy);
            before.rows.push_back(r);
        }
    }
    after = before;
    for (row& r : after.rows) {
        r.nanoseconds = 1.7 * *r.nanoseconds;
        r.repeated = repeats_about(*r.nanoseconds);
    }
    CHECK(compare_results(before, after).slower.empty());
    CHECK(to_text(compare_results(before, after)).find("by which all are slower") != std::string::npos);
    after.rows[6].repeated = repeats_about(2 * *after.rows[6].nanoseconds);
    after.rows[6].nanoseconds = 2 * *after.rows[6].nanoseconds;
    CHECK(compare_results(before, after).slower.size() == 1);
}

TEST_CASE("the Mann-Whitney test agrees with all the ways to choose") {
    // For two series of six values, every way to divide the twelve values is equally likely.
    const std::vector<double> values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    for (const unsigned mine : {0x03fU, 0x06fU, 0x0dbU, 0x555U, 0x2f8U}) { // six bits each
        std::vector<double> x, y;
        const auto off = [&](unsigned chosen) {
            double sum = 0;
            for (unsigned i = 0; i < 12; ++i) {
                sum += (chosen >> i & 1U) != 0 ? values[i] : 0;
            }
            return std::fabs(sum - 39);
        };
        double as_uneven = 0, all = 0;
        for (unsigned chosen = 0; chosen < 4096; ++chosen) {
            if (std::popcount(chosen) == 6) {
                ++all;
                as_uneven += off(chosen) >= off(mine) ? 1 : 0;
            }
        }
        for (unsigned i = 0; i < 12; ++i) {
            ((mine >> i & 1U) != 0 ? x : y).push_back(values[i]);
        }
        REQUIRE(x.size() == 6);
        CHECK(std::fabs(probability_of_no_difference(x, y) - as_uneven / all) < 0.02);
        CHECK(probability_of_no_difference(x, y) == doctest::Approx(probability_of_no_difference(y, x)));
    }
    CHECK(probability_of_no_difference({1, 1, 1, 1}, {1, 1, 1, 1}) == 1);
    CHECK(probability_of_no_difference({1, 2}, {9, 10}) == 1); // too few to tell
}

TEST_CASE("files of version 1, without pairs and repeats, are read") {
    std::string text = to_json(small_results());
    text.replace(text.find("\"version\": 2"), 12, "\"version\": 1");
    for (const char* field :
         {"\"repeated\": [],", "\"extremes\": [],", "\"shown\": []", "\"program\": \"\",", "\"inputs\": \"\","}) {
        for (auto at = text.find(field); at != std::string::npos; at = text.find(field)) {
            const bool is_last = std::string(field) == "\"shown\": []";
            const auto from = is_last ? text.rfind(',', at) : at;
            text.erase(from, at + std::string(field).size() - from);
        }
    }
    const temporary_file file;
    write_whole_file(file.path, text);
    const results old = read_results(file.path);
    CHECK(old.rows.size() == 5);
    CHECK(compare_results(old, small_results()).compared == 5);
}

TEST_CASE("a history tells every row, run by run") {
    const results first = small_results();
    results second = first, third = first;
    second.rows[1].error(quantity::time).fewest_bits = 40;
    third.rows.erase(third.rows.begin());
    third.rows[0].decisions.overlap = 2;
    const auto all = history_of({first, second, third});
    REQUIRE(all.size() == 5);
    CHECK(all[0].variant == "lagrange"); // in the order of the last result's rows
    CHECK(all[0].digits[1] == doctest::Approx(40 / std::log2(10.0)));
    CHECK(all[0].wrong == std::vector<std::optional<std::size_t>>{0, 0, 2});
    CHECK(all[4].variant == "textbook");
    CHECK_FALSE(all[4].digits[2]);
    const std::string text = history_text({first, second, third}, {"a", "b", "c"});
    CHECK(text.find("3 rows the same in every run") != std::string::npos);
}
