// environment_contacts FILE COUNT MOST [--started-flushing | --write]: hashes of contacts and rounded times, as this
// program was compiled, over pairs that integers alone generate: the first COUNT and the first MOST of each subject,
// and the first COUNT also in every rounding mode, with and without subnormals. Ends with 0 if all are those of the
// file, with 1 if not, with 77 if the process was to start with subnormals flushed to zero and did not; or writes the
// file.
#include "contact_hash.hpp"
#include "state.hpp"
#include "text_file.hpp"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace environments {
namespace {

// "<subject> <count>" and the hash of its first `count` pairs.
using hashes = std::map<std::string, std::uint64_t>;

[[nodiscard]] std::string key(const hashed_subject& s, std::uint64_t count) {
    return s.name + ' ' + std::to_string(count);
}

[[nodiscard]] hashes read(const char* path) {
    std::istringstream file(text_of(path));
    hashes h;
    for (std::string line; std::getline(file, line);) {
        const std::size_t space = line.rfind(' ');
        std::uint64_t hash = 0;
        const auto [end, error] = std::from_chars(line.data() + space + 1, line.data() + line.size(), hash, 16);
        if (error != std::errc() || end != line.data() + line.size()) {
            throw std::runtime_error(std::string(path) + ": not a hash: " + line);
        }
        h[line.substr(0, space)] = hash;
    }
    return h;
}

class checker {
  public:
    explicit checker(hashes expected) : expected_(std::move(expected)) {}

    void check(const std::string& mode, const hashed_subject& s, std::uint64_t count) {
        const tally t = s.run(count);
        std::printf("%-24s %-28s %8lu pairs %8lu contacts %8lu by doubles %016llx\n", mode.c_str(), s.name.c_str(),
                    static_cast<unsigned long>(count), static_cast<unsigned long>(t.contacts),
                    static_cast<unsigned long>(t.by_doubles), static_cast<unsigned long long>(t.hash));
        found_[key(s, count)] = t.hash;
        const auto known = expected_.find(key(s, count));
        if (known == expected_.end() || known->second != t.hash || 8 * t.contacts < count) {
            std::printf("wrong: %s\n", known == expected_.end() ? "the file has no such hash" : "another hash");
            ++wrong_;
        }
        pairs_ += count;
        contacts_ += t.contacts;
        by_doubles_ += t.by_doubles;
    }

    void write(const char* path) const {
        const open_file file(std::fopen(path, "w"));
        if (!file) {
            throw std::runtime_error(std::string(path) + ": cannot be written");
        }
        for (const auto& [name, hash] : found_) {
            std::fprintf(file.get(), "%s %016llx\n", name.c_str(), static_cast<unsigned long long>(hash));
        }
    }
    [[nodiscard]] bool report() const {
        const auto number = [](std::uint64_t n) { return static_cast<unsigned long>(n); };
        std::printf("total %lu %lu %lu %lu\n", number(pairs_), number(by_doubles_), number(contacts_ - by_doubles_),
                    number(wrong_));
        return wrong_ == 0 && pairs_ != 0;
    }

  private:
    hashes expected_, found_;
    std::uint64_t pairs_ = 0, contacts_ = 0, by_doubles_ = 0, wrong_ = 0;
};

int run(const char* path, std::uint64_t count, std::uint64_t most, std::string_view option) {
    save_state();
    const bool write = option == "--write";
    if (option == "--started-flushing" && !flushes()) {
        std::printf("SKIPPED: the process does not start with subnormals flushed to zero\n");
        return 77;
    }
    const std::vector<hashed_subject> subjects = hashed_subjects();
    checker checks(write ? hashes{} : read(path));
    for (const hashed_subject& s : subjects) {
        checks.check("as started", s, count);
        if (most > count) {
            checks.check("as started", s, most);
        }
    }
    for (const bool flush : {false, true}) {
        if (flush && !can_flush()) {
            continue;
        }
        for (const rounding r : {rounding::nearest, rounding::upward, rounding::downward, rounding::towards_zero}) {
            if (!can_round(r)) {
                continue;
            }
            const std::string mode = std::string(name_of(r)) + (flush ? ", flushing" : "");
            for (const hashed_subject& s : subjects) {
                if (!set_state(r, flush)) {
                    restore_state();
                    throw std::runtime_error("the machine does not calculate " + mode);
                }
                checks.check(mode, s, count);
                restore_state();
            }
        }
    }
    if (write) {
        checks.write(path);
        return 0;
    }
    return checks.report() ? 0 : 1;
}

} // namespace
} // namespace environments

int main(int argc, char** argv) {
    const std::string_view option = argc == 5 ? argv[4] : "";
    if (argc != 4 && option != "--started-flushing" && option != "--write") {
        std::fprintf(stderr, "environment_contacts FILE COUNT MOST [--started-flushing | --write]\n");
        return 2;
    }
    try {
        return environments::run(argv[1], std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10),
                                 option);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "environment_contacts: %s\n", e.what());
        return 1;
    }
}
