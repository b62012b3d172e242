// Checks of options' values, with messages in the user's words.
#pragma once

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace compare {

// A whole number, digits only. CLI11's own check also accepts "-1", and numbers too large for an unsigned.
[[nodiscard]] inline CLI::Validator whole_from(std::uint64_t least, std::uint64_t most) {
    return {[least, most](const std::string& text) -> std::string {
                std::uint64_t value = 0;
                const char* end = text.data() + text.size();
                const auto parsed = std::from_chars(text.data(), end, value);
                if (parsed.ec == std::errc() && parsed.ptr == end && value >= least && value <= most) {
                    return {};
                }
                const bool unlimited = most == std::numeric_limits<std::uint64_t>::max();
                return "\"" + text + "\" is not a whole number " +
                       (unlimited ? "below 2^64" : "from " + std::to_string(least) + " to " + std::to_string(most));
            },
            ""};
}

[[nodiscard]] inline CLI::Validator seconds_up_to(double most) {
    return {[most](const std::string& text) -> std::string {
                double value = 0;
                const char* end = text.data() + text.size();
                const auto parsed = std::from_chars(text.data(), end, value);
                return parsed.ec == std::errc() && parsed.ptr == end && value >= 0 && value <= most
                           ? std::string()
                           : "\"" + text + "\" is not a number of seconds from 0 to " +
                                 std::to_string(std::lround(most));
            },
            ""};
}

[[nodiscard]] inline CLI::Validator named() {
    return {[](const std::string& name) { return name.empty() ? std::string("the name is empty") : std::string(); },
            ""};
}

} // namespace compare
