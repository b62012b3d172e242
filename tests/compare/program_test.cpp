// graze-compare as its user sees it: what it prints, what it writes, and how it ends.
#include "json_results.hpp"
#include "workshop.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace fs = std::filesystem;

using workshop::bench, workshop::ending, workshop::content_of, workshop::holds;

namespace {

// All pairs, however slow the machine is.
const std::string quick = "--family grazing --count 60 --seed 3 --types double,cpp_rational --timing 0 --all ";

} // namespace

namespace {

std::string on_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

TEST_CASE("bad input ends with 2 and one line that says what is wrong") {
    const bench here;
    here.copy_from(GRAZE_BAD_INPUTS);
    workshop::check_bad_lines(here, "scenes.txt", false);
    workshop::check_bad_lines(here, "commands.txt", false);
}

TEST_CASE("the standard input is a scene, and the standard output takes one file") {
    const bench here;
    here.copy_from(GRAZE_BAD_INPUTS);
    const ending e = here.run("- --types double --timing 0 --json - <ok.json");
    INFO(e.err);
    CHECK(e.code == 0);
    CHECK(e.err.empty());
    const auto json = nlohmann::json::parse(e.out); // and nothing else
    CHECK(json["source"] == "the standard input");
    CHECK_FALSE(std::filesystem::exists(here / "-"));
    CHECK(here.run("diff - one.json </dev/null").code == 2);
}

TEST_CASE("the version, and the help of each command") {
    const bench here;
    CHECK(holds(here.run("--version").out, "graze-compare 0."));
    CHECK(holds(here.run("--help").out, "graze-compare"));
    CHECK(holds(here.run("diff --help").out, "graze-compare diff"));
}

TEST_CASE("what a scene calls itself cannot write on the terminal") {
    const bench here;
    // ESC, BEL, a line end, a right-to-left override, and a NUL by way of JSON.
    here.write(
        "evil.json",
        R"({"dimension": 2, "name": "\u001b[31mred\u0007\nnext\u202egnp.exe\u0000", "description": "\u001b]0;title\u0007",
        "balls": [{"position": [0, 0], "velocity": [1, 0], "radius": 1}, {"position": [5, 0], "velocity": [0, 0], "radius": 1}]})");
    const ending e = here.run("evil.json --types double --timing 0 --json one.json");
    CHECK(e.code == 0);
    CHECK(holds(e.out, "\\x1b[31mred\\x07\\x0anext\\xe2\\x80\\xaegnp.exe\\x00"));
    const ending same = here.run("diff one.json one.json");
    compare::results other = compare::read_results((here / "one.json").string());
    other.rows[0].error(compare::quantity::time).largest += 1;
    here.write("two.json", compare::to_json(other));
    for (const std::string& text : {e.out, here.run("diff one.json two.json").out}) {
        CHECK(holds(text, "red"));
        CHECK_FALSE(holds(text, "\x1b"));
        CHECK_FALSE(holds(text, "\a"));
        CHECK_FALSE(holds(text, "\u202e"));
        CHECK_FALSE(holds(text, std::string(1, '\0')));
    }
}

TEST_CASE("without times there are no trade-offs, and no figure of what was not measured") {
    const bench here;
    const ending e = here.run("--family far --count 40 --types double --timing 0 --json out.json");
    CHECK(holds(e.out, "There are no trade-offs between time and error: nothing was timed."));
    CHECK_FALSE(holds(e.out, "inf"));
    here.write("plane.json", R"({"dimension": 2, "balls": [{"position": [0, 5], "velocity": [0, -1], "radius": 1}],
        "planes": [{"point": [0, 0], "normal": [0, 1]}]})");
    const ending alone = here.run("plane.json --types double --timing 0 --json plane_out.json");
    const auto rows = nlohmann::json::parse(content_of(here / "plane_out.json"))["rows"];
    CHECK(rows[0]["momentum"]["count"] == 0); // a plane absorbs momentum
    CHECK(rows[0]["momentum"]["median"].is_null());
    CHECK(rows[0]["momentum"]["largest"].is_null());
    CHECK(rows[0]["errors"]["time"]["largest"].is_null());
    CHECK(rows[0]["cells"][0]["hardness"].is_null());
    CHECK(rows[0]["nanoseconds_low"].is_null());
    CHECK(rows[0]["energy"]["largest"] == 0);
}

