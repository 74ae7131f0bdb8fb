"""`roughcontact` with a fault at one allocation, write, close, open, rename or fsync after another: it ends with an exit code of its own
and a line that says why, and its files are whole or not there.

Usage: test_command.py ROUGHCONTACT INJECT PLUGINS [--long] [TEST ...]
"""
import json
import os
import signal
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "outside" / "tools"))
from faulted import CRASHES, Faulted, spread, take_arguments  # noqa: E402
from harness import CommandTest, np, rough  # noqa: E402

HISTORY = ["--pitch", "1e-6", "--modulus", "1e9", "--approach", "1e-7,2e-7", "--out", "out", "--quiet"]
SOLVERS = {"dense": "nnls", "fft": "polonsky-keer", "split": "haar-cg"}
HARD = ["--hardness", "5e7"]
RUNS, LONG = 25, 2000  # faults of a sweep, spread evenly over its calls
LARGE = 1 << 16  # bytes; FFTW's planner ends the process where it gets less than that and larger ones just succeeded, see docs/development/errors.md


def by(backend, solver):
    return ["--backend", backend, "--solver", solver, *(["--boundary", "free"] if backend == "split" else [])]


class Sweeps(CommandTest):
    in_memory = True

    def faulted(self, arguments):
        loaded = map(str, sorted(Path(PLUGINS).glob("rcb_*.so")))  # what their libraries do while they are loaded is beyond us
        return Faulted(INJECT, [COMMAND, *map(str, arguments)], self.folder, loaded, PATH="/nonexistent", RC_PLUGIN_PATH="")

    def clear(self):
        for name in self.names("."):
            path = self.folder / name
            if path.is_dir():
                for each in path.iterdir():
                    each.unlink()
                path.rmdir()
            elif name not in ("surface.npy", "faults.log"):
                path.unlink()

    def assert_whole(self):
        """What is in the folder can be read, and is what summary.json lists."""
        for path in self.folder.rglob("*"):
            self.assertFalse(path.name.endswith(".tmp") or path.name.endswith(".lock"), path)
            if path.suffix == ".npy":
                np.load(path)
            if path.suffix == ".json":
                json.loads(path.read_text())
            if path.suffix == ".gsf":
                self.assertGreater(path.stat().st_size, 32 * 32 * 4)
        out = self.folder / "out"
        if out.exists() and os.listdir(out):
            steps = json.loads((out / "summary.json").read_text())["steps"]
            self.assertTrue({n % (k + 1) for k in range(len(steps)) for n in ("gap-%d.npy", "pressure-%d.npy")} <= set(os.listdir(out)))

    def assert_ends_well(self, done, lines, least=0):
        if done.returncode == -signal.SIGABRT and done.stderr.splitlines()[-1].startswith("fftw: alloc.c") and least < LARGE:
            return  # FFTW's planner ends the process where a small allocation fails after larger ones have succeeded
        self.assertNotIn(done.returncode, CRASHES, done.stderr)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertTrue(lines)
        if "libgomp: Out of memory" in done.stderr:
            return  # the library of OpenMP, which CHOLMOD brings along, ends the process
        if done.returncode == 1:
            if "Memory allocation failed" in done.stderr and "roughcontact: " not in done.stderr:
                return  # Fortran's library, which LAPACK brings along, ends the process while it is loaded
            self.assertIn("roughcontact: ", done.stderr)
        self.assert_whole()

    def sweep(self, faulted, call, how="", least=0):
        total = faulted.calls(call, least)
        self.clear()
        for at in spread(total, RUNS):
            with self.subTest(call=call, at=at, of=total, how=how, least=least, command=faulted.command[1:]):
                self.assert_ends_well(*faulted.run(call, at, how, least), least)
            self.clear()

    def each_command(self):
        surface = self.npy(rough(32, 32))
        yield ["solve", surface, *HISTORY]
        leaking = ["solve", surface, *HISTORY, "--boundary", "periodic", "--leak", "viscosity=1mPas,drop=1bar"]
        if "built without" not in self.run_command(*leaking).stderr:
            yield leaking
        yield ["generate", "noise", "--size", "32", "--output", "a.npy"]
        yield ["generate", "spectral", "--size", "32", "--output", "a.gsf"]
        yield ["analyze", surface, "--pitch", "1e-6", "--json", "a.json"]
        yield ["options"]

    def test_each_allocation_of_each_command(self):
        for command in self.each_command():
            self.sweep(self.faulted(command), "alloc")

    def test_large_allocations(self):
        surface = self.npy(rough(128, 128))
        for pair in ("auto*auto", "fft*polonsky-keer", "split*haar-cg", "fft*haar-cg"):
            for more in ([], HARD):
                self.sweep(self.faulted(["solve", surface, *HISTORY, *by(*pair.split("*")), *more]), "alloc", least=LARGE)

    def sweep_backend(self, backend, *solvers):
        if backend in self.run_command("backends").stdout:
            for solver in solvers:
                for more in ([], HARD):
                    self.sweep(self.faulted(["solve", self.npy(rough(32, 32)), *HISTORY, *by(backend, solver), *more]), "alloc")

    def test_allocations_with_each_backend(self):
        for backend, solver in SOLVERS.items():
            self.sweep_backend(backend, solver)

    def test_allocations_with_cholmod(self):
        """Also run with each BLAS that is installed."""
        self.sweep_backend("cholmod", "nnls", "admm")

    def test_every_kth_allocation(self):
        faulted = self.faulted(["solve", self.npy(rough(32, 32)), *HISTORY])
        for every in (1, 2):  # every k-th; all from the k-th on
            for at in (2, 3, 7, 23, 100, 500, 1000, 1500, 2000):
                with self.subTest(at=at, every=every):
                    self.assert_ends_well(*faulted.run("alloc", at, every=every))
                self.clear()

    def test_each_call_on_files(self):
        for command in self.each_command():
            for call in ("close", "open", "rename", "fsync"):
                self.sweep(self.faulted(command), call)
            for how in ("", "short"):
                self.sweep(self.faulted(command), "write", how=how)


if __name__ == "__main__":
    COMMAND, INJECT, PLUGINS = take_arguments(["ROUGHCONTACT", "INJECT", "PLUGINS"])
    import harness

    harness.COMMAND = COMMAND
    if "--long" in sys.argv:
        RUNS = LONG
        sys.argv.remove("--long")
    unittest.main()
