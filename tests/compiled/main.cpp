// Whether all units of this program, each compiled with its own flags, give the same answers about the same pairs.
// UNITS lists their functions: as calls, and as declarations.
#include <cstdint>
#include <cstdio>

std::uint64_t UNITS;

int main() {
    const std::uint64_t hashes[] = {UNITS};
    int different = 0;
    for (const std::uint64_t hash : hashes) {
        std::printf("%016llx\n", static_cast<unsigned long long>(hash));
        different += hash != hashes[0] ? 1 : 0;
    }
    return different;
}
