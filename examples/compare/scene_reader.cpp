#include "scene_reader.hpp"

#include "exact_text.hpp"
#include "json_tree.hpp"
#include "rounding.hpp"

#include <graze/linear/vec.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <utility>

namespace compare {

namespace {

constexpr std::size_t largest_file = std::size_t{256} << 20U;

const char* described(json_type type) {
    switch (type) {
    case json_type::null:
        return "null";
    case json_type::boolean:
        return "a boolean";
    case json_type::number:
        return "a number";
    case json_type::string:
        return "a string";
    case json_type::array:
        return "an array";
    case json_type::object:
        return "an object";
    }
    return "nothing";
}

class reader;

// A value of the file and where it stands.
class value {
  public:
    value(const reader& from, const json_node& node, std::string pointer)
        : reader_(&from), node_(&node), pointer_(std::move(pointer)) {}

    [[noreturn]] void fail(const std::string& what) const;

    void expect(json_type type) const {
        if (node_->type != type) {
            fail(std::string("expected ") + described(type) + ", found " + described(node_->type));
        }
    }

    // Of an object: every key is one of these, and the required ones are there.
    void expect_keys(std::initializer_list<const char*> required, std::initializer_list<const char*> optional) const {
        expect(json_type::object);
        for (const std::string& key : node_->keys) {
            const auto is_key = [&](const char* known) { return key == known; };
            if (std::none_of(required.begin(), required.end(), is_key) &&
                std::none_of(optional.begin(), optional.end(), is_key)) {
                std::string known;
                for (const auto& list : {required, optional}) {
                    for (const char* name : list) {
                        known += (known.empty() ? "" : ", ") + std::string(name);
                    }
                }
                value(*reader_, *node_, pointer_to(pointer_, key)).fail("unknown key; known here: " + known);
            }
        }
        for (const char* key : required) {
            if (!has(key)) {
                fail(std::string("the key \"") + key + "\" is missing");
            }
        }
    }

    [[nodiscard]] bool has(const std::string& key) const {
        return std::find(node_->keys.begin(), node_->keys.end(), key) != node_->keys.end();
    }

    [[nodiscard]] value at(const std::string& key) const {
        const auto index = std::find(node_->keys.begin(), node_->keys.end(), key) - node_->keys.begin();
        return {*reader_, node_->items[static_cast<std::size_t>(index)], pointer_to(pointer_, key)};
    }

    [[nodiscard]] value at(std::size_t index) const {
        return {*reader_, node_->items[index], pointer_to(pointer_, index)};
    }

    [[nodiscard]] std::size_t size() const {
        expect(json_type::array);
        return node_->items.size();
    }

    [[nodiscard]] const std::string& text() const {
        expect(json_type::string);
        return node_->text;
    }

    [[nodiscard]] bool is_infinite() const { return node_->type == json_type::string && is_infinity(node_->text); }

    [[nodiscard]] exact number() const;

    // A number that as written and as read satisfies the test.
    template <class Test>
    [[nodiscard]] exact number(Test is_good, const char* what_it_is_otherwise) const;

    template <int N>
    [[nodiscard]] graze::vec<N, exact> vector() const {
        if (size() != N) {
            fail("a vector of " + std::to_string(size()) + " components in a scene of dimension " + std::to_string(N));
        }
        return graze::make_vec<N>([&](int i) { return at(static_cast<std::size_t>(i)).number(); });
    }

    template <int N>
    [[nodiscard]] graze::vec<N, exact> vector_not_zero(const char* what_it_is_otherwise) const {
        const auto result = vector<N>();
        if (graze::sign(graze::squared_norm(result)) == 0) {
            fail(what_it_is_otherwise);
        }
        return result;
    }

  private:
    [[nodiscard]] exact number_as_written() const {
        if (node_->type != json_type::number && node_->type != json_type::string) {
            fail(std::string("expected a number, found ") + described(node_->type));
        }
        try {
            return parse_exact(node_->text);
        } catch (const number_text_error& error) {
            fail(error.what());
        }
    }

    const reader* reader_;
    const json_node* node_;
    std::string pointer_;
};

class reader {
  public:
    reader(const std::string& file, number_input numbers) : file_(file), numbers_(numbers) {}

