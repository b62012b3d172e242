// Headless Chromium as the eyes of tests: opens a page of ours and reports what is visible.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace eyes {

// Where the browser is; empty if it is not installed.
[[nodiscard]] std::optional<std::string> chromium();

struct seen_picture {
    std::string name;             // the element's class
    double width = 0, height = 0; // of its box, CSS pixels
    int drawn = 0;                // shapes and texts within it that have an extent
    int named_points = 0;         // with a title of their own
    double ink = 0;               // the share of its pixels that differ from the paper around it
    int colours = 0;              // distinct ones, of 16 levels a channel
};

struct seen_page {
    int width = 0;                     // of the view
    int needed_width = 0;              // more than width: the page scrolls sideways
    std::vector<std::string> too_wide; // elements that reach out of the view
    int references = 0;                // to anything outside the page, whether it could be loaded or not
    int scripts = 0;
    std::vector<seen_picture> pictures; // those that are shown
    double paper = 0;                   // brightness of the page's background, 0 to 1
};

// A page in a view so many pixels wide.
struct view {
    std::string html;
    int width = 0;
    bool dark = false;
    bool pixels = true; // else ink, colours and paper stay 0
};

// Opens the pages and looks at each. The browser starts rarely, since that takes it longest: once for all views in the
// light and in the dark, once for each of which the pixels are wanted, and once to count these. Throws
// std::runtime_error if it fails or does not answer in two minutes.
[[nodiscard]] std::vector<seen_page> look_at(const std::vector<view>& views);

// Opens the page and runs the script in it, the body of an async function; what it returns, as JSON. Throws where the
// page or the script fails.
[[nodiscard]] std::string done_in(const std::string& html, int width, const std::string& script);

} // namespace eyes
