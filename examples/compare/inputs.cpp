#include "inputs.hpp"

#include "default_scene.hpp"
#include "families.hpp"
#include "input_error.hpp"
#include "pairs.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace compare {

namespace {

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
group family_group(const std::string& name, std::vector<problem<N>> pairs, const progress_line& line) {
    for (const family_description& f : family_list()) {
        if (f.name == name) {
            const std::size_t all = pairs.size();
            return group_of(name, f.what_makes_it_hard, f.hardness_meaning, std::move(pairs), all, line);
        }
    }
    throw std::logic_error("a family without a description: " + name);
}

std::vector<group> default_groups(const options& o, const progress_line& line) {
    const scene_file file = read_scene_text(default_scene_text(), "the embedded scene", o.numbers);
    std::vector<problem<2>> pairs = default_pairs(o.numbers, o.seed).pairs;
    std::vector<group> groups;
    for (auto first = pairs.begin(); first != pairs.end();) {
        const auto last = std::find_if(first, pairs.end(), [&](const auto& p) { return p.group != first->group; });
        const std::string name = first->group;
        std::vector<problem<2>> part(std::make_move_iterator(first), std::make_move_iterator(last));
        const std::size_t all = part.size();
        groups.push_back(name == file.name ? group_of(name, file.description, "", std::move(part), all, line)
                                           : family_group(name, std::move(part), line));
        first = last;
    }
    return groups;
}

} // namespace

std::vector<group> groups_of(const options& o, const progress_line& line) {
    std::vector<group> groups;
    if (!o.family.empty()) {
        groups.push_back(o.dimension == 2 ? family_group(o.family, draw_family<2>(o.family, o.count, o.seed), line)
                                          : family_group(o.family, draw_family<3>(o.family, o.count, o.seed), line));
    } else if (!o.scene.empty()) {
        const scene_file file = read_scene(o.scene, o.numbers);
        groups.push_back(std::visit(
            [&]<int N>(const exact_scene<N>& scene) {
                scene_pairs<N> drawn = pairs_of(scene, file.name, o.all ? every_pair : sample_size, o.seed);
                if (drawn.pairs.empty()) {
                    throw input_error(o.scene + ": no two things that could meet");
                }
                return group_of(file.name, file.description, "", std::move(drawn.pairs), drawn.total, line);
            },
            file.scene));
    } else {
        groups = default_groups(o, line);
    }
    return groups;
}

} // namespace compare
