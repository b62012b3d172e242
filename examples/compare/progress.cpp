#include "progress.hpp"

#include <algorithm>
#include <cstdio>

namespace compare {

void progress_line::show(const std::string& text) const {
    if (shown_) {
        std::fprintf(stderr, "\r\033[K%s", text.c_str());
        std::fflush(stderr);
    }
}

void progress_line::show(const std::string& text, std::size_t done, std::size_t all) const {
    show(text + " (" + std::to_string(100 * done / std::max<std::size_t>(all, 1)) + "%)");
}

} // namespace compare
