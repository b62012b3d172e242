#!/usr/bin/env python3
"""Slips in the formulas, one at a time, each of which must break a proof.

Every operator, sign, index, constant, factor and term of include/graze/formula is changed or dropped in a copy of its
header, and the proofs are compiled against that copy. A slip that no proof notices must be listed in equivalent.txt,
with the reason for which it changes nothing.

    mutate.py [--compiler g++] [--jobs 1] [--only plane_crossing] [--sample 8 --seed 1] [--list]
"""
import argparse
import concurrent.futures
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FORMULAS = ROOT / "include/graze/formula"
# The proofs, those that are about a header first; the slow ones last.
PROOFS = ["formula/discriminant", "formula/roots", "formula/root_order", "formula/contact", "formula/impulse",
          "formula/plane_crossing", "formula/flight_motion", "formula/errata", "formula/wall_features", "predicate/scenes",
          "predicate/wall_scenes", "analysis/bit_width", "predicate/decisions"]
ABOUT = {
    "relative_motion": ["formula/discriminant"], "quadratic": ["formula/discriminant"],
    "discriminant": ["formula/discriminant"], "roots": ["formula/roots"], "root_order": ["formula/root_order"],
    "contact": ["formula/contact"], "impulse": ["formula/impulse"], "plane_crossing": ["formula/plane_crossing"],
    "wall_features": ["formula/wall_features"], "wall_encounter": ["predicate/wall_scenes", "formula/errata"],
    "encounter": ["formula/errata"], "solution": ["predicate/scenes", "formula/errata"],
    "solve_balls": ["predicate/scenes"], "solve_plane": ["predicate/scenes"], "solve_wall": ["predicate/scenes"],
    "exact_in": ["analysis/bit_width"], "flight_motion": ["formula/flight_motion"],
}
SWAPS = {"+": "-", "-": "+", "*": "+", "/": "*", "<": "<=", ">": ">=", "<=": "<", ">=": ">", "==": "!=", "!=": "==",
         "&&": "||", "||": "&&", ">>": "<<", "<<": ">>", "&": "|"}


def is_code(line):
    stripped = line.strip()
    return stripped and not re.match(r"//|#|template|requires|namespace|struct|class|using|\[\[nodiscard\]\] "
                                     r"(constexpr|static|friend|inline)|static_assert|public:|private:", stripped)


def end_of(text, start, stops):
    """Where the operand that starts at `start` ends: at one of the stops, outside its own parentheses."""
    depth = 0
    for i in range(start, len(text)):
        c = text[i]
        if depth == 0 and (c in ";,)?" or any(text.startswith(s, i) for s in stops)):
            return i
        depth += (c in "([{") - (c in ")]}")
        if depth < 0:
            return i
    return len(text)


def mutations_of(line):
    """The changed lines, each once."""
    code = line.split("//")[0]
    found = []
    binary = r"(?<= )(\+|-|\*|/|<=|>=|<|>|==|!=|&&|\|\||>>|<<|&)(?= )|(?<=\))[-+*](?=[A-Za-z])"
    for match in re.finditer(binary, code):
        operator, (start, end) = match.group(0), match.span()
        found.append(code[:start] + SWAPS[operator] + code[end:])
        if operator in "+-":  # without the term
            found.append(code[:start].rstrip() + code[end_of(code, end + 1, [" + ", " - ", " == ", " >= ", " <= ", " < ",
                                                                            " > ", " && ", " || ", " : "]):])
        if operator == "*":  # without either factor
            found.append(code[:start].rstrip() + code[end_of(code, end + 1, [" + ", " - ", " * ", " / ", " == ", " < ",
                                                                            " > ", " && ", " || ", " : ", ")-", ")+"]):])
    for match in re.finditer(r"(?<=[ (,={])-(?=[A-Za-z(])", code):  # a sign
        found.append(code[:match.start()] + code[match.end():])
    for match in re.finditer(r"(?<=[ (])!(?=[A-Za-z(])", code):
        found.append(code[:match.start()] + code[match.end():])
    for match in re.finditer(r"graze::twice\(", code):  # a factor of 2
        found.append(code[:match.start()] + "(" + code[match.end():])
    for match in re.finditer(r"(?<![\w.])\d(?![\w.])", code):  # an index or constant
        digit = match.group(0)
        found.append(code[:match.start()] + {"0": "1", "1": "0"}.get(digit, str(int(digit) - 1)) + code[match.end():])
    for old, new in [("dot(", "cross("), ("cross(", "dot("), (".dx", ".du"), (".du", ".dx"), (".w", ".u"), (".u", ".w"),
                     ("true", "false"), ("false", "true"), ("height", "speed"), ("speed", "height"),
                     ("inverse_a", "inverse_b"), ("inverse_b", "inverse_a"), ("dx", "du"), ("position_a", "position_b"),
                     ("velocity_a", "velocity_b")]:
        for match in re.finditer(r"(?<!\w)" + re.escape(old) + (r"(?!\w)" if old[-1].isalnum() else ""), code):
            found.append(code[:match.start()] + new + code[match.end():])
    return [m for m in dict.fromkeys(found) if m != code]


