#include "whole_file.hpp"

#include "input_error.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>

namespace compare {
namespace {

namespace fs = std::filesystem;

// Returns an empty text on success, otherwise what failed. A new file is readable by its owner alone.
[[nodiscard]] std::string write(const std::string& path, std::string_view content, bool is_new) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | (is_new ? O_CREAT | O_EXCL : 0), S_IRUSR | S_IWUSR);
    if (file < 0) {
        return std::strerror(errno);
    }
    std::string failure;
    while (failure.empty() && !content.empty()) {
        const ssize_t written = ::write(file, content.data(), content.size());
        if (written >= 0) {
            content.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            failure = std::strerror(errno);
        }
    }
    if (::close(file) != 0 && failure.empty()) {
        failure = std::strerror(errno);
    }
    return failure;
}

constexpr const char* part = ".part"; // followed by the number of the process that writes it

// Removes the part files of processes that no longer exist.
void remove_parts_left(const fs::path& target) {
    std::error_code error;
    const std::string start = target.filename().string() + part;
    for (fs::directory_iterator at(target.parent_path(), error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        int process = 0;
        const char* last = name.data() + name.size();
        if (name.starts_with(start) && std::from_chars(name.data() + start.size(), last, process).ptr == last &&
            process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) {
            std::error_code ignored;
            fs::remove(at->path(), ignored);
        }
    }
}

// The mode of the file that is replaced or, if there is none, of any new file.
[[nodiscard]] mode_t mode_for(const fs::path& target) {
    struct stat now {};
    if (::stat(target.c_str(), &now) == 0) {
        return now.st_mode & 07777U;
    }
    const mode_t masked = ::umask(0);
    ::umask(masked);
    return 0666U & ~masked;
}

} // namespace

void write_whole_file(const std::string& path, std::string_view content) {
    if (path == standard_stream) {
        std::cout << content << std::flush;
        return;
    }
    std::error_code error;
    const bool special = fs::exists(path, error) && !fs::is_regular_file(path, error);
    // A link is kept: the file that it points to is replaced.
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    const fs::path target = special || error ? fs::path(path) : real;
    const std::string first = special ? target.string() : target.string() + part + std::to_string(::getpid());
    if (!special) {
        remove_parts_left(target);
    }
    std::string failure = write(first, content, !special);
    if (special && failure.empty()) {
        return;
    }
    if (failure.empty() &&
        (::chmod(first.c_str(), mode_for(target)) != 0 || std::rename(first.c_str(), target.c_str()) != 0)) {
        failure = std::strerror(errno);
    }
    if (!failure.empty()) {
        if (!special) {
            fs::remove(first, error);
        }
        throw std::runtime_error(printable(path, 200) + ": cannot be written: " + failure);
    }
}

void check_writable(const std::string& option, const std::string& path) {
    if (path.empty() || path == standard_stream) {
        return;
    }
    std::error_code error;
    if (fs::is_directory(path, error)) {
        throw input_error(option + " " + printable(path, 200) + ": is a directory");
    }
    if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
        if (::access(path.c_str(), W_OK) != 0) {
            throw input_error(option + " " + printable(path, 200) + ": cannot be written");
        }
        return;
    }
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    const fs::path folder = error ? fs::path() : real.parent_path();
    if (!fs::is_directory(folder, error)) {
        throw input_error(option + " " + printable(path, 200) + ": no such directory");
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        throw input_error(option + " " + printable(path, 200) + ": the directory cannot be written to");
    }
}

} // namespace compare
