#include "failure.hpp"

#include "options.hpp"
#include "reference.hpp"
#include "shrink.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace precision {

namespace {

std::string decimal(double x) {
    char text[80];
    std::snprintf(text, sizeof text, "%.17g (%a)", x, x);
    return text;
}

std::string told(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

std::string share(std::size_t part, std::size_t whole) { return std::to_string(part) + " of " + std::to_string(whole); }

// The pair's numbers in decimals, with their names.
template <int N>
std::string in_words(const pair<N>& p) {
    std::ostringstream out;
    out.precision(17);
    const auto vector = [&](const char* name, const graze::vec<N, double>& x) {
        out << ' ' << name << " (";
        for (int i = 0; i < N; ++i) {
            out << (i == 0 ? "" : ", ") << x[i];
        }
        out << ')';
    };
    const auto ball = [&](const char* name, const graze::ball<N, double>& b) {
        out << "    " << name;
        vector("position", b.position);
        vector("velocity", b.velocity);
        out << " radius " << b.radius << " mass " << b.mass << '\n';
    };
    ball("ball a:", p.a);
    if (const auto* b = std::get_if<graze::ball<N, double>>(&p.other)) {
        ball("ball b:", *b);
    } else if (const auto* plane = std::get_if<graze::plane<N, double>>(&p.other)) {
        out << "    plane:";
        vector("point", plane->point);
        vector("normal", plane->normal);
        out << '\n';
    } else {
        std::visit(
            [&](const auto& w) {
                if constexpr (requires { w.corner; }) {
                    out << (std::holds_alternative<graze::wall<N, double>>(p.other) ? "    wall:" : "    triangle:");
                    vector("corner", w.corner);
                    for (const auto& e : w.edge) {
                        vector("edge", e);
                    }
                    out << '\n';
                }
            },
            p.other);
    }
    return out.str();
}

std::string in_words(const reading& x) {
    std::string text;
    for (const double part : x.parts) {
        text += (text.empty() ? "" : " + ") + decimal(part);
    }
    if (x.exponent != 0 || x.decimal_exponent != 0) {
        text = "(" + text + ")";
    }
    text += x.exponent == 0 ? "" : " 2^" + std::to_string(x.exponent);
    return text + (x.decimal_exponent == 0 ? "" : " 10^" + std::to_string(x.decimal_exponent));
}

template <int N>
std::string expected_and_actual(const key& k, const subject& formula, const pair<N>& p) {
    const std::optional<truth<N>> about = truth_for(p, formula.type);
    if (!about) {
        return {};
    }
    const truth<N>& right = *about;
    std::optional<graze::precision::answer> given;
    std::string text;
    try {
        given = formula(p);
    } catch (const std::exception& e) {
        return std::string("    actual: an exception: ") + e.what() + "\n";
    }
    if (k.of == quantity::encounter) {
        text += std::string("    expected: ") + to_string(static_cast<graze::encounter>(right.met().what)) +
                "\n    actual:   " + (given->what ? to_string(*given->what) : "nothing");
        if (given->where) {
            text += std::string(", ") + to_string(*given->where) + " " + std::to_string(given->index);
        }
        return text + "\n";
    }
    const auto where = given->where ? static_cast<oracle::feature>(*given->where) : right.met().where();
    const auto& all = right.of(k.of, where, given->index);
    std::size_t at = 0;
    for (const auto& v : given->values) {
        if (v.of != k.of || at == all.size()) {
            continue;
        }
        for (std::size_t i = 0; i < all[at].size(); ++i) {
            text += "    expected: " + decimal(oracle::nearest_double(all[at][i].exactly())) +
                    " to the nearest double\n" + "    actual:   " + in_words(v.components[i]) + "\n";
        }
        ++at;
    }
    return text.empty() ? "    actual: nothing\n" : text;
}

std::string order_in_words(int order) {
    return order < 0 ? "the first pair comes first" : order > 0 ? "the second pair comes first" : "both come at once";
}

std::string expected_and_actual_order(const subject& formula, const any_pair& first, const any_pair& second) {
    return std::visit(
        [&]<int N>(const pair<N>& p) -> std::string {
            const pair<N>& q = std::get<pair<N>>(second);
            const auto about_p = truth_for(p, formula.type), about_q = truth_for(q, formula.type);
            if (!about_p || !about_q) {
                return {};
            }
            const std::string expected = order_in_words(oracle::compare(*about_p->met().time, *about_q->met().time));
            std::string actual;
            try {
                const auto given = formula(p, q);
                actual = given && given->order ? order_in_words(*given->order) : "nothing";
            } catch (const std::exception& e) {
                actual = std::string("an exception: ") + e.what();
            }
            return "    expected: " + expected + "\n    actual:   " + actual + "\n";
        },
        first);
}

std::string file_name(const key& k) {
    std::string name = to_string(k);
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
}

void write(const std::filesystem::path& file, const std::string& text) {
    if (!(std::ofstream(file) << text).flush()) {
        throw std::runtime_error(file.string() + ": cannot be written");
    }
}

// Whether a greater share of the values is misrounded; compares by cross products.
bool more_are_misrounded(const figures& now, const figures& accepted) {
    return now.misrounded != 0 &&
           now.misrounded * std::max<std::size_t>(accepted.values, 1) > accepted.misrounded * now.values;
}

// The worst pair, and the question whether another pair is as bad.
struct witness {
    std::size_t at;
    std::function<bool(const verdict&)> is_bad;
};

std::optional<witness> witness_of(const figures& now, const figures& accepted) {
    if (now.largest > accepted.largest && now.largest_at) {
        return witness{*now.largest_at, [limit = accepted.largest](const verdict& v) { return v.largest() > limit; }};
    }
    if (now.wrong > accepted.wrong && now.wrong_at) {
        return witness{*now.wrong_at, [](const verdict& v) { return v.wrong; }};
    }
    if (now.misrounded_at && more_are_misrounded(now, accepted)) {
        return witness{*now.misrounded_at, [](const verdict& v) { return v.misrounded != 0; }};
    }
    return std::nullopt;
}

// The answer of graze's own formula in as many digits to the same pair.
std::string beside_accepted(const reference& accepted, quantity of, const any_pair& p, bool is_loss) {
    if (!accepted.exists()) {
        return "";
    }
    const std::string who = "graze's own " + accepted.name() + " in as many digits, each operation rounded once";
    const auto v = judge_one(accepted.formula(), of, p);
    std::string text = "    beside:   " + who + ", ";
    if (!v || v->wrong) {
        text += "is wrong there";
    } else if (v->errors.empty()) {
        text += "is right there";
    } else {
        text += "decides nothing wrong there, with an error of " + told(v->largest()) + " units in the last place";
    }
    return text + (is_loss ? "\n" : "; no pair of the family was found that shows the loss and that it gets right\n");
}

// The command that shows the pair in this type and formula; empty unless graze-compare knows both.
std::string compare_command(const key& k, const std::string& scene) {
    const auto dot = k.variant.find('.');
    const std::string form = k.variant.substr(0, dot);
    const bool is_form = form == "textbook" || form == "halved" || form == "kahan" || form == "lagrange";
    const bool is_built_in = k.type == "float" || k.type == "double" || k.type.starts_with("long_double");
    if (!is_form || !is_built_in || k.of == quantity::order) {
        return "";
    }
    const std::string type = k.type.starts_with("long") ? "'long double'" : k.type;
    return "graze-compare " + quoted(scene) + " --as exact --types " + type + " --variants " + form +
           (dot == std::string::npos ? "" : "/" + k.variant.substr(dot + 1)) + " --timing 0";
}

} // namespace

std::string flags_or_none(const std::string& flags) {
    return flags.find_first_not_of(' ') == std::string::npos ? "none" : flags;
}

std::vector<std::string> losses(const figures& now, const figures& accepted) {
    std::vector<std::string> worse;
    if (now.pairs < accepted.pairs) {
        worse.push_back("pairs measured: " + std::to_string(accepted.pairs) + " -> " + std::to_string(now.pairs));
    }
    if (now.wrong > accepted.wrong) {
        worse.push_back("wrong decisions: " + share(accepted.wrong, accepted.pairs) + " -> " +
                        share(now.wrong, now.pairs));
    }
    if (more_are_misrounded(now, accepted)) {
        worse.push_back("misrounded: " + share(accepted.misrounded, accepted.values) + " -> " +
                        share(now.misrounded, now.values));
    }
    if (!now.correctly_rounded && as_told(now.largest) > as_told(accepted.largest)) {
        worse.push_back("largest error: " + told(accepted.largest) + " -> " + told(now.largest) +
                        " units in the last place");
    }
    return worse;
}

std::string tell(const key& k, const figures& now, const figures& accepted, const subject& formula, const family& pairs,
                 const circumstances& about) {
    std::string text = "LOST " + to_string(k) + "\n";
    for (const std::string& loss : losses(now, accepted)) {
        text += "  " + loss + "\n";
    }
    const std::string program = quoted(about.program);
    std::string repeat = program + " --only " + quoted(to_string(k)) + " " + about.inputs_option +
                         about.accepted_option + " --results " + quoted(about.results.string());
    if (const auto found = witness_of(now, accepted)) {
        const bool is_order = k.of == quantity::order; // of a pair and its predecessor
        const reference accepted_build(formula, k.of, about.as_variant);
        // Bad, and right or at most half as bad in an accepted build: otherwise the input is to blame.
        const auto is_bad = [&](const any_pair& p, const any_pair* second) {
            const auto v = judge_one(formula, k.of, p, second);
            return v && found->is_bad(*v);
        };
        const auto is_lost = [&](const any_pair& p, const any_pair* second) {
            if (!accepted_build.exists()) {
                return is_bad(p, second);
            }
            const auto v = judge_one(formula, k.of, p, second);
            if (!v || !found->is_bad(*v)) {
                return false;
            }
            const auto there = judge_one(accepted_build.formula(), k.of, p, second);
            return there && (!found->is_bad(*there) || (!there->wrong && 2 * there->largest() < v->largest()));
        };
        const auto as_held = [&](const any_pair& p) {
            return std::visit([&](const auto& q) -> any_pair { return held(q, formula.type).value_or(q); }, p);
        };
        // The witness, or another pair that an accepted build gets right.
        std::size_t at = found->at;
        bool is_loss = is_lost(pairs.pairs[at], is_order ? &pairs.pairs[at - 1] : nullptr);
        for (std::size_t i = is_order ? 1 : 0; i < pairs.pairs.size() && !is_loss; ++i) {
            if (is_lost(pairs.pairs[i], is_order ? &pairs.pairs[i - 1] : nullptr)) {
                at = i;
                is_loss = true;
            }
        }
        const auto shows = [&](const any_pair& p, const any_pair* second) {
            return is_loss ? is_lost(p, second) : is_bad(p, second);
        };
        any_pair smallest = pairs.pairs[at];
        std::optional<any_pair> before;
        if (is_order) {
            before = pairs.pairs[at - 1];
            smallest = shrunk(smallest, [&](const any_pair& p) { return shows(*before, &p); });
            before = as_held(shrunk(*before, [&](const any_pair& p) { return shows(p, &smallest); }));
        } else {
            smallest = shrunk(smallest, [&](const any_pair& p) { return shows(p, nullptr); });
        }
        smallest = as_held(smallest);
        std::filesystem::create_directories(about.results);
        const std::filesystem::path base = about.results / file_name(k);
        const auto with = [&](const char* suffix) {
            std::filesystem::path file = base;
            file += suffix;
            return file;
        };
        std::string lines = "# origin: " + repeat + ", pair " + std::to_string(at) + ", shrunk\n";
        lines += (before ? to_line(*before) + "\n" : "") + to_line(smallest) + "\n";
        write(with(".txt"), lines);
        write(with(".json"), to_scene(smallest, file_name(k), before ? &*before : nullptr));
        text += "  on the smallest input found, from pair " + std::to_string(at) + ":\n";
        const auto show = [&](const any_pair& p) {
            text += std::visit([](const auto& q) { return in_words(q); }, p) + "    " + to_line(p) + "\n";
        };
        if (before) {
            show(*before);
            text += "    and\n";
        }
        show(smallest);
        text += before ? expected_and_actual_order(formula, *before, smallest)
                       : std::visit([&](const auto& p) { return expected_and_actual(k, formula, p); }, smallest);
        const auto v = before ? std::nullopt : judge_one(formula, k.of, smallest);
        if (v && !v->errors.empty()) {
            text += "    error:    " + told(v->largest()) + " units in the last place\n";
        }
        text += before ? "" : beside_accepted(accepted_build, k.of, smallest, is_loss);
        const std::string compared = compare_command(k, with(".json").string());
        text += compared.empty() ? "  scene:  " + quoted(with(".json").string()) + "\n"
                                 : "  as a scene: " + compared + "\n";
        const std::string all_of_it = std::string(graze::precision::to_string(k.of)) + "/" + k.variant + "/" + k.type;
        text += "  alone:  " + program + " --only " + quoted(all_of_it + "/") + " --inputs " +
                quoted(with(".txt").string()) + " --show\n";
    }
    text += "  compiler: " + about.compiler + "; flags: " + flags_or_none(about.flags) +
            "; inputs: " + about.inputs_option + "\n";
    return text + "  repeat: " + repeat + "\n";
}

} // namespace precision
