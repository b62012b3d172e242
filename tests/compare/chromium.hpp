// Headless Chromium as the tests' eyes: opens a page and reports what is visible.
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
    int drawn = 0;                // visible shapes and texts in it
    int named_points = 0;         // points with titles of their own
    double ink = 0;               // the share of its pixels that differ from the paper around it
    int colours = 0;              // distinct ones, of 16 levels a channel
};

struct seen_page {
    int width = 0;                     // of the view
    int needed_width = 0;              // if larger than width, the page scrolls sideways
    std::vector<std::string> too_wide; // elements that reach out of the view
    int references = 0;                // to anything outside the page, loaded or not
    int scripts = 0;
    std::vector<seen_picture> pictures; // the visible ones
    double paper = 0;                   // brightness of the page's background, 0 to 1
};

// A page in a view so many pixels wide.
struct view {
    std::string html;
    int width = 0;
    bool dark = false;
    bool pixels = true; // if false, ink, colours and paper stay 0
};

// Opens the pages and looks at each. Starting the browser takes longest, so it starts rarely: once for all views in
// light and in dark mode, once for each view whose pixels are wanted, and once to count these. Throws
// std::runtime_error if it fails or does not answer within two minutes.
[[nodiscard]] std::vector<seen_page> look_at(const std::vector<view>& views);

// Opens the page and runs the script in it, which is the body of an async function. Returns the script's result as
// JSON. Throws if the page or the script fails.
[[nodiscard]] std::string done_in(const std::string& html, int width, const std::string& script);

} // namespace eyes