    [[nodiscard]] scene_file read(const json_node& root) const {
        const value top(*this, root, "");
        top.expect_keys({"dimension", "balls"}, {"name", "description", "source", "planes", "walls"});
        scene_file result;
        result.name = top.has("name") ? top.at("name").text() : std::filesystem::path(file_).stem().string();
        result.description = top.has("description") ? top.at("description").text() : "";
        result.source = top.has("source") ? top.at("source").text() : "";
        const exact dimension = top.at("dimension").number();
        if (dimension == 2) {
            result.scene = scene<2>(top);
        } else if (dimension == 3) {
            result.scene = scene<3>(top);
        } else {
            top.at("dimension").fail("is neither 2 nor 3");
        }
        return result;
    }

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] bool as_double() const { return numbers_ == number_input::as_double; }

  private:
    template <int N>
    [[nodiscard]] exact_scene<N> scene(const value& top) const {
        exact_scene<N> result;
        const value balls = top.at("balls");
        for (std::size_t i = 0; i < balls.size(); ++i) {
            result.balls.push_back(ball<N>(balls.at(i)));
        }
        if (result.balls.empty()) {
            balls.fail("no balls");
        }
        for (std::size_t i = 0; top.has("planes") && i < top.at("planes").size(); ++i) {
            const value plane = top.at("planes").at(i);
            plane.expect_keys({"point", "normal"}, {});
            result.planes.push_back({plane.at("point").template vector<N>(),
                                     plane.at("normal").template vector_not_zero<N>("a normal of length 0")});
        }
        for (std::size_t i = 0; top.has("walls") && i < top.at("walls").size(); ++i) {
            result.walls.push_back(wall<N>(top.at("walls").at(i)));
        }
        if (result.balls.size() == 1 && result.planes.empty() && result.walls.empty()) {
            balls.fail("one ball and nothing that it could meet");
        }
        return result;
    }

    template <int N>
    [[nodiscard]] exact_ball<N> ball(const value& from) const {
        from.expect_keys({"position", "velocity", "radius"}, {"mass"});
        exact_ball<N> result;
        result.shape.position = from.at("position").template vector<N>();
        result.shape.velocity = from.at("velocity").template vector<N>();
        result.shape.radius =
            from.at("radius").number([](const exact& r) { return r.sign() >= 0; }, "a negative radius");
        result.shape.mass = exact(1);
        result.inverse_mass = exact(1);
        if (from.has("mass") && from.at("mass").is_infinite()) {
            result.inverse_mass = exact(0);
        } else if (from.has("mass")) {
            result.shape.mass =
                from.at("mass").number([](const exact& m) { return m.sign() > 0; }, "a mass that is not positive");
            result.inverse_mass = 1 / result.shape.mass;
        }
        return result;
    }

    template <int N>
    [[nodiscard]] graze::wall<N, exact> wall(const value& from) const {
        from.expect_keys({"corner", "edges"}, {});
        graze::wall<N, exact> result;
        result.corner = from.at("corner").template vector<N>();
        const value edges = from.at("edges");
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

    const std::string& file_;
    number_input numbers_;
};

void value::fail(const std::string& what) const { fail_at(reader_->file(), pointer_, what); }

exact value::number() const {
    return number([](const exact&) { return true; }, "");
}

template <class Test>
exact value::number(Test is_good, const char* what_it_is_otherwise) const {
    const exact written = number_as_written();
    if (!is_good(written)) {
        fail(what_it_is_otherwise);
    }
    if (!reader_->as_double()) {
        return written;
    }
    const double nearest = nearest_double(written);
    if (std::isinf(nearest)) {
        fail('"' + printable(node_->text) + "\" overflows a double");
    }
    const exact result = exact_of(nearest);
    if (!is_good(result)) {
        fail(std::string(what_it_is_otherwise) + " once rounded to double");
    }
    return result;
}

[[noreturn]] void fail_to_read(const std::string& path, const std::string& what) {
    throw input_error(printable(path, 4096) + ": " + what);
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

} // namespace

scene_file read_scene(const std::string& path, number_input numbers) {
    return read_scene_text(content_of(path), path, numbers);
}

scene_file read_scene_text(std::string_view text, const std::string& file, number_input numbers) {
    return reader(file, numbers).read(parse_json(text, file));
}

} // namespace compare
