// graze-compare as its user sees it: what it prints, what it writes, and how it ends.
#include "json_results.hpp"
#include "workshop.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

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

const std::string quick = "--family grazing --count 60 --seed 3 --types double,cpp_rational --timing 0 ";

} // namespace

namespace {

std::string on_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

TEST_CASE("bad input ends with 2 and one line that says what is wrong") {
    const bench here;
    here.write("broken.json", "{\"dimension\": 2,\n \"balls\": [}");
    here.write("lonely.json", R"({"dimension": 2, "balls": [{"position": [0, 0], "velocity": [0, 0], "radius": 1}]})");
    struct wrong {
        const char* arguments;
        const char* names;
        const char* says;
    };
    const std::vector<wrong> all = {
        {"missing.json", "missing.json", ""},
        {"broken.json", "broken.json", "line 2"},
        {"lonely.json", "lonely.json", "nothing that it could meet"},
        {"--types double,flaot", "--types", "flaot"},
        {"--variants cosine", "--variants", "cosine"},
        {"--variants lagrange/square", "--variants", "lagrange/square"},
        {"--quantity colour", "--quantity", "colour"},
        {"--family nonesuch", "nonesuch", ""},
        {"--family generic --count 0", "--count", ""},
        {"--family generic --count many", "--count", "many"},
        {"--count 5", "--count", "--family"},
        {"--family generic --dimension 4", "--dimension", "4"},
        {"--family generic broken.json", "--family", ""},
        {"--as float", "--as", "float"},
        {"--digits 0", "--digits", ""},
        {"--seed -1", "--seed", ""},
        {"--timing -1", "--timing", ""},
        {"--nonsense", "--nonsense", ""},
        {"broken.json other.json", "other.json", ""},
        {"--json nowhere/out.json", "--json", "nowhere/out.json"},
        {"--json .", "--json", "directory"},
        {"--report nowhere/out.html", "--report", "nowhere/out.html"},
        {"--json same --report ./same", "--json and --report", "same"},
        {"diff", "old", ""},
        {"diff missing.json missing.json", "missing.json", ""},
        {"diff lonely.json lonely.json", "lonely.json", "schema"},
    };
    const std::size_t before = here.files();
    for (const wrong& w : all) {
        INFO(w.arguments);
        const ending e = here.run(w.arguments);
        INFO(e.err);
        CHECK(e.code == 2);
        CHECK(e.out.empty());
        CHECK(std::count(e.err.begin(), e.err.end(), '\n') == 1);
        CHECK(holds(e.err, w.names));
        CHECK(holds(e.err, w.says));
        CHECK(here.files() == before);
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
    CHECK(found.rows.size() == 8 + 6); // no fused multiply-add in rationals
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
    const std::set<std::string> free_keys = {"kinds", "encounters", "histogram"}; // whose keys are data
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

TEST_CASE("options choose") {
    const bench here;
    const ending e = here.run(quick + "--variants lagrange/stable,halved --quantity position,velocity --dimension 3");
    CHECK(e.code == 0);
    CHECK(holds(e.out, "grazing (3D)"));
    CHECK(holds(e.out, "error of position"));
    CHECK(holds(e.out, "error of velocity"));
    CHECK_FALSE(holds(e.out, "textbook"));
    CHECK(holds(here.run("--family tangent --count 4 --types CGAL::Exact_rational,double --timing 0").out, "double"));
    CHECK(holds(here.run("--help").out, "--family"));
    CHECK(holds(here.run("diff --help").out, "new"));
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
    const ending worse = here.run("diff one.json worse.json");
    CHECK(worse.code == 1);
    CHECK(holds(worse.out, "velocity, largest error"));
    CHECK(here.run("diff worse.json one.json").code == 0);

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
