#include "kept.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace search {

namespace {

constexpr const char* const terms_mark = "# search:";
constexpr const char* const pair_mark = "# found:";
constexpr const char* const shrunk_mark = "# shrunk:";

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& w : words) {
        text += (text.empty() ? "" : ",") + w;
    }
    return text;
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream in(text);
    for (std::string w; std::getline(in, w, ',');) {
        words.push_back(w);
    }
    return words;
}

// The given magnitudes, as options or as values of a line.
std::string within(const terms& t, const std::string& before, const std::string& after) {
    std::string text;
    for (const auto& [name, value] :
         {std::pair("lengths", &t.lengths), std::pair("velocities", &t.velocities), std::pair("masses", &t.masses)}) {
        text += value->empty() ? std::string() : before + name + after + *value;
    }
    return text;
}

// One line of names and values, `name=value name=value`.
std::string line_of(const kept_file& f) {
    std::ostringstream out;
    out << terms_mark << " goal=" << f.of.goal << " figure=" << f.of.figure << " families=" << joined(f.of.families)
        << " seed=" << f.of.seed << " evaluations=" << f.of.evaluations << within(f.of, " ", "=")
        << " shard=" << f.of.shard << '/' << f.of.shards << " next=" << f.next << " merged=" << (f.merged ? 1 : 0);
    return out.str();
}

// Takes values by name, in order. Throws std::runtime_error if one is missing.
class values {
  public:
    explicit values(const std::string& line) : in_(line) {}
    std::string text(const std::string& name) {
        std::string word;
        if (!(in_ >> word) || !word.starts_with(name + "=")) {
            throw std::runtime_error("\"" + name + "=\" expected");
        }
        return word.substr(name.size() + 1);
    }
    // Empty if it is missing.
    std::string text_if_any(const std::string& name) {
        const auto here = in_.tellg();
        std::string word;
        if (in_ >> word && word.starts_with(name + "=")) {
            return word.substr(name.size() + 1);
        }
        in_.clear();
        in_.seekg(here);
        return "";
    }
    std::uint64_t number(const std::string& name) { return to_number(name, text(name)); }
    double real(const std::string& name) {
        const std::string word = text(name);
        std::size_t used = 0;
        double number = 0;
        try {
            number = std::stod(word, &used);
        } catch (const std::logic_error&) {
            used = 0;
        }
        if (used == 0 || used != word.size() || !std::isfinite(number)) {
            throw std::runtime_error(name + ": \"" + word + "\" is not a number");
        }
        return number;
    }
    static std::uint64_t to_number(const std::string& name, const std::string& word) {
        std::size_t used = 0;
        std::uint64_t number = 0;
        try {
            number = std::stoull(word, &used);
        } catch (const std::logic_error&) {
            used = 0;
        }
        if (used == 0 || used != word.size() || word.find_first_not_of("0123456789") != std::string::npos) {
            throw std::runtime_error(name + ": \"" + word + "\" is not a whole number");
        }
        return number;
    }

  private:
    std::istringstream in_;
};

void read_terms(const std::string& line, kept_file& f) {
    values v(line);
    f.of.goal = v.text("goal");
    f.of.figure = v.text("figure");
    f.of.families = split(v.text("families"));
    f.of.seed = v.number("seed");
    f.of.evaluations = v.number("evaluations");
    f.of.lengths = v.text_if_any("lengths");
    f.of.velocities = v.text_if_any("velocities");
    f.of.masses = v.text_if_any("masses");
    const std::string shard = v.text("shard");
    const auto slash = shard.find('/');
    f.of.shard = values::to_number("shard", shard.substr(0, slash));
    f.of.shards = values::to_number("shard", slash == std::string::npos ? "" : shard.substr(slash + 1));
    if (f.of.shard >= f.of.shards) {
        throw std::runtime_error("shard: \"" + shard + "\" is not i/n with i < n");
    }
    f.next = v.number("next");
    f.merged = v.number("merged") != 0;
}

} // namespace

bool same_search(const terms& x, const terms& y) {
    return x.goal == y.goal && x.figure == y.figure && x.families == y.families && x.seed == y.seed &&
           x.evaluations == y.evaluations && within(x, " ", "=") == within(y, " ", "=");
}

void keep(std::vector<kept_pair>& pairs, kept_pair p) {
    const std::string line = p.at.lines();
    std::erase_if(pairs, [&](const kept_pair& q) { return q.attempt == p.attempt && (q.partial || !p.partial); });
    const auto same = std::ranges::find_if(pairs, [&](const kept_pair& q) { return q.at.lines() == line; });
    if (same != pairs.end()) {
        if (p.partial || (!same->partial && same->attempt < p.attempt)) {
            return;
        }
        pairs.erase(same);
    }
    const auto place = std::ranges::find_if(pairs, [&](const kept_pair& q) {
        return q.at.score < p.at.score || (q.at.score == p.at.score && q.attempt > p.attempt);
    });
    pairs.insert(place, std::move(p));
    std::size_t whole = 0;
    std::erase_if(pairs, [&](const kept_pair& q) { return !q.partial && ++whole > most_kept; });
}

std::string command_of(const terms& t) {
    return t.program + " --goal " + t.goal + " --figure " + t.figure +
           (t.families.empty() ? "" : " --families " + joined(t.families)) + " --seed " + std::to_string(t.seed) +
           " --evaluations " + std::to_string(t.evaluations) + within(t, " --", " ");
}

