#include "json_results.hpp"

#include "input_error.hpp"
#include "json_fields.hpp"
#include "json_tree.hpp"
#include "whole_file.hpp"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <thread>

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
    template <class T>
    void operator()(const char* name, where_known<T> x) {
        object[name] = x.known ? written(x.value) : json(nullptr);
    }
    template <class T>
    void operator()(const char* name, since_2<T> x) {
        object[name] = written(x.value);
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

// The place of a value in a file, for messages.
struct place {
    const std::string& file;
    std::string pointer;
    int version = schema_version; // of the file
    [[noreturn]] void fail(const std::string& what) const { fail_at(file, pointer, what); }
    [[nodiscard]] place at(const std::string& key) const { return {file, pointer_to(pointer, key), version}; }
    [[nodiscard]] place at(std::size_t index) const { return {file, pointer_to(pointer, index), version}; }
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
        take(*found(name), here.at(name), x);
    }
    template <class T>
    void operator()(const char* name, where_known<T> x) {
        const json_node& value = *found(name);
        if (value.type == json_type::null) {
            x.value = x.unknown;
        } else {
            take(value, here.at(name), x.value);
        }
    }
    template <class T>
    void operator()(const char* name, since_2<T> x) {
        if (const json_node* value = found(name, here.version == 1)) {
            take(*value, here.at(name), x.value);
        }
    }

  private:
    [[nodiscard]] const json_node* found(const char* name, bool may_miss = false) const {
        for (std::size_t i = 0; i < node.keys.size(); ++i) {
            if (node.keys[i] == name) {
                return &node.items[i];
            }
        }
        if (!may_miss) {
            here.fail("the key \"" + std::string(name) + "\" is missing");
        }
        return nullptr;
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

std::string to_benchmark_json(const results& found) {
    json benchmarks = json::array();
    std::size_t family = 0;
    for (const row& r : found.rows) {
        const std::string name = r.group + "/" + r.type + "/" + r.variant + "/" + r.root;
        for (std::size_t i = 0; i < r.repeated.size(); ++i) {
            benchmarks.push_back({{"name", name},
                                  {"family_index", family},
                                  {"per_family_instance_index", 0},
                                  {"run_name", name},
                                  {"run_type", "iteration"},
                                  {"repetitions", r.repeated.size()},
                                  {"repetition_index", i},
                                  {"threads", 1},
                                  {"iterations", r.timed_pairs},
                                  {"real_time", r.repeated[i]},
                                  {"cpu_time", r.repeated[i]},
                                  {"time_unit", "ns"}});
        }
        family += r.repeated.empty() ? 0 : 1;
    }
    const json context = {{"date", found.machine.date},
                          {"host_name", found.machine.system},
                          {"executable", found.program + found.inputs},
                          {"num_cpus", std::thread::hardware_concurrency()},
                          {"mhz_per_cpu", 0},
                          {"cpu_scaling_enabled", false},
                          {"caches", json::array()},
                          {"load_avg", json::array()},
                          {"library_build_type", "release"}};
    return json{{"context", context}, {"benchmarks", benchmarks}}.dump(1, ' ', false, json::error_handler_t::replace) +
           "\n";
}

results read_results(const std::string& path) {
    const bool is_stream = path == standard_stream;
    const std::string file = is_stream ? "the standard input" : path;
    if (std::error_code error; !is_stream && std::filesystem::is_directory(path, error)) {
        throw input_error(printable(path, 200) + ": is a directory");
    }
    std::ifstream in(path, std::ios::binary);
    if (!is_stream && !in) {
        throw input_error(printable(path, 200) + ": cannot be read: " + std::strerror(errno));
    }
    const std::string text{std::istreambuf_iterator<char>(is_stream ? std::cin : in), std::istreambuf_iterator<char>()};
    const json_node root = parse_json(text, file, 4096); // a histogram may have a key for every power of two
    place top{file, ""};
    need(root, json_type::object, "an object", top);
    std::string schema;
    field_reader reader{root, top};
    reader("schema", schema);
    if (schema != schema_name) {
        top.at("schema").fail("\"" + std::string(schema_name) + "\" expected: not a comparison");
    }
    reader("version", top.version);
    if (top.version < 1 || top.version > schema_version) {
        top.at("version").fail("versions 1 to " + std::to_string(schema_version) + " can be read, not " +
                               std::to_string(top.version));
    }
    results found;
    fields(reader, found);
    return found;
}

} // namespace compare
