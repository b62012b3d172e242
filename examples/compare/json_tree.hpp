// JSON text as a tree. Numbers keep the text that they have in the file.
#pragma once

#include "input_error.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace compare {

enum class json_type { null, boolean, number, string, array, object };

struct json_node {
    json_type type = json_type::null;
    std::string text;              // of a number, a string or a boolean
    std::vector<std::string> keys; // of an object, in the file's order, without repetition
    std::vector<json_node> items;  // of an array or an object
};

// Throws input_error, which names the file and the place: for a syntax error the line and the column of the last
// character read, in characters; for a key that occurs twice, an object of more than most_keys keys, or arrays and
// objects nested more than eight deep the JSON pointer. A UTF-8 byte order mark is skipped.
[[nodiscard]] json_node parse_json(std::string_view text, const std::string& file, std::size_t most_keys = 32);

// The JSON pointer (RFC 6901) of the member `key` of the value at `pointer`.
[[nodiscard]] std::string pointer_to(const std::string& pointer, const std::string& key);
[[nodiscard]] std::string pointer_to(const std::string& pointer, std::size_t index);

// Throws input_error about the value at the pointer. "" points to the whole text.
[[noreturn]] void fail_at(const std::string& file, const std::string& pointer, const std::string& what);

} // namespace compare
