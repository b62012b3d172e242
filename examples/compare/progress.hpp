// Shows the progress of a long run.
#pragma once

#include <cstddef>
#include <string>

namespace compare {

// One line on standard error that is written over and over, and leaves nothing behind; or nothing at all.
class progress_line {
  public:
    explicit progress_line(bool shown) : shown_(shown) {}
    ~progress_line() { show(""); }
    progress_line(const progress_line&) = delete;
    progress_line& operator=(const progress_line&) = delete;

    void show(const std::string& text) const;
    void show(const std::string& text, std::size_t done, std::size_t all) const; // with how much of it is done

  private:
    bool shown_;
};

} // namespace compare
