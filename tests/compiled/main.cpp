// Whether all units of this program, each compiled with flags of its own, say the same of the same pairs.
#include <cstdint>
#include <cstdio>

std::uint64_t plain(), plain_compiled(), fast(), fast_compiled(), native(), native_compiled();

int main() {
    const std::uint64_t hashes[] = {plain(), plain_compiled(), fast(), fast_compiled(), native(), native_compiled()};
    int different = 0;
    for (const std::uint64_t hash : hashes) {
        std::printf("%016llx\n", static_cast<unsigned long long>(hash));
        different += hash != hashes[0] ? 1 : 0;
    }
    return different;
}
