#!/usr/bin/env python3
"""What clang's NumericalStabilitySanitizer sees of the wrong signs of discriminants, as a table for the documentation.

nsan.py --clang clang++-19 --include include --work FOLDER --page PAGE [--write]

Compares with the table in the page, between its marks, or writes it there. Exit code 77 where the sanitizer is missing.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys

FAMILIES = ["generic", "grazing", "far", "near_contact", "common_part"]
FORMS = ["textbook", "halved", "kahan", "lagrange", "closest", "factored"]
COUNT = 1000
# All reports, without an allowance for values near 0: a small discriminant may matter.
OPTIONS = "halt_on_error=0:symbolize=0:suppress_equal_stacks=0:log2_absolute_error_threshold=1000"


def lines_of(program, family, form, environment):
    """The signs by pair, and the pairs before whose line there was a report."""
    ran = subprocess.run([program, family, form, str(COUNT)], capture_output=True, text=True, env=environment, check=True)
    signs, reported, seen = {}, set(), False
    for line in ran.stderr.splitlines():
        told = re.fullmatch(r"pair (\d+): (-?\d)", line)
        if told:
            signs[int(told[1])] = int(told[2])
            if seen:
                reported.add(int(told[1]))
            seen = False
        elif "NumericalStabilitySanitizer" in line:
            seen = True
    return signs, reported


def main():
    options = argparse.ArgumentParser()
    for name in ("clang", "include", "work", "page"):
        options.add_argument("--" + name, required=True)
    options.add_argument("--write", action="store_true")
    asked = options.parse_args()
    work = pathlib.Path(asked.work)
    work.mkdir(parents=True, exist_ok=True)
    source = pathlib.Path(__file__).with_name("pairs.cpp")
    compile_it = [asked.clang, "-std=c++20", "-O1", "-ffp-contract=off", "-I" + asked.include, str(source), "-o"]
    subprocess.run(compile_it + [str(work / "exact"), "-DEXACT"], check=True)
    if subprocess.run(compile_it + [str(work / "watched"), "-fsanitize=numerical"], check=False).returncode != 0:
        print("no -fsanitize=numerical here")
        return 77
    watching = dict(os.environ, NSAN_OPTIONS=OPTIONS)
    rows = ["| family | form | pairs | wrong signs | of these reported | right signs reported |", "|---|---|--:|--:|--:|--:|"]
    for family in FAMILIES:
        truth = {i: s for i, s in lines_of(work / "exact", family, "exact", os.environ)[0].items() if s != 2}
        for form in FORMS:
            signs, reported = lines_of(work / "watched", family, form, watching)
            wrong = {i for i, s in truth.items() if signs[i] != s}
            rows.append(f"| `{family}` | `{form}` | {len(truth)} | {len(wrong)} | {len(wrong & reported)} | "
                        f"{len((set(truth) - wrong) & reported)} |")
    table = "\n".join(rows) + "\n"
    page = pathlib.Path(asked.page)
    text = page.read_text()
    begin, end = "<!-- nsan -->\n", "<!-- /nsan -->"
    head, rest = text.split(begin)
    known, tail = rest.split(end)
    if asked.write:
        page.write_text(head + begin + table + end + tail)
    elif known != table:
        print(f"{page} has another table than this:\n{table}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
