// The report's text: complete, escaped, self-contained, and written whole.
#include "report.hpp"
#include "report_sample.hpp"

#include "report/dots.hpp"
#include "report/gnuplot.hpp"
#include "report/picture.hpp"
#include "report/pictures.hpp"
#include "report/placement.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"
#include "whole_file.hpp"

#include <boost/property_tree/xml_parser.hpp>
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

namespace {

namespace fs = std::filesystem;
using namespace compare::report;

struct scratch {
    fs::path path;
    scratch() {
        std::string name = (fs::temp_directory_path() / "graze-report-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path = name;
    }
    scratch(const scratch&) = delete;
    scratch& operator=(const scratch&) = delete;
    ~scratch() { fs::remove_all(path); }
};

// Sets PATH during a test.
struct path_is {
    std::string before = std::getenv("PATH");
    explicit path_is(const std::string& path) { ::setenv("PATH", path.c_str(), 1); }
    path_is(const path_is&) = delete;
    path_is& operator=(const path_is&) = delete;
    ~path_is() { ::setenv("PATH", before.c_str(), 1); }
};

[[nodiscard]] std::string contents(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

[[nodiscard]] std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size()) {
        ++n;
    }
    return n;
}

[[nodiscard]] std::size_t files_in(const fs::path& path) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
}

[[nodiscard]] std::string report_of(const compare::results& found) {
    const scratch room;
    compare::write_report(found, (room.path / "report.html").string());
    CHECK(files_in(room.path) == 1);
    return contents(room.path / "report.html");
}

// The report, written once for all tests.
[[nodiscard]] const std::string& sample_report() {
    static const std::string html = report_of(sample_results());
    return html;
}

} // namespace

TEST_CASE("the report says first what the answer is and how it was found") {
    const std::string& html = sample_report();
    const auto answer = html.find("On &lt;this&gt; scene the cheapest type");
    REQUIRE(answer != std::string::npos);
    CHECK(answer < html.find("<svg"));
    for (const char* said : {"graze-compare --report report.html &quot;a &lt;scene&gt;.json&quot;", "g++ 12.2.0", "-O2",
                             "Xeon", "seed 1"}) {
        CAPTURE(said);
        CHECK(html.find(said) < html.find("<svg"));
    }
}

TEST_CASE("names from outside stay text") {
    const std::string& html = sample_report();
    CHECK(count(html, "<script") == 3); // the page's own
    CHECK(count(html, "</script>") == 3);
    CHECK(count(html, "alert(1)") > 0);
    CHECK(count(html, "<this>") == 0);
    CHECK(count(html, "<b>is</b>") == 0);
    CHECK(count(html, "<missing>") == 0);
    // Neither gnuplot nor the replacement of placeholders touched a part of the name.
    CHECK(count(html, "pool &lt;script&gt;alert(1)&lt;/script&gt; &amp; &#39;break&#39; &quot;~3~&quot;") > 0);
}

TEST_CASE("the page needs nothing else") {
    const std::string& html = sample_report();
    for (const char* reference :
         {"http:", "https:", "src=", "url(", "@import", "<link", "xlink", "href=\"/", "file:"}) {
        CAPTURE(reference);
        CHECK(count(html, reference) == 0);
    }
    CHECK(count(html, "href=\"") == count(html, "href=\"#"));
    CHECK(count(html, "~\"") == 0);
    CHECK(count(html, "rgb(") == 0); // every colour is a variable, so that dark mode can change it
}

TEST_CASE("every type and variant has a point with its name, and a line in a table") {
    const auto found = sample_results();
    const std::string wide = speed_picture(found, format::wide), html = sample_report();
    std::set<std::string> names;
    for (const auto& r : found.rows) {
        names.insert(name_of(r.type, r.variant, r.root));
    }
    CHECK(count(wide, "<g class=\"point\">") == names.size());
    for (const auto& name : names) {
        CAPTURE(name);
        CHECK(count(wide, std::string("<title>").append(name).append(": ")) == 1);
        CHECK(count(html, name) > found.groups.size());
    }
}

TEST_CASE("large groups are thinned, what is extreme stays, and the page says so") {
    auto found = sample_results();
    auto& g = found.groups[1];
    for (std::size_t i = 0; i < 20000; ++i) {
        g.places.push_back({100000 + i, "pair", 3, 1.0, 0.5});
        for (auto& r : found.rows) {
            if (r.group == g.name) {
                r.dots.push_back(i == 12345 ? 1e9F : 1.0F);
            }
        }
    }
    g.shown.push_back(g.shown[0]);
    g.shown.back().number = 100777;
    const std::string data = dots_data(found, 3000), all = dots_data(found, 30000);
    CHECK(data.find("112345,") != std::string::npos); // the worst of each line are kept
    CHECK(data.find("100777,") != std::string::npos); // and so are pairs on which a row is wrong
    CHECK(data.size() < all.size() / 3);              // the rows are the same
    CHECK(dots_remark(found, 3000).find("of 20\u2009060") != std::string::npos);
    CHECK(dots_remark(found, 30000).empty());
    CHECK(count(report_of(found), "Not all pairs are drawn.") == 1);
}

