#include "inputs.hpp"

#include "../../examples/families/families.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace precision {

namespace {

const char* const kinds[] = {"ball-ball", "ball-plane", "ball-wall", "ball-triangle"};

template <int N, class P, class F>
void for_each_number(P& p, F f) {
    const auto vector = [&](auto& x) {
        for (int i = 0; i < N; ++i) {
            f(x[i]);
        }
    };
    const auto ball = [&](auto& b) {
        vector(b.position);
        vector(b.velocity);
        f(b.radius);
        f(b.mass);
    };
    ball(p.a);
    std::visit(
        [&](auto& other) {
            if constexpr (requires { other.radius; }) {
                ball(other);
            } else if constexpr (requires { other.normal; }) {
                vector(other.point);
                vector(other.normal);
            } else {
                vector(other.corner);
                for (auto& e : other.edge) {
                    vector(e);
                }
            }
        },
        p.other);
}

std::string hexadecimal(double x) {
    if (std::isinf(x)) {
        return x < 0 ? "-inf" : "inf";
    }
    char text[40];
    const double size = std::fabs(x);
    const auto end = std::to_chars(text, text + sizeof text, size, std::chars_format::hex).ptr;
    return std::string(std::signbit(x) ? "-0x" : "0x") + std::string(text, end);
}

double number_from(const std::string& text) {
    const bool negative = text.starts_with('-');
    std::string digits = text.substr(negative ? 1 : 0);
    double x = 0;
    const bool is_hexadecimal = digits.starts_with("0x");
    digits = digits.substr(is_hexadecimal ? 2 : 0);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x,
                                              is_hexadecimal ? std::chars_format::hex : std::chars_format::general);
    if (error != std::errc() || end != digits.data() + digits.size() || (!is_hexadecimal && digits != "inf")) {
        throw std::runtime_error("\"" + text + "\" is not a hexadecimal float, as 0x1.8p-3, or inf");
    }
    return negative ? -x : x;
}

template <int N>
any_pair pair_from(std::size_t kind, const std::vector<double>& numbers) {
    pair<N> p{};
    if (kind == 1) {
        p.other = graze::plane<N, double>{};
    } else if (kind == 2) {
        p.other = graze::wall<N, double>{};
    } else if (kind == 3) {
        if constexpr (N == 3) {
            p.other = graze::triangle<double>{};
        } else {
            throw std::runtime_error("a ball-triangle has 3 dimensions");
        }
    }
    const std::size_t wanted = numbers_of(p).size();
    if (numbers.size() != wanted) {
        throw std::runtime_error(std::string(kinds[kind]) + " in " + std::to_string(N) + " dimensions takes " +
                                 std::to_string(wanted) + " numbers, not " + std::to_string(numbers.size()));
    }
    set_numbers(p, numbers);
    return p;
}

template <int N>
any_pair from_family(const families::pair_of_doubles<N>& drawn) {
    pair<N> p{drawn.a, drawn.b};
    if (drawn.kind == families::pair_kind::ball_plane) {
        p.other = drawn.plane;
    } else if (drawn.kind == families::pair_kind::ball_wall) {
        p.other = drawn.wall;
    }
    return p;
}

template <int N>
std::string json(const graze::vec<N, double>& x) {
    std::string text = "[";
    for (int i = 0; i < N; ++i) {
        text += (i == 0 ? "\"" : ", \"") + hexadecimal(x[i]) + "\"";
    }
    return text + "]";
}
template <int N>
std::string json(const graze::ball<N, double>& b) {
    return "{\"position\": " + json(b.position) + ", \"velocity\": " + json(b.velocity) + ", \"radius\": \"" +
           hexadecimal(b.radius) + "\", \"mass\": \"" + hexadecimal(b.mass) + "\"}";
}

template <int N>
std::string scene_of(const pair<N>& p, const std::string& name, const pair<N>* other) {
    std::string balls = json(p.a), rest;
    if (other != nullptr) {
        balls = json(other->a) + ",\n    " + json(std::get<graze::ball<N, double>>(other->other)) + ",\n    " + balls;
    }
    if (const auto* b = std::get_if<graze::ball<N, double>>(&p.other)) {
        balls += ",\n    " + json(*b);
    } else if (const auto* plane = std::get_if<graze::plane<N, double>>(&p.other)) {
        rest = ",\n  \"planes\": [{\"point\": " + json(plane->point) + ", \"normal\": " + json(plane->normal) + "}]";
    } else {
        std::visit(
            [&](const auto& w) {
                if constexpr (requires { w.corner; }) {
                    std::string edges;
                    for (const auto& e : w.edge) {
                        edges += (edges.empty() ? "" : ", ") + json(e);
                    }
                    const bool is_wall = std::holds_alternative<graze::wall<N, double>>(p.other);
                    rest = std::string(",\n  \"") + (is_wall ? "walls" : "triangles") +
                           "\": [{\"corner\": " + json(w.corner) + ", \"edges\": [" + edges + "]}]";
                }
            },
            p.other);
    }
    return "{\n  \"dimension\": " + std::to_string(N) + ",\n  \"name\": \"" + name + "\",\n  \"balls\": [\n    " +
           balls + "\n  ]" + rest + "\n}\n";
}

} // namespace

