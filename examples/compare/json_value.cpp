#include "json_value.hpp"

#include "exact_text.hpp"
#include "rounding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace compare {

namespace {

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

} // namespace

void json_value::fail(const std::string& what) const { fail_at(*file_, pointer_, what); }

void json_value::expect(json_type type) const {
    if (node_->type != type) {
        fail(std::string("expected ") + described(type) + ", found " + described(node_->type));
    }
}

void json_value::expect_keys(std::initializer_list<const char*> required,
                             std::initializer_list<const char*> optional) const {
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
            part(*node_, pointer_to(pointer_, key)).fail("unknown key; known here: " + known);
        }
    }
    for (const char* key : required) {
        if (!has(key)) {
            fail(std::string("the key \"") + key + "\" is missing");
        }
    }
}

bool json_value::has(const std::string& key) const {
    return std::find(node_->keys.begin(), node_->keys.end(), key) != node_->keys.end();
}

json_value json_value::at(const std::string& key) const {
    const auto index = std::find(node_->keys.begin(), node_->keys.end(), key) - node_->keys.begin();
    return part(node_->items.at(static_cast<std::size_t>(index)), pointer_to(pointer_, key));
}

std::size_t json_value::size() const {
    expect(json_type::array);
    return node_->items.size();
}

json_value json_value::at(std::size_t index) const { return part(node_->items.at(index), pointer_to(pointer_, index)); }

const std::string& json_value::text() const {
    expect(json_type::string);
    return node_->text;
}

bool json_value::is_infinite() const { return node_->type == json_type::string && is_infinity(node_->text); }

exact json_value::number() const {
    return number({[](const exact&) { return true; }, ""});
}

exact json_value::number(const number_rule& rule) const {
    const exact written = number_as_written();
    if (!rule.is_good(written)) {
        fail(rule.otherwise);
    }
    if (!as_double_) {
        return written;
    }
    const double nearest = nearest_double(written);
    if (std::isinf(nearest)) {
        fail('"' + printable(node_->text) + "\" overflows a double");
    }
    const exact result = exact_of(nearest);
    if (!rule.is_good(result)) {
        fail(std::string(rule.otherwise) + " once rounded to double");
    }
    return result;
}

void json_value::expect_components(std::size_t dimension) const {
    if (size() != dimension) {
        fail("a vector of " + std::to_string(size()) + " components in a scene of dimension " +
             std::to_string(dimension));
    }
}

json_value json_value::part(const json_node& node, std::string pointer) const {
    json_value result = *this;
    result.node_ = &node;
    result.pointer_ = std::move(pointer);
    return result;
}

exact json_value::number_as_written() const {
    if (node_->type != json_type::number && node_->type != json_type::string) {
        fail(std::string("expected a number, found ") + described(node_->type));
    }
    try {
        return parse_exact(node_->text);
    } catch (const number_text_error& error) {
        fail(error.what());
    }
}

} // namespace compare
