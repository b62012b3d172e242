#include "scene_reader.hpp"

#include "json_value.hpp"

#include <graze/linear/vec.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace compare {

namespace {

template <int N>
exact_ball<N> ball_from(const json_value& from) {
    from.expect_keys({"position", "velocity", "radius"}, {"mass"});
    exact_ball<N> result;
    result.shape.position = from.at("position").template vector<N>();
    result.shape.velocity = from.at("velocity").template vector<N>();
    result.shape.radius = from.at("radius").number({[](const exact& r) { return r.sign() >= 0; }, "a negative radius"});
    result.shape.mass = exact(1);
    result.inverse_mass = exact(1);
    if (from.has("mass") && from.at("mass").is_infinite()) {
        result.inverse_mass = exact(0);
    } else if (from.has("mass")) {
        result.shape.mass =
            from.at("mass").number({[](const exact& m) { return m.sign() > 0; }, "a mass that is not positive"});
        result.inverse_mass = 1 / result.shape.mass;
    }
    return result;
}

// The corner and the edges of a wall or a triangle.
template <int N>
graze::wall<N, exact> flat_from(const json_value& from) {
    graze::wall<N, exact> result;
    result.corner = from.at("corner").template vector<N>();
    const json_value edges = from.at("edges");
    if (edges.size() != N - 1) {
        edges.fail(std::string(N == 2 ? "one edge" : "two edges") + " expected in a scene of dimension " +
                   std::to_string(N) + ", found " + std::to_string(edges.size()));
    }
    for (std::size_t i = 0; i < N - 1; ++i) {
        result.edge[i] = edges.at(i).template vector_not_zero<N>("an edge of length 0");
    }
    if constexpr (N == 3) {
        if (graze::sign(graze::squared_norm(graze::cross(result.edge[0], result.edge[1]))) == 0) {
            edges.fail("parallel edges");
        }
    }
    return result;
}

// A bit for each edge of a triangle at which nothing is met.
std::uint8_t inner_edges_from(const json_value& from) {
    std::uint8_t bits = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const exact edge = from.at(i).number(
            {[](const exact& k) { return k == 0 || k == 1 || k == 2; }, "no edge of a triangle: 0, 1 or 2"});
        bits = static_cast<std::uint8_t>(bits | 1U << static_cast<unsigned>(numerator(edge)));
    }
    return bits;
}

template <int N>
void add_triangles(exact_scene<N>& to, const json_value& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        const json_value from = all.at(i);
        if constexpr (N == 3) {
            from.expect_keys({"corner", "edges"}, {"inner_edges"});
            const graze::wall<3, exact> half_of = flat_from<3>(from);
            to.triangles.push_back({half_of.corner, half_of.edge});
            to.inner_edges.push_back(from.has("inner_edges") ? inner_edges_from(from.at("inner_edges")) : 0U);
        } else {
            from.fail("a triangle in a scene of dimension 2");
        }
    }
}

template <int N>
exact_scene<N> scene_from(const json_value& top) {
    exact_scene<N> result;
    const json_value balls = top.at("balls");
    for (std::size_t i = 0; i < balls.size(); ++i) {
        result.balls.push_back(ball_from<N>(balls.at(i)));
    }
    if (result.balls.empty()) {
        balls.fail("no balls");
    }
    for (std::size_t i = 0; top.has("planes") && i < top.at("planes").size(); ++i) {
        const json_value plane = top.at("planes").at(i);
        plane.expect_keys({"point", "normal"}, {});
        result.planes.push_back({plane.at("point").template vector<N>(),
                                 plane.at("normal").template vector_not_zero<N>("a normal of length 0")});
    }
    for (std::size_t i = 0; top.has("walls") && i < top.at("walls").size(); ++i) {
        const json_value wall = top.at("walls").at(i);
        wall.expect_keys({"corner", "edges"}, {});
        result.walls.push_back(flat_from<N>(wall));
    }
    if (top.has("triangles")) {
        add_triangles<N>(result, top.at("triangles"));
    }
    if (top.has("period")) {
        const json_value period = top.at("period");
        result.period = period.template vector<N>();
        for (int i = 0; i < N; ++i) {
            if (result.period[i].sign() < 0) {
                period.at(static_cast<std::size_t>(i)).fail("a negative period");
            }
        }
    }
    if (result.planes.empty() && result.walls.empty() && result.triangles.empty()) {
        if (result.balls.size() == 1) {
            balls.fail("one ball and nothing that it could meet");
        }
        if (std::all_of(result.balls.begin(), result.balls.end(),
                        [](const exact_ball<N>& b) { return b.inverse_mass.is_zero(); })) {
            balls.fail("two infinite masses have no collision, and there is nothing else to meet");
        }
    }
    return result;
}

constexpr std::size_t largest_file = std::size_t{256} << 20U;

[[noreturn]] void fail_to_read(const std::string& path, const std::string& what) {
    throw input_error(printable(path, 4096) + ": " + what);
}

std::string content_of(std::istream& in, const std::string& path) {
    std::string text;
    std::string block(1U << 16U, '\0');
    while (in) {
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        text.append(block, 0, static_cast<std::size_t>(in.gcount()));
        if (text.size() > largest_file) {
            fail_to_read(path, "is larger than 256 MiB");
        }
    }
    if (in.bad()) {
        fail_to_read(path, std::strerror(errno));
    }
    return text;
}

std::string content_of(const std::string& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        fail_to_read(path, status.type() == std::filesystem::file_type::not_found ? "no such file" : error.message());
    }
    if (std::filesystem::is_directory(status)) {
        fail_to_read(path, "is a directory");
    }
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        fail_to_read(path, std::strerror(errno));
    }
    return content_of(in, path);
}

} // namespace

scene_file read_scene(const std::string& path, number_input numbers) {
    if (path == "-") {
        const std::string stream = "the standard input";
        return read_scene_text(content_of(std::cin, stream), stream, numbers);
    }
    return read_scene_text(content_of(path), path, numbers);
}

scene_file read_scene_text(std::string_view text, const std::string& file, number_input numbers) {
    const json_node root = parse_json(text, file);
    const json_value top(file, root, numbers == number_input::as_double);
    top.expect_keys({"dimension", "balls"},
                    {"name", "description", "source", "planes", "walls", "triangles", "period"});
    scene_file result;
    result.name = top.has("name") ? top.at("name").text() : std::filesystem::path(file).stem().string();
    result.description = top.has("description") ? top.at("description").text() : "";
    result.source = top.has("source") ? top.at("source").text() : "";
    const exact dimension = top.at("dimension").number();
    if (dimension == 2) {
        result.scene = scene_from<2>(top);
    } else if (dimension == 3) {
        result.scene = scene_from<3>(top);
    } else {
        top.at("dimension").fail("is neither 2 nor 3");
    }
    return result;
}

} // namespace compare
