#!/usr/bin/env python3
"""Puts plausible faults into the source, one at a time, and tells which of them the tests notice.

Usage: faults.py BUILD [--only TEXT] [--all] [--list]

BUILD: a build folder of this tree with its tests, such as build-gcc. Each fault of scripts/faults.txt is put into its file, what its
tests need is built, `scenes` runs and, if it notices nothing, the tests of the fault's family; a test that fails without the fault
as well notices nothing. The file is restored at the end and after Ctrl-C; files with changes of your own are refused. --only: faults
whose line contains the text. --all: the family's tests run even if `scenes` notices the fault. Exit status: 0 if all faults could be
tried, and at most 3 are noticed by nothing.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "scripts/faults.txt"
MOST_UNNOTICED = 3


def faults():
    """(name, file, before, after, names of tests, targets beside theirs) of each fault."""
    for block in re.split(r"\n\n+", LIST.read_text().strip()):
        lines = [line for line in block.split("\n") if not line.startswith("#")]
        if not lines:
            continue
        name, file, before, after, tests, *targets = (line.partition(": ")[2].replace("\\n", "\n") for line in lines)
        yield name, file, before, after, tests, targets[0].split() if targets else []


def changed(file, before, after):
    """The file's text with the fault; None if the source has changed, and the fault must be written anew."""
    text = (ROOT / file).read_text()
    return text.replace(before, after) if text.count(before) == 1 else None


def tests_of(build, pattern):
    """Names of the tests, and the targets of those that are programs of this build, which may not be built yet."""
    shown = subprocess.run(
        ["ctest", "--test-dir", build, "--show-only=json-v1", "-R", pattern, "-LE", "full"],
        capture_output=True,
        text=True,
        check=True,
    )
    names = {test["name"] for test in json.loads(shown.stdout)["tests"]}
    targets = set()
    for file in build.rglob("CTestTestfile.cmake"):
        for name, command in re.findall(r"^add_test\(\[=\[(.*?)\]=\] (.*)\)$", file.read_text(), re.M):
            programs = re.findall(rf'"{re.escape(str(build))}/bin/([^"/]+)"', command)
            targets.update(programs if name in names else [])
    return names, targets


def scenes_pass(build):
    return subprocess.run([build / "bin/test_scenes", "--stop"], capture_output=True).returncode == 0


def noticed_by(build, pattern):
    """Names of the tests that fail."""
    run = subprocess.run(
        ["ctest", "--test-dir", build, "-R", pattern, "-LE", "full", "--timeout", "600"], capture_output=True, text=True
    )
    return re.findall(r"^\s*\d+ - (\S+) \(", run.stdout, re.M)


def judged(build, fault, everything):
    """What notices the fault; None if it does not compile."""
    name, file, before, after, pattern, extra = fault
    names, targets = tests_of(build, pattern)
    if not names:
        sys.exit(f"{name}: no test is called {pattern}")
    path, original = ROOT / file, (ROOT / file).read_text()

    def built(wanted):
        return subprocess.run(["cmake", "--build", build, "--target", *sorted(wanted)], capture_output=True).returncode == 0

    found = []
    path.write_text(changed(file, before, after))
    try:
        if not built(["test_scenes"]):
            return None
        by_scenes = not scenes_pass(build)
        if everything or not by_scenes:
            if not built([*targets, *extra]):
                return None
            found = noticed_by(build, pattern)
    finally:
        path.write_text(original)
    if found:  # a test that fails without the fault as well notices nothing
        built([*targets, *extra])
        found = [each for each in found if each not in noticed_by(build, "^(" + "|".join(map(re.escape, found)) + ")$")]
    return ["scenes"] * by_scenes + found


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    wanted = [fault for fault in faults() if arguments.only in " ".join(fault[:4])]
    files = sorted({fault[1] for fault in wanted})
    stale = [fault for fault in wanted if changed(*fault[1:4]) is None]
    for fault in stale:
        print(f"{fault[0]} | {fault[1]} | the line of this fault is not there once: write it anew")
    wanted = [fault for fault in wanted if fault not in stale]
    if arguments.list:
        for name, file, *_ in wanted:
            print(f"{name} | {file}")
        return 1 if stale else 0
    if dirty := subprocess.run(
        ["git", "-C", ROOT, "status", "--porcelain", *files], capture_output=True, text=True, check=True
    ).stdout:
        sys.exit(f"commit or stash these files first:\n{dirty}")
    build = arguments.build.resolve()
    subprocess.run(["cmake", "--build", build, "--target", "test_scenes"], check=True, capture_output=True)
    if not scenes_pass(build):
        sys.exit("`scenes` fails without any fault")
    unnoticed, tried = [], 0
    for fault in wanted:
        found = judged(build, fault, arguments.all)
        if found is None:
            print(f"{fault[0]} | {fault[1]} | does not build", flush=True)
            continue
        tried += 1
        if not found:
            unnoticed.append(fault)
        print(f"{fault[0]} | {fault[1]} | {', '.join(found) or 'NOBODY'}", flush=True)
    print(f"{tried} faults, {tried - len(unnoticed)} noticed")
    return 0 if len(unnoticed) <= MOST_UNNOTICED and not stale else 1


if __name__ == "__main__":
    sys.exit(main())
