"""One allocation of a program after the other fails: whatever the backend, the program must end with a status and a text.

Usage: injected.py INJECT_LIBRARY PROGRAM PLUGIN_DIRECTORY [--full]

FFTW's planner ends the process where one of its small allocations fails although larger ones just succeeded: those ends are counted.
All allocations of 64 KiB and more must be survived.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

inject, program, plugins = sys.argv[1:4]
full = "--full" in sys.argv
LARGE = 1 << 16
scratch = pathlib.Path(tempfile.mkdtemp())
FREE, PERIODIC = "1", "2"


def run(arguments, **fault):
    log = scratch / "log"
    log.unlink(missing_ok=True)
    settings = {f"RC_FAULT_{key.upper()}": str(value) for key, value in fault.items()}
    environment = {**os.environ, "LD_PRELOAD": inject, "RC_FAULT": "alloc", "RC_FAULT_LOG": str(log), "RC_PLUGIN_PATH": plugins}
    environment.update(settings)
    done = subprocess.run([program, *arguments], env=environment, capture_output=True, text=True, timeout=120)
    lines = log.read_text().split("\n") if log.exists() else []
    return done, lines


def calls(arguments, **fault):
    done, lines = run(arguments, **fault)
    assert done.returncode == 0, f"{arguments}: {done.returncode} without a fault: {done.stdout}{done.stderr}"
    return int(next(line.split()[1] for line in lines if line.startswith("calls")))


def sweep(arguments, least, most_runs):
    """(runs, ends inside FFTW's planner)."""
    count = calls(arguments, least=least)
    stride = max(1, count // most_runs)
    runs = planner = 0
    for k in range(1, count + 1, stride):
        done, _ = run(arguments, least=least, at=k)
        runs += 1
        if done.returncode < 0 and "fftw: alloc.c" in done.stderr and least == 0:
            planner += 1
            continue
        what = f"{arguments}, {k} of {count} from {least} bytes on: {done.returncode}: {done.stdout}{done.stderr}"
        assert done.returncode in (0, 1), what
        # The run-time library of Fortran, which LAPACK brings along, ends the process with a line of its own while it is loaded.
        assert done.returncode == 0 or done.stdout or done.stderr, what
    return runs, planner


SMALL = [
    ("dense", "nnls", "12", FREE),
    ("cholmod", "nnls", "12", FREE),
    ("cholmod", "admm", "12", FREE),
    ("fft", "polonsky-keer", "16", FREE),
    ("fft", "haar-cg", "15", PERIODIC),
    ("split", "haar-cg", "40", FREE),
    ("dense", "nnls", "12", FREE, "0.05"),
    ("fft", "haar-cg", "16", PERIODIC, "0.05"),
]
LARGER = [
    ("fft", "haar-cg", "200", FREE),
    ("fft", "polonsky-keer", "200", PERIODIC),
    ("split", "haar-cg", "200", FREE),
    ("fft", "haar-cg", "200", FREE, "0.05"),
]
present = {path.name[4:-3] for path in pathlib.Path(plugins).glob("rcb_*.so")} | {"dense", "callback"}
for arguments in SMALL:
    if arguments[0] in present:
        runs, planner = sweep(arguments, 0, 2000 if full else 24)
        print(f"{' '.join(arguments)}: {runs} failed allocations, {planner} ended by FFTW's planner")
        assert arguments[0] in ("fft", "split") or planner == 0
for arguments in LARGER:
    if arguments[0] in present:
        runs, _ = sweep(arguments, LARGE, 1000 if full else 24)
        print(f"{' '.join(arguments)}: {runs} failed allocations of {LARGE} bytes and more")
