// The report as a browser shows it: on a telephone and on a desk, in light and in dark.
#include "chromium.hpp"
#include "report.hpp"
#include "report_sample.hpp"

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace {

[[nodiscard]] const std::string& report() {
    static const std::string html = [] {
        const auto path =
            std::filesystem::temp_directory_path() / ("graze-report-" + std::to_string(::getpid()) + ".html");
        compare::write_report(sample_results(), path.string());
        std::ifstream in(path, std::ios::binary);
        std::string text(std::istreambuf_iterator<char>(in), {});
        in.close();
        std::filesystem::remove(path);
        return text;
    }();
    return html;
}

[[nodiscard]] std::ptrdiff_t count_of(const eyes::seen_page& page, const std::string& name) {
    return std::ranges::count(page.pictures, name, &eyes::seen_picture::name);
}

void check_pictures(const eyes::seen_page& page) {
    CHECK(count_of(page, "speed") == 1);
    CHECK(count_of(page, "exactness") == 1);
    CHECK(count_of(page, "matrix") == 1);
    CHECK(count_of(page, "decisions") == 1);
    CHECK(count_of(page, "distribution") == 4); // one a group
    CHECK(count_of(page, "hardness") == 6);     // three families have a hardness: of the time and of D
    for (const auto& p : page.pictures) {
        CAPTURE(p.name);
        CHECK(p.width >= 300);
        CHECK(p.height >= 200);
        CHECK(p.drawn >= 12);
        CHECK(p.ink > 0.01);
        CHECK(p.colours >= 4);
        if (p.name == "speed" || p.name == "exactness") {
            CHECK(p.named_points == 114); // 9 types with Kahan's form, 7 without: 9 · 8 + 7 · 6
        }
    }
}

// With every <details> open.
[[nodiscard]] std::string open_report() {
    std::string text = report();
    constexpr std::string_view closed = "<details>", open = "<details open>";
    for (std::size_t at = 0; (at = text.find(closed, at)) != std::string::npos; at += open.size()) {
        text.replace(at, closed.size(), open);
    }
    return text;
}

// Without its pictures, with something wide and something that it refers to.
[[nodiscard]] std::string broken_report() {
    std::string broken = report();
    for (std::size_t at = 0; (at = broken.find("<svg class=\"", at)) != std::string::npos;) {
        const auto from = broken.find('>', at) + 1;
        broken.erase(from, broken.find("</svg>", from) - from);
        at = from;
    }
    broken.insert(broken.rfind("</main>"), "<div style=\"width: 500px\">wide</div><img src=\"file:///none.png\">");
    return broken;
}

constexpr std::array layouts = {320, 390, 641, 1100, 1101}; // where the layout changes

struct sights {
    eyes::seen_page telephone, desk, broken;
    std::vector<eyes::seen_page> open;
};

[[nodiscard]] const sights& seen() {
    static const sights all = [] {
        std::vector<eyes::view> views = {{report(), 390}, {report(), 1200, true}, {broken_report(), 390}};
        for (const int width : layouts) {
            views.push_back({open_report(), width, false, false});
        }
        const auto pages = eyes::look_at(views);
        return sights{pages[0], pages[1], pages[2], {pages.begin() + 3, pages.end()}};
    }();
    return all;
}

} // namespace

TEST_CASE("a telephone scrolls only downwards and shows every picture") {
    const auto& page = seen().telephone;
    CHECK(page.width == 390);
    CHECK(page.needed_width <= 390);
    CHECK(page.too_wide.empty());
    CHECK(page.references == 0);
    CHECK(page.scripts == 1);
    CHECK(page.paper > 0.9);
    check_pictures(page);
}

TEST_CASE("tables fit too, wherever the layout changes") {
    REQUIRE(seen().open.size() == layouts.size());
    for (std::size_t i = 0; i < layouts.size(); ++i) {
        const auto& page = seen().open[i];
        const int width = layouts[i];
        CAPTURE(width);
        CHECK(page.width == width);
        CHECK(page.needed_width <= width);
        CHECK(page.too_wide == std::vector<std::string>());
    }
}

TEST_CASE("a desk in the dark") {
    const auto& page = seen().desk;
    CHECK(page.needed_width <= 1200);
    CHECK(page.paper < 0.2);
    check_pictures(page);
}

TEST_CASE("what is missing or too wide is noticed") {
    const auto& page = seen().broken;
    CHECK(page.needed_width > 390);
    CHECK_FALSE(page.too_wide.empty());
    CHECK(page.references == 1);
    REQUIRE(count_of(page, "speed") == 1);
    for (const auto& p : page.pictures) {
        CHECK(p.drawn == 0);
        CHECK(p.ink == 0);
    }
}

int main(int count, char** words) {
    if (!eyes::chromium()) {
        std::puts("skipped: chromium is not installed");
        return 77;
    }
    return doctest::Context(count, words).run();
}
