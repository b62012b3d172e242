#include "book.hpp"

#include <report.hpp>
#include <report/style.hpp>
#include <report/text.hpp>
#include <whole_file.hpp>

#include <filesystem>

namespace peers {

namespace {

using compare::report::escaped;

constexpr const char* before_style = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>graze: the picture book</title>
<style>
)";

constexpr const char* introduction = R"(<h1>What collisions cost, and what they lose</h1>
<p>Every number type and variant of the formulas, and the libraries that one would take instead, each on the same pairs in
one run. A chapter's own page has its tables and the figures behind each mark.</p>
)";

constexpr const char* about_fallback = R"(<h2>Which stage settles an answer</h2>
<p>A decision is first tried in floating point, with a proven bound on its error; where that is not certain, in a form that cancels
less, in double words, and at last in integers. Ordinary pairs of balls take the first; most families are made of those that need
more.</p>
)";

std::string image(const std::string& file, const std::string& what) {
    return "<figure><a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"" + escaped(what) +
           "\" style=\"width:100%\"></a></figure>\n";
}

std::string name_in(const std::string& path) { return std::filesystem::path(path).filename().string(); }

} // namespace

void write_book(const std::string& folder, const std::vector<chapter>& chapters,
                const std::vector<fallback_rate>& rates, const std::string& command) {
    std::filesystem::create_directories(folder);
    std::string page = before_style + compare::report::style() + "</style>\n</head>\n<body>\n<main>\n" + introduction;
    for (const chapter& c : chapters) {
        const std::string stem = folder + '/' + c.name;
        compare::write_report(c.found, stem + ".html");
        const std::vector<std::string> pictures = compare::write_pictures(c.found, stem + '-');
        const std::string title = c.found.source == "default" ? "number types on the default scene" : c.found.source;
        page += "<h2><a href=\"" + escaped(c.name) + ".html\">" + escaped(title) + "</a></h2>\n<p>" +
                escaped(c.found.sentence) + "</p>\n";
        std::string rest;
        for (const std::string& p : pictures) {
            const std::string file = name_in(p);
            if (file.ends_with("-speed.svg") || file.ends_with("-exactness.svg")) {
                page += image(file, title + (file.ends_with("-speed.svg") ? ": speed against error"
                                                                          : ": exactness against cost"));
            } else {
                rest += (rest.empty() ? "" : ", ") + ("<a href=\"" + file + "\">" + file + "</a>");
            }
        }
        page += rest.empty() ? "" : "<p class=\"under\">More: " + rest + "</p>\n";
    }
    compare::write_picture_file(picture_of(rates), command, folder + "/fallback.svg");
    page += about_fallback + image("fallback.svg", "the share of decisions that each stage settled, by family");
    page += "<p class=\"under\">Made by <code>" + escaped(command) + "</code></p>\n</main>\n</body>\n</html>\n";
    compare::write_whole_file(folder + "/index.html", page);
}

} // namespace peers
