// Files through C's functions, since libc++ for WebAssembly has no file streams.
#pragma once

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace environments {

using open_file = std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })>;

// The whole content of the file.
[[nodiscard]] inline std::string text_of(const char* path) {
    const open_file file(std::fopen(path, "rb"));
    if (!file) {
        throw std::runtime_error(std::string(path) + ": cannot be read");
    }
    std::string text;
    char part[4096];
    for (std::size_t size; (size = std::fread(part, 1, sizeof part, file.get())) != 0;) {
        text.append(part, size);
    }
    return text;
}

} // namespace environments
