#include "svg.hpp"

#include "gnuplot.hpp"
#include "text.hpp"

#include <boost/property_tree/xml_parser.hpp>

#include <array>
#include <charconv>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string_view>

namespace compare::report {
namespace {

using element = boost::property_tree::ptree;

struct marker {
    std::string_view id, start; // start: the element up to its class
};

[[nodiscard]] const marker& marker_of(std::string_view reference) {
    static constexpr std::string_view hollow_square =
        R"(<rect class="hollow" x="-.9" y="-.9" width="1.8" height="1.8")";
    static constexpr std::string_view square = R"(<rect class="full" x="-.9" y="-.9" width="1.8" height="1.8")";
    static constexpr std::array<marker, 8> markers = {
        {{"#gpPt3", hollow_square},
         {"#gpPt4", square},
         {"#gpPt5", R"(<circle class="hollow" r="1")"},
         {"#gpPt6", R"(<circle class="full" r="1")"},
         {"#gpPt7", R"(<path class="hollow" d="M0-1.2L-1.15.8H1.15z")"},
         {"#gpPt8", R"(<path class="full" d="M0-1.2L-1.15.8H1.15z")"},
         {"#gpPt11", R"(<path class="hollow" d="M0-1.3L1.3 0 0 1.3-1.3 0z")"},
         {"#gpPt12", R"(<path class="full" d="M0-1.3L1.3 0 0 1.3-1.3 0z")"}}};
    for (const auto& m : markers) {
        if (m.id == reference) {
            return m;
        }
    }
    throw gnuplot_error("gnuplot drew a marker that the report does not know");
}

// The CSS variable for a placeholder such as "rgb(  1,   0,   3)", in any spacing; empty for any other colour.
[[nodiscard]] std::string variable_in(const std::string& value) {
    int red = 0, green = 0, blue = -1;
    if (std::sscanf(value.c_str(), "rgb( %d , %d , %d )", &red, &green, &blue) == 3 && red == 1 && green == 0 &&
        blue >= 0 && blue < ink_count) {
        return "var(" + std::string(variable_of(static_cast<ink>(blue))) + ")";
    }
    return {};
}

// The escaped text that the placeholder in content stands for; empty if there is none.
[[nodiscard]] std::string text_in(std::string_view content, const std::vector<std::string>& texts) {
    const auto from = content.find('~'), to = content.rfind('~');
    std::size_t index = texts.size();
    if (from != std::string_view::npos && to > from + 1) {
        std::from_chars(content.data() + from + 1, content.data() + to, index);
    }
    return index < texts.size() ? escaped(texts[index]) : std::string();
}

// The attributes of an element that are kept, with colours as variables and default values left out.
class attributes {
  public:
    explicit attributes(const element& e) : of_(e) {}

    [[nodiscard]] std::string value(const std::string& name) const {
        const auto all = of_.find("<xmlattr>");
        if (all == of_.not_found()) {
            return {};
        }
        const auto found = all->second.find(name);
        return found == all->second.not_found() ? std::string() : found->second.data();
    }
    attributes& keep(const std::string& name, std::string_view unless = "") {
        const std::string v = value(name);
        return v.empty() || v == unless ? *this : put(name, v);
    }
    attributes& keep_colour(const std::string& name) {
        const std::string v = variable_in(value(name));
        return v.empty() ? *this : put(name, v);
    }
    [[nodiscard]] const std::string& written() const { return written_; }

  private:
    const element& of_;
    std::string written_;
    attributes& put(const std::string& name, const std::string& v) {
        written_ += " " + name + "=\"" + escaped(v) + "\"";
        return *this;
    }
};

[[nodiscard]] std::string printed(const element& parent, const std::vector<std::string>& texts);

[[nodiscard]] std::string printed_group(const element& e, const std::vector<std::string>& texts) {
    attributes a(e);
    const std::string inside = printed(e, texts), said = text_in(a.value("onmousemove"), texts);
    if (inside.empty()) {
        return {};
    }
    if (!said.empty()) {
        return "<g class=\"point\"><title>" + said + "</title>" + inside + "</g>";
    }
    const bool has_text = e.find("text") != e.not_found();
    a.keep("transform").keep("stroke-width", "1.00").keep_colour(has_text ? "fill" : "stroke");
    if (has_text) {
        a.keep("font-size").keep("text-anchor", "start");
    }
    return a.written().empty() ? inside : "<g" + a.written() + ">" + inside + "</g>\n";
}

[[nodiscard]] std::string printed(const std::string& name, const element& e, const std::vector<std::string>& texts) {
    attributes a(e);
    if (name == "g") {
        return printed_group(e, texts);
    }
    if (name == "path") {
        a.keep_colour("stroke").keep("stroke-dasharray").keep("stroke-opacity").keep("d");
        return "<path" + a.written() + "/>";
    }
    if (name == "polygon") {
        a.keep_colour("fill").keep("fill-opacity").keep("points");
        return "<polygon" + a.written() + "/>";
    }
    if (name == "use") {
        a.keep("transform").keep_colour("color").keep("opacity");
        return std::string(marker_of(a.value("xlink:href")).start) + a.written() + "/>";
    }
    if (name == "text") {
        const std::string content = e.get_value<std::string>();
        const std::string meant = text_in(content, texts);
        return "<text>" + (meant.empty() ? escaped(content) : meant) + "</text>";
    }
    return {};
}

std::string printed(const element& parent, const std::vector<std::string>& texts) {
    std::string all;
    for (const auto& [name, child] : parent) {
        all += printed(name, child, texts);
    }
    return all;
}

} // namespace

std::string mark_of_text(std::size_t index) {
    std::string mark(1, '~');
    mark.append(std::to_string(index)).push_back('~');
    return mark;
}

std::string mark_of_colour(ink role) {
    std::array<char, 16> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "#0100%02x", static_cast<unsigned>(role));
    return buffer.data();
}

std::string coloured(const std::string& drawing, const std::string& name, const std::string& description,
                     const std::vector<std::string>& texts) {
    element document;
    try {
        std::istringstream stream(drawing);
        boost::property_tree::read_xml(stream, document);
        const element& root = document.get_child("svg");
        const std::string inside = printed(root, texts);
        return "<svg class=\"" + name + "\" viewBox=\"" + escaped(attributes(root).value("viewBox")) +
               "\" role=\"img\" aria-label=\"" + escaped(description) + "\">\n" + inside + "</svg>\n";
    } catch (const boost::property_tree::ptree_error& e) {
        throw gnuplot_error(std::string("gnuplot drew what is no SVG: ") + e.what());
    }
}

} // namespace compare::report
