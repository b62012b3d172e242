#include "chromium.hpp"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace eyes {
namespace {

namespace fs = std::filesystem;

// A directory that is removed at the end.
struct scratch {
    fs::path path;
    scratch() {
        std::string name = (fs::temp_directory_path() / "graze-eyes-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) {
            throw std::runtime_error("no temporary directory");
        }
        path = name;
    }
    scratch(const scratch&) = delete;
    scratch& operator=(const scratch&) = delete;
    ~scratch() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

void save(const fs::path& path, const std::string& content) {
    std::ofstream out(path, std::ios::binary);
    out << content;
    if (!out.flush()) {
        throw std::runtime_error("cannot write " + path.string());
    }
}

[[nodiscard]] std::string contents(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// What the browser prints. After two minutes, it and all that it started are killed.
[[nodiscard]] std::string run(const fs::path& room, const std::vector<std::string>& more) {
    std::vector<std::string> words = {*chromium(),
                                      "--headless",
                                      "--no-sandbox",
                                      "--disable-gpu",
                                      "--disable-quic",
                                      "--no-first-run",
                                      "--disable-background-networking",
                                      "--disable-component-update",
                                      "--disable-sync",
                                      "--hide-scrollbars",
                                      "--user-data-dir=" + (room / "profile").string()};
    words.insert(words.end(), more.begin(), more.end());
    std::vector<char*> arguments;
    for (auto& w : words) {
        arguments.push_back(w.data());
    }
    arguments.push_back(nullptr);
    fs::remove_all(room / "profile");
    const std::string out = (room / "out").string();

    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t group;
    posix_spawnattr_init(&group);
    posix_spawnattr_setflags(&group, POSIX_SPAWN_SETPGROUP);
    pid_t child = 0;
    const int failure = posix_spawn(&child, words[0].c_str(), &streams, &group, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&streams);
    posix_spawnattr_destroy(&group);
    if (failure != 0) {
        throw std::runtime_error("chromium cannot be started");
    }
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > patience) {
            ::kill(-child, SIGKILL);
            ::waitpid(child, &status, 0);
            throw std::runtime_error("chromium did not answer");
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return contents(out);
}

[[nodiscard]] std::string url(const fs::path& file) { return "file://" + file.string(); }

// What the page's script left in the element `answer`.
[[nodiscard]] nlohmann::json answer_in(const std::string& dom) {
    static constexpr std::string_view before = "<pre id=\"answer\">";
    const auto from = dom.find(before);
    const auto to = dom.find("</pre>", from);
    if (from == std::string::npos || to <= from + before.size()) {
        throw std::runtime_error("chromium shows no answer");
    }
    return nlohmann::json::parse(dom.substr(from + before.size(), to - from - before.size()));
}

[[nodiscard]] std::string base64(const std::string& bytes) {
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned block = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            block = block << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += j <= bytes.size() - i ? digits[block >> (18 - 6 * j) & 63] : '=';
        }
    }
    return text;
}

// Runs in the page. A headless window is at least 500 pixels wide, so the page is in a frame and sends its answer out.
constexpr std::string_view measure = R"(<script>addEventListener('load', () => {
  const round = x => Math.round(x * 10) / 10, visible = e => e.getBoundingClientRect().width > 0;
  const pictures = [...document.querySelectorAll('figure svg, body > svg')].filter(visible).map(svg => {
    const r = svg.getBoundingClientRect();
    const drawn = [...svg.querySelectorAll('path, polygon, circle, rect, text')].filter(e => {
      const b = e.getBBox(); return b.width > 0 || b.height > 0 }).length;
    return { name: svg.className.baseVal, x: round(r.x), y: round(r.y + scrollY), width: round(r.width), height: round(r.height),
             drawn, named: [...svg.querySelectorAll('.point > title')].filter(t => t.textContent.length > 3).length } });
  const out = [...document.querySelectorAll('body *')].filter(e => visible(e) && !e.closest('svg') &&
    (e.getBoundingClientRect().right > innerWidth + 0.5 || e.getBoundingClientRect().left < -0.5));
  parent.postMessage(JSON.stringify({ width: innerWidth, needed: document.documentElement.scrollWidth,
    height: Math.ceil(document.documentElement.getBoundingClientRect().height),
    wide: out.slice(0, 8).map(e => e.tagName + ' ' + e.textContent.replace(/[^\w ]/g, '').slice(0, 40)),
    references: performance.getEntriesByType('resource').length + [...document.querySelectorAll('[src], [href], [srcset], [data]')]
      .filter(e => !(e.getAttribute('href') ?? '').startsWith('#')).length, scripts: document.scripts.length - 1, pictures }), '*') })</script>)";

