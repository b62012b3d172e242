// A temporary folder in which a test runs graze-compare as its user does.
#pragma once

#include <doctest/doctest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace workshop {

namespace fs = std::filesystem;

inline std::string content_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

struct ending {
    int code = -1;
    std::string out, err;
};

// An empty directory during a test, in which programs run.
class bench {
  public:
    bench() {
        std::string name = (fs::temp_directory_path() / "graze-compare-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~bench() { fs::remove_all(path_); }
    bench(const bench&) = delete;
    bench& operator=(const bench&) = delete;

    [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }

    [[nodiscard]] ending run(const std::string& arguments) const {
        const std::string command = "cd '" + path_.string() + "' && '" GRAZE_COMPARE "' " + arguments + " >out 2>err";
        const int status = std::system(command.c_str());
        ending e{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(path_ / "out"), content_of(path_ / "err")};
        fs::remove(path_ / "out");
        fs::remove(path_ / "err");
        return e;
    }

    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
    }

    void copy_from(const fs::path& folder) const { fs::copy(folder, path_, fs::copy_options::recursive); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }

  private:
    fs::path path_;
};

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Runs each line "arguments, a tab, message" of a list in tests/compare/bad, whose files are in the bench: the program
// ends with 2, prints nothing, and reports that in one line. of_run: the lines of the command run, else all others.
inline void check_bad_lines(const bench& here, const std::string& list, bool of_run) {
    std::ifstream in(here / list);
    const std::size_t before = here.files();
    std::size_t lines = 0;
    for (std::string line; std::getline(in, line);) {
        const auto tab = line.find('\t');
        const bool is_run = line.starts_with("run ") || line.starts_with("run\t");
        if (line.empty() || line[0] == '#' || is_run != of_run) {
            continue;
        }
        REQUIRE(tab != std::string::npos);
        ++lines;
        const ending e = here.run(line.substr(0, tab));
        INFO(line);
        INFO(e.err);
        CHECK(e.code == 2);
        CHECK(e.out.empty());
        CHECK(std::count(e.err.begin(), e.err.end(), '\n') == 1);
        CHECK(e.err.starts_with("graze-compare: "));
        CHECK(holds(e.err, line.substr(tab + 1)));
        CHECK(here.files() == before);
    }
    CHECK(lines > 10);
}

} // namespace workshop
