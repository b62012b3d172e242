#include "which_flag.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

namespace precision {

namespace {

struct flag_set {
    std::string text;
    std::set<std::string> flags, lost;
    bool has_unaccepted = false;
};

flag_set read(const std::filesystem::path& file) {
    std::ifstream in(file);
    flag_set s;
    std::string word, rest, line;
    if (!std::getline(in, line) || !line.starts_with("flags ")) {
        throw std::runtime_error(file.string() + ": not the results of a flag set; its test has to run first");
    }
    s.text = line.substr(6);
    std::istringstream words(s.text);
    while (words >> word) {
        s.flags.insert(word);
    }
    while (in >> word && std::getline(in >> std::ws, rest)) {
        if (word == "lost") {
            s.lost.insert(rest);
        } else if (word == "unaccepted") {
            s.has_unaccepted = rest != "0";
        }
    }
    return s;
}

std::string joined(const std::set<std::string>& words) {
    std::string text;
    for (const std::string& w : words) {
        text += (text.empty() ? "" : " ") + w;
    }
    return text;
}

} // namespace

flag_verdict which_flag(const std::vector<std::filesystem::path>& results, std::ostream& out) {
    std::vector<flag_set> sets;
    std::set<std::string> lost;
    for (const auto& file : results) {
        sets.push_back(read(file));
        lost.insert(sets.back().lost.begin(), sets.back().lost.end());
    }
    // The figures, grouped by the sets of flags in which they are lost.
    std::map<std::vector<bool>, std::vector<std::string>> alike;
    for (const std::string& figure : lost) {
        std::vector<bool> in;
        for (const flag_set& s : sets) {
            in.push_back(s.lost.contains(figure));
        }
        alike[in].push_back(figure);
    }
    for (const auto& [in, figures] : alike) {
        std::set<std::string> common, elsewhere, guilty;
        bool first = true;
        for (std::size_t i = 0; i < sets.size(); ++i) {
            if (!in[i]) {
                elsewhere.insert(sets[i].flags.begin(), sets[i].flags.end());
                continue;
            }
            std::set<std::string> both;
            std::set_intersection(common.begin(), common.end(), sets[i].flags.begin(), sets[i].flags.end(),
                                  std::inserter(both, both.end()));
            common = first ? sets[i].flags : both;
            first = false;
        }
        std::set_difference(common.begin(), common.end(), elsewhere.begin(), elsewhere.end(),
                            std::inserter(guilty, guilty.end()));
        const bool everywhere = std::all_of(in.begin(), in.end(), [](bool b) { return b; });
        if (!guilty.empty()) {
            out << "lost by " << joined(guilty);
        } else if (everywhere) {
            out << "lost with every flag set";
        } else {
            out << "lost, by no flag alone, with";
            for (std::size_t i = 0; i < sets.size(); ++i) {
                out << (in[i] ? " [" + sets[i].text + "]" : "");
            }
        }
        out << ": " << figures.size() << " figures, such as " << figures.front() << '\n';
    }
    const bool all_accepted =
        std::none_of(sets.begin(), sets.end(), [](const flag_set& s) { return s.has_unaccepted; });
    if (!all_accepted) {
        for (const flag_set& s : sets) {
            out << (s.has_unaccepted ? "figures that nobody has accepted yet, with [" + s.text + "]\n" : "");
        }
    } else if (lost.empty()) {
        out << "no flag set lost any precision\n";
    }
    return !lost.empty() ? flag_verdict::lost : all_accepted ? flag_verdict::nothing_lost : flag_verdict::unaccepted;
}

} // namespace precision