// Counts the pixels of each image within its boxes.
constexpr std::string_view count_pixels = R"(<script>addEventListener('load', () => {
  document.getElementById('answer').textContent = JSON.stringify([...document.images].map((image, i) => {
    const canvas = document.createElement('canvas');
    canvas.width = image.naturalWidth; canvas.height = image.naturalHeight;
    const c = canvas.getContext('2d'); c.drawImage(image, 0, 0);
    const paper = c.getImageData(2, 2, 1, 1).data;
    return { paper: (paper[0] + paper[1] + paper[2]) / 765,
      pictures: boxes[i].map(([x, y, w, h]) => {
        const d = c.getImageData(x, y, Math.max(w, 1), Math.max(h, 1)).data, colours = new Set(); let ink = 0;
        for (let i = 0; i < d.length; i += 4) {
          if (Math.abs(d[i] - paper[0]) + Math.abs(d[i + 1] - paper[1]) + Math.abs(d[i + 2] - paper[2]) > 24) ++ink;
          colours.add((d[i] >> 4) << 8 | (d[i + 1] >> 4) << 4 | d[i + 2] >> 4) }
        return { ink: ink / (d.length / 4), colours: colours.size } }) } })) })</script>)";

// A page that shows files in frames and passes their answers on.
[[nodiscard]] std::string frames(const std::vector<std::size_t>& files, const std::vector<view>& views, int height) {
    std::ostringstream page;
    page << "<!DOCTYPE html><style>body { margin: 0 } iframe { border: 0; display: block; height: " << height
         << "px } pre { display: none }</style>";
    for (const std::size_t file : files) {
        page << "<iframe style=\"width: " << views[file].width << "px\" src=\"" << file << ".html\"></iframe>";
    }
    page << "<pre id=\"answer\"></pre><script>const frames = [...document.querySelectorAll('iframe')], answers = [];"
         << "onmessage = e => { answers[frames.findIndex(f => f.contentWindow === e.source)] = JSON.parse(e.data);"
         << "if (Object.keys(answers).length === frames.length)"
         << "document.getElementById('answer').textContent = JSON.stringify(answers) }</script>";
    return page.str();
}

constexpr const char* patience = "--virtual-time-budget=20000";
[[nodiscard]] std::string scheme(bool dark) {
    return std::string("--blink-settings=preferredColorScheme=") + (dark ? "0" : "1");
}

// What the script `measure` finds in each view.
[[nodiscard]] std::vector<nlohmann::json> measured(const fs::path& room, const std::vector<view>& views) {
    std::vector<nlohmann::json> found(views.size());
    for (const bool dark : {false, true}) {
        std::vector<std::size_t> files;
        for (std::size_t i = 0; i < views.size(); ++i) {
            if (views[i].dark == dark) {
                files.push_back(i);
                std::string html = views[i].html;
                const auto end = html.rfind("</body>");
                html.insert(end == std::string::npos ? html.size() : end, measure);
                save(room / (std::to_string(i) + ".html"), html);
            }
        }
        if (files.empty()) {
            continue;
        }
        save(room / "frames.html", frames(files, views, 900));
        const auto answers = answer_in(
            run(room, {scheme(dark), "--window-size=1400,900", patience, "--dump-dom", url(room / "frames.html")}));
        for (std::size_t i = 0; i < files.size(); ++i) {
            found[files[i]] = answers.at(i);
        }
    }
    return found;
}

