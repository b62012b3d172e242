#!/usr/bin/env python3
"""Slips in the formulas, one at a time, each of which must break a proof.

Every operator, sign, index, constant, factor, term and arm of a choice in include/graze/formula is changed or dropped
in a copy of its header, and the proofs are compiled against that copy until one of them fails. A slip that no proof
notices must be listed in equivalent.txt, with the reason for which it changes nothing.

    mutate.py [--compiler g++] [--jobs 1] [--only plane_crossing] [--sample 8 --seed 1] [--list] [--verbose] [--near]
              [--again LOG]
"""
import argparse
import collections
import concurrent.futures
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FORMULAS = ROOT / "include/graze/formula"
# The proofs, the quick ones first. Those about a header are tried before the others.
PROOFS = ["formula/encounter", "formula/root_order", "formula/roots", "formula/contact", "formula/plane_crossing",
          "formula/discriminant", "formula/flight_motion", "formula/solve_wall", "formula/impulse", "formula/errata",
          "formula/wall_features", "formula/slanted_wall", "analysis/bit_width", "predicate/scenes",
          "formula/wall_encounter", "formula/flat_features", "predicate/triangles", "predicate/wall_scenes",
          "predicate/decisions"]
ABOUT = {
    "relative_motion": ["formula/discriminant"], "quadratic": ["formula/discriminant"],
    "discriminant": ["formula/discriminant"], "roots": ["formula/roots"], "root_order": ["formula/root_order"],
    "contact": ["formula/contact"], "impulse": ["formula/impulse"], "plane_crossing": ["formula/plane_crossing"],
    "wall_features": ["formula/wall_features", "formula/slanted_wall"],
    "flat_motion": ["formula/flat_features", "formula/slanted_wall", "formula/wall_encounter", "predicate/triangles"],
    "flat_way": ["formula/flat_features", "formula/wall_encounter", "predicate/triangles"],
    "flat_edge": ["formula/flat_features", "formula/wall_encounter", "predicate/triangles"],
    "flat_hull": ["predicate/triangles", "predicate/decisions", "predicate/wall_scenes"],
    "flat_sight": ["formula/slanted_wall", "formula/wall_encounter", "predicate/triangles", "predicate/wall_scenes"],
    "flat_view": ["formula/slanted_wall", "formula/wall_encounter", "predicate/triangles", "predicate/wall_scenes"],
    "flat_entry": ["formula/wall_encounter", "formula/slanted_wall", "predicate/triangles", "predicate/wall_scenes",
                   "formula/solve_wall"],
    "flat_encounter": ["formula/wall_encounter", "formula/slanted_wall", "predicate/triangles",
                       "predicate/wall_scenes", "predicate/decisions"],
    "wall_encounter": ["formula/wall_encounter"],
    "encounter": ["formula/encounter"], "solution": ["predicate/scenes", "formula/errata"],
    "solve_balls": ["predicate/scenes"], "solve_plane": ["predicate/scenes"],
    "solve_flat": ["formula/solve_wall", "predicate/scenes", "predicate/wall_scenes", "predicate/triangles"],
    "exact_in": ["analysis/bit_width"], "flight_motion": ["formula/flight_motion"],
}
SWAPS = {"+": "-", "-": "+", "*": "+", "/": "*", "<": "<=", ">": ">=", "<=": "<", ">=": ">", "==": "!=", "!=": "==",
         "&&": "||", "||": "&&", ">>": "<<", "<<": ">>", "&": "|"}
NAMES = [("dot(", "cross("), ("cross(", "dot("), (".dx", ".du"), (".du", ".dx"), (".w", ".u"), (".u", ".w"),
         ("true", "false"), ("false", "true"), ("height", "speed"), ("speed", "height"), ("inverse_a", "inverse_b"),
         ("inverse_b", "inverse_a"), ("dx", "du"), ("position_a", "position_b"), ("velocity_a", "velocity_b")]
# What ends an operand: a weaker operator outside the operand's own parentheses, after a blank.
LOOSER = {"*": r"\*|/|\+|-|<=|>=|<|>|==|!=|&&|\|\||\?|:", "+": r"\+|-|<=|>=|<|>|==|!=|&&|\|\||\?|:",
          "&&": r"&&|\|\||\?|:", "?": r"\?|:"}
DECLARATION = re.compile(r"\s*(#|template|requires|namespace|struct|class|using|static_assert|public:|private:)")


