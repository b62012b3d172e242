#include "options.hpp"

#include <charconv>

namespace precision {

const char* const usage =
    "usage: PROGRAM [options]\n"
    "Measures formulas against the exact truth and compares the figures with the accepted ones.\n"
    "  --only TEXT         figures whose quantity/variant/type/family contains TEXT; may be repeated\n"
    "  --pairs N           pairs of each family (400)\n"
    "  --seed N            which ones (1)\n"
    "  --inputs FILE       the pairs of a file instead of the families; may be repeated\n"
    "  --kept PATH         the pairs of a file, or of a folder's *.txt, beside the families; may be repeated\n"
    "  --accepted FOLDER   the accepted figures\n"
    "  --as VARIANT/TYPE   compare with the figures accepted for another variant, or type; either may be left out\n"
    "  --results FOLDER    where a failure's inputs are written (precision-results)\n"
    "  --threads N         (1)\n"
    "  --show              print the figures and compare nothing\n"
    "  --quiet             count the losses without telling of each\n"
    "  --expect-loss       a loss is expected: that nothing is lost is the failure\n"
    "  --no-update         update no accepted figures, whatever GRAZE_PRECISION_UPDATE says\n"
    "  --which-flag FILE.. of the results of several flag sets, say which flag lost the precision\n"
    "GRAZE_PRECISION_UPDATE=no|new|all: compare only; write *.accepted.new beside files that would change; replace "
    "them\n"
    "exit codes: 0 nothing lost, 1 precision lost, 2 bad input, 3 nothing measured where something was to be,\n"
    "  4 an expected failure passed, 5 figures that nobody has accepted yet\n";

namespace {

template <class T>
T whole(const std::string& option, const std::string& text) {
    T x{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (error != std::errc() || end != text.data() + text.size() || x == 0) {
        throw std::invalid_argument(option + ": \"" + text + "\" is not a whole number above 0");
    }
    return x;
}

} // namespace

options parse(const std::vector<std::string>& words) {
    options o;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const auto next = [&]() -> const std::string& {
            if (i + 1 == words.size()) {
                throw std::invalid_argument(word + ": a value is missing");
            }
            return words[++i];
        };
        if (word == "--only") {
            o.only.push_back(next());
        } else if (word == "--pairs") {
            o.pairs = whole<std::size_t>(word, next());
        } else if (word == "--seed") {
            o.seed = whole<std::uint64_t>(word, next());
        } else if (word == "--threads") {
            o.threads = whole<unsigned>(word, next());
        } else if (word == "--inputs") {
            o.inputs.emplace_back(next());
        } else if (word == "--kept") {
            o.kept.emplace_back(next());
        } else if (word == "--accepted") {
            o.accepted = next();
        } else if (word == "--as") {
            const std::string& text = next();
            const auto slash = text.find('/');
            if (slash == std::string::npos || text.size() == 1) {
                throw std::invalid_argument(word + ": \"" + text +
                                            "\" is not a variant/type, as lagrange/double or /double");
            }
            o.as_variant = text.substr(0, slash);
            o.as_type = text.substr(slash + 1);
        } else if (word == "--results") {
            o.results = next();
        } else if (word == "--show") {
            o.show = true;
        } else if (word == "--quiet") {
            o.quiet = true;
        } else if (word == "--expect-loss") {
            o.expect_loss = true;
        } else if (word == "--no-update") {
            o.no_update = true;
        } else if (word == "--help") {
            o.help = true;
        } else if (word == "--which-flag") {
            o.flag_results.emplace_back(next());
            while (i + 1 < words.size() && !words[i + 1].starts_with("--")) {
                o.flag_results.emplace_back(next());
            }
        } else {
            throw std::invalid_argument(word + ": no such option; --help names them");
        }
    }
    return o;
}

std::string quoted(const std::string& word) {
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-=:,@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
        return word;
    }
    std::string text = "'";
    for (const char letter : word) {
        text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    }
    return text + "'";
}

} // namespace precision