template <int N>
std::vector<double> numbers_of(const pair<N>& p) {
    std::vector<double> numbers;
    for_each_number<N>(p, [&](double x) { numbers.push_back(x); });
    return numbers;
}

template <int N>
void set_numbers(pair<N>& p, const std::vector<double>& numbers) {
    auto next = numbers.begin();
    for_each_number<N>(p, [&](double& x) { x = *next++; });
}

template std::vector<double> numbers_of(const pair<2>&);
template std::vector<double> numbers_of(const pair<3>&);
template void set_numbers(pair<2>&, const std::vector<double>&);
template void set_numbers(pair<3>&, const std::vector<double>&);

std::string to_line(const any_pair& p) {
    return std::visit(
        []<int N>(const pair<N>& q) {
            std::string line = std::string(kinds[q.other.index()]) + " " + std::to_string(N);
            for (const double x : numbers_of(q)) {
                line += " " + hexadecimal(x);
            }
            return line;
        },
        p);
}

any_pair from_line(const std::string& line) {
    std::istringstream words(line);
    std::string kind, dimension, word;
    words >> kind >> dimension;
    const auto which = std::find(std::begin(kinds), std::end(kinds), kind);
    if (which == std::end(kinds)) {
        throw std::runtime_error("\"" + kind + "\" is not ball-ball, ball-plane, ball-wall or ball-triangle");
    }
    if (dimension != "2" && dimension != "3") {
        throw std::runtime_error("the dimension is \"" + dimension + "\", not 2 or 3");
    }
    std::vector<double> numbers;
    while (words >> word) {
        numbers.push_back(number_from(word));
    }
    const auto index = static_cast<std::size_t>(which - std::begin(kinds));
    return dimension == "2" ? pair_from<2>(index, numbers) : pair_from<3>(index, numbers);
}

std::string to_scene(const any_pair& p, const std::string& name, const any_pair* other) {
    return std::visit(
        [&]<int N>(const pair<N>& q) {
            return scene_of<N>(q, name, other == nullptr ? nullptr : &std::get<pair<N>>(*other));
        },
        p);
}

std::vector<family> drawn_families(std::size_t count, std::uint64_t seed) {
    std::vector<family> drawn;
    for (const families::family& f : families::all_families) {
        family one{std::string(f.name), {}};
        for (std::size_t i = 0; i < count; ++i) {
            one.pairs.push_back(i / 2 % 2 == 0 ? from_family(f.draw<2>(seed, i)) : from_family(f.draw<3>(seed, i)));
        }
        drawn.push_back(std::move(one));
    }
    return drawn;
}

family drawn_triangles(std::size_t count, std::uint64_t seed) {
    constexpr std::array<const char*, 3> about_walls = {"edges_and_corners", "borders", "generic_wall"};
    family drawn{"triangles", {}};
    for (std::size_t i = 0; drawn.pairs.size() < count; ++i) {
        const auto* const from =
            std::ranges::find(families::all_families, about_walls[i % about_walls.size()], &families::family::name);
        const auto one = from->draw<3>(seed, i);
        if (one.kind == families::pair_kind::ball_wall) {
            drawn.pairs.push_back(pair<3>{one.a, graze::triangle<double>{one.wall.corner, one.wall.edge}});
        }
    }
    return drawn;
}

family read_inputs(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) {
        throw std::runtime_error(file.string() + ": cannot be read");
    }
    family kept{"kept." + file.stem().string(), {}};
    bool has_origin = false;
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        const std::string place = file.string() + ":" + std::to_string(number) + ": ";
        if (line.empty() || line.starts_with('#')) {
            has_origin = has_origin || (line.starts_with("# origin: ") && line.size() > 10);
            continue;
        }
        if (!has_origin) {
            throw std::runtime_error(place + "no line `# origin: ` before it says where the pair came from");
        }
        try {
            kept.pairs.push_back(from_line(line));
        } catch (const std::runtime_error& e) {
            throw std::runtime_error(place + e.what());
        }
    }
    return kept;
}

} // namespace precision
