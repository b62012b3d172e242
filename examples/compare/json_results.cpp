#include "json_results.hpp"

#include "input_error.hpp"
#include "json_fields.hpp"
#include "json_tree.hpp"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace compare {

namespace {

using json = nlohmann::ordered_json;
constexpr const char* schema_name = "graze-compare";

// JSON has no infinity; a string stands for it.
constexpr const char* infinite = "infinity";
constexpr const char* minus_infinite = "-infinity";

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

json written(double x);
json written(const std::array<double, quantile_shares.size()>& values);
json written(const std::array<error_statistics, quantity_count>& errors);
json written(const std::map<int, std::size_t>& counts);
json written(const std::map<std::string, std::size_t>& counts);
template <class T>
json written(const T& x);

struct field_writer {
    json object = json::object();
    template <class T>
    void operator()(const char* name, const T& x) {
        object[name] = written(x);
    }
};

json written(double x) {
    return std::isfinite(x) ? json(x) : std::isnan(x) ? json(nullptr) : json(x > 0 ? infinite : minus_infinite);
}
json written(const std::array<double, quantile_shares.size()>& values) {
    json array = json::array();
    for (const double x : values) {
        array.push_back(written(x));
    }
    return array;
}
json written(const std::array<error_statistics, quantity_count>& errors) {
    json object = json::object();
    for (std::size_t i = 0; i < quantity_count; ++i) {
        object[quantity_names[i]] = written(errors[i]);
    }
    return object;
}
json written(const std::map<int, std::size_t>& counts) {
    json object = json::object();
    for (const auto& [key, count] : counts) {
        object[std::to_string(key)] = count;
    }
    return object;
}
json written(const std::map<std::string, std::size_t>& counts) { return json(counts); }

template <class T>
json written(const T& x) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
        return json(x);
    } else if constexpr (is_optional<T>) {
        return x ? written(*x) : json(nullptr);
    } else if constexpr (is_vector<T>) {
        json array = json::array();
        for (const auto& item : x) {
            array.push_back(written(item));
        }
        return array;
    } else {
        field_writer writer;
        fields(writer, x);
        return std::move(writer.object);
    }
}

// Where something stands, for messages.
struct place {
    const std::string& file;
    std::string pointer;
    [[noreturn]] void fail(const std::string& what) const { fail_at(file, pointer, what); }
    [[nodiscard]] place at(const std::string& key) const { return {file, pointer_to(pointer, key)}; }
    [[nodiscard]] place at(std::size_t index) const { return {file, pointer_to(pointer, index)}; }
};

void need(const json_node& node, json_type type, const char* name, const place& here) {
    if (node.type != type) {
        here.fail(std::string(name) + " expected");
    }
}

void take(const json_node& node, const place& here, std::string& x);
void take(const json_node& node, const place& here, bool& x);
void take(const json_node& node, const place& here, double& x);
template <std::integral I>
void take(const json_node& node, const place& here, I& x);
void take(const json_node& node, const place& here, std::array<double, quantile_shares.size()>& values);
void take(const json_node& node, const place& here, std::array<error_statistics, quantity_count>& errors);
template <class Key>
void take(const json_node& node, const place& here, std::map<Key, std::size_t>& counts);
template <class T>
void take(const json_node& node, const place& here, T& x);

struct field_reader {
    const json_node& node;
    const place& here;
    template <class T>
    void operator()(const char* name, T& x) {
        for (std::size_t i = 0; i < node.keys.size(); ++i) {
            if (node.keys[i] == name) {
                take(node.items[i], here.at(name), x);
                return;
            }
        }
        here.fail("the key \"" + std::string(name) + "\" is missing");
    }
};

void take(const json_node& node, const place& here, std::string& x) {
    need(node, json_type::string, "a string", here);
    x = node.text;
}
void take(const json_node& node, const place& here, bool& x) {
    need(node, json_type::boolean, "true or false", here);
    x = node.text == "true";
}
void take(const json_node& node, const place& here, double& x) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (node.type == json_type::string && (node.text == infinite || node.text == minus_infinite)) {
        x = node.text == infinite ? infinity : -infinity;
        return;
    }
    need(node, json_type::number, "a number", here);
    const char* end = node.text.data() + node.text.size();
    if (std::from_chars(node.text.data(), end, x).ec != std::errc()) {
        here.fail("not a double");
    }
}
template <std::integral I>
void take(const json_node& node, const place& here, I& x) {
    need(node, json_type::number, "a whole number", here);
    const char* end = node.text.data() + node.text.size();
    const auto parsed = std::from_chars(node.text.data(), end, x);
    if (parsed.ec != std::errc() || parsed.ptr != end) {
        here.fail("not a whole number in range");
    }
}
void take(const json_node& node, const place& here, std::array<double, quantile_shares.size()>& values) {
    need(node, json_type::array, "an array", here);
    if (node.items.size() != values.size()) {
        here.fail(std::to_string(values.size()) + " numbers expected");
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        take(node.items[i], here.at(i), values[i]);
    }
}
void take(const json_node& node, const place& here, std::array<error_statistics, quantity_count>& errors) {
    need(node, json_type::object, "an object", here);
    field_reader reader{node, here};
    for (std::size_t i = 0; i < quantity_count; ++i) {
        reader(quantity_names[i], errors[i]);
    }
}
template <class Key>
void take(const json_node& node, const place& here, std::map<Key, std::size_t>& counts) {
    need(node, json_type::object, "an object", here);
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const place there = here.at(node.keys[i]);
        std::size_t count = 0;
        take(node.items[i], there, count);
        if constexpr (std::is_same_v<Key, int>) {
            int key = 0;
            take(json_node{json_type::number, node.keys[i], {}, {}}, there, key);
            counts[key] = count;
        } else {
            counts[node.keys[i]] = count;
        }
    }
}

template <class T>
void take(const json_node& node, const place& here, T& x) {
    if constexpr (is_optional<T>) {
        if (node.type != json_type::null) {
            take(node, here, x.emplace());
        }
    } else if constexpr (is_vector<T>) {
        need(node, json_type::array, "an array", here);
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            take(node.items[i], here.at(i), x.emplace_back());
        }
    } else {
        need(node, json_type::object, "an object", here);
        field_reader reader{node, here};
        fields(reader, x);
    }
}

} // namespace

std::string to_json(const results& found) {
    field_writer writer;
    writer("schema", std::string(schema_name));
    writer("version", schema_version);
    writer("quantile_shares", quantile_shares);
    fields(writer, found);
    return writer.object.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

results read_results(const std::string& path) {
    if (std::error_code error; std::filesystem::is_directory(path, error)) {
        throw input_error(printable(path, 200) + ": is a directory");
    }
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        throw input_error(printable(path, 200) + ": cannot be read");
    }
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const json_node root = parse_json(text, path, 4096); // a histogram may have a key for every power of two
    const place top{path, ""};
    need(root, json_type::object, "an object", top);
    std::string schema;
    int version = 0;
    field_reader reader{root, top};
    reader("schema", schema);
    if (schema != schema_name) {
        top.at("schema").fail("\"" + std::string(schema_name) + "\" expected: not a comparison");
    }
    reader("version", version);
    if (version != schema_version) {
        top.at("version").fail("version " + std::to_string(schema_version) + " expected, not " +
                               std::to_string(version));
    }
    results found;
    fields(reader, found);
    return found;
}

} // namespace compare