def all_mutations(only):
    for header in sorted(FORMULAS.glob("*.hpp")):
        if only and header.stem not in only:
            continue
        lines = header.read_text().split("\n")
        for number, line in enumerate(lines):
            if is_code(line):
                for mutated in mutations_of(line):
                    yield header, number, line, mutated


REFUTED = re.compile(r"static assertion failed|not a constant expression|not constant|is not an integral constant")


def compile_proof(proof, compiler, folder=None):
    """What the compiler says, or nothing where the proof holds."""
    command = [compiler, "-std=c++20", "-fsyntax-only", "-w", f"-I{ROOT / 'include'}",
               str(ROOT / "proofs" / f"{proof}.cpp")]
    if folder:
        command.insert(1, f"-I{folder}")
    if "clang" in compiler:
        command.insert(1, "-fconstexpr-steps=100000000")
    run = subprocess.run(command, capture_output=True, check=False, text=True)
    return None if run.returncode == 0 else run.stderr or "no message"


def verdict_on(mutation, compiler, proofs):
    """caught: a proof does not hold. stillborn: no proof compiles for another reason. missed: all proofs hold."""
    header, number, _, mutated = mutation
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "graze/formula"
        copy.mkdir(parents=True)
        lines = header.read_text().split("\n")
        lines[number] = mutated
        (copy / header.name).write_text("\n".join(lines))
        first = ABOUT.get(header.stem, [])
        verdict = "missed"
        for proof in first + [p for p in proofs if p not in first]:
            said = compile_proof(proof, compiler, folder)
            if said and REFUTED.search(said):
                return "caught"
            if said:
                return "stillborn"
    return verdict


def equivalents():
    """From header, line and changed line to the reason."""
    known = {}
    for line in (pathlib.Path(__file__).parent / "equivalent.txt").read_text().split("\n"):
        if line and not line.startswith("#"):
            header, old, new, reason = [field.strip() for field in line.split(" | ", 3)]
            known[header, old, new] = reason
    return known


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--sample", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()

    known = equivalents()
    proofs = [p for p in PROOFS if (ROOT / "proofs" / f"{p}.cpp").exists()]
    everything = list(all_mutations(options.only))
    chosen = everything
    if options.sample:
        random.seed(options.seed)
        chosen = random.sample([m for m in everything if (m[0].name, m[2].strip(), m[3].strip()) not in known],
                               options.sample)
    if options.list:
        for header, number, _, mutated in chosen:
            print(f"{header.name}:{number + 1}: {mutated.strip()}")
        return 0
    # What does not hold unchanged would catch everything.
    about = {p for header, *_ in chosen for p in ABOUT.get(header.stem, [])}
    for proof in sorted(about) if options.sample else proofs:
        if said := compile_proof(proof, options.compiler):
            print(f"{proof} does not compile unchanged:\n{said}")
            return 2
    listed = [m for m in chosen if (m[0].name, m[2].strip(), m[3].strip()) in known]
    unlisted = [m for m in chosen if m not in listed]
    count = {"caught": 0, "stillborn": 0, "missed": 0}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for m, verdict in zip(unlisted, pool.map(lambda x: verdict_on(x, options.compiler, proofs), unlisted)):
            count[verdict] += 1
            if verdict == "missed":
                print(f"{m[0].name} | {m[2].strip()} | {m[3].strip()} | not noticed", flush=True)
    print(f"{len(everything)} slips, {len(chosen)} tried: {count['caught']} caught, {count['stillborn']} do not compile, "
          f"{len(listed)} change nothing, {count['missed']} not noticed")
    return 1 if count["missed"] or not count["caught"] else 0


if __name__ == "__main__":
    sys.exit(main())
