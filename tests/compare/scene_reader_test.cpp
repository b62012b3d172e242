// Scene files: what is read, and the message for every kind of bad file, word for word.
#include "default_scene.hpp"
#include "exact_text.hpp"
#include "rounding.hpp"
#include "scene_reader.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

using namespace compare;

namespace {

std::string message_for(const std::string& text, number_input numbers = number_input::as_double) {
    try {
        static_cast<void>(read_scene_text(text, "s.json", numbers));
    } catch (const input_error& error) {
        return error.what();
    }
    return "no error";
}

std::string message_for_file(const std::string& path) {
    try {
        static_cast<void>(read_scene(path));
    } catch (const input_error& error) {
        return error.what();
    }
    return "no error";
}

// A scene of two balls in space, with replacements in its text.
struct scene_with {
    std::string position = "[0, 0, 0]", velocity = "[1, 0, 0]", radius = "1", more = "";
    std::string top = "";
    operator std::string() const {
        return R"({"dimension": 3, "balls": [{"position": [5, 0, 0], "velocity": [0, 0, 0], "radius": 1}, {"position": )" +
               position + R"(, "velocity": )" + velocity + R"(, "radius": )" + radius + more + "}]" + top + "}";
    }
};

} // namespace

TEST_CASE("triangles, with their inner edges") {
    const std::string floor =
        R"(, "triangles": [{"corner": [0, 0, 0], "edges": [[4, 0, 0], [0, "1/3", 0]], "inner_edges": [1, 2]},
        {"corner": [4, 4, 0], "edges": [[-4, 0, 0], [0, -4, 0]]}])";
    const scene_file file = read_scene_text(std::string(scene_with{.top = floor}), "x", number_input::exactly);
    const auto& scene = std::get<exact_scene<3>>(file.scene);
    REQUIRE(scene.triangles.size() == 2);
    CHECK(scene.triangles[0].edge[1][1] == exact(1) / 3);
    CHECK(scene.triangles[1].corner[1] == 4);
    CHECK(scene.inner_edges == std::vector<std::uint8_t>{0b110, 0});
    const auto with = [](const std::string& triangle) {
        return message_for(scene_with{.top = ", \"triangles\": [" + triangle + "]"});
    };
    CHECK(with(R"({"corner": [0, 0, 0], "edges": [[1, 0, 0], [2, 0, 0]]})") ==
          "s.json: /triangles/0/edges: parallel edges");
    CHECK(with(R"({"corner": [0, 0, 0], "edges": [[1, 0, 0], [0, 1, 0]], "inner_edges": [3]})") ==
          "s.json: /triangles/0/inner_edges/0: no edge of a triangle: 0, 1 or 2");
    CHECK(message_for(R"({"dimension": 2, "balls": [{"position": [5, 0], "velocity": [0, 0], "radius": 1}],
        "triangles": [{"corner": [0, 0], "edges": [[1, 0], [0, 1]]}]})") ==
          "s.json: /triangles/0: a triangle in a scene of dimension 2");
}

TEST_CASE("a scene in the plane, as written and as doubles") {
    const std::string text = R"({
        "name": "two and a wall", "description": "d", "source": "s",
        "walls": [{"edges": [["0x1p-3", 0]], "corner": [-1, 2e0]}],
        "planes": [{"point": [0, 0], "normal": [0, "1/3"]}],
        "balls": [{"position": [0.1, "1/3"], "velocity": [-1, 12345678901234567890123], "radius": 0, "mass": "inf"},
                  {"position": [1, -0], "velocity": [0, 0], "radius": 1e-3, "mass": 0.25}],
        "dimension": 2})";
    const scene_file written = read_scene_text(text, "x", number_input::exactly);
    CHECK(written.name == "two and a wall");
    CHECK(written.description == "d");
    CHECK(written.source == "s");
    const auto& scene = std::get<exact_scene<2>>(written.scene);
    REQUIRE(scene.balls.size() == 2);
    CHECK(scene.balls[0].shape.position[0] == exact(1, 10));
    CHECK(scene.balls[0].shape.position[1] == exact(1, 3));
    CHECK(scene.balls[0].shape.velocity[1] == exact(exact_integer("12345678901234567890123")));
    CHECK(scene.balls[0].inverse_mass == 0);
    CHECK(scene.balls[1].inverse_mass == 4);
    CHECK(scene.balls[1].shape.radius == exact(1, 1000));
    REQUIRE(scene.planes.size() == 1);
    CHECK(scene.planes[0].normal[1] == exact(1, 3));
    REQUIRE(scene.walls.size() == 1);
    CHECK(scene.walls[0].corner[0] == -1);
    CHECK(scene.walls[0].edge[0][0] == exact(1, 8));

    const scene_file rounded = read_scene_text(text, "x");
    const auto& doubles = std::get<exact_scene<2>>(rounded.scene);
    CHECK(doubles.balls[0].shape.position[0] == exact_of(0.1));
    CHECK(doubles.balls[0].shape.position[1] == exact_of(1.0 / 3.0));
    CHECK(doubles.balls[0].shape.velocity[1] == exact_of(12345678901234567890123.0));
    CHECK(doubles.balls[1].shape.radius == exact_of(1e-3));
    CHECK(doubles.planes[0].normal[1] == exact_of(1.0 / 3.0));
}

