#include "property.hpp"

#include <rapidcheck.h>

namespace property {

bool check(const std::string& name, const trial& t) {
    return rc::check(name, [&] { t(); });
}

std::int64_t signed_in_range(std::int64_t low, std::int64_t high) { return *rc::gen::inRange(low, high); }
std::uint64_t unsigned_in_range(std::uint64_t low, std::uint64_t high) { return *rc::gen::inRange(low, high); }
std::size_t index_below(std::size_t count) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(std::size_t{0}, count));
}

template <>
bool any<bool>() {
    return *rc::gen::arbitrary<bool>();
}
template <>
std::int32_t any<std::int32_t>() {
    return *rc::gen::arbitrary<std::int32_t>();
}
template <>
std::uint32_t any<std::uint32_t>() {
    return *rc::gen::arbitrary<std::uint32_t>();
}
template <>
std::int64_t any<std::int64_t>() {
    return *rc::gen::arbitrary<std::int64_t>();
}
template <>
std::uint64_t any<std::uint64_t>() {
    return *rc::gen::arbitrary<std::uint64_t>();
}

void tag(const std::string& kind) { RC_TAG(kind); }
void log(const std::string& line) { RC_LOG(line); }

void fail(const char* file, int line, const char* expression) {
    throw rc::detail::CaseResult(rc::detail::CaseResult::Type::Failure,
                                 rc::detail::makeMessage(file, line, expression));
}
void discard(const char* file, int line, const char* expression) {
    throw rc::detail::CaseResult(rc::detail::CaseResult::Type::Discard,
                                 rc::detail::makeMessage(file, line, expression));
}

} // namespace property