std::string text_of(const kept_file& file, const goal& g) {
    std::ostringstream out;
    out << "# Hard pairs that graze-search found for " << file.of.goal << " of " << file.of.figure << ".\n"
        << line_of(file) << '\n';
    for (const kept_pair& p : file.pairs) {
        out << pair_mark << " try=" << p.attempt << " climbs=" << p.climbs << " climbing=" << (p.at.climbing ? 1 : 0)
            << " partial=" << (p.partial ? 1 : 0) << " score=" << std::setprecision(17) << p.at.score << '\n'
            << "# " << g.tell(p.at.score) << (p.at.climbing ? ", still climbing" : ", no changed bit is worse") << '\n'
            << "# origin: " << p.origin << '\n'
            << p.at.lines() << '\n';
        if (!p.shrunk.empty()) {
            out << shrunk_mark << '\n' << p.shrunk << '\n';
        }
    }
    return out.str();
}

file_lock::file_lock(const std::filesystem::path& of) : path_(of.string() + ".lock") {
    for (;;) {
        file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
        if (file_ < 0) {
            throw std::runtime_error(path_.string() + ": cannot be written");
        }
        if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
            ::close(file_);
            throw std::runtime_error(of.string() + ": another search is using this file; another --out is needed");
        }
        struct stat here {
        }, there{}; // whoever had the lock may have removed the file meanwhile
        if (::fstat(file_, &here) == 0 && ::stat(path_.c_str(), &there) == 0 && here.st_ino == there.st_ino) {
            return;
        }
        ::close(file_);
    }
}

file_lock::~file_lock() {
    ::unlink(path_.c_str());
    ::close(file_);
}

void write(const std::filesystem::path& path, const kept_file& file, const goal& g) {
    const std::filesystem::path draft = path.string() + ".new";
    {
        std::ofstream out(draft);
        out << text_of(file, g);
        out.flush();
        if (!out) {
            throw std::runtime_error(draft.string() + ": cannot be written");
        }
    }
    std::filesystem::rename(draft, path);
}

kept_file read_kept(const std::filesystem::path& path) {
    std::ifstream in(path);
    if (!in) {
        throw std::runtime_error(path.string() + ": cannot be read");
    }
    kept_file f;
    bool has_terms = false, is_shrunk = false, is_told = false;
    std::string first_line; // of the two lines of an order
    std::string line, origin;
    kept_pair next;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        try {
            if (line.starts_with(terms_mark)) {
                if (has_terms) {
                    throw std::runtime_error("a second line \"" + std::string(terms_mark) + "\"");
                }
                read_terms(line.substr(std::string(terms_mark).size()), f);
                has_terms = true;
            } else if (line.starts_with(pair_mark)) {
                if (is_told) {
                    throw std::runtime_error("no pair since the last line \"" + std::string(pair_mark) + "\"");
                }
                values v(line.substr(std::string(pair_mark).size()));
                next.attempt = v.number("try");
                next.climbs = v.number("climbs");
                next.at.climbing = v.number("climbing") != 0;
                next.partial = v.number("partial") != 0;
                next.at.score = v.real("score");
                is_told = true;
                next.shrunk.clear();
                next.origin.clear();
            } else if (line.starts_with("# origin: ")) {
                next.origin = line.substr(10);
            } else if (line.starts_with(shrunk_mark)) {
                is_shrunk = true;
            } else if (!line.empty() && !line.starts_with('#')) {
                if (!is_told && !is_shrunk) {
                    throw std::runtime_error("no line \"" + std::string(pair_mark) + "\" before the pair");
                }
                const any_pair read = precision::from_line(line);
                if (f.of.figure.starts_with("order/") && first_line.empty()) {
                    first_line = line;
                    continue;
                }
                if (is_told) {
                    next.at.pair = first_line.empty() ? read : precision::from_line(first_line);
                    next.at.other = first_line.empty() ? std::nullopt : std::optional(read);
                    if (next.origin.empty()) {
                        throw std::runtime_error("no line \"# origin: \" before the pair");
                    }
                    f.pairs.push_back(next);
                } else if (!f.pairs.empty()) {
                    f.pairs.back().shrunk = first_line + (first_line.empty() ? "" : "\n") + line;
                }
                is_shrunk = is_told = false;
                first_line.clear();
            }
        } catch (const std::runtime_error& e) {
            throw std::runtime_error(path.string() + ":" + std::to_string(number) + ": " + e.what());
        }
    }
    if (!has_terms) {
        throw std::runtime_error(path.string() + ": no line \"" + std::string(terms_mark) + "\": not a search's");
    }
    if (is_told || is_shrunk) {
        throw std::runtime_error(path.string() + ": ends before its last pair");
    }
    return f;
}

void check(const kept_file& file, const goal& g) {
    for (const kept_pair& p : file.pairs) {
        const auto score = p.at.score_by(g);
        if (!score || *score != p.at.score) {
            throw std::runtime_error("try " + std::to_string(p.attempt) + ": the file says \"" + g.tell(p.at.score) +
                                     "\", but the pair shows \"" + (score ? g.tell(*score) : "nothing") +
                                     "\": the formula or its build has changed");
        }
    }
}

kept_file merged(const std::vector<kept_file>& files) {
    kept_file all;
    all.of = files.at(0).of;
    all.of.shard = 0;
    all.of.shards = 1;
    all.merged = true;
    for (const kept_file& f : files) {
        if (!same_search(f.of, all.of)) {
            throw std::runtime_error("merge: \"" + command_of(f.of) + "\" is another search than \"" +
                                     command_of(all.of) + "\"");
        }
        for (const kept_pair& p : f.pairs) {
            keep(all.pairs, p);
        }
        all.next = std::max(all.next, f.next);
    }
    return all;
}

} // namespace search