TEST_CASE("a scene's pairs have no hardness, which is said once") {
    auto found = sample_results();
    found.groups.resize(1);
    std::erase_if(found.rows, [&](const auto& r) { return r.group != found.groups[0].name; });
    const std::string html = report_of(found);
    CHECK(count(html, "these pairs have no hardness") == 1);
    CHECK(count(html, "Nothing was measured for this picture") == 0);
}

TEST_CASE("without gnuplot the report says so and keeps its tables") {
    const auto found = sample_results();
    const std::string& with = sample_report();
    const scratch empty;
    const path_is nothing(empty.path.string());
    const std::string without = report_of(found);
    CHECK(without.find("gnuplot is not installed") < without.find("<section"));
    CHECK(count(without, "<svg class=") == count(without, "<svg class=\"dots-of-pairs\"")); // the script draws that one
    CHECK(count(without, "<table") == count(with, "<table"));
    CHECK(count(without, "<tr") == count(with, "<tr"));
    CHECK_THROWS_WITH_AS(compare::write_picture(found, (empty.path / "speed.svg").string()),
                         doctest::Contains("not installed"), gnuplot_error);
    CHECK(files_in(empty.path) == 0);
}

TEST_CASE("a gnuplot that fails is quoted") {
    const scratch room;
    std::ofstream(room.path / "gnuplot") << "#!/bin/sh\necho 'no <terminal> of that name' >&2\nexit 1\n";
    fs::permissions(room.path / "gnuplot", fs::perms::owner_all);
    const path_is fake(room.path.string());
    CHECK(count(report_of(sample_results()), "gnuplot failed: no &lt;terminal&gt; of that name") > 0);
}

TEST_CASE("results without times, types or groups make a report all the same") {
    CHECK(count(report_of({}), "Nothing was timed") == 1);
    auto found = sample_results();
    for (auto& r : found.rows) {
        r.nanoseconds.reset();
    }
    const std::string html = report_of(found);
    CHECK(count(html, "Nothing was timed") == 1);
    CHECK(count(html, "<svg class=\"decisions\"") == 2);
    const double infinite = std::numeric_limits<double>::infinity();
    for (auto& r : found.rows) {
        r.nanoseconds = 0;
        r.error(compare::quantity::time).largest = infinite;
        r.error(compare::quantity::time).not_finite = 3;
        for (auto& c : r.cells) {
            c.time_largest = std::numeric_limits<double>::quiet_NaN(), c.discriminant_largest = infinite;
        }
    }
    CHECK(count(report_of(found), "</html>") == 1);
}

TEST_CASE("the picture alone is well-formed, small, and has its own dark colours") {
    const scratch room;
    const auto path = room.path / "speed.svg";
    compare::write_picture(sample_results(), path.string());
    const std::string svg = contents(path);
    std::istringstream stream(svg);
    boost::property_tree::ptree tree;
    CHECK_NOTHROW(boost::property_tree::read_xml(stream, tree));
    CHECK(tree.get<std::string>("svg.<xmlattr>.xmlns") == "http://www.w3.org/2000/svg");
    CHECK(svg.size() < 200000);
    CHECK(count(svg, "prefers-color-scheme: dark") == 1);
    CHECK(count(svg, "graze-compare") == 1);
    CHECK(files_in(room.path) == 1);
}

TEST_CASE("every picture of the report is a file too") {
    const scratch room;
    const auto written = compare::write_pictures(sample_results(), (room.path / "book-").string());
    CHECK(written.size() == files_in(room.path));
    for (const char* name : {"book-speed.svg", "book-exactness.svg", "book-digits.svg", "book-decisions.svg"}) {
        CAPTURE(name);
        CHECK(count(contents(room.path / name), "xmlns=") == 1);
    }
    CHECK(std::ranges::count_if(written, [](const std::string& w) { return count(w, "hardness-") == 1; }) == 3);
}

TEST_CASE("an answer is right to the last bit or not") {
    compare::results found;
    found.groups.emplace_back().name = "group";
    found.groups[0].pairs = 10;
    auto& peer = found.rows.emplace_back();
    peer.type = "peer", peer.group = "group", peer.nanoseconds = 7;
    peer.decisions.evaluated = 10, peer.decisions.hit_or_miss = 1;
    peer.error(compare::quantity::time).count = 6, peer.error(compare::quantity::time).correctly_rounded = 4;
    const auto all = candidates(found);
    REQUIRE(all.size() == 1);
    CHECK(all[0].imperfect == doctest::Approx(0.3));
    CHECK(all[0].name() == "peer"); // without a variant
    CHECK(count(exactness_picture(found, format::wide), "<title>peer: ") == 1);
}

