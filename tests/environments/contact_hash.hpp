// The hash of the contacts of one kind of pair, dimension and type.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace environments {

struct tally {
    std::uint64_t hash = 0, contacts = 0, by_doubles = 0;
};

struct hashed_subject {
    std::string name;
    tally (*run)(std::uint64_t count); // hashes the first `count` pairs
};

// The subjects compiled at this level: 0 takes seconds, 1 is all of them.
[[nodiscard]] std::vector<hashed_subject> hashed_subjects();

} // namespace environments
