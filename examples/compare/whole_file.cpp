#include "whole_file.hpp"

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

} // namespace compare
