// graze-speed: the cost of graze relative to its alternatives, as ratios measured in one run.
#include "speed.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

namespace speed {

void print_stages();
void print_contact_stages();

namespace {

// Prints as usual, and keeps the medians for the ratios that are printed at the end.
class ratio_reporter : public benchmark::ConsoleReporter {
  public:
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
                const std::string name = run.run_name.function_name;
                const auto slash = name.find('/');
                const std::string group = name.substr(0, slash);
                if (times_.find(group) == times_.end()) {
                    groups_.push_back(group);
                }
                auto& members = times_[group];
                const std::string member = name.substr(slash + 1);
                auto found =
                    std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == member; });
                if (found == members.end()) {
                    members.emplace_back(member, std::vector<double>{});
                    found = members.end() - 1;
                }
                found->second.push_back(1e9 / run.counters.at("items_per_second"));
            }
        }
    }

    void print_ratios() {
        for (const std::string& group : groups_) {
            std::printf("\n%s: nanoseconds (median of %zu, least), ratio to the first\n", group.c_str(),
                        times_[group].front().second.size());
            double first = 0;
            auto& members = times_[group]; // benchmarks run in random order; the alternatives' names come first
            std::stable_partition(members.begin(), members.end(),
                                  [](const auto& m) { return m.first.find("graze") == std::string::npos; });
            std::stable_partition(members.begin(), members.end(),
                                  [](const auto& m) { return m.first.find("plain") != std::string::npos; });
            for (auto& [member, times] : members) {
                std::sort(times.begin(), times.end());
                const double median = times[times.size() / 2];
                first = first == 0 ? median : first;
                std::printf("  %-32s %12.2f %12.2f %10.2f\n", member.c_str(), median, times.front(), median / first);
            }
        }
    }

  private:
    std::vector<std::string> groups_;
    std::map<std::string, std::vector<std::pair<std::string, std::vector<double>>>> times_;
};

} // namespace
} // namespace speed

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    speed::register_decisions();
    speed::register_orders();
    speed::register_contacts();
    speed::register_flights();
    speed::register_flat();
#ifdef GRAZE_SPEED_CGAL
    speed::register_cgal();
#endif
    speed::ratio_reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    reporter.print_ratios();
    speed::print_stages();
    speed::print_contact_stages();
    return 0;
}
