#!/usr/bin/env python3
"""Holds a change that must not alter answers to the bits of the library before it.

Usage: digests.py record BUILD FOLDER [ctest options]     runs the tests of a build and writes a digest of every answer into FOLDER
       digests.py compare BEFORE BEFORE_AGAIN AFTER

A line that differs between BEFORE and BEFORE_AGAIN depends on chance (a time limit, a race, the name of a temporary file) and is left out.
compare ends with status 0 if AFTER has every other line as often as BEFORE. Tests of failing memory may fail under `record`.
"""

import collections
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def record(build, folder, options):
    folder = pathlib.Path(folder).resolve()
    folder.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as work:
        recorder = pathlib.Path(work) / "recorder.so"
        include = HERE.parent.parent / "include"
        subprocess.run(["g++", "-std=c++20", "-O2", "-fPIC", "-shared", f"-I{include}", HERE / "recorder.cpp", "-o", recorder, "-ldl"], check=True)
        environment = {**os.environ, "RC_DIGESTS": str(folder), "LD_PRELOAD": str(recorder)}
        subprocess.run(["ctest", "--test-dir", build, *options], env=environment, check=False)
    return 0


def answers(folder):
    """(file, line) -> how often."""
    return collections.Counter((file.name, line) for file in pathlib.Path(folder).iterdir() for line in file.read_text().splitlines())


def compare(before, again, after):
    before, again, after = answers(before), answers(again), answers(after)
    steady = before & again
    lost = steady - after
    for (name, line), times in list(lost.items())[:40]:
        print(f"{name}: {times} x {line}")
    total, programs = sum(steady.values()), {name.rsplit("-", 1)[0] for name, _ in steady}
    print(f"{total - sum(lost.values())} of {total} answers of {len(programs)} programs have the same bits; {sum((before - again).values())} depend on chance")
    return 1 if lost or not total else 0


if len(sys.argv) >= 4 and sys.argv[1] == "record":
    sys.exit(record(sys.argv[2], sys.argv[3], sys.argv[4:]))
if len(sys.argv) == 5 and sys.argv[1] == "compare":
    sys.exit(compare(*sys.argv[2:]))
sys.exit(__doc__)
