#include "report.hpp"

#include "report/gnuplot.hpp"
#include "report/pictures.hpp"
#include "report/style.hpp"
#include "report/summary.hpp"
#include "report/tables.hpp"
#include "report/text.hpp"
#include "whole_file.hpp"

#include <functional>
#include <optional>

namespace compare {
namespace {

using namespace report;

// The page as it grows. The first picture that fails tells why; the others are then left out.
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
    add("<header>\n<h1>What number types cost, and what they lose</h1>\n<p class=\"under\">Collisions of balls with "
        "balls and "
        "walls: " +
        escaped(found_.source == "default" ? "the default scene and families" : found_.source) + "</p>\n");
    add("<p class=\"answer\">" + escaped(found_.sentence) + "</p>\n");
    made();
    add("<nav><a href=\"#speed\">Speed and error</a> <a href=\"#digits\">Digits</a> <a "
        "href=\"#decisions\">Decisions</a> "
        "<a href=\"#distribution\">Distribution</a> <a href=\"#hardness\">Hardness</a> <a "
        "href=\"#tables\">Tables</a></nav>\n</header>\n");
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

// The lines of the pictures with a line a type.
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

void page::pictures() {
    add("<section id=\"speed\"><h2>Speed against error</h2>\n<p>Each point is one number type with one form of the "
        "discriminant and of the "
        "root. Further left is faster, further down is more exact; the lowest line has no error at all. The green "
        "staircase joins "
        "the best of those that decided every pair right. Point at or touch a mark to read its name.</p>\n");
    figure([&](format f) { return speed_picture(found_, f); }, "Nothing was timed.");
    add("</section>\n<section id=\"digits\"><h2>Digits wanted, and what they cost</h2>\n<p>The cheapest that decides "
        "every pair right and whose every "
        "time is right to so many decimal digits, over all groups. The table has each group by itself.</p>\n");
    figure([&](format f) { return matrix_picture(found_, f); }, "No type was good enough, or nothing was timed.");
    add("<details><summary>Digits wanted, by group</summary>\n" + matrix_table(found_) + "</details>\n</section>\n");
    add("<section id=\"decisions\"><h2>Wrong decisions</h2>\n<p>How many pairs a type took for a hit that was a miss, "
        "for overlapping, for approaching, "
        "or the other way round. Amber: left open, by a type that says so. What has no line "
        "here decided every pair right.</p>\n");
    figure([&](format f) { return decisions_picture(found_, f); }, "Every type and variant decided every pair right.");
    add("</section>\n<section id=\"distribution\"><h2>How the errors are distributed</h2>\n<p>Which share of the times "
        "of impact, of pairs decided right, "
        "has at most which error, in units of the last place of a double. Left and up is better; left of the dashed "
        "line a time "
        "rounds to the right double.</p>\n");
    key();
    panels([&](const group_information& g) { return distribution_picture(found_, g); });
    add("</section>\n<section id=\"hardness\"><h2>Error against hardness</h2>\n<p>Bits that the worst pair loses, of "
        "those that the type has, as pairs get "
        "harder. Grey is what the conditioning of the problem explains: what rounding the inputs alone would lose. A "
        "line "
        "above the grey is the formula's fault, a line in it the problem's, and a line ends where no decision was "
        "right.</p>\n");
    key();
    add("<h3>The time of impact</h3>\n");
    panels([&](const group_information& g) { return hardness_picture(found_, g, quantity::time); });
    add("<h3>The discriminant</h3>\n");
    panels([&](const group_information& g) { return hardness_picture(found_, g, quantity::discriminant); });
    add("</section>\n");
}

void page::tables() {
    add("<section id=\"tables\"><h2>Tables</h2>\n<p>Errors are the largest ones, the median in parentheses, in units "
        "of the last place that the exact "
        "value has as a double. Momentum and energy: the largest relative change over an impact. A star marks the best "
        "of a "
        "group: nothing is both faster and better.</p>\n");
    for (const auto& g : found_.groups) {
        add("<details><summary>" + escaped(g.name) + ": every type and variant</summary>\n" + rows_table(found_, g) +
            "</details>\n");
        const std::string by_hardness = hardness_table(found_, g);
        if (!by_hardness.empty()) {
            add("<details><summary>" + escaped(g.name) +
                ": the largest error of τ by hardness</summary>\n<p>k: " + escaped(g.hardness_name) +
                ". Units of the last place of a double; wrong or open decisions in bold.</p>\n" + by_hardness +
                "</details>\n");
        }
    }
    add("<details><summary>The groups</summary>\n" + groups_table(found_) + "</details>\n");
    add("<details><summary>The number types</summary>\n" + types_table(found_) + "</details>\n</section>\n");
}

std::string page::html() {
    pictures();
    tables();
    const std::string rest = std::move(body_);
    body_.clear();
    head();
    if (no_pictures_) {
        add("<p class=\"notice\"><strong>This report has no pictures:</strong> " + escaped(*no_pictures_) +
            ". The tables below are complete.</p>\n");
    }
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
           "content=\"width=device-width, "
           "initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n<title>graze: " +
           escaped(found_.source) + "</title>\n<style>\n" + style() + "</style>\n</head>\n<body>\n<main>\n" + body_ +
           rest +
           "</main>\n<script>for(const n of['click','mouseover'])addEventListener(n,e=>{const "
           "p=e.target.closest('.point'),"
           "o=p&&p.closest('figure').querySelector('output');if(o)o.textContent=p.firstChild.textContent})</script>\n</"
           "body>\n</html>\n";
}

} // namespace

void write_report(const results& found, const std::string& path) { write_whole_file(path, page(found).html()); }

void write_picture(const results& found, const std::string& path) {
    std::string svg = speed_picture(found, format::wide);
    if (svg.empty()) {
        throw std::runtime_error(path + ": there is no picture to write: nothing was timed");
    }
    svg.insert(svg.find('\n') + 1, "<style>\n" + picture_style() + "svg { background: var(--paper); }\n</style>\n");
    svg.insert(4, " xmlns=\"http://www.w3.org/2000/svg\"");
    // A comment may not hold two hyphens.
    std::string command = found.command;
    for (std::size_t at = 0; (at = command.find("--", at)) != std::string::npos;) {
        command.replace(at, 2, "-\u2060-");
    }
    write_whole_file(path,
                     "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- Made by: " + escaped(command) + " -->\n" + svg);
}

} // namespace compare
