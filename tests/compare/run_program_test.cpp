// `graze-compare run` as its user sees it.
#include "workshop.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

using workshop::bench, workshop::ending, workshop::content_of, workshop::holds;

namespace {

const std::string photon = "run " GRAZE_SCENES "/photon.json --until 10 ";

} // namespace

TEST_CASE("what a scene calls itself cannot write on the terminal") {
    const bench here;
    here.write("evil.json", R"({"dimension": 2, "name": "\u001b[31mred\u0007\nnext\u202e",
        "balls": [{"position": [0, 0], "velocity": [1, 0], "radius": 1}, {"position": [5, 0], "velocity": [0, 0], "radius": 1}]})");
    const ending e = here.run("run evil.json --until 9 --certified --json run.json");
    CHECK(e.code == 0);
    CHECK(e.out.starts_with("\\x1b[31mred\\x07\\x0anext\\xe2\\x80\\xae: 1 collision"));
    const std::string scene = nlohmann::json::parse(content_of(here / "run.json"))["scene"];
    CHECK(scene.starts_with("\x1b[31mred\a\n")); // not escaped
}

TEST_CASE("the photon: what every type keeps of it") {
    const bench here;
    const ending e = here.run(photon + "--distance 0 --timing 0.001 --events --json out.json");
    INFO(e.out << e.err);
    REQUIRE(e.code == 0);
    CHECK(e.err.empty());
    CHECK(holds(e.out, "photon: 14 collisions until t = 10, every decision proved"));
    CHECK(holds(e.out, "ball 0 is 0.99526291944335"));
    CHECK(holds(e.out, "double is right for all 14 collisions, to "));
    CHECK(holds(e.out, " digits; for 15 digits take "));
    const auto all = nlohmann::json::parse(content_of(here / "out.json"));
    CHECK(all["events"].size() == 14);
    CHECK(all["distance"]["from_origin"].get<std::string>().substr(0, 12) == "0.9952629194");
    const auto digits_of = [&](const std::string& type) {
        for (const auto& t : all["types"]) {
            if (t["type"] == type) {
                CHECK(t["first_wrong"].is_null());
                CHECK(t["right"] == 14);
                CHECK(t["digits"].size() == 14);
                CHECK(t["events_per_second"] > 0);
                return t["end_digits"].get<double>();
            }
        }
        FAIL("no row of " << type);
        return 0.0;
    };
    const std::string page = content_of(GRAZE_JSON_PAGE);
    for (const nlohmann::json& object : {all, all["types"][0], all["events"][0], all["states"][0], all["distance"]}) {
        for (const auto& [key, value] : object.items()) {
            INFO(key);
            CHECK(holds(page, "`" + key + "`"));
        }
    }
    CHECK(digits_of("double") == doctest::Approx(5).epsilon(0.3));
    CHECK(digits_of("cpp_bin_float_50") == doctest::Approx(40).epsilon(0.1));
    CHECK(digits_of("cpp_bin_float_100") == doctest::Approx(90).epsilon(0.1));
    CHECK(all["types"].size() >= 7); // libquadmath's and QD's may be missing
}

TEST_CASE("a thousand digits") {
    const bench here;
    const ending e = here.run(photon + "--distance 0 --digits 1000 --certified");
    CHECK(e.code == 0);
    const std::string text = "ball 0 is 0.9952629194433541608903118094267216210294669227341543498032088580";
    CHECK(holds(e.out, text));
    const auto at = e.out.find("0.9952629194");
    REQUIRE(at != std::string::npos);
    CHECK(e.out.find(' ', at) - at == 1002);
}

TEST_CASE("a type that goes wrong is told where, and pictures show it") {
    const bench here;
    const ending e =
        here.run("run " GRAZE_SCENES "/sinai.json --collisions 200 --types double,cpp_bin_float_50 --digits 5 "
                 "--timing 0 --picture digits.svg --paths paths.svg --beside double --json out.json");
    INFO(e.out << e.err);
    CHECK(e.code == 0);
    const auto all = nlohmann::json::parse(content_of(here / "out.json"));
    REQUIRE(all["types"].size() == 2);
    for (const auto& t : all["types"]) {
        REQUIRE(t["first_wrong"].is_object());
        const std::size_t right = t["right"];
        CHECK(right < 200);
        CHECK(t["first_wrong"]["event"] == right + 1);
        CHECK(holds(e.out, t["first_wrong"]["text"].get<std::string>()));
    }
    CHECK(all["types"][0]["right"] < all["types"][1]["right"]); // the type of fewer digits first
    for (const char* picture : {"digits.svg", "paths.svg"}) {
        const std::string svg = content_of(here / picture);
        CHECK(holds(svg, "<svg xmlns="));
        CHECK(holds(svg, "double"));
        CHECK(holds(svg, "<path"));
    }
    const std::string paths = content_of(here / "paths.svg");
    CHECK(holds(paths, "they part at t = "));
    const ending together =
        here.run("run " GRAZE_SCENES "/sinai.json --collisions 5 --types double --timing 0 --paths paths.svg");
    CHECK(together.code == 0);
    CHECK(holds(content_of(here / "paths.svg"), "they stay together"));
}

