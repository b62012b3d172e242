// Records beside a std::vector, which has the same done to it.
#include <graze/scene/records.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

struct record {
    int number;
    double value;
    bool operator==(const record&) const = default;
};
using records = graze::detail::records<record>;
static_assert(!std::is_same_v<records, std::vector<record>>);

// All numbers that decide are drawn by the caller, so that both do the same.
template <class Records>
void change(Records& a, Records& other, unsigned what, std::size_t n, const record& x) {
    const std::size_t i = a.empty() ? 0 : n % a.size();
    const auto at = a.begin() + static_cast<std::ptrdiff_t>(i);
    const auto is_of_class = [&](const record& y) { return y.number % 3 == x.number % 3; };
    switch (what) {
    case 0:
        a.push_back(a.empty() ? x : a[i]); // one of its own
        break;
    case 1:
        a.resize(n);
        break;
    case 2:
        a.assign(n, x);
        break;
    case 3:
        a.erase(std::remove_if(a.begin(), a.end(), is_of_class), a.end());
        break;
    case 4:
        if (!a.empty()) {
            a.erase(at);
        }
        break;
    case 5:
        if (!a.empty()) {
            a.pop_back();
        }
        break;
    case 6:
        a = other;
        break;
    case 7:
        other = Records(a);
        break;
    case 8:
        a = std::move(other);
        other = {};
        break;
    case 9:
        a.reserve(n);
        break;
    default:
        a.push_back(x);
    }
}

TEST_CASE("records are what a vector is") {
    std::mt19937 random(1);
    records a, other;
    std::vector<record> b, same;
    for (int i = 0; i < 20000; ++i) {
        const auto what = static_cast<unsigned>(random() % 16);
        const std::size_t n = random() % 40;
        const record x{static_cast<int>(random() % 100), 0.5 * static_cast<int>(random() % 7)};
        change(a, other, what, n, x);
        change(b, same, what, n, x);
        REQUIRE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
        REQUIRE(std::equal(other.begin(), other.end(), same.begin(), same.end()));
        REQUIRE(a.size() == b.size());
    }
}

} // namespace
