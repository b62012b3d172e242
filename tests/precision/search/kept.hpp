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
    std::vector<std::string> families; // from which tries start; none means all
    // The least and the greatest magnitude, "1e-3:1e3"; empty: no limit.
    std::string lengths = {}, velocities = {}, masses = {};
    std::uint64_t seed = 1, evaluations = 20'000;
    std::uint64_t shard = 0, shards = 1;  // makes the tries whose number is `shard` modulo `shards`
    std::string program = "graze-search"; // for the command of origins; not a term of the search
};

// Whether the terms are the same, except for the shard.
[[nodiscard]] bool same_search(const terms& x, const terms& y);

struct kept_pair {
    found at;
    std::uint64_t attempt = 0; // the try that found it
    std::uint64_t climbs = 1;  // how often it got the evaluations of a try
    bool partial = false;      // the search was stopped during this try or climb, which must be repeated
    std::string shrunk;        // the line of a simpler pair, or the lines of two; empty if there is none
    std::string origin;        // the command that finds it, or something at least as bad, again
};

struct kept_file {
    terms of;
    std::uint64_t next = 0;       // the first try that has not been made
    bool merged = false;          // from several files; the search does not continue
    std::vector<kept_pair> pairs; // the worst for the formula first
};

inline constexpr std::size_t most_kept = 8;

// Inserts the pair at its place. It replaces an earlier one of the same try; a partial one replaces only a partial one.
// Of equal pairs, that of the earlier try stays. Keeps the first most_kept pairs, and partial ones.
void keep(std::vector<kept_pair>& pairs, kept_pair p);

// The options that repeat the search.
[[nodiscard]] std::string command_of(const terms& t);

// The whole file, in which a shrunk pair follows each pair.
[[nodiscard]] std::string text_of(const kept_file& file, const goal& g);

// Locks a search's file against other processes while it exists, on this machine and on others that share the folder.
// Throws std::runtime_error if another process has the lock.
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

// Writes the file, whole or not at all.
void write(const std::filesystem::path& path, const kept_file& file, const goal& g);

// Throws std::runtime_error with file and line.
[[nodiscard]] kept_file read_kept(const std::filesystem::path& path);

// Throws std::runtime_error if a pair does not show what the file says: then the formula or its build has changed.
void check(const kept_file& file, const goal& g);

// The files must be of the same search, or std::runtime_error is thrown.
[[nodiscard]] kept_file merged(const std::vector<kept_file>& files);

} // namespace search
