#include "accepted.hpp"

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

// Of any size: what underflows is 0 or subnormal, what overflows infinite.
bool is_number(const std::string& text, double& x) {
    char* end = nullptr;
    x = std::strtod(text.c_str(), &end);
    return !text.empty() && end == text.c_str() + text.size();
}

std::string whole_text(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void read_file(const std::filesystem::path& file, quantity q, accepted_figures& lines) {
    std::ifstream in(file);
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
        std::string largest, median, rest;
        words >> k.variant >> k.type >> k.family >> f.pairs >> f.wrong >> f.values >> f.misrounded >> largest >> median;
        if (!words || !is_number(largest, f.largest) || !is_number(median, f.median) || words >> rest) {
            throw std::runtime_error(file.string() + ":" + std::to_string(n) +
                                     ": not a variant, a type, a family and six figures: " + line);
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
    is_number(number(error), told);
    return told;
}

accepted_figures read_accepted(const std::filesystem::path& folder) {
    accepted_figures lines;
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
        line.accepted = f;
    }
    std::vector<std::filesystem::path> written;
    std::filesystem::create_directories(folder);
    for (const quantity q : touched) {
        std::filesystem::path file = file_of(folder, q);
        // The command alone is no change.
        const auto figures_in = [](const std::string& text) {
            const auto at = text.find("\n# variant ");
            return at == std::string::npos ? text : text.substr(at);
        };
        const std::string text = text_of(q, after, command);
        if (figures_in(whole_text(file)) == figures_in(text)) {
            continue;
        }
        if (how == update::renewed) {
            file += ".new";
        }
        std::ofstream out(file);
        out << text;
        if (!out.flush()) {
            throw std::runtime_error(file.string() + ": cannot be written");
        }
        written.push_back(file);
    }
    return written;
}

} // namespace precision
