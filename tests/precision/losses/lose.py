#!/usr/bin/env python3
"""Deliberate losses of precision, one at a time, each of which the precision regression must notice.

Every statement of the formulas and of the products of vectors is rewritten in all ways below that apply; what is rewritten
is equal in exact arithmetic but for a factor of 2 or of 1 + 2^-30. The regression in double is compiled against a copy with that change.

    association    a + b + c as a + (b + c), a b c as a (b c)
    float          the value of a statement goes through a float
    fused          a b + c, a b - c d as a fused multiply-add
    reciprocal     a / b as a (1 / b)
    conjugate      a / (b - c) as a (b + c) / (b b - c c), the naive root for the stable one
    difference     a a - b b as (a - b) (a + b)
    residual       a term that is called an error is dropped
    halved         a factor of 2 is dropped
    moved          a + b as a + b (1 + 2^-30), which moves a border

A change is `caught` if a figure becomes worse than accepted. It is listed as `harmless`, with what was measured, if no figure
does, provided that the regression measures the statement at all: it must notice the value negated. If it does
not, or a border was moved, the change is `unseen`, and the script fails. NOT_MEASURED names the statements that are left out, and why.

    lose.py --build build/release [--compiler g++] [--jobs 1] [--only roots] [--kind moved] [--sample 8 --seed 1] [--list]
"""
import argparse
import concurrent.futures
import importlib.util
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PRECISION = ROOT / "tests/precision"
_specification = importlib.util.spec_from_file_location("mutate", ROOT / "proofs/mutation/mutate.py")
mutate = importlib.util.module_from_spec(_specification)
_specification.loader.exec_module(mutate)

BALLS = ["coefficients", "discriminant_in<variant::textbook>", "discriminant_in<variant::halved>",
         "discriminant_in<variant::kahan>", "discriminant_in<variant::lagrange>"]
SOLUTIONS = ["solution_in<variant::textbook, root_form::printed>", "solution_in<variant::lagrange, root_form::stable>"]
# The headers, and the part of the regression that is compiled for each.
MEASURED = {
    "linear/vec.hpp": BALLS + SOLUTIONS, "formula/relative_motion.hpp": BALLS, "formula/quadratic.hpp": BALLS,
    "formula/discriminant.hpp": BALLS, "formula/roots.hpp": SOLUTIONS, "formula/contact.hpp": SOLUTIONS,
    "formula/impulse.hpp": SOLUTIONS, "formula/plane_crossing.hpp": SOLUTIONS, "formula/wall_features.hpp": SOLUTIONS,
    "formula/flat_way.hpp": SOLUTIONS, "formula/flat_edge.hpp": SOLUTIONS,
    "formula/flat_entry.hpp": SOLUTIONS, "formula/flat_view.hpp": SOLUTIONS, "formula/flat_sight.hpp": SOLUTIONS, "formula/flat_encounter.hpp": SOLUTIONS,
    "formula/root_order.hpp": ["order_of_roots"],
    "formula/solution.hpp": SOLUTIONS, "formula/solve_balls.hpp": SOLUTIONS, "formula/solve_plane.hpp": SOLUTIONS,
    "formula/solve_flat.hpp": SOLUTIONS,
}
# Code that no program of the regression runs.
NOT_MEASURED = {
    "-height / speed": "Eq. (33) as printed, which nothing but the errata uses",
    "q.a * numerator + q.h * denominator": "asked of exact coefficients alone",
    "graze::sign(height) * graze::sign(speed)": "a product of signs",
    "x[i] + y[i]": "no formula that solves a pair adds vectors",
    "s * x[i]": "of the formulas flight_motion alone scales a vector, in integers",
    "number_traits<T>::dot(x, y)": "a product that a type brings along, and double brings none",
    "number_traits<T>::squared_norm(x)": "likewise",
}
HELPERS = """
namespace graze::lost {
// change of a double, of each in a vector, of no other number.
template <class T, class F>
constexpr T each(const T& x, F change) {
    if constexpr (__is_same(T, double)) {
        return change(x);
    } else if constexpr (requires { x.component[0]; }) {
        T y = x;
        for (auto& component : y.component) {
            component = each(component, change);
        }
        return y;
    } else {
        return x;
    }
}
template <class T>
constexpr T narrowed(const T& x) {
    return each(x, [](double y) { return static_cast<double>(static_cast<float>(y)); });
}
template <class T>
constexpr T moved(const T& x) {
    return each(x, [](double y) { return y * (1 + 0x1p-30); });
}
template <class A, class B, class C>
constexpr auto fused(const A& a, const B& b, const C& c) {
    if constexpr (__is_same(A, double) && __is_same(B, double) && __is_same(C, double)) {
        return __builtin_fma(a, b, c);
    } else {
        return a * b + c;
    }
}
} // namespace graze::lost
"""
STATEMENT = re.compile(r"(?:return |(?:const )?(?:auto|T) \w+ = )([\w<>, ]+\{\{[^;{}]+\}\}|[^;{}]+)(?=;)")


