// Measures the time of candidates that are compared.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

namespace compare {

class stopwatch {
  public:
    [[nodiscard]] double seconds() const { return std::chrono::duration<double>(clock::now() - start_).count(); }

  private:
    using clock = std::chrono::steady_clock;
    clock::time_point start_ = clock::now();
};

// run(n) processes the first n of the available items.
struct timed_candidate {
    std::function<void(std::size_t)> run;
    std::size_t available = 0;
};

struct timing {
    double median = 0, low = 0, high = 0; // nanoseconds for one item; low and high are the quartiles of the repeats
    std::size_t pairs = 0;
    std::vector<double> repeated; // each repeat, in the order of measurement
};

// Slow candidates may take this many times as long before they are repeated less often.
constexpr double patience = 2.5;

// Times the candidates in turn, so that changes of the machine's load affect all of them: each at least three times
// with at least 24 items, or with all items if there are fewer. seconds is the target for all candidates together,
// or patience times that if 24 items take long.
[[nodiscard]] std::vector<timing> time_interleaved(const std::vector<timed_candidate>& candidates, double seconds);

} // namespace compare
