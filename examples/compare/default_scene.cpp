#include "default_scene.hpp"

#include "families.hpp"

#include <iterator>
#include <utility>

namespace compare {

scene_pairs<2> default_pairs(number_input numbers, std::uint64_t seed) {
    constexpr std::size_t beside = 2000;
    const scene_file file = read_scene_text(default_scene_text(), "the embedded scene", numbers);
    scene_pairs<2> result = pairs_of<2>(std::get<exact_scene<2>>(file.scene), file.name, sample_size, seed);
    for (const char* name : {"grazing", "far"}) {
        std::vector<problem<2>> family = draw_family<2>(name, beside, seed);
        result.pairs.insert(result.pairs.end(), std::make_move_iterator(family.begin()),
                            std::make_move_iterator(family.end()));
        result.total += beside;
    }
    return result;
}

} // namespace compare
