// Shows the progress of a long run.
#pragma once

#include <cstddef>
#include <string>

namespace compare {

// A line on standard error that is overwritten and leaves nothing behind. If it is off, nothing is shown.
class progress_line {
  public:
    explicit progress_line(bool shown) : shown_(shown) {}
    ~progress_line() { show(""); }
    progress_line(const progress_line&) = delete;
    progress_line& operator=(const progress_line&) = delete;

    void show(const std::string& text) const;
    void show(const std::string& text, std::size_t done, std::size_t all) const; // with the share that is done

  private:
    bool shown_;
};

} // namespace compare
