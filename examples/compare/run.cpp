#include "run.hpp"

#include <utility>

namespace compare {

void measure_all(results& found, const std::vector<measurable>& types, const std::vector<group>& groups,
                 const measurement_plan& plan, const progress_line& line) {
    std::size_t done = 0;
    for (const measurable& type : types) {
        found.types.push_back(type.information);
        for (const group& pairs : groups) {
            line.show("measuring " + type.information.name + " on " + pairs.information.name, done++,
                      types.size() * groups.size());
            if (type.prepare == nullptr) {
                continue;
            }
            for (row& measured : measure(type, pairs, plan)) {
                measured.type = type.information.name;
                measured.group = pairs.information.name;
                found.rows.push_back(std::move(measured));
            }
        }
    }
}

} // namespace compare
