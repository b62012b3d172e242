#include "run.hpp"

#include <cstdio>
#include <utility>

namespace compare {

namespace {

// One line that is written over and over, and leaves nothing behind.
class progress_line {
  public:
    explicit progress_line(bool shown) : shown_(shown) {}
    ~progress_line() { show(""); }
    progress_line(const progress_line&) = delete;
    progress_line& operator=(const progress_line&) = delete;

    void show(const std::string& text) const {
        if (shown_) {
            std::fprintf(stderr, "\r\033[K%s", text.c_str());
            std::fflush(stderr);
        }
    }

  private:
    bool shown_;
};

} // namespace

void measure_all(results& found, const std::vector<measurable>& types, const std::vector<group>& groups,
                 const measurement_plan& plan, bool progress) {
    const progress_line line(progress);
    std::size_t done = 0;
    for (const measurable& type : types) {
        found.types.push_back(type.information);
        for (const group& pairs : groups) {
            const std::size_t all = types.size() * groups.size();
            line.show("measuring " + type.information.name + " on " + pairs.information.name + " (" +
                      std::to_string(100 * done++ / all) + "%)");
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
