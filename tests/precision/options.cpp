#include "options.hpp"

#include <charconv>

namespace precision {

const char* const usage =
    "usage: PROGRAM [options]\n"
    "Measures formulas against the exact truth and compares the figures with the accepted ones.\n"
    "  --only TEXT         Measure only figures whose quantity/variant/type/family contains TEXT; may be repeated\n"
    "  --pairs N           Draw N pairs of each family (400)\n"
    "  --seed N            The seed of the families (1)\n"
    "  --triangles         Draw triangles, in space, instead of the families\n"
    "  --inputs FILE       Measure the pairs of this file instead of the families; may be repeated\n"
    "  --kept PATH         Measure the pairs of this file, or of a folder's *.txt, beside the families; may be "
    "repeated\n"
    "  --accepted FOLDER   The folder of the accepted figures\n"
    "  --as VARIANT/TYPE   Compare with the figures accepted for another variant or type; either may be left out\n"
    "  --tolerance P       Let the largest error exceed the accepted one by P percent (0)\n"
    "  --results FOLDER    Write the inputs of a failure to this folder (precision-results)\n"
    "  --threads N         Use N threads (1)\n"
    "  --show              Print the figures and compare nothing\n"
    "  --quiet             Count the losses and describe none\n"
    "  --expect-loss       Expect a loss: the run fails if nothing is lost\n"
    "  --no-update         Update no accepted figures, whatever GRAZE_PRECISION_UPDATE says\n"
    "  --which-flag FILE.. Say which flag lost the precision, from the results of several flag sets\n"
    "  --help              Print this and exit\n"
    "GRAZE_PRECISION_UPDATE=no: compare only; new: write *.accepted.new beside files that would change; all: replace "
    "them\n"
    "Exit codes: 0 nothing lost, 1 precision lost, 2 bad input, 3 nothing measured where something was expected,\n"
    "  4 an expected failure passed, 5 figures not accepted yet\n";

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
        } else if (word == "--tolerance") {
            const std::string& text = next();
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), o.tolerance);
            if (error != std::errc() || end != text.data() + text.size() ||
                !(o.tolerance >= 0 && o.tolerance <= 1000)) {
                throw std::invalid_argument(word + ": \"" + text + "\" is not a percentage from 0 to 1000");
            }
        } else if (word == "--results") {
            o.results = next();
        } else if (word == "--triangles") {
            o.triangles = true;
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

} // namespace precision