def code_of(text):
    """The text with blanks for comments, strings, declarations and the signatures of functions: where slips count."""
    kept = re.sub(r"//[^\n]*", lambda m: " " * len(m.group(0)), text)
    kept = re.sub(r'"[^"\n]*"', lambda m: " " * len(m.group(0)), kept)
    lines = []
    signature = False  # until its body begins
    for line in kept.split("\n"):
        if signature or re.match(r"\s*\[\[nodiscard\]\]", line):
            body = line.find("{", 0 if ") " in line or "{" in line else len(line))
            match = re.search(r"(\)|const|noexcept) (: [^{]*)?\{", line)
            signature = match is None and ";" not in line
            lines.append(" " * match.end() + line[match.end():] if match and body >= 0 else " " * len(line))
        elif DECLARATION.match(line):
            lines.append(" " * len(line))
        else:
            lines.append(line)
    return "\n".join(lines)


def is_bracket(code, i):
    """Whether the < or > at i is a template's: comparisons stand between blanks."""
    return code[i] in "<>" and code[i - 1] not in " \n-=<" and not (code[i] == "<" and code[i + 1] == "=")


def operand_end(code, start, operator):
    """Where the operand that starts at `start` ends."""
    depth = 0
    choices = 0
    for i in range(start, len(code)):
        c = code[i]
        if depth == 0:
            if c in ";,)]}":
                return i
            if operator in "?:" and c in "?:" and code[i - 1] in " \n":
                if c == ":" and not choices:
                    return i
                choices += 1 if c == "?" else -1
            elif operator not in "?:" and i > start and code[i - 1] in " \n)" and re.match(
                    f"({LOOSER[operator]})(?=[ \n]|(?<=[-+*])[a-z])", code[i:]):
                return i
        depth += (c in "([{") - (c in ")]}")
        depth += (c == "<") - (c == ">") if is_bracket(code, i) else 0
    return len(code)


def operand_start(code, end, operator):
    """Where the operand that ends at `end` starts."""
    depth = 0
    for i in range(end - 1, -1, -1):
        c = code[i]
        depth += (c in ")]}") - (c in "([{")
        depth += (c == ">") - (c == "<") if is_bracket(code, i) else 0
        if depth < 0 or (depth == 0 and c in ";,{}" and c != "}"):
            return i + 1
        if depth == 0 and c in " \n" and re.search(rf"(^|[ \n)])({LOOSER[operator]}|=|return|:)$", code[:i]):
            return i + 1
    return 0


def edits_of(code, text):
    """(start, end, what instead), each a slip."""
    binary = r"(?<=[ \n])(\+|-|\*|/|<=|>=|<|>|==|!=|&&|\|\||>>|<<|&)(?=[ \n])|(?<=\))[-+*](?=[A-Za-z])"
    for match in re.finditer(binary, code):
        operator, (start, end) = match.group(0), match.span()
        yield start, end, SWAPS[operator]
        level = {"-": "+", "||": "&&"}.get(operator, operator)
        if level in ("+", "*", "&&"):  # without what follows, and without what comes before
            yield start, operand_end(code, end + 1, level), ""
            before = operand_start(code, len(code[:start].rstrip()), level)
            yield before, end, ""
    for match in re.finditer(r"(?<=[ \n])\?(?=[ \n])", code):  # one arm of a choice, always
        colon = operand_end(code, match.end() + 1, "?")
        last = operand_end(code, colon + 2, ":")
        before = operand_start(code, len(code[:match.start()].rstrip()), "?")
        yield before, last, text[match.end() + 1:colon]
        yield before, last, text[colon + 2:last]
    for match in re.finditer(r"(?<=[ (,={\n])-(?=[A-Za-z(\d])", code):  # a sign
        yield match.start(), match.end(), ""
    for match in re.finditer(r"(?<=[ (\n])!(?=[A-Za-z(])", code):
        yield match.start(), match.end(), ""
    for match in re.finditer(r"graze::twice(?=\()", code):  # a factor of 2
        yield match.start(), match.end(), ""
    for match in re.finditer(r"(?<![\w.])\d(?![\w.])", code):  # an index or constant
        digit = match.group(0)
        yield match.start(), match.end(), {"0": "1", "1": "0"}.get(digit, str(int(digit) - 1))
    for old, new in NAMES:
        for match in re.finditer(r"(?<!\w)" + re.escape(old) + (r"(?!\w)" if old[-1].isalnum() else ""), code):
            yield match.start(), match.end(), new


def squeezed(text):
    return " ".join(text.split())


class Slip:
    """A header with one change; what is shown of it are the lines that differ."""

    def __init__(self, header, text, start, end, instead):
        self.header = header
        self.text = text[:start] + instead + text[end:]
        self.number = text.count("\n", 0, start) + 1
        first = text.rfind("\n", 0, start) + 1
        last = text.find("\n", end)
        self.key = (header.name, squeezed(text[first:last]), squeezed(text[first:start] + instead + text[end:last]))