TEST_CASE("what no type measured is not told as if it were not there") {
    const bench here;
    // A hit for which floats and doubles overflow, a pair that overlaps, and one that recedes.
    here.write("fast.json", R"({"dimension": 2, "balls": [{"position": [0, 0], "velocity": [0, 0], "radius": 1},
        {"position": [1e300, 1e300], "velocity": [-1e308, -1e308], "radius": 1e290}]})");
    here.write("inside.json", R"({"dimension": 2, "balls": [{"position": [0, 0], "velocity": [1, 0], "radius": 1},
        {"position": [1, 0], "velocity": [0, 0], "radius": 1}]})");
    here.write("apart.json", R"({"dimension": 2, "balls": [{"position": [0, 0], "velocity": [-1, 0], "radius": 1},
        {"position": [5, 0], "velocity": [0, 0], "radius": 1}]})");
    const auto said = [&](const std::string& scene) {
        return on_one_line(here.run(scene + ".json --types double --timing 0.001").out);
    };
    const std::string fast = said("fast");
    CHECK(holds(fast, "in truth 1 hit"));
    CHECK(holds(fast, "No measured type gets every decision right, and every time right to 15 digits"));
    CHECK_FALSE(holds(fast, "No pair collides"));
    CHECK_FALSE(holds(fast, "inf"));
    CHECK(holds(said("inside"), "What collides overlaps at the start, so no time is needed."));
    CHECK(holds(said("apart"), "No pair collides, so no time is needed."));
}

TEST_CASE("a file that cannot be written costs no results") {
    const bench here;
    const ending e = here.run(quick + "--json /dev/full");
    CHECK(e.code == 2);
    CHECK(holds(e.err, "/dev/full: cannot be written"));
    CHECK(holds(e.out, "textbook/printed"));
}

TEST_CASE("one unit of time") {
    const bench here;
    const ending e = here.run("--family generic --count 12 --types double,cpp_rational --timing 0.01");
    CHECK(holds(e.out, " ns"));
    CHECK((holds(e.out, " µs") || holds(e.out, " ms"))); // rationals, on whatever machine
    CHECK_FALSE(holds(e.out, " us "));
    CHECK_FALSE(holds(e.out, "exact is"));
    CHECK(holds(on_one_line(e.out), "exact values"));
}

TEST_CASE("the wrong and the worst pairs are named, and their commands show them again") {
    const bench here;
    const ending e =
        here.run("--family grazing --count 60 --seed 3 --types double --timing 0 --json out.json --pairs found");
    INFO(e.out << e.err);
    REQUIRE(e.code == 0);
    CHECK(holds(e.out, "Wrong decisions, those farthest from the border first."));
    CHECK(holds(e.out, "The largest error of the time"));
    const compare::results found = compare::read_results((here / "out.json").string());
    std::size_t wrong = 0, errors = 0;
    for (const compare::row& r : found.rows) {
        for (const compare::extreme_pair& x : r.extremes) {
            const auto place = std::find_if(found.groups[0].shown.begin(), found.groups[0].shown.end(),
                                            [&](const auto& p) { return p.number == x.pair; });
            REQUIRE(place != found.groups[0].shown.end());
            CHECK(content_of(here / ("found/pair-" + std::to_string(x.pair) + ".json")) == place->scene);
            CHECK(place->numbers.size() == 8);
            const bool is_error = x.which == "largest";
            if (r.variant != "textbook" || r.root != "printed") {
                continue;
            }
            // The pair alone, by its number and as a scene, gives the same error and the same answers.
            for (const std::string& inputs : {found.inputs + " --pair " + std::to_string(x.pair),
                                              " found/pair-" + std::to_string(x.pair) + ".json --as exact"}) {
                const ending again =
                    here.run(inputs + " --types double --variants textbook/printed --timing 0 --json again.json");
                INFO(inputs << "\n" << again.err);
                REQUIRE(again.code == 0);
                const compare::results one = compare::read_results((here / "again.json").string());
                REQUIRE(one.rows.size() == 1);
                const auto same =
                    std::find_if(one.rows[0].extremes.begin(), one.rows[0].extremes.end(), [&](const auto& y) {
                        return y.what == x.what && y.error == x.error && y.said == x.said && y.right == x.right;
                    });
                CHECK(same != one.rows[0].extremes.end());
            }
            (is_error ? errors : wrong) += 1;
        }
    }
    CHECK(wrong >= 2);
    CHECK(errors >= 4);
    // The printed command works.
    const auto at = e.out.find("graze-compare --family grazing");
    REQUIRE(at != std::string::npos);
    std::string printed = on_one_line(e.out.substr(at, 200));
    printed = printed.substr(std::string("graze-compare").size(),
                             printed.find(". --pairs") - std::string("graze-compare").size());
    const ending again = here.run(printed);
    INFO(printed << again.err);
    CHECK(again.code == 0);
    CHECK(holds(again.out, "hexadecimal"));
    const std::string pair = printed.substr(printed.find("--pair ") + 7); // it stands in a table
    CHECK(holds(e.out, " " + pair + "  pair " + pair));
    CHECK(holds(content_of(here / "found/pairs.txt"),
                "graze-compare --family grazing --count 60 --dimension 2 --seed 3 --pair"));
}

