#!/usr/bin/env python3
"""Finds runs of tokens that stand twice in the headers: names them, and exits with 1 if there are more than MOST.

clones.py FOLDER LENGTH MOST: LENGTH tokens in a row of what stands in `detail`, where the procedures are; comments, includes
and lists of explicit instantiations aside.
"""
import pathlib
import re
import sys

TOKEN = re.compile(r"[A-Za-z_]\w*|\d[\w.']*|\"[^\"]*\"|\S")


def tokens_of(path):
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"//(?! namespace)[^\n]*", "", text)
    text = re.sub(r"^[ \t]*#[^\n]*", "", text, flags=re.M)
    parts = []
    for part in re.finditer(r"namespace (?:graze::inline v0_1::)?detail \{(.*?)\n\} // namespace", text, flags=re.S):
        first = text.count("\n", 0, part.start(1)) + 1
        body = part.group(1)
        parts += [(m.group(), first + body.count("\n", 0, m.start())) for m in TOKEN.finditer(body)]
    return parts


def main():
    folder, length, most = pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    seen, found = {}, []
    for path in sorted(folder.rglob("*.hpp")):
        if path.name == "compiled.hpp":
            continue
        tokens = tokens_of(path)
        end = 0
        for i in range(len(tokens) - length + 1):
            run = tuple(word for word, _ in tokens[i : i + length])
            if run in seen and i >= end:
                found.append((seen[run], (path, tokens[i][1])))
                end = i + length
            seen.setdefault(run, (path, tokens[i][1]))
    for (first, line), (second, other) in found:
        print(f"{first}:{line} and {second}:{other}")
    print(f"{len(found)} runs of {length} tokens stand twice, at most {most} are accepted")
    return 1 if len(found) > most else 0


if __name__ == "__main__":
    sys.exit(main())
