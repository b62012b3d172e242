// The faults of an input, found independently of the library and worded as the library does.
#pragma once

#include "../oracle/lift.hpp"

#include <graze/shape/ball.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/triangle.hpp>
#include <graze/shape/wall.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

namespace faults {

using list = std::vector<std::string>;

template <class T>
bool is_finite(T x) {
    if constexpr (std::is_floating_point_v<T>) {
        return std::isfinite(x);
    } else {
        return true;
    }
}
template <int N, class T>
bool is_finite(const graze::vec<N, T>& x) {
    return std::all_of(x.component, x.component + N, [](T c) { return is_finite(c); });
}
template <int N, class T>
bool is_zero(const graze::vec<N, T>& x) {
    return std::all_of(x.component, x.component + N, [](T c) { return c == 0; });
}

template <int N, class T>
list of_one(const graze::ball<N, T>& b, const std::string& name) {
    list all;
    if (!is_finite(b.position)) {
        all.push_back(name + ": position is not finite");
    }
    if (!is_finite(b.velocity)) {
        all.push_back(name + ": velocity is not finite");
    }
    if (!is_finite(b.radius)) {
        all.push_back(name + ": radius is not finite");
    } else if (b.radius < 0) {
        all.push_back(name + ": radius is negative");
    }
    return all;
}
template <int N, class T>
list of_one(const graze::plane<N, T>& p) {
    list all;
    if (!is_finite(p.point)) {
        all.push_back("plane: point is not finite");
    }
    if (!is_finite(p.normal)) {
        all.push_back("plane: normal is not finite");
    } else if (is_zero(p.normal)) {
        all.push_back("plane: normal is zero");
    }
    return all;
}

// Whether two finite edges are parallel, by the squares of their lengths and product. A single edge never is.
template <class T>
bool parallel(const graze::wall<2, T>&) {
    return false;
}
template <class T>
bool parallel(const graze::wall<3, T>& w) {
    oracle::group<T> g;
    oracle::collect<3>(g, w.edge[0]);
    oracle::collect<3>(g, w.edge[1]);
    const auto x = oracle::next<3>(g), y = oracle::next<3>(g);
    const mpz_class product = oracle::dot<3>(x, y);
    return oracle::dot<3>(x, x) * oracle::dot<3>(y, y) == product * product;
}
template <int N, class T>
list of_one(const graze::wall<N, T>& w) {
    list all;
    if (!is_finite(w.corner)) {
        all.push_back("wall: corner is not finite");
    }
    bool spanned = true;
    for (const auto& e : w.edge) {
        if (!is_finite(e)) {
            all.push_back("wall: edge is not finite");
        } else if (is_zero(e)) {
            all.push_back("wall: edge is zero");
        }
        spanned = spanned && is_finite(e) && !is_zero(e);
    }
    if (spanned && parallel(w)) {
        all.push_back("wall: edges are parallel");
    }
    return all;
}

template <class T>
list of_one(const graze::triangle<T>& t) {
    list all = of_one(graze::wall<3, T>{t.corner, t.edge});
    for (std::string& told : all) {
        told = "triangle" + told.substr(4);
    }
    return all;
}

inline list joined(list x, const list& y) {
    x.insert(x.end(), y.begin(), y.end());
    return x;
}
template <int N, class T>
list of(const graze::ball<N, T>& a, const graze::ball<N, T>& b) {
    return joined(of_one(a, "ball a"), of_one(b, "ball b"));
}
template <int N, class T, class Shape>
list of(const graze::ball<N, T>& b, const Shape& s) {
    return joined(of_one(b, "ball"), of_one(s));
}

// The message of the std::domain_error that f throws, or nothing.
template <class F>
std::string thrown_by(F f) {
    try {
        f();
    } catch (const std::domain_error& e) {
        return e.what();
    }
    return "";
}

// Whether f throws one of these messages, or nothing if there are none.
template <class F>
bool told(const list& all, F f) {
    const std::string message = thrown_by(f);
    return all.empty() ? message.empty() : std::find(all.begin(), all.end(), message) != all.end();
}

} // namespace faults
