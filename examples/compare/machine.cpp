#include "machine.hpp"

#include <sys/utsname.h>

#include <chrono>
#include <ctime>
#include <fstream>

namespace compare {

namespace {

std::string processor_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "";
}

std::string compiler_name() {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "g++ " __VERSION__;
#else
    return "";
#endif
}

std::string today() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    return std::string(text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc));
}

} // namespace

machine_information this_machine() {
    machine_information m;
    m.processor = processor_name();
    m.compiler = compiler_name();
    m.flags = COMPARE_COMPILE_FLAGS;
    m.graze = COMPARE_GRAZE_VERSION;
    m.date = today();
    utsname system{};
    if (uname(&system) == 0) {
        m.system = std::string(system.sysname) + " " + system.release + " " + system.machine;
    }
    return m;
}

} // namespace compare
