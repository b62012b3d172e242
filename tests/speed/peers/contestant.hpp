// A contestant: graze, the formulas in a number type, or a library's continuous collision detection.
#pragma once

#include "question.hpp"

#include <memory>
#include <optional>

namespace peers {

// Holds the questions of one trial in the contestant's own form.
class contestant {
  public:
    virtual ~contestant() = default;
    // When the ball first touches the thing before the horizon; empty if it does not.
    [[nodiscard]] virtual std::optional<double> answer(std::size_t i) const = 0;
};

struct entry {
    std::string name;     // "FCL"; for the formulas, the number type
    std::string version;  // "FCL 0.7.0"; empty for graze and the formulas
    std::string settings; // all settings that were chosen
    std::string promise;  // what its documentation promises
    std::unique_ptr<contestant> (*prepare)(const trial&) = nullptr;
    int digits = 53;       // of the numbers that it computes in
    bool in_space = true;  // whether it takes trials in space
    bool boxes = true;     // whether it takes boxes and edges
    std::string variant{}; // of the formulas; otherwise empty
    std::string root{};    // the same
};

// graze first, then the formulas.
[[nodiscard]] std::vector<entry> own_entries();

// The libraries' entries, if the build has them.
[[nodiscard]] std::vector<entry> fcl_entries();
[[nodiscard]] std::vector<entry> bullet_entries();
[[nodiscard]] std::vector<entry> box2d_entries();

} // namespace peers
