#!/usr/bin/env python3
"""own_costs.py BUILD [TEST...]: the processor seconds of each test program: compiling its own units, and its tests' runs.

It compiles each unit once more, without ccache, and writes no file of the build. What a program shares with others, such as
libraries and precompiled headers, is not counted. Left out are tests with a label and programs that are not built. TEST: only
programs with this in their name.
"""
import json
import os
import resource
import shlex
import statistics
import subprocess
import sys
import tempfile


def seconds(command, folder, environment):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"{shlex.join(command)} failed:\n{done.stderr}")
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def output_of(entry):
    command = shlex.split(entry["command"])
    return os.path.join(entry["directory"], command[command.index("-o") + 1])


def compiling(entry, out):
    command = shlex.split(entry["command"])
    while os.path.basename(command[0]) in ("ccache", "sccache"):
        command = command[1:]
    command[command.index("-o") + 1] = out
    return seconds(command, entry["directory"], os.environ | {"CCACHE_DISABLE": "1"})


def running(test):
    properties = {p["name"]: p["value"] for p in test.get("properties", [])}
    environment = os.environ | dict(e.split("=", 1) for e in properties.get("ENVIRONMENT", []))
    return seconds(test["command"], properties.get("WORKING_DIRECTORY"), environment)


def main():
    build, wanted = os.path.realpath(sys.argv[1]), sys.argv[2:]
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1", "-LE", "."], check=True, capture_output=True)
    programs = {}
    for test in json.loads(listed.stdout)["tests"]:
        program = test.get("command", [""])[0]
        if program.startswith(build + "/tests/") and os.path.exists(program):
            programs.setdefault(program, []).append(test)
    with open(f"{build}/compile_commands.json", encoding="utf-8") as file:
        entries = json.load(file)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for program, tests in programs.items():
            name = os.path.basename(program)
            objects = f"{os.path.dirname(program)}/CMakeFiles/{name}.dir/"
            units = [e for e in entries if output_of(e).startswith(objects)]
            if units and (not wanted or any(w in name for w in wanted)):
                compiled = sum(compiling(e, f"{folder}/unit.o") for e in units)
                ran = sum(running(t) for t in tests)
                rows.append((compiled + ran, compiled, ran, name))
                print(f"\r{len(rows)} of at most {len(programs)}", end="", file=sys.stderr)
    print("\r\033[K", end="", file=sys.stderr)
    print("  all  compile   run  program")
    for row in sorted(rows, reverse=True):
        print("{:5.1f}    {:5.1f} {:5.1f}  {}".format(*row))
    if rows:
        print(f"median {statistics.median(r[0] for r in rows):.1f} of {len(rows)}")


main()
