#include "run.hpp"

#include "failure.hpp"
#include "options.hpp"
#include "which_flag.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>

namespace precision {

namespace {

enum exit_code {
    passed = 0,
    lost = 1,
    bad_input = 2,
    nothing_measured = 3,
    expected_failure_passed = 4,
    not_accepted = 5
};

update update_asked() {
    const char* text = std::getenv("GRAZE_PRECISION_UPDATE");
    const std::string how = text == nullptr ? "no" : text;
    if (how == "no") {
        return update::no;
    }
    if (how == "new") {
        return update::renewed;
    }
    if (how == "all") {
        return update::all;
    }
    throw std::invalid_argument("GRAZE_PRECISION_UPDATE is \"" + how + "\", not no, new or all");
}

std::vector<family> families_asked(const options& o) {
    std::vector<family> all;
    if (o.inputs.empty()) {
        all = o.triangles ? std::vector{drawn_triangles(o.pairs, o.seed)} : drawn_families(o.pairs, o.seed);
    }
    std::vector<std::filesystem::path> files = o.inputs;
    for (const auto& path : o.kept) {
        if (!std::filesystem::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        const std::size_t before = files.size();
        for (const auto& entry : std::filesystem::directory_iterator(path)) {
            if (entry.path().extension() == ".txt") {
                files.push_back(entry.path());
            }
        }
        if (files.size() == before) {
            throw std::runtime_error("--kept " + path.string() + ": no *.txt in this folder");
        }
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        all.push_back(read_inputs(file));
        if (all.back().pairs.empty()) {
            throw std::runtime_error(file.string() + ": no pairs in it");
        }
    }
    return all;
}

// The options that name the inputs. short_paths: without this machine's folders, as in the accepted figures.
std::string command_of(const options& o, bool short_paths = false) {
    const auto told = [&](const std::filesystem::path& path) {
        return short_paths ? path.filename().string() : quoted(path.string());
    };
    std::string command;
    for (const auto& path : o.inputs) {
        command += (command.empty() ? "--inputs " : " --inputs ") + told(path);
    }
    if (o.inputs.empty()) {
        command = std::string(o.triangles ? "--triangles " : "") + "--pairs " + std::to_string(o.pairs) + " --seed " +
                  std::to_string(o.seed);
    }
    for (const auto& path : o.kept) {
        command += " --kept " + told(path);
    }
    return command;
}

std::string as_written(double x) {
    std::string text = std::to_string(x);
    text.erase(text.find_last_not_of('0') + 1);
    return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

std::string accepted_option(const options& o) {
    const bool by_another = !o.as_variant.empty() || !o.as_type.empty();
    return (o.accepted.empty() ? "" : " --accepted " + quoted(o.accepted.string())) +
           (by_another ? " --as " + o.as_variant + "/" + o.as_type : "") +
           (o.tolerance > 0 ? " --tolerance " + as_written(o.tolerance) : "") + (o.no_update ? " --no-update" : "");
}

void print(const all_figures& measured) {
    std::cout << "quantity/variant/type/family  pairs wrong  values misrounded  largest median\n";
    for (const auto& [k, f] : measured) {
        std::cout << to_string(k) << "  " << f.pairs << ' ' << f.wrong << "  " << f.values << ' ' << f.misrounded
                  << "  " << as_told(f.largest) << ' ' << as_told(f.median) << '\n';
    }
}

class comparison {
  public:
    comparison(const graze::precision::subjects& formulas, const plan& what, const all_figures& measured,
               const accepted_figures& accepted, const options& asked, const circumstances& about)
        : formulas_(formulas), plan_(what), measured_(measured), accepted_(accepted), asked_(asked), about_(about) {
        for (const auto& [k, f] : measured_) {
            compare(k, f);
        }
        look_for_unmeasured();
    }

    [[nodiscard]] const std::vector<key>& losses() const { return lost_; }
    [[nodiscard]] std::size_t unaccepted() const { return new_.size(); }
    // Whether a formula that promises correct rounding was wrong.
    [[nodiscard]] bool promise_is_broken() const { return promise_is_broken_; }

    int finish(std::ostream& out) const {
        if (!unexpected_.empty()) {
            out << "PASSED, though expected to fail (remove the '!' from the line):\n";
            list(unexpected_, out);
        }
        if (!new_.empty()) {
            out << "NOT ACCEPTED YET: " << new_.size() << (new_.size() == 1 ? " figure, " : " figures, such as ")
                << to_string(new_.front())
                << (asked_.no_update ? "; this run updates none: the test of another set of flags does\n"
                                     : "; see them with GRAZE_PRECISION_UPDATE=new\n");
        }
        if (!unmeasured_.empty()) {
            out << "NOT MEASURED, though accepted:\n";
            list(unmeasured_, out);
        }
        out << measured_.size() << (measured_.size() == 1 ? " figure, " : " figures, ") << lost_.size()
            << " worse than accepted, " << better_ << " better; compiled by " << about_.compiler << ", flags "
            << flags_or_none(about_.flags) << '\n';
        return !lost_.empty()         ? lost
               : !unexpected_.empty() ? expected_failure_passed
               : !unmeasured_.empty() ? nothing_measured
               : !new_.empty()        ? not_accepted
                                      : passed;
    }

  private:
    static void list(const std::vector<key>& keys, std::ostream& out) {
        constexpr std::size_t most = 10;
        for (std::size_t i = 0; i < std::min(keys.size(), most); ++i) {
            out << "  " << to_string(keys[i]) << '\n';
        }
        if (keys.size() > most) {
            out << "  and " << keys.size() - most << " more\n";
        }
    }

    void compare(const key& k, const figures& now) {
        key other = k;
        other.variant = asked_.as_variant.empty() ? k.variant : asked_.as_variant;
        other.type = asked_.as_type.empty() ? k.type : asked_.as_type;
        const auto line = accepted_.find(other);
        if (!now.correctly_rounded && line == accepted_.end()) {
            new_.push_back(k);
            return;
        }
        figures before; // the promise: nothing is wrong
        if (now.correctly_rounded) {
            before.pairs = now.pairs;
            before.values = now.values;
        } else {
            before = line->second.accepted;
        }
        if (asked_.tolerance > 0 && !now.correctly_rounded) {
            before.largest *= 1 + asked_.tolerance / 100;
        }
        if (other != k) {
            before.pairs = std::min(before.pairs, now.pairs); // a type with another range holds other pairs
        }
        const bool is_worse = !precision::losses(now, before).empty();
        if (!now.correctly_rounded && line->second.expected_to_fail) {
            if (!is_worse) {
                unexpected_.push_back(k);
            }
            return;
        }
        if (!is_worse) {
            better_ += !now.correctly_rounded && !precision::losses(before, now).empty() ? 1 : 0;
            return;
        }
        lost_.push_back(k);
        promise_is_broken_ = promise_is_broken_ || now.correctly_rounded;
        if (asked_.quiet) {
            return;
        }
        constexpr std::size_t most = 3; // messages printed; the results have all
        if (lost_.size() <= most) {
            const auto formula = std::find_if(formulas_.begin(), formulas_.end(), [&](const auto& s) {
                return s->variant == k.variant && s->type.name == k.type;
            });
            const auto pairs = std::find_if(plan_.families.begin(), plan_.families.end(),
                                            [&](const family& f) { return f.name == k.family; });
            std::cout << tell(k, now, before, **formula, *pairs, about_) << '\n';
        } else if (lost_.size() == most + 1) {
            std::cout << "Further losses, by name:\n";
        }
        if (lost_.size() > most) {
            std::cout << "  " << to_string(k) << ": " << precision::losses(now, before).front() << '\n';
        }
    }

    // Finds accepted lines of measured types for which there are no figures any more. If only pairs from files were
    // asked, lines of other families do not count.
    void look_for_unmeasured() {
        const auto is_asked = [&](const std::string& name) {
            return asked_.inputs.empty() && (!name.starts_with("kept.") || !asked_.kept.empty());
        };
        std::set<std::string> types, drawn;
        for (const auto& s : formulas_) {
            types.insert(s->type.name);
        }
        for (const family& f : plan_.families) {
            drawn.insert(f.name);
        }
        for (const auto& [k, line] : accepted_) {
            if (asked_.as_variant.empty() && asked_.as_type.empty() && types.contains(k.type) &&
                (drawn.contains(k.family) || is_asked(k.family)) && plan_.chooses(k) && !measured_.contains(k)) {
                unmeasured_.push_back(k);
            }
        }
    }

    const graze::precision::subjects& formulas_;
    const plan& plan_;
    const all_figures& measured_;
    const accepted_figures& accepted_;
    const options& asked_;
    const circumstances& about_;
    bool promise_is_broken_ = false;
    std::vector<key> lost_, unexpected_, new_, unmeasured_;
    std::size_t better_ = 0;
};

std::filesystem::path results_file(const std::filesystem::path& folder) { return folder / "results.txt"; }

// Removes the results of an earlier run, and checks before the work that results can be written.
void start_results(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    if (!std::ofstream(results_file(folder))) {
        throw std::runtime_error(results_file(folder).string() + ": cannot be written");
    }
}

void write_results(const options& o, const std::string& flags, const all_figures& measured,
                   const comparison& compared) {
    const std::filesystem::path file = results_file(o.results);
    std::ofstream out(file);
    out << "flags " << flags << "\nmeasured " << measured.size() << "\nunaccepted " << compared.unaccepted() << '\n';
    for (const key& k : compared.losses()) {
        out << "lost " << to_string(k) << '\n';
    }
    if (!out.flush()) {
        throw std::runtime_error(file.string() + ": cannot be written");
    }
}

int run_checked(const options& o, const std::string& program, const graze::precision::subjects& formulas,
                const std::string& compiler, const std::string& flags) {
    if (!o.flag_results.empty()) {
        const flag_verdict found = which_flag(o.flag_results, std::cout);
        return found == flag_verdict::lost ? lost : found == flag_verdict::unaccepted ? not_accepted : passed;
    }
    plan what;
    what.families = families_asked(o);
    what.threads = o.threads;
    what.chooses = [&](const key& k) {
        const std::string name = to_string(k);
        return o.only.empty() || std::any_of(o.only.begin(), o.only.end(), [&](const std::string& text) {
                   return name.find(text) != std::string::npos;
               });
    };
    const update how = update_asked();
    if (!o.accepted.empty() && how == update::no && !std::filesystem::exists(o.accepted)) {
        throw std::runtime_error("--accepted " + o.accepted.string() +
                                 ": no such folder; GRAZE_PRECISION_UPDATE=all makes it and accepts the figures");
    }
    const accepted_figures accepted = o.accepted.empty() ? accepted_figures{} : read_accepted(o.accepted);
    if (!o.show) {
        start_results(o.results);
    }
    const all_figures measured = measure(formulas, what);
    if (measured.empty()) {
        std::cout << "NOTHING WAS MEASURED: --only leaves no figure, or no formula is about these pairs\n";
        return nothing_measured;
    }
    if (o.show) {
        print(measured);
        return passed;
    }
    const std::string repeated = command_of(o);
    const circumstances about{program, compiler, flags, repeated, accepted_option(o), o.results, o.as_variant};
    // Only a run's own figures can be accepted: not those compared with another's figures, nor those meant to be worse.
    // With several sets of flags, one set alone decides what is accepted.
    const bool own_figures = o.as_variant.empty() && o.as_type.empty() && !o.expect_loss && !o.no_update;
    if (!o.accepted.empty() && own_figures && how != update::no) {
        for (const auto& file : write_accepted(o.accepted, accepted, measured, how,
                                               std::filesystem::path(program).filename().string() + " " +
                                                   command_of(o, true) + ", flags " + flags)) {
            std::cout << "wrote " << file.string() << '\n';
        }
    }
    const accepted_figures now = how == update::all ? read_accepted(o.accepted) : accepted;
    const comparison result(formulas, what, measured, now, o, about);
    write_results(o, flags, measured, result);
    const int code = result.finish(std::cout);
    if (!o.expect_loss || result.promise_is_broken() || code == nothing_measured) {
        return code;
    }
    std::cout << (code == lost ? "A loss was expected.\n" : "A LOSS WAS EXPECTED, and there is none.\n");
    return code == lost ? passed : code == passed ? expected_failure_passed : code;
}

} // namespace

int run(int argc, char** argv, const graze::precision::subjects& formulas, const std::string& compiler,
        const std::string& flags) {
    try {
        const options o = parse({argv + 1, argv + argc});
        if (o.help) {
            std::cout << usage;
            return passed;
        }
        return run_checked(o, argv[0], formulas, compiler, flags);
    } catch (const std::exception& e) {
        std::cerr << e.what() << '\n';
        return bad_input;
    }
}

} // namespace precision
