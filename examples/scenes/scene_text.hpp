// Writes a scene as JSON text, with decimals made from integers: the same bytes on every platform.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scenes {

// value · 10^-digits, without trailing zeros.
[[nodiscard]] inline std::string decimal(std::int64_t value, int digits) {
    std::string text = std::to_string(value < 0 ? -value : value);
    if (digits > 0) {
        const auto places = static_cast<std::size_t>(digits);
        if (text.size() <= places) {
            text.insert(0, places + 1 - text.size(), '0');
        }
        text.insert(text.size() - places, 1, '.');
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return value < 0 && text != "0" ? "-" + text : text;
}

using components = std::vector<std::int64_t>;

// [x, y, z], in units of 10^-digits.
[[nodiscard]] inline std::string vector_text(const components& x, int digits) {
    std::string text = "[";
    for (const std::int64_t component : x) {
        text += (text.size() > 1 ? ", " : "") + decimal(component, digits);
    }
    return text + "]";
}

class scene_text {
  public:
    scene_text(int dimension, const std::string& name, const std::string& description)
        : head_("{\n  \"dimension\": " + std::to_string(dimension) + ",\n  \"name\": \"" + name +
                "\",\n  \"description\": \"" + description + "\",\n  \"source\": \"examples/scenes/generate.cpp\"") {}

    void ball(const std::string& position, const std::string& velocity, const std::string& radius,
              const std::string& mass) {
        add(balls_, "{\"position\": " + position + ", \"velocity\": " + velocity + ", \"radius\": " + radius +
                        (mass.empty() ? "" : ", \"mass\": " + mass) + "}");
    }
    void plane(const std::string& point, const std::string& normal) {
        add(planes_, "{\"point\": " + point + ", \"normal\": " + normal + "}");
    }
    void wall(const std::string& corner, const std::vector<std::string>& edges) {
        std::string text;
        for (const std::string& edge : edges) {
            text += (text.empty() ? "" : ", ") + edge;
        }
        add(walls_, "{\"corner\": " + corner + ", \"edges\": [" + text + "]}");
    }

    [[nodiscard]] std::string text() const {
        return head_ + list("balls", balls_) + list("planes", planes_) + list("walls", walls_) + "\n}\n";
    }

  private:
    static void add(std::string& items, const std::string& item) {
        items += (items.empty() ? "    " : ",\n    ") + item;
    }
    static std::string list(const char* key, const std::string& items) {
        return items.empty() ? "" : std::string(",\n  \"") + key + "\": [\n" + items + "\n  ]";
    }

    std::string head_, balls_, planes_, walls_;
};

} // namespace scenes