TEST_CASE("defaults: the mass is 1, the name that of the file") {
    const scene_file file = read_scene_text(std::string(scene_with{}), "some/where.else/tale.json");
    CHECK(file.name == "tale");
    const auto& scene = std::get<exact_scene<3>>(file.scene);
    CHECK(scene.balls[1].inverse_mass == 1);
    CHECK(scene.walls.empty());
    CHECK(scene.planes.empty());
    CHECK(read_scene_text("\xef\xbb\xbf" + std::string(scene_with{}), "x.json").name == "x"); // a byte order mark
}

TEST_CASE("numbers beyond the range of double") {
    CHECK(message_for(scene_with{.radius = "1e400"}) == "s.json: /balls/1/radius: \"1e400\" overflows a double");
    CHECK(message_for(scene_with{.radius = "\"1e400\""}) == "s.json: /balls/1/radius: \"1e400\" overflows a double");
    CHECK(message_for(scene_with{.radius = "1e400"}, number_input::exactly) == "no error");
    CHECK(message_for(scene_with{.radius = "1e5000"}, number_input::exactly) ==
          "s.json: /balls/1/radius: \"1e5000\" is too large: write it as a string");
    CHECK(message_for(scene_with{.radius = "\"1e5000\""}, number_input::exactly) == "no error");
    CHECK(message_for(scene_with{.radius = "1e-400"}) == "no error");
    CHECK(message_for(scene_with{.more = R"(, "mass": 1e-400)"}) ==
          "s.json: /balls/1/mass: a mass that is not positive once rounded to double");
    CHECK(message_for(scene_with{.top = R"(, "planes": [{"point": [0, 0, 0], "normal": [1e-400, 0, 0]}])"}) ==
          "s.json: /planes/0/normal: a normal of length 0");
    CHECK(message_for(scene_with{.radius = "1e-999999999"}) ==
          "s.json: /balls/1/radius: \"1e-999999999\" has an exponent beyond ±10000");
    CHECK(message_for(scene_with{.radius = "\"1e999999999\""}) ==
          "s.json: /balls/1/radius: \"1e999999999\" has an exponent beyond ±10000");
    CHECK(message_for(scene_with{.radius = "0." + std::string(20'000, '3')}) ==
          "s.json: /balls/1/radius: \"0." + std::string(58, '3') + "...\" has more than 10000 characters");
}

TEST_CASE("broken JSON: line and column") {
    CHECK(message_for("") == "s.json: is empty");
    CHECK(message_for(" \n\t") == "s.json: is empty");
    CHECK(message_for("\xef\xbb\xbf") == "s.json: is empty");
    CHECK(message_for("{\n  \"dimension\": 2,\n  \"balls\": [,]}").substr(0, 36) ==
          "s.json: line 3, column 13: syntax er");
    CHECK(message_for("{\"name\": \"\xc3\xa4\xc3\xa4\", x}").substr(0, 26) == "s.json: line 1, column 16:");
    CHECK(message_for("{} {}").substr(0, 25) == "s.json: line 1, column 4:"); // something follows the end
    CHECK(message_for(std::string(scene_with{}) + "x").find(": line 1, column ") != std::string::npos);
    CHECK(message_for(scene_with{.radius = "NaN"}).find("syntax error") != std::string::npos);
    CHECK(message_for(scene_with{.radius = "Infinity"}).find("syntax error") != std::string::npos);
    CHECK(message_for(scene_with{.radius = "01"}).find("syntax error") != std::string::npos);
    CHECK(message_for(scene_with{.radius = "1.}"}).find("syntax error") != std::string::npos);
    CHECK(message_for("{\"name\": \"\xff\"}").find("ill-formed UTF-8") != std::string::npos);
    CHECK(message_for("{\"name\": \"a\nb\"}").find("control character") != std::string::npos);
    CHECK(message_for("{\"dimension\": 2").find("unexpected end of input") != std::string::npos);
    CHECK(message_for(std::string("\xff\xfe{\0}\0", 6)) == "s.json: is not JSON text in UTF-8");
    CHECK(message_for(std::string("{}\0", 3)) == "s.json: is not JSON text in UTF-8");
    for (const std::string& text : {std::string("{\"a\": \"\xff\"}"), std::string("{\x01}"), std::string("[\"\n\"]")}) {
        const std::string message = message_for(text);
        CAPTURE(message);
        CHECK(message.find_first_of("\n\x01\xff") == std::string::npos); // one line, printable
    }
}

TEST_CASE("wrong keys") {
    CHECK(message_for(R"({"dimension": 2, "ballz": []})") ==
          "s.json: /ballz: unknown key; known here: dimension, balls, name, description, source, planes, walls, "
          "triangles, period");
    CHECK(message_for(scene_with{.more = R"(, "radius": 2)"}) == "s.json: /balls/1/radius: the key occurs twice");
    CHECK(message_for(scene_with{.top = R"(, "dimension": 3)"}) == "s.json: /dimension: the key occurs twice");
    CHECK(message_for(scene_with{.more = R"(, "a/b~c": 2)"}) ==
          "s.json: /balls/1/a~1b~0c: unknown key; known here: position, velocity, radius, mass");
    std::string many = "{\"k\": 0";
    for (int i = 0; i < 32; ++i) {
        many += ", \"k" + std::to_string(i) + "\": 0";
    }
    CHECK(message_for(many + "}") == "s.json: an object of more than 32 keys");
    CHECK(message_for(R"({"dimension": 2})") == "s.json: the key \"balls\" is missing");
    CHECK(message_for(R"({"dimension": 2, "balls": [{"position": [0, 0], "radius": 1}]})") ==
          "s.json: /balls/0: the key \"velocity\" is missing");
    CHECK(message_for(scene_with{.top = R"(, "walls": [{"corner": [0, 0, 0]}])"}) ==
          "s.json: /walls/0: the key \"edges\" is missing");
}

TEST_CASE("wrong types") {
    CHECK(message_for("[]") == "s.json: expected an object, found an array");
    CHECK(message_for("null") == "s.json: expected an object, found null");
    CHECK(message_for(R"({"dimension": 2, "balls": {}})") == "s.json: /balls: expected an array, found an object");
    CHECK(message_for(R"({"dimension": 2, "balls": [7]})") == "s.json: /balls/0: expected an object, found a number");
    CHECK(message_for(scene_with{.position = "7"}) == "s.json: /balls/1/position: expected an array, found a number");
    CHECK(message_for(scene_with{.position = "[0, true, 0]"}) ==
          "s.json: /balls/1/position/1: expected a number, found a boolean");
    CHECK(message_for(scene_with{.radius = "\"big\""}) == "s.json: /balls/1/radius: \"big\" is not a number");
    CHECK(message_for(scene_with{.radius = "\"nan\""}) == "s.json: /balls/1/radius: \"nan\" is not a number");
    CHECK(message_for(scene_with{.radius = "\"inf\""}) == "s.json: /balls/1/radius: \"inf\" is infinite");
    CHECK(message_for(scene_with{.top = R"(, "name": 5)"}) == "s.json: /name: expected a string, found a number");
    CHECK(message_for(R"({"dimension": [[[[[[[[[[]]]]]]]]]]})") ==
          "s.json: /dimension/0/0/0/0/0/0/0: arrays and objects nested more than eight deep");
    CHECK(message_for(std::string(1'000'000, '[')) ==
          "s.json: /0/0/0/0/0/0/0/0: arrays and objects nested more than eight deep");
}

TEST_CASE("wrong values") {
    CHECK(message_for(R"({"dimension": 4, "balls": []})") == "s.json: /dimension: is neither 2 nor 3");
    CHECK(message_for(R"({"dimension": 2.5, "balls": []})") == "s.json: /dimension: is neither 2 nor 3");
    CHECK(message_for(R"({"dimension": 2, "balls": []})") == "s.json: /balls: no balls");
    CHECK(message_for(R"({"dimension": 2, "balls": [{"position": [0, 0], "velocity": [0, 0], "radius": 1}]})") ==
          "s.json: /balls: one ball and nothing that it could meet");
    CHECK(
        message_for(R"({"dimension": 2, "balls": [{"position": [0, 0], "velocity": [0, 0], "radius": 1, "mass": "inf"},
                                                   {"position": [5, 0], "velocity": [0, 0], "radius": 1, "mass": "inf"}]})") ==
        "s.json: /balls: two infinite masses have no collision, and there is nothing else to meet");
    CHECK(message_for(scene_with{.velocity = "[1, 0]"}) ==
          "s.json: /balls/1/velocity: a vector of 2 components in a scene of dimension 3");
    CHECK(message_for(scene_with{.radius = "-1"}) == "s.json: /balls/1/radius: a negative radius");
    CHECK(message_for(scene_with{.radius = "-1e-400"}) == "s.json: /balls/1/radius: a negative radius");
    CHECK(message_for(scene_with{.more = R"(, "mass": 0)"}) == "s.json: /balls/1/mass: a mass that is not positive");
    CHECK(message_for(scene_with{.more = R"(, "mass": -2)"}) == "s.json: /balls/1/mass: a mass that is not positive");
    CHECK(message_for(scene_with{.more = R"(, "mass": "-inf")"}) == "s.json: /balls/1/mass: \"-inf\" is infinite");
    const auto with_wall = [](const std::string& edges) {
        return message_for(scene_with{.top = R"(, "walls": [{"corner": [0, 0, 0], "edges": )" + edges + "}]"});
    };
    CHECK(with_wall("[[1, 0, 0], [0, 1, 0]]") == "no error");
    CHECK(with_wall("[[1, 0, 0]]") == "s.json: /walls/0/edges: two edges expected in a scene of dimension 3, found 1");
    CHECK(with_wall("[[1, 0, 0], [0, 0, 0]]") == "s.json: /walls/0/edges/1: an edge of length 0");
    CHECK(with_wall("[[1, 2, 0], [-2, -4, 0]]") == "s.json: /walls/0/edges: parallel edges");
    CHECK(with_wall("[[\"1/3\", 1, 0], [1, 3, 0]]") == "no error"); // not parallel as doubles
    CHECK(message_for(scene_with{.top = R"(, "walls": [{"corner": [0, 0, 0], "edges": [["1/3", 1, 0], [1, 3, 0]]}])"},
                      number_input::exactly) == "s.json: /walls/0/edges: parallel edges");
    CHECK(message_for(scene_with{.top = R"(, "planes": [{"point": [0, 0, 0], "normal": [0, 0, 0]}])"}) ==
          "s.json: /planes/0/normal: a normal of length 0");
}

TEST_CASE("files") {
    const auto folder = std::filesystem::temp_directory_path() / "graze_scene_reader_test";
    std::filesystem::create_directories(folder);
    const auto path = [&](const char* name) { return (folder / name).string(); };
    CHECK(message_for_file(path("none.json")) == path("none.json") + ": no such file");
    CHECK(message_for_file(path("a\nb")).find('\n') == std::string::npos);
    CHECK(message_for_file(folder.string()) == folder.string() + ": is a directory");
    std::ofstream(path("empty.json")).close();
    CHECK(message_for_file(path("empty.json")) == path("empty.json") + ": is empty");
    std::ofstream(path("good.json")) << std::string(scene_with{});
    CHECK(read_scene(path("good.json")).name == "good");
    std::filesystem::remove_all(folder);
}

TEST_CASE("the embedded scene") {
    const scene_pairs<2> pairs = default_pairs();
    CHECK(pairs.pairs.size() == 184 + 4000);
    CHECK(pairs.total == 184 + 4000);
    CHECK(pairs.pairs.front().group == "pool break");
    CHECK(pairs.pairs.back().group == "far");
    CHECK(default_pairs(number_input::exactly).pairs.front().a.shape.velocity[0] == exact(8990, 901));
}
