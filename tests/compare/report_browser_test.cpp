// The report as a browser shows it: on a telephone and on a desktop, in light and in dark mode.
#include "chromium.hpp"
#include "report.hpp"
#include "report_sample.hpp"

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

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
    CHECK(count_of(page, "hardness") == 6);     // for the time and D of each of the three families with a hardness
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

// The report with every <details> open.
[[nodiscard]] std::string open_report() {
    std::string text = report();
    constexpr std::string_view closed = "<details>", open = "<details open>";
    for (std::size_t at = 0; (at = text.find(closed, at)) != std::string::npos; at += open.size()) {
        text.replace(at, closed.size(), open);
    }
    return text;
}

// The report without its pictures, with something too wide and a reference to something outside.
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
    CHECK(page.scripts == 3); // hints of marks, the pairs' data, and the dots
    CHECK(count_of(page, "dots-of-pairs") == 3);
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

TEST_CASE("a row leads to its pair's dot, the dot and the pair back to the row, and types can be switched off") {
    // Each step notes what it saw; hashchange comes after a click.
    const std::string seen = eyes::done_in(report(), 1200, R"(
      const step = () => new Promise(done => setTimeout(done, 50));
      const button = document.querySelector('tr[id^=row-] .opens'), row = button.closest('tr');
      button.click();
      const opened = row.nextElementSibling.className, link = row.nextElementSibling.querySelector('a[href^="#pair-"]');
      link.click(); await step();
      const pair = /pair-(\d+)/.exec(location.hash)[1], card = document.querySelector('.card');
      const rings = document.querySelectorAll('.dots-of-pairs .chosen').length, told = card.textContent;
      const back = card.querySelector(`a[href="#${row.id}"]`);
      document.querySelectorAll('details').forEach(d => d.open = false);
      back.click(); await step();
      const visible = row.getBoundingClientRect().height > 0, again = row.nextElementSibling.className;
      const svg = document.querySelector('.border .dots-of-pairs'), path = svg.querySelector('[data-line="1"]');
      const [x, y] = /M([\d.]+) ([\d.]+)/.exec(path.getAttribute('d')).slice(1).map(Number), box = svg.getBoundingClientRect();
      const at = {clientX: box.left + x * box.width / 360, clientY: box.top + y * box.height / 300, bubbles: true};
      svg.dispatchEvent(new PointerEvent('pointermove', at));
      const named = document.querySelector('#dots > output').textContent;
      svg.dispatchEvent(new MouseEvent('click', at)); await step();
      const by_dot = location.hash, heading = card.querySelector('h3').textContent;
      document.getElementById('dots-line-1').click();
      const gone = svg.querySelector('[data-line="1"]') === null;
      const groups = document.querySelectorAll('[name=dots-group]').length;
      return {opened, pair, rings, told, visible, again, named, by_dot, heading, gone, groups};)");
    const auto saw = nlohmann::json::parse(seen);
    CAPTURE(seen);
    REQUIRE_FALSE(saw.contains("failed"));
    CHECK(saw["opened"] == "worst");
    CHECK(saw["rings"] > 0);
    const std::string told = saw["told"], pair = saw["pair"], named = saw["named"], by_dot = saw["by_dot"],
                      heading = saw["heading"];
    CHECK(told.starts_with("Pair " + pair + ":"));
    CHECK(told.find("0x1p+0") != std::string::npos); // its numbers in hexadecimal
    CHECK(told.find("--pair " + pair + " --types") != std::string::npos);
    CHECK(saw["visible"] == true);
    CHECK(saw["again"] == "worst");
    CHECK(named.starts_with("pair "));
    CHECK(by_dot.starts_with("#pair-"));
    CHECK(heading.starts_with("Pair " + by_dot.substr(6) + ":"));
    CHECK(named.starts_with("pair " + by_dot.substr(6) + ","));
    CHECK(saw["gone"] == true);
    CHECK(saw["groups"] == 4);
}

TEST_CASE("what is missing or too wide is noticed") {
    const auto& page = seen().broken;
    CHECK(page.needed_width > 390);
    CHECK_FALSE(page.too_wide.empty());
    CHECK(page.references == 1);
    REQUIRE(count_of(page, "speed") == 1);
    for (const auto& p : page.pictures) {
        const bool is_drawn_later = p.name == "dots-of-pairs"; // by the script, as soon as the page is loaded
        CHECK((p.drawn == 0) != is_drawn_later);
        CHECK((p.ink == 0) != is_drawn_later);
    }
}

int main(int count, char** words) {
    if (!eyes::chromium()) {
        std::puts("skipped: chromium is not installed");
        return 77;
    }
    return doctest::Context(count, words).run();
}