def split(text, operators):
    """The operands outside parentheses, and the operators between them."""
    operands, between, start, depth = [], [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "([{") - (c in ")]}")
        found = next((o for o in operators if text.startswith(o, i)), None)
        if depth == 0 and found:
            operands.append(text[start:i])
            between.append(found)
            start = i + len(found)
    return operands + [text[start:]], between


def losses_of(code):
    """(kind, rewritten) of an expression."""
    if any(s in code for s in (" ? ", " && ", " || ", " < ", " >= ", " <= ", " == ", " != ")):
        return
    terms, signs = split(code, (" + ", " - "))
    factors, products = split(code, (" * ", " / "))
    if len(terms) > 2:
        inner = [terms[1]] + [s.translate(str.maketrans("+-", "-+")) + t if signs[0] == " - " else s + t
                              for s, t in zip(signs[1:], terms[2:])]
        yield "association", f"{terms[0]}{signs[0]}({''.join(inner)})"
    if len(terms) == 1 and len(factors) > 2 and set(products) == {" * "}:
        yield "association", f"{factors[0]} * ({' * '.join(factors[1:])})"
    if len(terms) > 1 or len(factors) > 1 or "dot(" in code or "squared_norm(" in code:
        yield "float", f"graze::lost::narrowed({code})"
    if len(terms) == 2:
        first, between = split(terms[0], (" * ", " / "))
        second, other = split(terms[1], (" * ", " / "))
        minus = signs[0] == " - "
        if between == [" * "]:
            yield "fused", f"graze::lost::fused({first[0]}, {first[1]}, {'-(' if minus else '('}{terms[1]}))"
        if other == [" * "]:
            yield "fused", f"graze::lost::fused({'-(' if minus else '('}{second[0]}), {second[1]}, {terms[0]})"
        if minus and between == other == [" * "] and first[0] == first[1] and second[0] == second[1]:
            yield "difference", f"({first[0]} - {second[0]}) * ({first[0]} + {second[0]})"
        if terms[1].strip() in ("error", "residual"):
            yield "residual", terms[0]
        else:
            yield "moved", f"{terms[0]}{signs[0]}graze::lost::moved({terms[1]})"
    if len(terms) == 1 and products and products[-1] == " / ":
        above, below = " * ".join(factors[:-1]) if len(set(products[:-1]) | {" * "}) == 1 else None, factors[-1]
        if above:
            yield "reciprocal", f"{above} * (decltype({below})(1) / {below})".replace("decltype", "std::remove_cvref_t<decltype") \
                .replace(")(1)", ")>(1)")
            inner, sign = split(below.strip("()"), (" + ", " - "))
            if sign == [" - "]:
                yield "conjugate", (f"{above} * ({inner[0]} + {inner[1]}) / "
                                    f"({inner[0]} * {inner[0]} - {inner[1]} * {inner[1]})")
    if "graze::twice(" in code:
        yield "halved", code.replace("graze::twice(", "(", 1)


def values_of(code, column):
    """(column, expression) of a statement's value, or of each component where it names them."""
    before, braces, components = code.partition("{{")
    if not braces:
        yield column, code
        return
    column += len(before + braces)
    for component in split(components.removesuffix("}}"), (", ",))[0]:
        yield column, component
        column += len(component) + len(", ")


def all_losses(only):
    """(header, line, column, kind, expression, rewritten)."""
    for name in MEASURED:
        if only and pathlib.Path(name).stem not in only:
            continue
        for number, line in enumerate((ROOT / "include/graze" / name).read_text().split("\n")):
            if not line.strip() or re.match(r"\s*(//|#|template|requires|static_assert|concept)", line):
                continue
            for match in STATEMENT.finditer(line.split(" //")[0]):
                for column, expression in values_of(match.group(1), match.start(1)):
                    if expression not in NOT_MEASURED:
                        for kind, rewritten in losses_of(expression):
                            yield name, number, column, kind, expression, rewritten