TEST_CASE("a file keeps its mode, and what a killed program left is taken away") {
    namespace fs = std::filesystem;
    const bench here;
    here.write("out.json", "");
    fs::permissions(here / "out.json", fs::perms::owner_read | fs::perms::owner_write);
    here.write("out.json.part999999999", "half"); // no process has this number
    here.write("out.json.part" + std::to_string(getpid()), "of one that runs");
    REQUIRE(here.run(quick + "--json out.json").code == 0);
    CHECK(fs::status(here / "out.json").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
    CHECK_FALSE(fs::exists(here / "out.json.part999999999"));
    CHECK(fs::exists(here / ("out.json.part" + std::to_string(getpid()))));
}

TEST_CASE("Google Benchmark's format") {
    const bench here;
    REQUIRE(
        here.run("--family generic --count 12 --types double --timing 0.05 --benchmark-json times.json --json out.json")
            .code == 0);
    const auto json = nlohmann::json::parse(content_of(here / "times.json"));
    const compare::results found = compare::read_results((here / "out.json").string());
    std::size_t repeats = 0;
    for (const compare::row& r : found.rows) {
        CHECK(r.repeated.size() == r.repeats);
        repeats += r.repeats;
    }
    CHECK(json["benchmarks"].size() == repeats);
    const auto& first = json["benchmarks"][0];
    CHECK(first["name"] == "generic/double/textbook/printed");
    CHECK(first["real_time"] == found.rows[0].repeated[0]);
    CHECK(first["time_unit"] == "ns");
    CHECK(first["run_type"] == "iteration");
    for (const char* key : {"date", "host_name", "executable", "num_cpus", "mhz_per_cpu", "cpu_scaling_enabled",
                            "caches", "load_avg", "library_build_type"}) {
        CHECK(json["context"].contains(key));
    }
    for (const char* key : {"family_index", "per_family_instance_index", "run_name", "repetitions", "repetition_index",
                            "threads", "iterations", "cpu_time"}) {
        CHECK(first.contains(key));
    }
}

TEST_CASE("a small run") {
    const bench here;
    const ending e = here.run(quick + "--json out.json");
    CHECK(e.code == 0);
    CHECK(e.err.empty()); // no progress where there is no terminal
    CHECK(holds(e.out, "grazing (2D): 60 pairs"));
    CHECK(holds(e.out, "textbook/printed"));
    CHECK(holds(e.out, "cpp_rational"));
    const compare::results found = compare::read_results((here / "out.json").string());
    CHECK(here.files() == 1);
    CHECK(found.rows.size() == 8 + 6); // rationals have no fused multiply-add
    std::size_t wrong_double = 0, wrong_exact = 0;
    for (const compare::row& r : found.rows) {
        (r.type == "double" ? wrong_double : wrong_exact) += r.decisions.wrong();
        if (r.type != "double") {
            CHECK(r.error(compare::quantity::time).exact == r.error(compare::quantity::time).count);
            CHECK(r.error(compare::quantity::velocity).largest == 0);
            CHECK(r.energy.largest == 0);
            CHECK(r.momentum.largest == 0);
        }
    }
    CHECK(wrong_exact == 0);
    CHECK(wrong_double > 0);
    CHECK(holds(found.command, "--count 60"));
}

TEST_CASE("every field in the JSON stands in its reference page") {
    const bench here;
    REQUIRE(here.run(quick + "--json out.json").code == 0);
    const std::string page = content_of(GRAZE_JSON_PAGE);
    const auto json = nlohmann::json::parse(content_of(here / "out.json"));
    const std::set<std::string> free_keys = {"kinds", "encounters", "histogram"}; // their keys are data
    std::set<std::string> keys;
    const auto walk = [&](const auto& self, const nlohmann::json& x) -> void {
        for (const auto& [key, value] : x.items()) {
            if (x.is_object()) {
                keys.insert(key);
            }
            if (value.is_structured() && !(x.is_object() && free_keys.count(key) != 0)) {
                self(self, value);
            }
        }
    };
    walk(walk, json);
    CHECK(keys.size() > 60);
    for (const std::string& key : keys) {
        INFO(key);
        CHECK(holds(page, "`" + key + "`"));
    }
}

TEST_CASE("a scene of triangles: every feature is met, exact types are right, and a pair's scene holds its triangle") {
    const bench here;
    // Balls that fall onto a face, a slanted edge and a corner, and one that misses the triangle but would hit the
    // other half of the square.
    here.write("mesh.json", R"({"dimension": 3, "balls": [
        {"position": [1, 1, 3], "velocity": [0, 0, -1], "radius": 0.5},
        {"position": [2.25, 2.25, 3], "velocity": [0, 0, -1], "radius": 0.5},
        {"position": [4.25, -0.125, 3], "velocity": [0, 0, -1], "radius": 0.5},
        {"position": [3.5, 3.5, 9], "velocity": [0, 0, -1], "radius": 0.5}],
        "triangles": [{"corner": [0, 0, 0], "edges": [[4, 0, 0], [0, 4, 0]], "inner_edges": [1]}]})");
    REQUIRE(here.run("mesh.json --types double,cpp_rational,graze --timing 0 --json out.json --pairs found").code == 0);
    const compare::results found = compare::read_results((here / "out.json").string());
    CHECK(found.groups[0].kinds.at("ball_triangle") == 4);
    for (const compare::row& r : found.rows) {
        CHECK(r.decisions.wrong() == 0);
        CHECK(r.error(compare::quantity::crossing).count == 3);
        if (r.type != "double") {
            CHECK(r.error(compare::quantity::crossing).largest <= 0.5);
        }
    }
    const bool any = std::any_of(found.groups[0].shown.begin(), found.groups[0].shown.end(), [](const auto& p) {
        return p.kind == "ball_triangle" && holds(p.scene, "\"triangles\"") && holds(p.name, " and triangle 0");
    });
    CHECK(any);
}