TEST_CASE("the front holds what nothing beats, among those that decide right") {
    compare::results found;
    found.groups.emplace_back().name = "group";
    found.groups[0].pairs = 10;
    const auto add = [&](const char* type, double ns, double bits, std::size_t wrong) {
        compare::row r;
        r.type = type, r.variant = "halved", r.root = "stable", r.group = "group", r.nanoseconds = ns;
        r.decisions.evaluated = 10, r.decisions.hit_or_miss = wrong;
        r.error(compare::quantity::time).count = 5, r.error(compare::quantity::time).fewest_bits = bits;
        found.rows.push_back(r);
    };
    add("quick and wrong", 1, 60, 2);
    add("quick", 10, 40, 0);
    add("slower and worse", 12, 39, 0);
    add("slower and better", 12, 50, 0);
    add("as good and slower", 13, 50, 0);
    std::string front;
    for (const auto& c : candidates(found)) {
        front.append(c.on_front ? c.type : "").append(c.on_front ? "; " : "");
    }
    CHECK(front == "quick; slower and better; ");
}

TEST_CASE("costs of groups are weighted by their pairs, errors are the worst") {
    compare::results found;
    for (const auto& [group, pairs, ns, bits] :
         {std::tuple{"a", std::size_t{1}, 100.0, 50.0}, std::tuple{"b", std::size_t{3}, 20.0, 30.0}}) {
        found.groups.emplace_back().name = group;
        found.groups.back().pairs = pairs;
        compare::row r;
        r.type = "t", r.variant = "halved", r.root = "stable", r.group = group, r.nanoseconds = ns;
        r.decisions.evaluated = pairs, r.decisions.overlap = 1;
        r.error(compare::quantity::crossing).count = 1, r.error(compare::quantity::crossing).fewest_bits = bits;
        found.rows.push_back(r);
    }
    const auto both = candidates(found), one = candidates(found, "a");
    REQUIRE(both.size() == 1);
    CHECK(both[0].nanoseconds == 40);
    CHECK(both[0].fewest_bits == 30);
    CHECK(both[0].wrong == 2);
    REQUIRE(one.size() == 1);
    CHECK(one[0].nanoseconds == 100);
    CHECK(one[0].times == 1);
}

TEST_CASE("a file is written whole or not at all") {
    const scratch room;
    const auto path = (room.path / "file").string();
    compare::write_whole_file(path, "first");
    compare::write_whole_file(path, "second");
    CHECK(contents(path) == "second");
    CHECK(files_in(room.path) == 1);
    CHECK_THROWS_WITH(compare::write_whole_file((room.path / "none" / "file").string(), "x"),
                      doctest::Contains("none/file: cannot be written"));
    CHECK_THROWS(compare::write_whole_file(room.path.string(), "x"));
    CHECK(files_in(room.path) == 1);
    fs::create_symlink("file", room.path / "link");
    compare::write_whole_file((room.path / "link").string(), "third");
    CHECK(contents(path) == "third");
    CHECK(fs::is_symlink(room.path / "link"));
}

TEST_CASE("numbers for people") {
    CHECK(readable(0.0) == "0");
    CHECK(readable(0.5) == "0.5");
    CHECK(readable(14.55) == "14.6");
    CHECK(readable(123.4) == "123");
    CHECK(readable(3.14e-17) == "3.1·10⁻¹⁷");
    CHECK(readable(1e300) == "1.0·10³⁰⁰");
    CHECK(readable(std::numeric_limits<double>::infinity()) == "∞");
    CHECK(readable(std::optional<double>()) == "–");
    CHECK(readable_time(0.25) == "250\u00a0ps");
    CHECK(readable_time(18.2) == "18.2\u00a0ns");
    CHECK(readable_time(2200) == "2.2\u00a0µs");
    CHECK(readable_time(5e6) == "5\u00a0ms");
    CHECK(readable_count(1234) == "1234");
    CHECK(readable_count(124750) == "124\u2009750");
    CHECK(counted(1, "pair", "pairs") == "1 pair");
    CHECK(escaped("a\u202eb\u2028c\u00e9") == "a?b?c\u00e9"); // overrides and line separators, not letters
    CHECK(escaped("<a b='c'>&\"\x01") == "&lt;a b=&#39;c&#39;&gt;&amp;&quot;?");
}

TEST_CASE("names beside points keep off one another") {
    placement names({0, 0, 400, 300}, {{195, 145, 205, 155}});
    std::vector<box> boxes = {{195, 145, 205, 155}};
    for (const char* name : {"double", "float", "long double", "float128"}) {
        const auto at = names.place(name, 12, 200, 150);
        const double width = width_of(name, 12);
        const double left = at.align == "left" ? at.x : at.align == "right" ? at.x - width : at.x - width / 2;
        const box b{left, at.y - 6, left + width, at.y + 6};
        for (const auto& other : boxes) {
            CHECK_FALSE(b.meets(other));
        }
        boxes.push_back(b);
    }
}