TEST_CASE("a run that cannot be finished keeps what it has") {
    const bench here;
    here.write("mirrors.json", R"({"dimension": 2, "balls": [
        {"position": [0, 0], "velocity": [1, 0], "radius": 1}, {"position": [5, 0], "velocity": [0, 0], "radius": 1},
        {"position": [0, 50], "velocity": [1, 0], "radius": 1, "mass": "inf"},
        {"position": [20, 50], "velocity": [0, 0], "radius": 1, "mass": "inf"}]})");
    const ending e = here.run("run mirrors.json --until 30 --types double --timing 0");
    INFO(e.out << e.err);
    CHECK(e.code == 1);
    CHECK(holds(e.out, "1 collision until t = 3, every decision proved"));
    CHECK(holds(e.out, "both masses are infinite"));
    CHECK(holds(e.out, "ball 2 and ball 3"));
}

namespace {

// Starts a run, interrupts it `later` after it has begun to note interruptions, and waits for its end.
ending interrupted(const bench& here, const std::string& arguments, std::chrono::milliseconds later) {
    const std::string command =
        "cd '" + (here / "").string() + "' && exec '" GRAZE_COMPARE "' " + arguments + " >out 2>err";
    const pid_t program = fork();
    REQUIRE(program >= 0);
    if (program == 0) {
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    const auto takes_notice = [&] { // its mask of caught signals tells
        const std::string status = content_of("/proc/" + std::to_string(program) + "/status");
        const auto mask = status.find("SigCgt:");
        return holds(status, "graze-compare") && mask != std::string::npos &&
               (std::stoull(status.substr(mask + 7), nullptr, 16) >> (SIGINT - 1U) & 1U) != 0;
    };
    while (!takes_notice() && kill(program, 0) == 0 && waitpid(program, nullptr, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    std::this_thread::sleep_for(later);
    REQUIRE(kill(program, SIGINT) == 0);
    int status = 0;
    REQUIRE(waitpid(program, &status, 0) == program);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(here / "out"), content_of(here / "err")};
}

} // namespace

TEST_CASE("an interrupted run says what was not run, and finds no fault with it") {
    // At once, which is during the proof, and later, while the first type is timed. The answer is right in both cases.
    for (const int later : {0, 500}) {
        const bench here;
        const ending e =
            interrupted(here, "run " GRAZE_SCENES "/galperin.json --collisions 1000 --timing 3600 --json out.json",
                        std::chrono::milliseconds(later));
        INFO(e.out << e.err);
        CHECK(e.code == 1);
        CHECK(e.err.empty());
        CHECK(!holds(e.out, "missed"));
        CHECK(!holds(e.out, "no type here is enough"));
        CHECK(holds(e.out, "not run"));
        CHECK(holds(e.out, "Interrupted"));
        const auto all = nlohmann::json::parse(content_of(here / "out.json"));
        CHECK(all["interrupted"] == true);
        CHECK(all["types"].size() >= 2); // including those that were not run
        for (const auto& t : all["types"]) {
            CHECK(t["first_wrong"].is_null());
            CHECK(!t["type"].get<std::string>().empty());
        }
        CHECK(all["types"].back()["compared"] == "none");
    }
}

TEST_CASE("nothing collides") {
    const bench here;
    here.write("apart.json", R"({"dimension": 2, "balls": [
        {"position": [0, 0], "velocity": [-1, 0], "radius": 1}, {"position": [5, 0], "velocity": [1, 0], "radius": 1}]})");
    const ending e = here.run("run apart.json --until 30 --types double,cpp_bin_float_50 --timing 0");
    INFO(e.out << e.err);
    CHECK(e.code == 0);
    CHECK(holds(e.out, "nothing ever collides"));
    CHECK(holds(e.out, "Nothing collides: there is nothing to compare."));
    CHECK(!holds(e.out, "right for"));
}

