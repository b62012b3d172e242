#include "accepted.hpp"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace precision {

namespace {

std::filesystem::path file_of(const std::filesystem::path& folder, quantity q) {
    return folder / (std::string(graze::precision::to_string(q)) + ".accepted");
}

std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

// An error of any size: what underflows is 0 or subnormal, what overflows infinite. A NaN is none: nothing would be
// worse.
bool is_error(const std::string& text, double& x) {
    char* end = nullptr;
    x = std::strtod(text.c_str(), &end);
    return !text.empty() && end == text.c_str() + text.size() && x >= 0;
}

bool is_count(const std::string& text, std::size_t& n) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    return error == std::errc() && end == text.data() + text.size();
}

std::string whole_text(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void read_file(const std::filesystem::path& file, quantity q, accepted_figures& lines) {
    std::ifstream in(file);
    if (!in) {
        throw std::runtime_error(file.string() + ": cannot be read");
    }
    std::string line;
    for (std::size_t n = 1; std::getline(in, line); ++n) {
        if (line.empty() || line.front() == '#') {
            continue;
        }
        accepted_line a;
        a.expected_to_fail = line.front() == '!';
        std::istringstream words(line.substr(a.expected_to_fail ? 1 : 0));
        key k;
        k.of = q;
        figures& f = a.accepted;
        std::string pairs, wrong, values, misrounded, largest, median, rest;
        words >> k.variant >> k.type >> k.family >> pairs >> wrong >> values >> misrounded >> largest >> median;
        const bool understood = words && is_count(pairs, f.pairs) && is_count(wrong, f.wrong) &&
                                is_count(values, f.values) && is_count(misrounded, f.misrounded) &&
                                is_error(largest, f.largest) && is_error(median, f.median) && !(words >> rest);
        if (!understood) {
            throw std::runtime_error(file.string() + ":" + std::to_string(n) +
                                     ": not a variant, a type, a family and six figures: " + line);
        }
        if (f.wrong > f.pairs || f.misrounded > f.values) {
            throw std::runtime_error(file.string() + ":" + std::to_string(n) +
                                     ": more wrong than pairs, or misrounded than values: " + line);
        }
        if (!lines.emplace(k, a).second) {
            throw std::runtime_error(file.string() + ":" + std::to_string(n) + ": " + to_string(k) +
                                     " stands there twice");
        }
    }
}

} // namespace

double as_told(double error) {
    double told = 0;
    is_error(number(error), told);
    return told;
}

accepted_figures read_accepted(const std::filesystem::path& folder) {
    accepted_figures lines;
    if (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder)) {
        throw std::runtime_error(folder.string() + ": no folder of accepted figures");
    }
    for (const quantity q : graze::precision::all_quantities) {
        if (const auto file = file_of(folder, q); std::filesystem::exists(file)) {
            read_file(file, q, lines);
        }
    }
    return lines;
}

std::string text_of(quantity q, const accepted_figures& lines, const std::string& command) {
    std::string text = std::string("# ") + graze::precision::to_string(q) +
                       ": accepted figures, one line each. Errors in units in the last place of the exact value.\n"
                       "# made by: " +
                       command +
                       "\n"
                       "# variant type family pairs wrong values misrounded largest median\n";
    for (const auto& [k, a] : lines) {
        if (k.of == q) {
            const figures& f = a.accepted;
            text += (a.expected_to_fail ? "!" : "") + k.variant + " " + k.type + " " + k.family + " " +
                    std::to_string(f.pairs) + " " + std::to_string(f.wrong) + " " + std::to_string(f.values) + " " +
                    std::to_string(f.misrounded) + " " + number(f.largest) + " " + number(f.median) + "\n";
        }
    }
    return text;
}

std::vector<std::filesystem::path> write_accepted(const std::filesystem::path& folder, const accepted_figures& before,
                                                  const all_figures& measured, update how, const std::string& command) {
    accepted_figures after = before;
    std::set<quantity> touched;
    for (const auto& [k, f] : measured) {
        if (f.correctly_rounded) {
            continue;
        }
        touched.insert(k.of);
        accepted_line& line = after[k];
        if (!line.expected_to_fail) { // otherwise it is a goal
            line.accepted = f;
        }
    }
    std::vector<std::filesystem::path> written;
    std::filesystem::create_directories(folder);
    for (const quantity q : touched) {
        const std::filesystem::path file = file_of(folder, q);
        std::filesystem::path renewed = file;
        renewed += ".new";
        // A change of the command alone is no change.
        const auto figures_in = [](const std::string& text) {
            const auto at = text.find("\n# variant ");
            return at == std::string::npos ? text : text.substr(at);
        };
        const std::string text = text_of(q, after, command);
        if (figures_in(whole_text(file)) == figures_in(text)) {
            std::filesystem::remove(renewed); // left by an earlier run
            continue;
        }
        std::ofstream out(renewed);
        out << text;
        if (!out.flush()) {
            throw std::runtime_error(renewed.string() + ": cannot be written");
        }
        if (how == update::all) {
            std::filesystem::rename(renewed, file);
        }
        written.push_back(how == update::all ? file : renewed);
    }
    return written;
}

} // namespace precision
