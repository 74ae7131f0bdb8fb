#!/usr/bin/env python3
"""Puts plausible faults into the source, and tells which of them the tests notice.

Usage: faults.py BUILD [--only TEXT] [--all] [--list]

BUILD: a build folder of this tree with its tests, such as build-gcc. All faults of scripts/faults.txt are put into their files at
once, each behind its number, and what the tests need is built once. Then RC_FAULT turns on one after the other: the first seeds of
`scenes` run, if they notice nothing the tests of the fault's family, and then the other seeds. A test that fails without the fault as
well notices nothing. The files are restored at the end and after Ctrl-C; files with changes of your own are refused. --only: faults
whose lines contain the text. --all: the family's tests run even if `scenes` notices the fault. Exit status: 0 if all faults could be
tried, and at most 3 are noticed by nothing.
"""

import argparse
import contextlib
import json
import os
import pathlib
import re
import signal
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "scripts/faults.txt"
MOST_UNNOTICED = 3
FIRST_SEEDS, OTHER_SEEDS = "0:300", "300:2000"
SWITCH = """#ifndef RC_FAULT_SWITCH
#define RC_FAULT_SWITCH
#include <stdlib.h>
static inline int rc_fault_chosen(void) {
  static int number = -1;
  if (number < 0) number = getenv("RC_FAULT") ? atoi(getenv("RC_FAULT")) : 0;
  return number;
}
#ifdef __cplusplus
constexpr bool rc_fault(int number) { return !__builtin_is_constant_evaluated() && rc_fault_chosen() == number; }
#else
static inline int rc_fault(int number) { return rc_fault_chosen() == number; }
#endif
#endif
#line 1
"""


def faults():
    """(number, name, file, before, after, names of tests, targets beside theirs) of each fault."""
    number = 0
    for block in re.split(r"\n\n+", LIST.read_text().strip()):
        lines = [line for line in block.split("\n") if not line.startswith("#")]
        if not lines:
            continue
        number += 1
        name, file, before, after, tests, *targets = (line.partition(": ")[2].replace("\\n", "\n") for line in lines)
        after = re.sub(r"\bON\b", f"rc_fault({number})", after)
        yield number, name, file, before, after, tests, targets[0].split() if targets else []


def listed(build, pattern):
    """What CTest says of the tests that run before a landing."""
    shown = subprocess.run(
        ["ctest", "--test-dir", build, "--show-only=json-v1", "-R", pattern, "-LE", "full"],
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(shown.stdout)["tests"]


def tests_of(build, pattern):
    """Names of the tests, and the targets of those that are programs of this build, which may not be built yet."""
    names = {test["name"] for test in listed(build, pattern)}
    targets = set()
    for file in build.rglob("CTestTestfile.cmake"):
        for name, command in re.findall(r"^add_test\(\[=\[(.*?)\]=\] (.*)\)$", file.read_text(), re.M):
            programs = re.findall(rf'"{re.escape(str(build))}/bin/([^"/]+)"', command)
            targets.update(programs if name in names else [])
    return names, targets


@contextlib.contextmanager
def restored(files):
    """The texts of files that are changed in place, and are as before at the end. Files with changes of your own are refused."""
    if dirty := subprocess.run(
        ["git", "-C", ROOT, "status", "--porcelain", *files], capture_output=True, text=True, check=True
    ).stdout:
        sys.exit(f"commit or stash these files first:\n{dirty}")
    originals = {file: (ROOT / file).read_text() for file in files}
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended"))
    try:
        yield originals
    finally:
        for file in files:
            (ROOT / file).write_text(originals[file])


def scenes_pass(build, number, seeds=FIRST_SEEDS):
    command = [build / "bin/test_scenes", "--stop", "--seeds", seeds]
    return subprocess.run(command, capture_output=True, env={**os.environ, "RC_FAULT": str(number)}).returncode == 0


def failing(build, number, pattern, but):
    """Names of the tests but these that fail, up to the first."""
    run = subprocess.run(
        ["ctest", "--test-dir", build, "-R", pattern, "-E", but, "-LE", "full", "--timeout", "600", "--stop-on-failure"],
        capture_output=True,
        text=True,
        env={**os.environ, "RC_FAULT": str(number)},
    )
    return re.findall(r"^\s*\d+ - (\S+) \(", run.stdout, re.M)


def noticed_by(build, fault, everything):
    number, pattern = fault[0], fault[5]
    by_scenes = not scenes_pass(build, number)
    found, known = [], "^$"
    while everything or not by_scenes:
        found = failing(build, number, pattern, known)
        exactly = "^(" + "|".join(map(re.escape, found)) + ")$"
        if not found or not failing(build, 0, exactly, "^$"):
            break
        known += "|" + exactly  # a test that fails without the fault as well notices nothing
    if not found and not by_scenes:
        by_scenes = not scenes_pass(build, number, OTHER_SEEDS)
    return ["scenes"] * by_scenes + found


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    wanted = [fault for fault in faults() if arguments.only in " ".join(fault[1:5])]
    files = sorted({fault[2] for fault in wanted})
    originals = {file: (ROOT / file).read_text() for file in files}
    stale = [fault for fault in wanted if originals[fault[2]].count(fault[3]) != 1]
    for fault in stale:
        print(f"{fault[1]} | {fault[2]} | the line of this fault is not there once: write it anew")
    wanted = [fault for fault in wanted if fault not in stale]
    if arguments.list:
        for fault in wanted:
            print(f"{fault[1]} | {fault[2]}")
        return 1 if stale else 0
    build = arguments.build.resolve()
    targets = {"test_scenes"}
    for fault in wanted:
        names, programs = tests_of(build, fault[5])
        if not names:
            sys.exit(f"{fault[1]}: no test is called {fault[5]}")
        targets |= {*programs, *fault[6]}
    unnoticed = []
    with restored(files):
        for file in files:
            text = originals[file]
            for fault in wanted:
                text = text.replace(fault[3], fault[4]) if fault[2] == file else text
            (ROOT / file).write_text(SWITCH + text)
        built = subprocess.run(["cmake", "--build", build, "--target", *sorted(targets)], capture_output=True, text=True)
        if built.returncode != 0:
            sys.exit(f"does not build:\n{built.stdout[-4000:]}")
        if not scenes_pass(build, 0):
            sys.exit("`scenes` fails without any fault")
        for fault in wanted:
            found = noticed_by(build, fault, arguments.all)
            if not found:
                unnoticed.append(fault)
            print(f"{fault[1]} | {fault[2]} | {', '.join(found) or 'NOBODY'}", flush=True)
    print(f"{len(wanted)} faults, {len(wanted) - len(unnoticed)} noticed")
    return 0 if len(unnoticed) <= MOST_UNNOTICED and not stale else 1


if __name__ == "__main__":
    sys.exit(main())
