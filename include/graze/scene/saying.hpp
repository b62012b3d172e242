// Errors that say who met when they were thrown.
#pragma once

#include <graze/scene/mechanics.hpp>

#include <exception>
#include <stdexcept>
#include <string>

namespace graze::inline v0_1::detail {

// To be called where an exception is caught: throws it so that it names the pair as well.
[[noreturn, gnu::noinline]] inline void rethrow_naming(const scene_pair& who) {
    const auto said = [&](const std::exception& e) { return to_string(who) + ": " + e.what(); };
    try {
        throw;
    } catch (graze::undecided& e) {
        e.between(who);
        throw;
    } catch (const std::domain_error& e) { // parallel edges, or what restate was given
        throw std::domain_error(said(e));
    } catch (const std::overflow_error& e) {
        throw std::overflow_error(said(e));
    } catch (const std::range_error& e) { // of images
        throw std::range_error(said(e));
    }
}

// What f returns. An exception of f names who(), the pair, as well.
template <class F, class Who>
auto saying(F f, Who who) {
    try {
        return f();
    } catch (...) {
        rethrow_naming(who());
    }
}

} // namespace graze::inline v0_1::detail
