// The file of a search: the precision regression reads its pairs, and the search continues from it.
#pragma once

#include "climb.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace search {

// The terms of a search. A search continues only from a file with the same terms.
struct terms {
    std::string goal, figure;          // "error", "time/lagrange.stable/double"
    std::vector<std::string> families; // of which tries start; none: all
    // The least and the greatest magnitude, "1e-3:1e3"; empty: all.
    std::string lengths = {}, velocities = {}, masses = {};
    std::uint64_t seed = 1, evaluations = 20'000;
    std::uint64_t shard = 0, shards = 1;  // takes the tries whose number is `shard` modulo `shards`
    std::string program = "graze-search"; // whose command it is: no term
};

// Whether the terms are the same, except for the shard.
[[nodiscard]] bool same_search(const terms& x, const terms& y);

struct kept_pair {
    found at;
    std::uint64_t attempt = 0; // which try found it
    std::uint64_t climbs = 1;  // how often it was given the evaluations of a try
    bool partial = false;      // the search was stopped within the try or climb, which is to be made again
    std::string shrunk;        // the line of a simpler pair, or the lines of two; empty where there is none
    std::string origin;        // the command that finds it, or what is at least as bad, again
};

struct kept_file {
    terms of;
    std::uint64_t next = 0;       // the first try that is not done
    bool merged = false;          // of several; does not go on
    std::vector<kept_pair> pairs; // from the worst for the formula on
};

inline constexpr std::size_t most_kept = 8;

// Puts the pair in its place, instead of an earlier one of the same try or the same pair; a partial one stands beside
// what was there. Keeps the first most_kept, and partial ones.
void keep(std::vector<kept_pair>& pairs, kept_pair p);

// Options that repeat the search.
[[nodiscard]] std::string command_of(const terms& t);

// The whole file, with each pair followed by a shrunk one.
[[nodiscard]] std::string text_of(const kept_file& file, const goal& g);

// Keeps other processes from a search's file while it lives: one process at a time, on this machine or on others that
// share the folder. std::runtime_error where another has it.
class file_lock {
  public:
    explicit file_lock(const std::filesystem::path& of);
    ~file_lock();
    file_lock(const file_lock&) = delete;
    file_lock& operator=(const file_lock&) = delete;

  private:
    std::filesystem::path path_;
    int file_ = -1;
};

// Whole or not at all.
void write(const std::filesystem::path& path, const kept_file& file, const goal& g);

// std::runtime_error with file and line.
[[nodiscard]] kept_file read_kept(const std::filesystem::path& path);

// std::runtime_error where a pair does not show what the file says of it: the formula or its build is another one.
void check(const kept_file& file, const goal& g);

// Of the same search; std::runtime_error for others.
[[nodiscard]] kept_file merged(const std::vector<kept_file>& files);

} // namespace search
