#include "whole_file.hpp"

#include "input_error.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace compare {
namespace {

// Empty when everything arrived; otherwise what went wrong.
[[nodiscard]] std::string write(const std::string& path, std::string_view content) {
    errno = 0;
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    return out ? std::string() : errno != 0 ? std::strerror(errno) : "write error";
}

} // namespace

void write_whole_file(const std::string& path, std::string_view content) {
    std::error_code error;
    const bool special = std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
    // A link keeps pointing: what it points at is what is replaced.
    const auto real = std::filesystem::weakly_canonical(path, error);
    const std::string target = special || error ? path : real.string();
    const std::string first = special ? target : target + ".part" + std::to_string(::getpid());
    const std::string failure = write(first, content);
    if (special && failure.empty()) {
        return;
    }
    if (failure.empty()) {
        std::filesystem::rename(first, target, error);
    }
    if (!failure.empty() || error) {
        std::error_code ignored;
        if (!special) {
            std::filesystem::remove(first, ignored);
        }
        throw std::runtime_error(path + ": cannot be written: " + (failure.empty() ? error.message() : failure));
    }
}

void check_writable(const std::string& option, const std::string& path) {
    namespace fs = std::filesystem;
    if (path.empty()) {
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
