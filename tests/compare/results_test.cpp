// Results as JSON and back, the conclusions from them, and the differences between two.
#include "answer.hpp"
#include "diff.hpp"
#include "input_error.hpp"
#include "json_results.hpp"
#include "report_sample.hpp"
#include "whole_file.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

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
    CHECK(error_of(R"({"schema": "graze-compare", "version": 2})") == ": /version: version 1 expected, not 2");
    std::string text = to_json(small_results());
    const auto place = text.find("\"pairs\": 100");
    REQUIRE(place != std::string::npos);
    text.replace(place, 12, "\"pairs\": -1");
    CHECK(error_of(text) == ": /groups/0/pairs: not a whole number in range");
    CHECK_THROWS_AS(static_cast<void>(read_results("/nonexistent/file.json")), input_error);
}

TEST_CASE("the answer is the cheapest that is good enough, and the cheapest that is exact") {
    results found = small_results();
    draw_conclusions(found);
    REQUIRE(found.good_enough);
    CHECK(found.good_enough->type == "double");
    CHECK(found.good_enough->variant == "lagrange");
    REQUIRE(found.exact);
    CHECK(found.exact->variant == "lagrange");
    CHECK(found.sentence == "The cheapest type with no wrong decision and every time good to 15 digits here is double "
                            "(lagrange, stable root, 20 ns a pair); the cheapest that is exact is rational (lagrange, "
                            "stable root, 800 ns a pair).");
    const std::vector<bool> front = {true, true, false, false, true};
    for (std::size_t i = 0; i < front.size(); ++i) {
        CHECK(found.rows[i].on_front == front[i]);
    }
    found.digits = 16; // 51 bits are 15.35 digits
    draw_conclusions(found);
    CHECK(found.good_enough->type == "rational");
    CHECK(found.sentence.find("rational (lagrange, stable root, 800 ns a pair), and it is exact.") !=
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

TEST_CASE("differences") {
    const results before = small_results();
    results after = before;
    CHECK(compare_results(before, after).same == 5);
    after.rows[0].nanoseconds = 1000;
    difference d = compare_results(before, after);
    CHECK(d.worse.empty());
    CHECK(d.slower.size() == 1);
    CHECK(d.same == 5);
    after = before;
    after.rows[1].decisions.overlap = 1;
    after.rows[0].error(quantity::time).largest = 39.5;
    d = compare_results(before, after);
    REQUIRE(d.worse.size() == 1);
    CHECK(d.worse[0] == "g: double lagrange/stable: wrong on overlap 0 -> 1");
    REQUIRE(d.better.size() == 1);
    CHECK(d.better[0] == "g: double textbook/stable: time, largest error 40.0 -> 39.5");
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
