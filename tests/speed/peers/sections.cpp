#include "sections.hpp"

#include "trials.hpp"

#include <answer.hpp>
#include <machine.hpp>

#include <algorithm>
#include <array>
#include <cstdio>

namespace peers {

namespace {

std::string shown(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), x == 0 ? "0" : "%.0e", x);
    return text.data();
}

std::string name_of(const entry& e) {
    return e.variant.empty() ? e.name : e.name + ", " + e.variant + (e.root == "printed" ? "/printed" : "");
}

const char* plural_of(thing what) { return what == thing::ball ? "balls" : what == thing::box ? "boxes" : "edges"; }

std::string cell_of(const std::optional<score>& s) {
    if (!s) {
        return "–";
    }
    std::string text = std::to_string(s->missed) + " / " + std::to_string(s->invented);
    text += s->touch > s->missed ? " · " + shown(s->largest) + " (" + shown(s->median) + ")" : "";
    if (s->nanoseconds > 0) {
        std::array<char, 32> ns{};
        std::snprintf(ns.data(), ns.size(), " · %.0f ns", s->nanoseconds);
        text += ns.data();
    }
    return text;
}

} // namespace

std::vector<entry> all_entries(bool every, [[maybe_unused]] std::vector<std::string>& missing) {
    std::vector<entry> all = own_entries();
    if (!every) {
        std::erase_if(all, [](const entry& e) {
            return !e.variant.empty() && (e.name != "double" || (e.variant != "textbook" && e.variant != "lagrange"));
        });
    }
    [[maybe_unused]] const auto add = [&](const std::vector<entry>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
#ifdef GRAZE_PEERS_FCL
    add(fcl_entries());
#else
    missing.emplace_back("FCL (libfcl-dev)");
#endif
#ifdef GRAZE_PEERS_BULLET
    add(bullet_entries());
#else
    missing.emplace_back("Bullet (libbullet-dev)");
#endif
#ifdef GRAZE_PEERS_BOX2D
    add(box2d_entries());
#else
    missing.emplace_back("Box2D (libbox2d-dev)");
#endif
    return all;
}

std::vector<section> measure_sections(const std::vector<entry>& entries, std::uint64_t seed, std::size_t count,
                                      double timing) {
    std::vector<section> all;
    for (trial& t : all_trials(seed, count)) {
        const std::string where = t.in_space() ? "space" : "the plane";
        const std::string file = std::string(plural_of(t.what)) + (t.in_space() ? "-3d" : "-2d");
        if (all.empty() || all.back().file_name != file) {
            all.push_back({std::string("balls against ") + plural_of(t.what) + ", in " + where, file, {}, {}});
        }
        std::fprintf(stderr, "measuring %s: %s\n", all.back().name.c_str(), t.name.c_str());
        all.back().scores.push_back(measure(t, entries, timing));
        all.back().trials.push_back(std::move(t));
    }
    all.push_back({"balls from easy to hard, in space", "hardness", {}, {}});
    for (trial& t : trials_by_hardness(seed, count)) {
        std::fprintf(stderr, "measuring %s: %s\n", all.back().name.c_str(), t.name.c_str());
        all.back().scores.push_back(measure(t, entries, timing));
        all.back().trials.push_back(std::move(t));
    }
    return all;
}

std::string description_of(const std::vector<entry>& entries, const std::vector<std::string>& missing,
                           std::size_t count, std::uint64_t seed) {
    std::string text = std::to_string(count) + " questions a trial, seed " + std::to_string(seed) +
                       ". A cell: missed / invented · largest (median) relative error of τ · time of one answer (lower "
                       "quartile of the repeats).\n\n"
                       "| | settings | promises |\n|---|---|---|\n";
    for (const entry& e : entries) {
        text += "| " + name_of(e) + (e.version.empty() || e.version == e.name ? "" : " (" + e.version + ")") + " | " +
                e.settings + " | " + e.promise + " |\n";
    }
    for (const std::string& m : missing) {
        text += "\nNot in this build: " + m + ".\n";
    }
    return text;
}

std::string table_of(const section& s, const std::vector<entry>& entries) {
    std::string text = "\n## " + s.name + "\n\n";
    std::string head = "|", rule = "|---|", touching = "| touch |";
    head += " |";
    for (std::size_t t = 0; t < s.trials.size(); ++t) {
        head += " " + s.trials[t].name + " |";
        rule += "---|";
        touching += " " + std::to_string(s.scores[t].front()->touch) + " of " +
                    std::to_string(s.scores[t].front()->asked) + " |";
    }
    text += head + "\n" + rule + "\n" + touching + "\n";
    for (std::size_t e = 0; e < entries.size(); ++e) {
        std::string line = "| " + name_of(entries[e]) + " |";
        bool takes_part = false;
        for (const auto& scores : s.scores) {
            line += " " + cell_of(scores[e]) + " |";
            takes_part = takes_part || scores[e];
        }
        text += takes_part ? line + "\n" : "";
    }
    return text;
}

compare::results results_of(const section& s, const std::vector<entry>& entries, const std::string& command,
                            std::uint64_t seed) {
    compare::results found;
    found.command = command;
    found.machine = compare::this_machine();
    found.source = s.name;
    found.as = "double";
    found.seed = seed;
    for (const entry& e : entries) {
        const bool listed = std::any_of(found.types.begin(), found.types.end(),
                                        [&](const compare::type_information& t) { return t.name == e.name; });
        if (!listed) {
            compare::type_information t;
            t.name = e.name;
            t.library = e.version.empty() ? e.variant.empty() ? "graze" : "built in" : e.version;
            t.digits = e.digits;
            t.note = e.settings + "; promises " + e.promise;
            found.types.push_back(t);
        }
    }
    for (std::size_t t = 0; t < s.trials.size(); ++t) {
        compare::group_information g;
        g.name = s.trials[t].name;
        g.description = s.trials[t].description;
        g.dimension = s.trials[t].in_space() ? 3 : 2;
        g.hardness_name = s.trials[t].hardness_name;
        g.pairs = g.pairs_of = s.trials[t].questions.size();
        found.groups.push_back(g);
        for (const auto& one : s.scores[t]) {
            if (one) {
                found.rows.push_back(one->row);
            }
        }
    }
    compare::draw_conclusions(found);
    return found;
}

} // namespace peers
