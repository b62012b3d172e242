#!/usr/bin/env python3
"""Finds names that a header uses though it includes no header that declares them, itself or by another; exits with 1 if so.

includes.py INCLUDE: the folder of the headers. Looks for names of the standard library, but in headers that adapt another
library; and for names of graze that have several words. It reads, and does not compile.
"""
import pathlib
import re
import sys

STANDARD = {
    "algorithm": "all_of any_of binary_search clamp copy copy_if copy_n equal fill find find_if find_if_not for_each lower_bound max "
    "min min_element nth_element pop_heap push_heap remove_if rotate sort transform unique",
    "array": "array",
    "bit": "bit_cast bit_ceil bit_width countl_zero countr_zero popcount",
    "cmath": "ceil copysign fabs floor fma isinf ldexp nearbyint nextafter pow remainder sqrt",
    "compare": "partial_ordering strong_ordering",
    "concepts": "constructible_from convertible_to copy_constructible copyable default_initializable derived_from floating_point "
    "integral invocable same_as signed_integral totally_ordered",
    "cstddef": "byte max_align_t nullptr_t ptrdiff_t",
    "cstdint": "int16_t int32_t int64_t int8_t uint16_t uint32_t uint64_t uint8_t",
    "cstdio": "fprintf",
    "cstdlib": "abort",
    "cstring": "memcpy memmove",
    "exception": "exception terminate",
    "initializer_list": "initializer_list",
    "iterator": "back_inserter next",
    "limits": "numeric_limits",
    "map": "map",
    "memory": "make_unique unique_ptr",
    "numeric": "iota",
    "optional": "nullopt optional",
    "ranges": "ranges::begin ranges::input_range",
    "source_location": "source_location",
    "span": "span",
    "sstream": "ostringstream",
    "stdexcept": "domain_error invalid_argument length_error logic_error out_of_range overflow_error range_error runtime_error",
    "string": "string to_string",
    "string_view": "string_view",
    "tuple": "tie",
    "type_traits": "bool_constant conditional_t false_type integral_constant is_constant_evaluated is_class_v is_floating_point_v is_integral_v is_same_v "
    "is_standard_layout_v is_trivially_copyable_v is_void_v remove_cv_t remove_cvref_t true_type",
    "utility": "exchange forward in_place integer_sequence make_integer_sequence move pair swap",
    "variant": "get_if variant visit",
    "vector": "vector",
}
HEADER_OF = {name: header for header, names in STANDARD.items() for name in names.split()}
# What several standard headers declare.
SEVERAL = {"begin", "data", "declval", "end", "erase_if", "get", "size", "size_t", "tuple_element", "tuple_size", "tuple_size_v"}


# What is found by the type of an argument, whose header declares it.
BY_ARGUMENT = {"compare_exactly", "normal_of"}
# Words before a name that is not declared there.
KEYWORDS = {"and", "case", "const", "constexpr", "else", "new", "not", "or", "requires", "return", "static", "typename", "using"}


def code_of(path):
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"//[^\n]*", "", text)
    return re.sub(r'"(\\.|[^"\\\n])*"', '""', text)


def declared_in(code):
    """Names that the header declares in a namespace, where code is not indented: of types, concepts, constants and functions."""
    yield from re.findall(r"^(?:template <.*> )?(?:struct|class|concept|enum class|using) (\w+)", code, re.M)
    for line in re.findall(r"^[a-zA-Z\[].*", code, re.M):
        if line.startswith(("namespace", "using", "static_assert")):
            continue
        line = re.sub(r"\[\[.*?\]\]|__attribute__\(\(.*?\)\)", "", line)
        functions = [name for name in re.findall(r"(\w+)(?=\()", line) if name not in ("decltype", "noexcept", "requires", "sizeof")]
        yield from functions[:1]
        yield from re.findall(r"constexpr .*?(\w+) ?(?:=|\{)", line)


def used_in(code):
    """Names of several words that are called or given arguments, and that the header does not declare somewhere in its code."""
    code = re.sub(r"^ *#[^\n]*", "", code, flags=re.M)
    own = {name for before, name in re.findall(r"(\w+|[>&*\]])\s+(?=(\w+)\b)", code) if before not in KEYWORDS}
    own |= set(re.findall(r"using [\w:<>, ]+::(\w+);", code))
    return {name for name in re.findall(r"(?<![\w.>:])(?:graze::|detail::)?(\w+_\w+)\b(?= ?[(<{])", code)} - own


def main():
    root = pathlib.Path(sys.argv[1])
    headers = {str(path.relative_to(root)): code_of(path) for path in sorted(root.rglob("*.hpp"))}
    direct = {name: re.findall(r"^ *# *include <([^>]+)>", code, re.M) for name, code in headers.items()}
    everything = {}

    def included(name):
        if name not in everything:
            everything[name] = {name}.union(*(included(other) for other in direct.get(name, ())))
        return everything[name]

    places = {}
    for name, code in headers.items():
        for declared in declared_in(code):
            places.setdefault(declared, set()).add(name)

    wrong, looked_at = [], 0
    for name, code in headers.items():
        names = used_in(code) & set(places) - BY_ARGUMENT
        looked_at += len(names)
        for used in sorted(names):
            if not places[used] & included(name):
                wrong.append(f"{name}: {used} without <{min(places[used])}>")
        if re.search(r"^ *# *include <(?!graze/)[^>]*[/.]", code, re.M):
            continue
        names = set(re.findall(r"\bstd::((?:ranges::)?\w+)", code)) - SEVERAL
        looked_at += len(names)
        for used in sorted(names):
            header = HEADER_OF.get(used)
            if header is None:
                wrong.append(f"std::{used} is not in the table of includes.py")
            elif header not in included(name):
                wrong.append(f"{name}: std::{used} without <{header}>")
    print("\n".join(wrong))
    print(f"{looked_at} names in {len(headers)} headers")
    return 1 if wrong or looked_at < 2000 else 0


if __name__ == "__main__":
    sys.exit(main())
