// The fields of results by name, once, for writing and for reading them.
#pragma once

#include "results.hpp"

#include <concepts>
#include <type_traits>

namespace compare {

template <class S, class T>
concept some = std::same_as<std::remove_const_t<S>, T>;

template <class F, some<error_statistics> S>
void fields(F& field, S& s) {
    field("count", s.count);
    field("exact", s.exact);
    field("correctly_rounded", s.correctly_rounded);
    field("not_finite", s.not_finite);
    field("unscaled", s.unscaled);
    field("median", s.median);
    field("largest", s.largest);
    field("median_bits", s.median_bits);
    field("fewest_bits", s.fewest_bits);
    field("quantiles", s.quantiles);
    field("histogram", s.histogram);
}

template <class F, some<defect_statistics> S>
void fields(F& field, S& s) {
    field("count", s.count);
    field("zero", s.zero);
    field("median", s.median);
    field("largest", s.largest);
}

template <class F, some<decision_counts> S>
void fields(F& field, S& s) {
    field("evaluated", s.evaluated);
    field("undecided", s.undecided);
    field("approaching", s.approaching);
    field("overlap", s.overlap);
    field("hit_or_miss", s.hit_or_miss);
    field("feature", s.feature);
    field("failed", s.failed);
}

template <class F, some<cell> S>
void fields(F& field, S& s) {
    field("kind", s.kind);
    field("hardness", s.hardness);
    field("evaluated", s.evaluated);
    field("wrong", s.wrong);
    field("undecided", s.undecided);
    field("time_median", s.time_median);
    field("time_largest", s.time_largest);
    field("discriminant_median", s.discriminant_median);
    field("discriminant_largest", s.discriminant_largest);
}

template <class F, some<row> S>
void fields(F& field, S& s) {
    field("type", s.type);
    field("variant", s.variant);
    field("root", s.root);
    field("group", s.group);
    field("decisions", s.decisions);
    field("errors", s.errors);
    field("width", s.width);
    field("not_enclosed", s.not_enclosed);
    field("momentum", s.momentum);
    field("energy", s.energy);
    field("nanoseconds", s.nanoseconds);
    field("nanoseconds_low", s.nanoseconds_low);
    field("nanoseconds_high", s.nanoseconds_high);
    field("timed_pairs", s.timed_pairs);
    field("repeats", s.repeats);
    field("cells", s.cells);
    field("on_front", s.on_front);
}

template <class F, some<type_information> S>
void fields(F& field, S& s) {
    field("name", s.name);
    field("library", s.library);
    field("is_exact", s.is_exact);
    field("is_interval", s.is_interval);
    field("digits", s.digits);
    field("has_sqrt", s.has_sqrt);
    field("has_fma", s.has_fma);
    field("bytes", s.bytes);
    field("real_bytes", s.real_bytes);
    field("uses_heap", s.uses_heap);
    field("alias_of", s.alias_of);
    field("note", s.note);
}

template <class F, some<missing_type> S>
void fields(F& field, S& s) {
    field("name", s.name);
    field("reason", s.reason);
}

template <class F, some<conditioning> S>
void fields(F& field, S& s) {
    field("kind", s.kind);
    field("hardness", s.hardness);
    field("count", s.count);
    field("time_median", s.time_median);
    field("time_largest", s.time_largest);
    field("discriminant_median", s.discriminant_median);
    field("discriminant_largest", s.discriminant_largest);
}

template <class F, some<group_information> S>
void fields(F& field, S& s) {
    field("name", s.name);
    field("description", s.description);
    field("dimension", s.dimension);
    field("pairs", s.pairs);
    field("pairs_of", s.pairs_of);
    field("kinds", s.kinds);
    field("encounters", s.encounters);
    field("hardness_name", s.hardness_name);
    field("conditions", s.conditions);
}

template <class F, some<choice> S>
void fields(F& field, S& s) {
    field("type", s.type);
    field("variant", s.variant);
    field("root", s.root);
    field("nanoseconds", s.nanoseconds);
}

template <class F, some<digits_wanted> S>
void fields(F& field, S& s) {
    field("digits", s.digits);
    field("cheapest", s.cheapest);
}

template <class F, some<machine_information> S>
void fields(F& field, S& s) {
    field("processor", s.processor);
    field("compiler", s.compiler);
    field("flags", s.flags);
    field("system", s.system);
    field("date", s.date);
    field("graze", s.graze);
}

template <class F, some<results> S>
void fields(F& field, S& s) {
    field("command", s.command);
    field("machine", s.machine);
    field("source", s.source);
    field("as", s.as);
    field("seed", s.seed);
    field("digits", s.digits);
    field("seconds", s.seconds);
    field("groups", s.groups);
    field("types", s.types);
    field("missing", s.missing);
    field("rows", s.rows);
    field("matrix", s.matrix);
    field("good_enough", s.good_enough);
    field("exact", s.exact);
    field("sentence", s.sentence);
}

} // namespace compare