[[nodiscard]] seen_page page_of(const nlohmann::json& found) {
    seen_page page;
    page.width = found.at("width"), page.needed_width = found.at("needed");
    page.references = found.at("references"), page.scripts = found.at("scripts");
    page.too_wide = found.at("wide").get<std::vector<std::string>>();
    for (const auto& p : found.at("pictures")) {
        page.pictures.push_back({p.at("name"), p.at("width"), p.at("height"), p.at("drawn"), p.at("named"), 0, 0});
    }
    return page;
}

// Takes a picture of a whole page: the bytes of a PNG.
[[nodiscard]] std::string shot(const fs::path& room, const std::vector<view>& views, std::size_t i, int height) {
    save(room / "frames.html", frames({i}, views, height));
    const auto file = room / "shot.png";
    const std::string window =
        "--window-size=" + std::to_string(std::max(views[i].width, 500)) + "," + std::to_string(height);
    static_cast<void>(run(
        room, {scheme(views[i].dark), window, patience, "--screenshot=" + file.string(), url(room / "frames.html")}));
    return contents(file);
}

} // namespace

std::optional<std::string> chromium() {
    for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"}) {
        if (::access(path, X_OK) == 0) {
            return path;
        }
    }
    return std::nullopt;
}

std::vector<seen_page> look_at(const std::vector<view>& views) {
    const scratch room;
    const auto found = measured(room.path, views);
    std::vector<seen_page> pages;
    std::vector<std::size_t> shown;
    nlohmann::json boxes = nlohmann::json::array();
    std::string images;
    for (std::size_t i = 0; i < views.size(); ++i) {
        pages.push_back(page_of(found[i]));
        if (!views[i].pixels) {
            continue;
        }
        // A screenshot ends at 16,384 pixels; the pictures are above the tables.
        const int height = std::min(found[i].at("height").get<int>(), 16000);
        images += "<img src=\"data:image/png;base64," + base64(shot(room.path, views, i, height)) + "\">";
        shown.push_back(i);
        boxes.emplace_back(nlohmann::json::array());
        for (const auto& p : found[i].at("pictures")) {
            const auto whole = [&](const char* key) { return static_cast<int>(p.at(key).get<double>()); };
            boxes.back().push_back({whole("x"), whole("y"), whole("width"), whole("height")});
        }
    }
    if (shown.empty()) {
        return pages;
    }
    save(room.path / "count.html", "<!DOCTYPE html><script>const boxes = " + boxes.dump() + "</script>" + images +
                                       "<pre id=\"answer\"></pre>" + std::string(count_pixels));
    const auto counted = answer_in(run(room.path, {patience, "--dump-dom", url(room.path / "count.html")}));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        seen_page& page = pages[shown[i]];
        page.paper = counted.at(i).at("paper");
        for (std::size_t j = 0; j < page.pictures.size(); ++j) {
            page.pictures[j].ink = counted.at(i).at("pictures")[j].at("ink");
            page.pictures[j].colours = counted.at(i).at("pictures")[j].at("colours");
        }
    }
    return pages;
}

std::string done_in(const std::string& html, int width, const std::string& script) {
    const scratch room;
    std::string page = html;
    page.insert(page.rfind("</body>"), "<pre id=\"answer\"></pre><script>(async () => {" + script +
                                           "})().then(x => JSON.stringify(x), e => JSON.stringify({failed: String(e)}))"
                                           ".then(x => document.getElementById('answer').textContent = x)</script>");
    save(room.path / "page.html", page);
    const std::string window = "--window-size=" + std::to_string(width) + ",900";
    return answer_in(
               run(room.path, {window, "--virtual-time-budget=20000", "--dump-dom", url(room.path / "page.html")}))
        .dump();
}

} // namespace eyes
