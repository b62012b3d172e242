#include "report.hpp"

#include "report/dots.hpp"
#include "report/dots_words.hpp"
#include "report/gnuplot.hpp"
#include "report/pictures.hpp"
#include "report/style.hpp"
#include "report/summary.hpp"
#include "report/tables.hpp"
#include "report/text.hpp"
#include "report/words.hpp"
#include "whole_file.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

namespace compare {
namespace {

using namespace report;

// Builds the page. The first picture that fails leaves its reason here; the later ones are then left out.
class page {
  public:
    explicit page(const results& found) : found_(found) {}

    [[nodiscard]] std::string html();

  private:
    const results& found_;
    std::string body_;
    std::optional<std::string> no_pictures_;

    void add(const std::string& html) { body_ += html; }
    [[nodiscard]] std::string drawn(const std::function<std::string()>& picture);
    void head();
    void made();
    void figure(const std::function<std::string(format)>& picture, const std::string& nothing);
    void panels(const std::function<std::string(const group_information&)>& picture);
    void key();
    void section(const std::string& id, const std::string& head, const std::function<void()>& content);
    // A table that is folded at first. An empty table is left out.
    void fold(const std::string& summary, const std::string& table);
    void dots(const std::string& data);
    void pictures();
    void tables();
};

std::string page::drawn(const std::function<std::string()>& picture) {
    if (no_pictures_) {
        return {};
    }
    try {
        return picture();
    } catch (const gnuplot_error& e) {
        no_pictures_ = e.what();
        return {};
    }
}

void page::made() {
    const auto& m = found_.machine;
    add("<dl class=\"made\">\n");
    const auto entry = [&](const char* name, const std::string& html) {
        if (!html.empty()) {
            add(std::string("<dt>") + name + "<dd>" + html + "\n");
        }
    };
    entry("Command", found_.command.empty() ? "" : "<code>" + escaped(found_.command) + "</code>");
    entry("Built with", m.compiler.empty() ? "" : escaped(m.compiler) + " <code>" + escaped(m.flags) + "</code>");
    entry("Processor", escaped(m.processor));
    entry("System", escaped(m.system));
    std::size_t pairs = 0, distinct = 0;
    for (const auto& g : found_.groups) {
        pairs += g.pairs;
    }
    for (const auto& t : found_.types) {
        distinct += t.alias_of.empty() ? 1 : 0;
    }
    entry("Compared", counted(distinct, "number type", "number types") + " on " + counted(pairs, "pair", "pairs") +
                          " in " + counted(found_.groups.size(), "group", "groups") + ", numbers read as " +
                          escaped(found_.as) + ", seed " + std::to_string(found_.seed));
    entry("Made", escaped(m.date) + (m.graze.empty() ? "" : " by graze " + escaped(m.graze)) +
                      (found_.seconds > 0 ? " in " + readable(found_.seconds) + " s" : ""));
    add("</dl>\n");
}

void page::head() {
    add("<header>\n<h1>What number types cost, and what they lose</h1>\n");
    add("<p class=\"under\">Collisions of balls with balls, planes, walls and triangles: " +
        escaped(found_.source == "default" ? "the default scene and families" : found_.source) + "</p>\n");
    add("<p class=\"answer\">" + escaped(found_.sentence) + "</p>\n");
    made();
    add(words::navigation);
    add("</header>\n");
}

void page::figure(const std::function<std::string(format)>& picture, const std::string& nothing) {
    const std::string wide = drawn([&] { return picture(format::wide); });
    const std::string narrow = drawn([&] { return picture(format::narrow); });
    if (no_pictures_) {
        add("<p class=\"under\">No picture: " + escaped(*no_pictures_) + ".</p>\n");
    } else if (wide.empty()) {
        add("<p class=\"under\">" + nothing + "</p>\n");
    } else {
        add("<figure><div class=\"wide\">" + wide + "</div><div class=\"narrow\">" + narrow +
            "</div><output></output></figure>\n");
    }
}

void page::panels(const std::function<std::string(const group_information&)>& picture) {
    std::string all;
    for (const auto& g : found_.groups) {
        const std::string svg = drawn([&] { return picture(g); });
        if (!svg.empty()) {
            all += "<div><h4>" + escaped(g.name) + "</h4>" + svg + "</div>\n";
        }
    }
    if (no_pictures_) {
        add("<p class=\"under\">No pictures: " + escaped(*no_pictures_) + ".</p>\n");
    } else {
        add(all.empty() ? "<p class=\"under\">Nothing was measured for this picture.</p>\n"
                        : "<figure class=\"panels\">" + all + "</figure>\n");
    }
}

// The key of the pictures in which each type has a line.
void page::key() {
    if (no_pictures_) {
        return;
    }
    add("<ul class=\"key\">");
    for (const auto& l : chosen_lines(found_)) {
        add("<li><svg viewBox=\"0 0 26 10\" aria-hidden=\"true\"><path d=\"M0 5H26\" stroke-width=\"2.5\" "
            "stroke=\"var(" +
            std::string(variable_of(l.colour)) + ")\"" + (l.dashed ? " stroke-dasharray=\"5 3\"" : "") + "/></svg>" +
            escaped(name_of(l.type, l.variant, l.root)));
    }
    add("</ul>\n");
}

void page::section(const std::string& id, const std::string& head, const std::function<void()>& content) {
    add("<section id=\"" + id + "\">" + head);
    content();
    add("</section>\n");
}

void page::pictures() {
    section("speed", words::speed,
            [&] { figure([&](format f) { return speed_picture(found_, f); }, "Nothing was timed."); });
    section("exactness", words::exactness,
            [&] { figure([&](format f) { return exactness_picture(found_, f); }, "Without times there is no cost."); });
    section("digits", words::digits, [&] {
        figure([&](format f) { return matrix_picture(found_, f); }, "No type was good enough, or nothing was timed.");
        fold("Digits wanted, by group", matrix_table(found_));
    });
    section("decisions", words::decisions, [&] {
        figure([&](format f) { return decisions_picture(found_, f); },
               "Every type and variant decided every pair right.");
        fold("Wrong and open decisions by kind", decisions_table(found_));
    });
    section("distribution", words::distribution, [&] {
        key();
        panels([&](const group_information& g) { return distribution_picture(found_, g); });
    });
    section("hardness", words::hardness, [&] {
        if (std::ranges::all_of(found_.groups, [](const auto& g) { return g.hardness_name.empty(); })) {
            add("<p class=\"under\">Nothing to draw: these pairs have no hardness. The pairs of a family have "
                "one.</p>\n");
            return;
        }
        key();
        add("<h3>The time of impact</h3>\n");
        panels([&](const group_information& g) { return hardness_picture(found_, g, quantity::time); });
        add("<h3>The discriminant</h3>\n");
        panels([&](const group_information& g) { return hardness_picture(found_, g, quantity::discriminant); });
    });
    if (const std::string data = dots_data(found_); !data.empty()) {
        section("dots", words::dots, [&] { dots(data); });
    }
    section("tables", words::tables, [&] { tables(); });
}

// The page's script draws the dots. Without JavaScript, a line says so.
void page::dots(const std::string& data) {
    const std::string remark = dots_remark(found_);
    add(remark.empty() ? "" : "<p class=\"under\">" + escaped(remark) + "</p>\n");
    add("<noscript><p class=\"under\">Drawing the dots takes JavaScript.</p></noscript>\n<div "
        "class=\"controls\"></div>\n"
        "<div class=\"panels\">\n");
    for (const auto& [key, name] :
         {std::pair("hardness", "The error of the time against the hardness"),
          std::pair("time", "The error of the time against the true time"),
          std::pair("border", "The error of the time against the distance from the border")}) {
        add(std::string("<figure class=\"") + key +
            "\"><svg class=\"dots-of-pairs\" viewBox=\"0 0 360 300\" role=\"img\" "
            "aria-label=\"" +
            name + "\"></svg></figure>\n");
    }
    add("</div>\n<output></output>\n<div class=\"card\"></div>\n<script type=\"application/json\" id=\"pairs-data\">" +
        data + "</script>\n");
}

void page::fold(const std::string& summary, const std::string& table) {
    if (!table.empty()) {
        add("<details><summary>" + summary + "</summary>\n" + table + "</details>\n");
    }
}

void page::tables() {
    for (const auto& g : found_.groups) {
        fold(escaped(g.name) + ": every type and variant", rows_table(found_, g));
        fold(escaped(g.name) + ": the largest error of τ by hardness", hardness_table(found_, g));
    }
    fold("Intervals", intervals_table(found_));
    fold("The groups", groups_table(found_));
    fold("The number types", types_table(found_));
}

std::string page::html() {
    pictures();
    const std::string rest = std::move(body_);
    body_.clear();
    head();
    if (no_pictures_) {
        add("<p class=\"notice\"><strong>This report has no pictures:</strong> " + escaped(*no_pictures_) +
            ". The tables below are complete.</p>\n");
    }
    return std::string(words::before_title) + "<title>graze: " + escaped(found_.source) + "</title>\n<style>\n" +
           style() + "</style>\n</head>\n<body>\n<main>\n" + body_ + rest + words::after_all +
           (rest.find("id=\"pairs-data\"") == std::string::npos ? "" : words::dots_script) + words::end;
}

} // namespace

void write_report(const results& found, const std::string& path) { write_whole_file(path, page(found).html()); }

void write_picture_file(std::string svg, std::string command, const std::string& path) {
    svg.insert(svg.find('\n') + 1, "<style>\n" + picture_style() + "svg { background: var(--paper); }\n</style>\n");
    svg.insert(4, " xmlns=\"http://www.w3.org/2000/svg\"");
    for (std::size_t at = 0; (at = command.find("--", at)) != std::string::npos;) {
        command.replace(at, 2, "-\u2060-"); // two hyphens are not allowed in a comment of XML
    }
    write_whole_file(path,
                     "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Made by: " + escaped(command) + " -->\n" + svg);
}

void write_picture(const results& found, const std::string& path) {
    const std::string svg = speed_picture(found, format::wide);
    if (svg.empty()) {
        throw std::runtime_error(path + ": there is no picture to write: nothing was timed");
    }
    write_picture_file(svg, found.command, path);
}

std::vector<std::string> write_pictures(const results& found, const std::string& stem) {
    std::vector<std::string> written;
    const auto add = [&](const std::string& name, const std::string& svg) {
        if (!svg.empty()) {
            write_picture_file(svg, found.command, stem + name + ".svg");
            written.push_back(stem + name + ".svg");
        }
    };
    add("speed", speed_picture(found, format::wide));
    add("exactness", exactness_picture(found, format::wide));
    add("digits", matrix_picture(found, format::wide));
    add("decisions", decisions_picture(found, format::wide));
    for (const auto& g : found.groups) {
        std::string name = g.name;
        std::ranges::replace_if(
            name, [](unsigned char c) { return std::isalnum(c) == 0; }, '-');
        add("distribution-" + name, distribution_picture(found, g, true));
        add("hardness-" + name, hardness_picture(found, g, quantity::time, true));
    }
    return written;
}

} // namespace compare