TEST_CASE("the pairs as inputs of the regression") {
    const bench here;
    here.write("mixed.json", R"({"dimension": 2, "balls": [
        {"position": [0, 0.5], "velocity": [1, 0], "radius": 1, "mass": "inf"},
        {"position": [5, 0], "velocity": [0, 0], "radius": 0.25}],
        "walls": [{"corner": [9, -1], "edges": [[0, 3]]}]})");
    REQUIRE(here.run("mixed.json --types double --timing 0 --inputs pairs.txt").code == 0);
    const std::string text = content_of(here / "pairs.txt");
    CHECK(holds(text, "# origin: graze-compare mixed.json --pair 1\n"));
    CHECK(holds(text,
                "ball-ball 2 0x0p+0 0x1p-1 0x1p+0 0x0p+0 0x1p+0 inf 0x1.4p+2 0x0p+0 0x0p+0 0x0p+0 0x1p-2 0x1p+0\n"));
    CHECK(holds(text, "ball-wall 2 0x0p+0 0x1p-1 0x1p+0 0x0p+0 0x1p+0 inf 0x1.2p+3 -0x1p+0 0x0p+0 0x1.8p+1\n"));
    CHECK(std::count(text.begin(), text.end(), '\n') == 6);
}

TEST_CASE("options choose") {
    const bench here;
    const ending e = here.run(quick + "--variants lagrange/stable,halved --quantity position,velocity --dimension 3");
    CHECK(e.code == 0);
    CHECK(holds(e.out, "grazing (3D)"));
    CHECK(holds(e.out, "error of the positions"));
    CHECK(holds(e.out, "error of the velocities"));
    CHECK_FALSE(holds(e.out, "textbook"));
    CHECK(holds(here.run("--family tangent --count 4 --types CGAL::Exact_rational,double --timing 0").out, "double"));
    CHECK(holds(here.run("--help").out, "--family"));
    CHECK(holds(here.run("diff --help").out, "earliest"));
}