class Regression:
    def __init__(self, options):
        self.options = options
        self.library = next(pathlib.Path(options.build).resolve().rglob("libgraze_precision_suite.a"))

    def run(self, header=None, number=None, column=None, expression=None, rewritten=None):
        """caught, passed or stillborn, and what was said."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            formulas = set(sum(MEASURED.values(), [])) if header is None else MEASURED[header]
            if header is not None:
                self.change(folder, header, number, column, expression, rewritten)
            adds = "\n".join(f"add<{f}, double>(list);" for f in sorted(formulas))
            (folder / "type.cpp").write_text(
                f'#include <graze/precision/formulas.hpp>\n#include "{PRECISION}/run.hpp"\n'
                "using namespace graze;\nusing namespace graze::precision;\n"
                f"int main(int argc, char** argv) {{ subjects list;\n{adds}\n"
                'return ::precision::run(argc, argv, list, "", ""); }\n')
            command = [self.options.compiler, "-std=c++20", "-O0", "-ffp-contract=off", "-w", f"-I{folder}",
                       f"-I{ROOT / 'include'}", str(folder / "type.cpp"), str(self.library), "-lgmpxx", "-lgmp",
                       "-pthread", "-o", str(folder / "program")]
            built = subprocess.run(command, capture_output=True, check=False, text=True)
            if built.returncode != 0:
                return "stillborn", built.stderr
            # All figures of these formulas, each once, without the lines of others.
            only = sum((["--only", f"/{n}/double/"] for n in self.names(formulas)), [])
            ran = subprocess.run([str(folder / "program"), "--accepted", str(PRECISION / "accepted"), "--kept",
                                  str(PRECISION / "inputs"), "--results", str(folder / "results"), "--quiet"] + only,
                                 capture_output=True, check=False, text=True,
                                 env=os.environ | {"GRAZE_PRECISION_UPDATE": "no"})
            said = ran.stdout.strip().split("\n")[-1]
            return {0: "passed", 1: "caught"}.get(ran.returncode, "stillborn"), said if ran.returncode < 2 else ran.stderr

    @staticmethod
    def names(formulas):
        for f in formulas:
            words = re.findall(r"::(\w+)", f)
            yield {"coefficients": "quadratic", "order_of_roots": "root_order"}.get(f, ".".join(words))

    @staticmethod
    def change(folder, header, number, column, expression, rewritten):
        lines = (ROOT / "include/graze" / header).read_text().split("\n")
        line = lines[number]
        lines[number] = line[:column] + rewritten + line[column + len(expression):]
        last = max(i for i, text in enumerate(lines[:number]) if text.startswith("#"))
        lines.insert(last + 1, "#include <type_traits>" + HELPERS)
        copy = folder / "graze" / header
        copy.parent.mkdir(parents=True)
        copy.write_text("\n".join(lines))


def judge(regression, loss):
    header, number, column, kind, expression, rewritten = loss
    verdict, said = regression.run(header, number, column, expression, rewritten)
    if verdict != "passed":
        return verdict, said
    if kind == "moved":
        return "unseen", said
    negated, _ = regression.run(header, number, column, expression, f"-({expression})")
    return ("unseen" if negated == "passed" else "harmless"), said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, help="where the target graze_precision_suite was built")
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--kind", nargs="*")
    parser.add_argument("--sample", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    everything = [x for x in dict.fromkeys(all_losses(options.only)) if not options.kind or x[3] in options.kind]
    chosen = everything
    if options.sample:
        random.seed(options.seed)
        chosen = random.sample(everything, min(options.sample, len(everything)))
    if options.list:
        for header, number, _, kind, expression, rewritten in chosen:
            print(f"{header}:{number + 1}: {kind}: {expression}  ->  {rewritten}")
        print(len(chosen))
        return 0
    regression = Regression(options)
    verdict, said = regression.run()
    if verdict != "passed":
        print(f"the formulas do not pass unchanged: {said}")
        return 2
    count = {"caught": 0, "harmless": 0, "unseen": 0, "stillborn": 0}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for loss, (verdict, said) in zip(chosen, pool.map(lambda x: judge(regression, x), chosen)):
            header, number, _, kind, expression, rewritten = loss
            count[verdict] += 1
            if verdict == "stillborn":
                said = next((text for text in said.split("\n") if "error" in text), said.strip())
            print(f"{verdict}: {header}:{number + 1}: {kind}: {expression}  ->  {rewritten}: {said}", flush=True)
    print(f"{len(everything)} losses, {len(chosen)} tried: {count['caught']} caught, {count['harmless']} harmless, "
          f"{count['stillborn']} do not compile, {count['unseen']} not noticed by any figure")
    return 1 if count["unseen"] or not count["caught"] else 0


if __name__ == "__main__":
    sys.exit(main())
