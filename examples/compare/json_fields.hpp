// The names and fields of results, listed once for both writing and reading.
#pragma once

#include "results.hpp"

#include <concepts>
#include <type_traits>

namespace compare {

template <class S, class T>
concept some = std::same_as<std::remove_const_t<S>, T>;

// A field that is null in JSON unless `known`.
template <class T>
struct where_known {
    T& value;
    bool known;
    std::remove_const_t<T> unknown{}; // the value that a null is read as
};
template <class T>
where_known(T&, bool) -> where_known<T>;
template <class T, class U>
where_known(T&, bool, U) -> where_known<T>;

// A field that files of schema version 1 do not have.
template <class T>
struct since_2 {
    T& value;
};
template <class T>
since_2(T&) -> since_2<T>;

template <class F, some<error_statistics> S>
void fields(F& field, S& s) {
    field("count", s.count);
    field("exact", s.exact);
    field("correctly_rounded", s.correctly_rounded);
    field("not_finite", s.not_finite);
    field("unscaled", s.unscaled);
    const bool any = s.count > 0;
    field("median", where_known{s.median, any});
    field("largest", where_known{s.largest, any});
    field("median_bits", where_known{s.median_bits, any});
    field("fewest_bits", where_known{s.fewest_bits, any});
    field("quantiles", where_known{s.quantiles, any});
    field("histogram", s.histogram);
}

template <class F, some<defect_statistics> S>
void fields(F& field, S& s) {
    field("count", s.count);
    field("zero", s.zero);
    field("median", where_known{s.median, s.count > 0});
    field("largest", where_known{s.largest, s.count > 0});
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
    field("hardness", where_known{s.hardness, s.hardness >= 0, -1});
    field("evaluated", s.evaluated);
    field("wrong", s.wrong);
    field("undecided", s.undecided);
    field("time_median", s.time_median);
    field("time_largest", s.time_largest);
    field("discriminant_median", s.discriminant_median);
    field("discriminant_largest", s.discriminant_largest);
}

template <class F, some<extreme_pair> S>
void fields(F& field, S& s) {
    field("what", s.what);
    field("which", s.which);
    field("pair", s.pair);
    field("error", where_known{s.error, s.which == "largest"});
    field("right", s.right);
    field("said", s.said);
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
    field("nanoseconds_low", where_known{s.nanoseconds_low, s.nanoseconds.has_value()});
    field("nanoseconds_high", where_known{s.nanoseconds_high, s.nanoseconds.has_value()});
    field("timed_pairs", s.timed_pairs);
    field("repeats", s.repeats);
    field("repeated", since_2{s.repeated});
    field("cells", s.cells);
    field("extremes", since_2{s.extremes});
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
    field("hardness", where_known{s.hardness, s.hardness >= 0, -1});
    field("count", s.count);
    field("time_median", s.time_median);
    field("time_largest", s.time_largest);
    field("discriminant_median", s.discriminant_median);
    field("discriminant_largest", s.discriminant_largest);
}

template <class F, some<named_number> S>
void fields(F& field, S& s) {
    field("name", s.name);
    field("decimal", s.decimal);
    field("hexadecimal", where_known{s.hexadecimal, !s.hexadecimal.empty()});
}

template <class F, some<pair_information> S>
void fields(F& field, S& s) {
    field("number", s.number);
    field("name", s.name);
    field("kind", s.kind);
    field("hardness", where_known{s.hardness, s.hardness >= 0, -1});
    field("encounter", s.encounter);
    field("time", where_known{s.time, !s.time.empty()});
    field("border", s.border);
    field("numbers", s.numbers);
    field("scene", s.scene);
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
    field("shown", since_2{s.shown});
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
    field("program", since_2{s.program});
    field("inputs", since_2{s.inputs});
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
