#include "inputs.hpp"

#include "default_scene.hpp"
#include "families.hpp"
#include "input_error.hpp"
#include "pairs.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

namespace compare {

namespace {

// Numbers the pairs across all groups and, with --pair, keeps only that one.
template <int N>
void number(std::vector<problem<N>>& pairs, std::size_t& last, std::optional<std::size_t> only) {
    for (problem<N>& p : pairs) {
        p.number = ++last;
    }
    if (only) {
        std::erase_if(pairs, [&](const problem<N>& p) { return p.number != *only; });
    }
}

template <int N>
group group_of(std::string name, std::string description, std::string hardness, std::vector<problem<N>> pairs,
               std::size_t of, const progress_line& line) {
    group_information information;
    information.name = std::move(name);
    information.description = std::move(description);
    information.hardness_name = std::move(hardness);
    information.pairs_of = of;
    return make_group(std::move(information), std::move(pairs), line);
}

template <int N>
group family_group(const std::string& name, std::vector<problem<N>> pairs, std::size_t all, const progress_line& line) {
    for (const family_description& f : family_list()) {
        if (f.name == name) {
            return group_of(name, f.what_makes_it_hard, f.hardness_meaning, std::move(pairs), all, line);
        }
    }
    throw std::logic_error("a family without a description: " + name);
}

std::vector<group> default_groups(const options& o, const progress_line& line) {
    const scene_file file = read_scene_text(default_scene_text(), "the embedded scene", o.numbers);
    std::vector<problem<2>> pairs = default_pairs(o.numbers, o.seed).pairs;
    std::vector<group> groups;
    std::size_t last = 0;
    for (auto first = pairs.begin(); first != pairs.end();) {
        const auto end = std::find_if(first, pairs.end(), [&](const auto& p) { return p.group != first->group; });
        const std::string name = first->group;
        std::vector<problem<2>> members(std::make_move_iterator(first), std::make_move_iterator(end));
        const std::size_t all = members.size();
        number(members, last, o.pair);
        if (!members.empty()) {
            groups.push_back(name == file.name ? group_of(name, file.description, "", std::move(members), all, line)
                                               : family_group(name, std::move(members), all, line));
        }
        first = end;
    }
    return groups;
}

template <int N>
std::vector<group> groups_of_family(const options& o, const progress_line& line) {
    std::vector<problem<N>> pairs = draw_family<N>(o.family, o.count, o.seed);
    const std::size_t all = pairs.size();
    std::size_t last = 0;
    number(pairs, last, o.pair);
    std::vector<group> groups;
    if (!pairs.empty()) {
        groups.push_back(family_group(o.family, std::move(pairs), all, line));
    }
    return groups;
}

std::vector<group> groups_of_scene(const options& o, const progress_line& line) {
    const scene_file file = read_scene(o.scene, o.numbers);
    return std::visit(
        [&]<int N>(const exact_scene<N>& scene) {
            scene_pairs<N> drawn = pairs_of(scene, file.name, o.all ? every_pair : sample_size, o.seed);
            if (drawn.pairs.empty()) {
                throw input_error(printable(o.scene, 200) + ": no two things that could meet");
            }
            std::size_t last = 0;
            number(drawn.pairs, last, o.pair);
            std::vector<group> groups;
            if (!drawn.pairs.empty()) {
                groups.push_back(group_of(file.name, file.description, "", std::move(drawn.pairs), drawn.total, line));
            }
            return groups;
        },
        file.scene);
}

} // namespace

std::vector<group> groups_of(const options& o, const progress_line& line) {
    std::vector<group> groups = !o.family.empty()
                                    ? o.dimension == 2 ? groups_of_family<2>(o, line) : groups_of_family<3>(o, line)
                                : !o.scene.empty() ? groups_of_scene(o, line)
                                                   : default_groups(o, line);
    if (groups.empty()) {
        throw input_error("--pair: there is no pair " + std::to_string(o.pair.value_or(0)) +
                          "; pairs are numbered from 1, and differently with other inputs, options or seeds");
    }
    return groups;
}

} // namespace compare
