#include "picture.hpp"

#include "gnuplot.hpp"
#include "svg.hpp"

#include <array>
#include <cstdio>
#include <utility>

namespace compare::report {

const char* variable_of(ink colour) {
    static constexpr std::array<const char*, 14> names = {"--text", "--muted", "--grid", "--paper", "--bad",
                                                          "--open", "--best",  "--one",  "--two",   "--three",
                                                          "--four", "--five",  "--six",  "--seven"};
    return names[static_cast<std::size_t>(colour)];
}

picture::picture(std::string name, int width, int height, std::string description)
    : name_(std::move(name)), description_(std::move(description)), width_(width), height_(height) {
    const std::string frame = colour(ink::muted), lines = colour(ink::grid);
    add("set terminal svg size " + std::to_string(width) + "," + std::to_string(height) +
        " dynamic noenhanced rounded font \"sans-serif,12\"");
    add("unset key");
    add("set border 0");
    add("set style line 100 lc " + lines + " lw 1 dt solid");
    add("set grid back ls 100");
    add("set tics nomirror scale 0 textcolor " + frame);
}

void picture::margins(double left, double right, double top, double bottom) {
    add("set lmargin at screen " + exactly(left / width_));
    add("set rmargin at screen " + exactly(1 - right / width_));
    add("set tmargin at screen " + exactly(1 - top / height_));
    add("set bmargin at screen " + exactly(bottom / height_));
}

std::string picture::text(const std::string& content) {
    texts_.push_back(content);
    std::string quoted(1, '"');
    quoted.append(mark_of_text(texts_.size() - 1)).push_back('"');
    return quoted;
}

void picture::tics(char axis, const std::vector<std::pair<double, std::string>>& places) {
    std::string all = "set ";
    all.append(1, axis).append("tics (");
    for (std::size_t i = 0; i < places.size(); ++i) {
        all.append(i == 0 ? "" : ",").append(text(places[i].second)).append(" ").append(exactly(places[i].first));
    }
    add(all + ")");
}

std::string picture::colour(ink role) { return "rgb \"" + mark_of_colour(role) + '"'; }

void picture::label(const std::string& content, const std::string& x, const std::string& y, const std::string& align,
                    ink role, double size, int rotate) {
    add("set label " + text(content) + " at " + x + "," + y + " " + align +
        (rotate == 0 ? "" : " rotate by " + std::to_string(rotate)) + " font \"sans-serif," + exactly(size) +
        "\" textcolor " + colour(role) + " front");
}

std::string picture::svg() const { return coloured(run_gnuplot(script_), name_, description_, texts_); }

std::string exactly(double value) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
    return buffer.data();
}

} // namespace compare::report