TEST_CASE("a scene of triangles is run") {
    const bench here;
    here.write("mesh.json", R"({"dimension": 3, "balls": [
        {"position": [1, 1, 3], "velocity": [0, 0, -1], "radius": 0.5},
        {"position": [1, 1.25, 5], "velocity": [0, 0, -1], "radius": 0.5}],
        "triangles": [{"corner": [0, 0, 0], "edges": [[4, 0, 0], [0, 4, 0]], "inner_edges": [1]}]})");
    const ending e = here.run("run mesh.json --until 100 --types double --timing 0 --events");
    INFO(e.out << e.err);
    CHECK(e.code == 0);
    CHECK(holds(e.out, "ball 0 and triangle 0"));
    CHECK(holds(e.out, ", every decision proved ("));
    CHECK(holds(e.out, "double is right for all 3 collisions"));
}

TEST_CASE("a scene that has a period is run, and checked in a second way") {
    const bench here;
    const ending e = here.run("run " GRAZE_TEST_SCENES "/ring.json --collisions 5 --types double --timing 0");
    INFO(e.out << e.err);
    CHECK(e.code == 0);
    CHECK(holds(e.out, "ring: 5 collisions until t = 4.5, every decision proved ("));
    CHECK(holds(e.out, "double is right for all 5 collisions"));
}

TEST_CASE("order between events that share no ball is nobody's mistake") {
    const bench here;
    const ending e =
        here.run("run " GRAZE_TEST_SCENES "/mirrored_copies.json --collisions 24 --types double --timing 0 --events");
    INFO(e.out << e.err);
    CHECK(e.code == 0);
    CHECK(holds(e.out, "24 collisions"));
    CHECK(holds(e.out, "(either order)"));
    CHECK(holds(e.out, "in either order with the one before"));
    CHECK(holds(e.out, "double is right for all 24 collisions"));
}

TEST_CASE("the help of the subcommand says how it is called") {
    const ending e = bench().run("run --help");
    CHECK(e.code == 0);
    CHECK(holds(e.out, "graze-compare run"));
}

TEST_CASE("bad input ends with 2 and one line that says what is wrong") {
    const bench here;
    here.copy_from(GRAZE_BAD_INPUTS);
    workshop::check_bad_lines(here, "commands.txt", true);
    const ending e = here.run("run " GRAZE_SCENES "/long_corridor.json --until 1 --paths p.svg");
    CHECK(e.code == 2);
    CHECK(holds(e.err, "no scene in the plane"));
}

TEST_CASE("a point bounces off what it meets and off nothing else") {
    const bench here;
    ending e = here.run("run " GRAZE_TEST_SCENES "/thrown_back.json --until 10 --certified");
    CHECK(holds(e.out, "thrown back: 1 collision until t = 1, and none after that"));
    CHECK(holds(e.out, "velocity (1.00000000000000, 1.00000000000000)"));
    e = here.run("run " GRAZE_TEST_SCENES "/elsewhere.json --until 10 --certified --events");
    CHECK(holds(e.out, "elsewhere: 2 collisions until t = 6, and none after that"));
    CHECK(holds(e.out, "ball 0 and wall 0"));
    CHECK(holds(e.out, "ball 0 and wall 2"));
    CHECK(holds(e.out, "velocity (0.00000000000000, -1.00000000000000)"));
}

TEST_CASE("what is jammed is named, and what overlaps") {
    const bench here;
    const ending e = here.run("run " GRAZE_TEST_SCENES "/slot.json --until 10 --certified --json slot.json");
    CHECK(e.code != 0);
    CHECK(holds(e.out, "2 pairs overlap at the start: ball 0 and wall 0, ball 0 and wall 1"));
    CHECK(holds(e.out, "without end among ball 0, wall"));
    const auto all = nlohmann::json::parse(content_of(here / "slot.json"));
    CHECK(all["ending"] == "cascade");
    auto jammed = all["jammed"].get<std::vector<std::string>>();
    std::sort(jammed.begin(), jammed.end());
    CHECK(jammed == std::vector<std::string>{"ball 0", "wall 0", "wall 1"});
}

TEST_CASE("a mirror that presses a ball to a plane is a jam") {
    const bench here;
    const ending e =
        here.run("run " GRAZE_TEST_SCENES "/mirror.json --until 50 --jam 20 --certified --json mirror.json");
    INFO(e.out.substr(0, 300) << e.err);
    CHECK(holds(e.out, "without end among"));
    const auto all = nlohmann::json::parse(content_of(here / "mirror.json"));
    CHECK(all["ending"] == "cascade");
    CHECK(all["jammed"].size() == 3);
    CHECK(all["events"].size() > 1000);
    CHECK(all["events"].size() < 2'000'000 / 20);
    CHECK(all["events"].back()["time"].get<std::string>().substr(0, 5) == "1.499"); // it is over at 3/2
}
