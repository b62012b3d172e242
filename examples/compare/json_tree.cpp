#include "json_tree.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace compare {

namespace {

// long double, because the parser converts every number and must not refuse those beyond the range of double.
using tree = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, long double>;

constexpr std::size_t deepest = 8;

class tree_builder final : public nlohmann::json_sax<tree> {
  public:
    tree_builder(std::string_view text, const std::string& file, std::size_t most_keys)
        : text_(text), file_(file), most_keys_(most_keys) {}

    [[nodiscard]] json_node take() { return std::move(root_); }

    bool null() override { return leaf(json_type::null, {}); }
    bool boolean(bool value) override { return leaf(json_type::boolean, value ? "true" : "false"); }
    bool number_integer(std::int64_t value) override { return leaf(json_type::number, std::to_string(value)); }
    bool number_unsigned(std::uint64_t value) override { return leaf(json_type::number, std::to_string(value)); }
    bool number_float(long double, const std::string& raw) override { return leaf(json_type::number, raw); }
    bool string(std::string& value) override { return leaf(json_type::string, std::move(value)); }
    bool binary(tree::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(json_type::object); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(json_type::array); }
    bool end_array() override { return close(); }

    bool key(std::string& value) override {
        auto& keys = open_.back()->keys;
        if (std::find(keys.begin(), keys.end(), value) != keys.end()) {
            fail_at(file_, pointer_to(pointer(false), value), "the key occurs twice");
        }
        if (keys.size() == most_keys_) {
            fail_at(file_, pointer(false), "an object of more than " + std::to_string(most_keys_) + " keys");
        }
        keys.push_back(std::move(value));
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) override {
        if (error.id == 406) { // out of range, even for long double
            fail_at(file_, pointer(true), "\"" + printable(token, 40) + "\" is too large: write it as a string");
        }
        std::string what = error.what();
        if (const auto column = what.find(", column "); column != std::string::npos) {
            what.erase(0, what.find(": ", column) + 2);
        }
        const std::size_t last = std::min(position == 0 ? 0 : position - 1, text_.size());
        std::size_t line = 1, column = 1;
        for (std::size_t i = text_.starts_with("\xef\xbb\xbf") ? 3 : 0; i < last; ++i) {
            if (text_[i] == '\n') {
                ++line;
                column = 1;
            } else if ((static_cast<unsigned char>(text_[i]) & 0xc0U) != 0x80U) {
                ++column;
            }
        }
        throw input_error(printable(file_, 4096) + ": line " + std::to_string(line) + ", column " +
                          std::to_string(column) + ": " + printable(what, 300));
    }

  private:
    json_node& add(json_type type) {
        json_node* node = &root_;
        if (!open_.empty()) {
            node = &open_.back()->items.emplace_back();
        }
        node->type = type;
        return *node;
    }

    bool leaf(json_type type, std::string text) {
        add(type).text = std::move(text);
        return true;
    }

    bool open(json_type type) {
        if (open_.size() == deepest) {
            fail_at(file_, pointer(true), "arrays and objects nested more than eight deep");
        }
        open_.push_back(&add(type)); // stays valid: the parent gets no other item before this one is closed
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    // The pointer of the innermost open array or object or, if `next`, of the item that comes next in it.
    [[nodiscard]] std::string pointer(bool next) const {
        std::string result;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const json_node& node = *open_[i];
            const bool innermost = i + 1 == open_.size();
            if (innermost && !next) {
                break;
            }
            result = node.type == json_type::object ? pointer_to(result, node.keys.back())
                                                    : pointer_to(result, node.items.size() - (innermost ? 0 : 1));
        }
        return result;
    }

    std::string_view text_;
    const std::string& file_;
    std::size_t most_keys_;
    json_node root_;
    std::vector<json_node*> open_;
};

} // namespace

json_node parse_json(std::string_view text, const std::string& file, std::size_t most_keys) {
    const bool utf16 = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
    if (utf16 || text.find('\0') != std::string_view::npos) {
        throw input_error(printable(file, 4096) + ": is not JSON text in UTF-8");
    }
    if (text.find_first_not_of(" \t\r\n", text.starts_with("\xef\xbb\xbf") ? 3 : 0) == std::string_view::npos) {
        throw input_error(printable(file, 4096) + ": is empty");
    }
    tree_builder builder(text, file, most_keys);
    tree::sax_parse(text, &builder);
    return builder.take();
}

std::string pointer_to(const std::string& pointer, const std::string& key) {
    std::string result = pointer + '/';
    for (const char c : key) {
        c == '~' ? result += "~0" : c == '/' ? result += "~1" : result += c;
    }
    return result;
}

std::string pointer_to(const std::string& pointer, std::size_t index) { return pointer + '/' + std::to_string(index); }

void fail_at(const std::string& file, const std::string& pointer, const std::string& what) {
    throw input_error(printable(file, 4096) + ": " + (pointer.empty() ? "" : printable(pointer, 200) + ": ") + what);
}

} // namespace compare
