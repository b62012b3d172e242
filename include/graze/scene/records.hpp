// Plain records side by side, in storage that is compiled once for all their types.
#pragma once

#include <cstddef>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace graze::inline v0_1::detail {

// Storage that grows as that of a vector does.
class record_storage {
  public:
    record_storage() = default;
    [[gnu::noinline]] record_storage(const record_storage& other) {
        if (other.end_ != other.begin_) {
            make_room(other.length());
            std::memcpy(begin_, other.begin_, other.length());
            end_ = begin_ + other.length();
        }
    }
    record_storage(record_storage&& other) noexcept
        : begin_(std::exchange(other.begin_, nullptr)), end_(std::exchange(other.end_, nullptr)),
          limit_(std::exchange(other.limit_, nullptr)) {}
    // Allocates only where there is not room enough; if that throws, nothing has changed.
    [[gnu::noinline]] record_storage& operator=(const record_storage& other) {
        if (other.length() > room()) {
            return *this = record_storage(other);
        }
        if (this != &other) {
            const std::size_t bytes = other.length();
            if (bytes != 0) { // else there may be no storage
                std::memcpy(begin_, other.begin_, bytes);
            }
            end_ = begin_ + bytes;
        }
        return *this;
    }
    record_storage& operator=(record_storage&& other) noexcept {
        std::swap(begin_, other.begin_);
        std::swap(end_, other.end_);
        std::swap(limit_, other.limit_);
        return *this;
    }
    ~record_storage() { ::operator delete(begin_); }

  protected:
    [[nodiscard]] std::size_t length() const noexcept { return static_cast<std::size_t>(end_ - begin_); }
    [[nodiscard]] std::size_t room() const noexcept { return static_cast<std::size_t>(limit_ - begin_); }
    // Room for so many records of that size, but not less than twice as many as now.
    [[gnu::noinline]] void grow(std::size_t records, std::size_t size) {
        if (records > static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max()) / size) {
            throw std::length_error("too many records");
        }
        make_room(records * size < 2 * room() ? 2 * room() : records * size);
    }

    std::byte *begin_ = nullptr, *end_ = nullptr, *limit_ = nullptr;

  private:
    void make_room(std::size_t bytes) {
        auto* const fresh = static_cast<std::byte*>(::operator new(bytes));
        const std::size_t used = length();
        if (used != 0) {
            std::memcpy(fresh, begin_, used);
        }
        ::operator delete(begin_);
        begin_ = fresh;
        end_ = fresh + used;
        limit_ = fresh + bytes;
    }
};

// What a run needs of a vector, with the same meaning. Of each std::vector a compiler makes a hundred functions; the
// vectors of a run took it a quarter of its time.
template <class T>
class packed_records : public record_storage {
  public:
    using value_type = T;

    packed_records() = default;
    explicit packed_records(std::size_t n, const T& value = T()) { resize(n, value); }

    [[nodiscard]] T* begin() noexcept { return reinterpret_cast<T*>(begin_); }
    [[nodiscard]] T* end() noexcept { return reinterpret_cast<T*>(end_); }
    [[nodiscard]] const T* begin() const noexcept { return reinterpret_cast<const T*>(begin_); }
    [[nodiscard]] const T* end() const noexcept { return reinterpret_cast<const T*>(end_); }
    [[nodiscard]] std::size_t size() const noexcept { return length() / sizeof(T); }
    [[nodiscard]] bool empty() const noexcept { return begin_ == end_; }
    [[nodiscard]] std::size_t capacity() const noexcept { return room() / sizeof(T); }
    [[nodiscard]] T* data() noexcept { return begin(); }
    [[nodiscard]] const T* data() const noexcept { return begin(); }
    [[nodiscard]] T& operator[](std::size_t i) noexcept { return begin()[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return begin()[i]; }
    [[nodiscard]] T& front() noexcept { return *begin(); }
    [[nodiscard]] const T& front() const noexcept { return *begin(); }
    [[nodiscard]] T& back() noexcept { return end()[-1]; }
    [[nodiscard]] const T& back() const noexcept { return end()[-1]; }

    void clear() noexcept { end_ = begin_; }
    void reserve(std::size_t n) {
        if (n > capacity()) {
            grow(n, sizeof(T));
        }
    }
    void resize(std::size_t n, const T& value = T()) {
        if (n > size()) {
            const T copy = value;
            reserve(n);
            for (T* p = end(); p != begin() + n; ++p) {
                ::new (static_cast<void*>(p)) T(copy);
            }
        }
        end_ = begin_ + n * sizeof(T);
    }
    void assign(std::size_t n, const T& value) {
        clear();
        resize(n, value);
    }
    void push_back(const T& x) {
        if (end_ == limit_) {
            const T copy = x; // it may be one of these
            grow(size() + 1, sizeof(T));
            ::new (static_cast<void*>(end_)) T(copy);
        } else {
            ::new (static_cast<void*>(end_)) T(x);
        }
        end_ += sizeof(T);
    }
    void pop_back() noexcept { end_ -= sizeof(T); }
    void erase(T* first, const T* last) noexcept {
        if (first == last) { // there may be no storage
            return;
        }
        std::memmove(first, last, static_cast<std::size_t>(end() - last) * sizeof(T));
        end_ -= static_cast<std::size_t>(last - first) * sizeof(T);
    }
    void erase(T* at) noexcept { erase(at, at + 1); }
};

// A vector of anything. Where the standard library checks its own vectors, one of these.
#if defined(_GLIBCXX_DEBUG)
template <class T>
using records = std::vector<T>;
#else
template <class T>
using records = std::conditional_t<std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t),
                                   packed_records<T>, std::vector<T>>;
#endif

} // namespace graze::inline v0_1::detail
