#include "scene_writer.hpp"

#include "rounding.hpp"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace compare {

namespace {

// Numbers in the form that scene files take: a double as a hexadecimal float, any other number as a fraction.
struct written_number {
    std::string decimal, hexadecimal;
    [[nodiscard]] const std::string& exactly() const { return hexadecimal.empty() ? decimal : hexadecimal; }
};

written_number written(const exact& x) {
    const double nearest = nearest_double(x);
    if (!std::isfinite(nearest) || exact_of(nearest) != x) {
        return {x.str(), ""};
    }
    char text[40];
    const auto shortest = std::to_chars(text, text + sizeof text, nearest);
    written_number result{std::string(text, shortest.ptr), ""};
    const auto hexadecimal = std::to_chars(text, text + sizeof text, std::fabs(nearest), std::chars_format::hex);
    result.hexadecimal = std::string(std::signbit(nearest) ? "-0x" : "0x") + std::string(text, hexadecimal.ptr);
    return result;
}

template <int N>
std::vector<exact> numbers(const graze::vec<N, exact>& x) {
    std::vector<exact> all;
    for (int i = 0; i < N; ++i) {
        all.push_back(x[i]);
    }
    return all;
}

named_number named(const std::string& name, const std::vector<exact>& components) {
    named_number result{name, "", ""};
    bool doubles = true;
    for (const exact& x : components) {
        const written_number w = written(x);
        result.decimal += (result.decimal.empty() ? "" : ", ") + w.decimal;
        result.hexadecimal += (result.hexadecimal.empty() ? "" : ", ") + w.hexadecimal;
        doubles = doubles && !w.hexadecimal.empty();
    }
    result.hexadecimal = doubles ? result.hexadecimal : "";
    return result;
}

template <int N>
void add_ball(std::vector<named_number>& to, const std::string& ball, const exact_ball<N>& b) {
    to.push_back(named(ball + " position", numbers<N>(b.shape.position)));
    to.push_back(named(ball + " velocity", numbers<N>(b.shape.velocity)));
    to.push_back(named(ball + " radius", {b.shape.radius}));
    to.push_back(b.inverse_mass.is_zero() ? named_number{ball + " mass", "inf", ""}
                                          : named(ball + " mass", {exact(1 / b.inverse_mass)}));
}

template <int N>
std::vector<named_number> all_numbers(const problem<N>& pair) {
    std::vector<named_number> all;
    add_ball<N>(all, "a", pair.a);
    switch (pair.kind) {
    case pair_kind::ball_ball:
        add_ball<N>(all, "b", pair.b);
        break;
    case pair_kind::ball_plane:
        all.push_back(named("plane point", numbers<N>(pair.plane.point)));
        all.push_back(named("plane normal", numbers<N>(pair.plane.normal)));
        break;
    case pair_kind::ball_wall:
    case pair_kind::ball_triangle: {
        const std::string flat = pair.kind == pair_kind::ball_wall ? "wall" : "triangle";
        all.push_back(named(flat + " corner", numbers<N>(pair.wall.corner)));
        for (std::size_t i = 0; i < pair.wall.edge.size(); ++i) {
            all.push_back(named(flat + " edge " + std::to_string(i), numbers<N>(pair.wall.edge[i])));
        }
        break;
    }
    }
    return all;
}

using ordered = nlohmann::ordered_json;

ordered written_vector(const std::vector<exact>& components) {
    ordered array = ordered::array();
    for (const exact& x : components) {
        array.push_back(written(x).exactly());
    }
    return array;
}

template <int N>
ordered written_ball(const exact_ball<N>& b) {
    return {{"position", written_vector(numbers<N>(b.shape.position))},
            {"velocity", written_vector(numbers<N>(b.shape.velocity))},
            {"radius", written(b.shape.radius).exactly()},
            {"mass", b.inverse_mass.is_zero() ? "inf" : written(exact(1 / b.inverse_mass)).exactly()}};
}

template <int N>
std::string written_scene(const problem<N>& pair, const std::string& name) {
    ordered scene = {{"dimension", N}, {"name", name}, {"balls", ordered::array({written_ball<N>(pair.a)})}};
    switch (pair.kind) {
    case pair_kind::ball_ball:
        scene["balls"].push_back(written_ball<N>(pair.b));
        break;
    case pair_kind::ball_plane:
        scene["planes"] = ordered::array({ordered{{"point", written_vector(numbers<N>(pair.plane.point))},
                                                  {"normal", written_vector(numbers<N>(pair.plane.normal))}}});
        break;
    case pair_kind::ball_wall:
    case pair_kind::ball_triangle: {
        ordered edges = ordered::array();
        for (const auto& edge : pair.wall.edge) {
            edges.push_back(written_vector(numbers<N>(edge)));
        }
        scene[pair.kind == pair_kind::ball_wall ? "walls" : "triangles"] =
            ordered::array({ordered{{"corner", written_vector(numbers<N>(pair.wall.corner))}, {"edges", edges}}});
        break;
    }
    }
    // In ASCII, so that it is safe on a terminal whatever name the scene has.
    return scene.dump(1, ' ', true, ordered::error_handler_t::replace) + "\n";
}

template <int N>
std::string written_line(const problem<N>& pair) {
    std::string line = key_of(pair.kind);
    line[4] = '-'; // ball-ball
    line += " " + std::to_string(N);
    const auto add = [&](const std::vector<exact>& all) {
        for (const exact& x : all) {
            line += " " + written(exact_of(nearest_double(x))).hexadecimal;
        }
    };
    const auto add_ball = [&](const exact_ball<N>& b) {
        add(numbers<N>(b.shape.position));
        add(numbers<N>(b.shape.velocity));
        add({b.shape.radius});
        if (b.inverse_mass.is_zero()) {
            line += " inf";
        } else {
            add({exact(1 / b.inverse_mass)});
        }
    };
    add_ball(pair.a);
    if (pair.kind == pair_kind::ball_ball) {
        add_ball(pair.b);
    } else if (pair.kind == pair_kind::ball_plane) {
        add(numbers<N>(pair.plane.point));
        add(numbers<N>(pair.plane.normal));
    } else {
        add(numbers<N>(pair.wall.corner));
        for (const auto& edge : pair.wall.edge) {
            add(numbers<N>(edge));
        }
    }
    return line;
}

} // namespace

std::vector<named_number> numbers_of_pair(const problem<2>& pair) { return all_numbers<2>(pair); }
std::vector<named_number> numbers_of_pair(const problem<3>& pair) { return all_numbers<3>(pair); }
std::string scene_of_pair(const problem<2>& pair, const std::string& name) { return written_scene<2>(pair, name); }
std::string scene_of_pair(const problem<3>& pair, const std::string& name) { return written_scene<3>(pair, name); }
std::string line_of_pair(const problem<2>& pair) { return written_line<2>(pair); }
std::string line_of_pair(const problem<3>& pair) { return written_line<3>(pair); }

} // namespace compare
