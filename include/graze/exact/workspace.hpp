// Memory for the digits of big integers: taken from the front, given back all at once.
#pragma once

#include <cstdint>
#include <exception>

namespace graze::inline v0_1::detail {

// To use it, take digits, write them, then keep as many as the result has. Inputs with exponents as far apart as
// possible need less than two thirds of the room. That is measured, not proved: a program that runs out of room ends.
class workspace {
  public:
    constexpr workspace(std::int64_t* digits, int capacity) noexcept : next_(digits), end_(digits + capacity) {}
    workspace(const workspace&) = delete;
    workspace& operator=(const workspace&) = delete;

    [[nodiscard]] constexpr std::int64_t* take(int count) const noexcept {
        if (end_ - next_ < count) [[unlikely]] {
            std::terminate();
        }
        return next_;
    }
    constexpr void keep_until(std::int64_t* end) noexcept { next_ = end; }

    // At its end, everything taken during its lifetime is given back.
    class scope {
      public:
        constexpr explicit scope(workspace* w) noexcept : workspace_(w), mark_(w != nullptr ? w->next_ : nullptr) {}
        constexpr ~scope() {
            if (workspace_ != nullptr) {
                workspace_->next_ = mark_;
            }
        }
        scope(const scope&) = delete;
        scope& operator=(const scope&) = delete;

      private:
        workspace* workspace_;
        std::int64_t* mark_;
    };

  private:
    std::int64_t* next_;
    std::int64_t* end_;
};

// A workspace that includes its memory, which is not zeroed.
template <int Capacity>
class workspace_of : public workspace {
  public:
    constexpr workspace_of() noexcept : workspace(digits_, Capacity) {}

  private:
    std::int64_t digits_[Capacity];
};

} // namespace graze::inline v0_1::detail
