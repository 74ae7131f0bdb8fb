"""An address space of every size: a program ends with an answer or with a status and a text, and it does end.

Usage: little_memory.py PROGRAM PLUGIN_DIRECTORY [--full]
"""
import os
import pathlib
import resource
import subprocess
import sys

program, plugins = sys.argv[1:3]
full = "--full" in sys.argv
MIB = 1 << 20
present = {path.name[4:-3] for path in pathlib.Path(plugins).glob("rcb_*.so")} | {"dense", "callback"}


def run(arguments, limit):
    return subprocess.run(
        [program, *arguments],
        env={**os.environ, "RC_PLUGIN_PATH": plugins},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
        capture_output=True,
        text=True,
        timeout=120,
    )


for arguments in (
    ("fft", "haar-cg", "96", "1"),
    ("fft", "polonsky-keer", "97", "2"),
    ("split", "haar-cg", "96", "1"),
    ("auto", "auto", "96", "1"),
    ("cholmod", "nnls", "24", "1"),
    ("dense", "nnls", "24", "1"),
):
    if arguments[0] not in present | {"auto"}:
        continue
    ends = []
    for mebibytes in [*range(8, 48, 1 if full else 5), 1024]:
        done = run(arguments, mebibytes * MIB)
        said = done.returncode == 0 or done.returncode == 1 and done.stdout
        # 127: the system's loader finds no room for the program itself, which has not begun then.
        assert said or done.returncode == 127, f"{arguments} in {mebibytes} MiB: {done.returncode}: {done.stdout}{done.stderr}"
        ends.append(done.returncode)
    assert ends[-1] == 0, f"{arguments}: {ends}"
    print(f"{' '.join(arguments)}: {len(ends)} limits, {ends.count(1)} statuses, {ends.count(0)} answers")