TEST_CASE("the same seed gives the same answers, and diff tells what changed") {
    const bench here;
    REQUIRE(here.run(quick + "--json one.json").code == 0);
    REQUIRE(here.run(quick + "--json two.json").code == 0);
    const ending same = here.run("diff one.json two.json");
    CHECK(same.code == 0);
    CHECK(holds(same.out, "14 rows compared: 14 the same"));

    compare::results changed = compare::read_results((here / "two.json").string());
    changed.rows[0].error(compare::quantity::velocity).largest *= 2;
    here.write("worse.json", compare::to_json(changed));
    const ending worse = here.run("diff one.json worse.json --report diff.html");
    CHECK(holds(content_of(here / "diff.html"), "velocity, largest error"));
    CHECK(worse.code == 1);
    CHECK(holds(worse.out, "velocity, largest error"));
    CHECK(here.run("diff worse.json one.json").code == 0);
    const ending history = here.run("diff one.json two.json worse.json --report history.html");
    CHECK(history.code == 1);
    CHECK(holds(history.out, "run by run"));
    CHECK(holds(history.out, "worse.json beside two.json"));
    CHECK(holds(content_of(here / "history.html"), "The history of 3 results"));
    compare::results exact = compare::read_results((here / "one.json").string());
    exact.as = "exact", exact.seed = 4;
    here.write("exact.json", compare::to_json(exact));
    const std::string other = here.run("diff one.json exact.json").out;
    CHECK(other.starts_with("The settings differ."));
    CHECK(holds(other, "--as: double -> exact"));
    CHECK(holds(other, "--seed: 3 -> 4"));

    changed.rows.clear();
    here.write("empty.json", compare::to_json(changed));
    CHECK(here.run("diff one.json empty.json").code == 2); // nothing was compared
}

TEST_CASE("what was there stays when a file cannot be written") {
    const bench here;
    here.write("out.json", "kept");
    CHECK(here.run(quick + "--json /dev/full").code == 2);
    CHECK(here.run("--types nonesuch --json out.json").code == 2);
    CHECK(content_of(here / "out.json") == "kept");
    CHECK(here.files() == 1);
}

TEST_CASE("at least 14 distinct number types, where all libraries are there") {
    const bench here;
    const ending e = here.run("--list-types");
    CHECK(e.code == 0);
    const auto place = e.out.find(" distinct types");
    REQUIRE(place != std::string::npos);
    const auto line = e.out.rfind('\n', place);
    CHECK(holds(e.out, "another name of mpq_rational") != holds(e.out, "not in this build: CGAL"));
    if (!holds(e.out, "not in this build")) {
        CHECK(std::stoi(e.out.substr(line + 1, place - line - 1)) >= 14);
    }
    CHECK(holds(here.run("--list-families").out, "grazing: "));
}

TEST_CASE("every type answers, the exact ones rightly, and each is timed") {
    const bench here;
    const ending e = here.run("--family generic --count 12 --timing 0.01 --json out.json");
    REQUIRE(e.code == 0);
    const compare::results found = compare::read_results((here / "out.json").string());
    for (const compare::type_information& t : found.types) {
        INFO(t.name);
        std::size_t rows = 0;
        for (const compare::row& r : found.rows) {
            if (r.type == t.name) {
                ++rows;
                CHECK(r.nanoseconds.value_or(0) > 0);
                CHECK(r.decisions.evaluated > 0);
                CHECK(r.decisions.failed == 0);
                CHECK(r.not_enclosed == 0);
                if (t.is_exact) {
                    CHECK(r.decisions.wrong() == 0);
                    for (const compare::error_statistics& error : r.errors) {
                        CHECK(error.exact == error.count);
                        CHECK(error.unscaled == 0);
                    }
                }
            }
        }
        CHECK(rows == (!t.alias_of.empty() ? 0 : t.library == "graze" ? 1 : t.has_fma ? 8 : 6));
        CHECK(holds(e.out, t.name));
    }
    REQUIRE(found.exact);
    CHECK(holds(on_one_line(e.out), found.sentence)); // the terminal's text is wrapped
}

TEST_CASE("progress is shown on a terminal") {
    if (std::system("command -v script >/dev/null") != 0) {
        return;
    }
    const bench here;
    const std::string command = "cd '" + (here / ".").string() + "' && script -qec \"'" GRAZE_COMPARE "' " + quick +
                                "\" typescript >terminal </dev/null";
    CHECK(std::system(command.c_str()) == 0);
    CHECK(holds(content_of(here / "terminal"), "measuring double on grazing"));
}
