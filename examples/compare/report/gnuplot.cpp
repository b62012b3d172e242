#include "gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace compare::report {
namespace {

struct closer {
    void operator()(std::FILE* f) const { std::fclose(f); }
};
using file = std::unique_ptr<std::FILE, closer>;

// A file without a name, which vanishes when it is closed.
[[nodiscard]] file nameless_file() {
    file f(std::tmpfile());
    if (!f) {
        throw gnuplot_error(std::string("no temporary file could be made for gnuplot: ") + std::strerror(errno));
    }
    return f;
}

[[nodiscard]] std::string contents(std::FILE* f) {
    std::string all;
    std::array<char, 65536> block{};
    std::rewind(f);
    while (const std::size_t n = std::fread(block.data(), 1, block.size(), f)) {
        all.append(block.data(), n);
    }
    return all;
}

[[nodiscard]] std::string first_line(const std::string& text) {
    const auto from = text.find_first_not_of("\r\n");
    return from == std::string::npos ? "it printed nothing"
                                     : text.substr(from, text.find_first_of("\r\n", from) - from);
}

} // namespace

std::string run_gnuplot(const std::string& script) {
    const file in = nameless_file(), out = nameless_file(), errors = nameless_file();
    if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() || std::fflush(in.get()) != 0) {
        throw gnuplot_error(std::string("the script for gnuplot could not be written: ") + std::strerror(errno));
    }
    std::rewind(in.get());

    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    posix_spawn_file_actions_adddup2(&streams, fileno(in.get()), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&streams, fileno(out.get()), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&streams, fileno(errors.get()), STDERR_FILENO);
    // -d: ignore the user's own gnuplot settings.
    std::string program = "gnuplot", defaults = "-d";
    std::array<char*, 3> arguments{program.data(), defaults.data(), nullptr};
    pid_t child = 0;
    const int failure = posix_spawnp(&child, program.c_str(), &streams, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&streams);
    if (failure == ENOENT) {
        throw gnuplot_error("gnuplot is not installed (on Debian and Ubuntu: apt install gnuplot-nox)");
    }
    if (failure != 0) {
        throw gnuplot_error(std::string("gnuplot could not be started: ") + std::strerror(failure));
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            throw gnuplot_error(std::string("gnuplot was lost: ") + std::strerror(errno));
        }
    }
    std::string picture = contents(out.get());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.empty()) {
        throw gnuplot_error("gnuplot failed: " + first_line(contents(errors.get())));
    }
    return picture;
}

} // namespace compare::report