def all_slips(only):
    for header in sorted(FORMULAS.glob("*.hpp")):
        if only and header.stem not in only:
            continue
        text = header.read_text()
        code = code_of(text)
        seen = set()
        for edit in edits_of(code, text):
            slip = Slip(header, text, *edit)
            if slip.key[1] != slip.key[2] and squeezed(slip.text) not in seen:
                seen.add(squeezed(slip.text))
                yield slip


REFUTED = re.compile("static assertion failed|not a constant expression|not constant|is not an integral constant|"
                     "non-constant condition for static assertion")


def compile_proof(proof, compiler, folder=None):
    """What the compiler says, or nothing where the proof holds."""
    command = [compiler, "-std=c++20", "-fsyntax-only", "-w", "-Wfatal-errors", f"-I{ROOT / 'include'}",
               str(ROOT / "proofs" / f"{proof}.cpp")]
    if folder:
        command.insert(1, f"-I{folder}")
    if "clang" in compiler:
        command.insert(1, "-fconstexpr-steps=100000000")
    else:
        command.insert(1, "-fconstexpr-ops-limit=1000000000")
    try:
        run = subprocess.run(command, capture_output=True, check=False, text=True, timeout=600)
    except subprocess.TimeoutExpired:
        return "static assertion failed: the proof does not end"
    return None if run.returncode == 0 else run.stderr or "no message"


def verdict_on(slip, compiler, proofs, near):
    """caught: a proof does not hold. stillborn: no proof compiles for another reason. missed: all proofs hold."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "graze/formula"
        copy.mkdir(parents=True)
        (copy / slip.header.name).write_text(slip.text)
        first = [p for p in ABOUT.get(slip.header.stem, []) if p in proofs]
        for proof in first + ([] if near else [p for p in proofs if p not in first]):
            said = compile_proof(proof, compiler, folder)
            if said:
                return ("caught" if REFUTED.search(said) else "stillborn"), proof
    return "missed", ""


def equivalents():
    """From header, lines and changed lines to the reason."""
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
    parser.add_argument("--verbose", action="store_true", help="say which proof caught each")
    parser.add_argument("--near", action="store_true", help="try only the proofs that are about the header")
    parser.add_argument("--again", type=pathlib.Path, help="try only what this output of an earlier run did not notice")
    options = parser.parse_args()

    known = equivalents()
    proofs = [p for p in PROOFS if (ROOT / "proofs" / f"{p}.cpp").exists()]
    everything = list(all_slips(options.only))
    # Listed slips are not tried. Lines may be alike: each reason is about one slip.
    times = collections.Counter(s.key for s in everything)
    ambiguous = [key for key in known if times[key] != 1 and (not options.only or key[0][:-4] in options.only)]
    for key in ambiguous:
        print(" | ".join(key), f"| is listed, and is {times[key]} slips")
    if ambiguous:
        return 2
    chosen = everything
    if options.again:
        unnoticed = {tuple(line.split(" | ")[:3]) for line in options.again.read_text().split("\n")
                     if line.endswith(" | not noticed")}
        chosen = [s for s in everything if s.key in unnoticed]
    if options.sample:
        random.seed(options.seed)
        chosen = random.sample([s for s in chosen if s.key not in known], options.sample)
    if options.list:
        for slip in chosen:
            print(f"{slip.header.name}:{slip.number}: {slip.key[1]} | {slip.key[2]}")
        return 0
    # A proof that fails on the unchanged code would catch every slip.
    about = {p for slip in chosen for p in ABOUT.get(slip.header.stem, []) if p in proofs}
    for proof in sorted(about) if options.sample or options.near else proofs:
        if said := compile_proof(proof, options.compiler):
            print(f"{proof} does not compile unchanged:\n{said}")
            return 2
    listed = [s for s in chosen if s.key in known]
    unlisted = [s for s in chosen if s.key not in known]
    count = {"caught": 0, "stillborn": 0, "missed": 0}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for slip, (verdict, proof) in zip(unlisted,
                                          pool.map(lambda x: verdict_on(x, options.compiler, proofs,
                                                                                   options.near), unlisted)):
            count[verdict] += 1
            if verdict == "missed" or options.verbose:
                said = "not noticed" if verdict == "missed" else f"{verdict} by {proof}"
                print(" | ".join([*slip.key, said]), flush=True)
    print(f"{len(everything)} slips, {len(chosen)} tried: {count['caught']} caught, {count['stillborn']} do not compile, "
          f"{len(listed)} change nothing, {count['missed']} not noticed")
    return 1 if count["missed"] or not count["caught"] else 0


if __name__ == "__main__":
    sys.exit(main())
