"""What the tests of roughcontact-mpi share: running it on a number of ranks, beside roughcontact itself."""
import json
import os
import subprocess
import sys
import unittest
from pathlib import Path

for folder in ('../../behaviour/ranks', '../tools'):
    sys.path.insert(0, str(Path(__file__).resolve().parent / folder))
import harness
from harness import np
from run import ENVIRONMENT as MPI

COMMAND = SERIAL = MPIEXEC = ''
ENVIRONMENT = {**os.environ, **MPI, 'OMP_NUM_THREADS': '1'}
PRESS = ['--pitch', '1e-6', '--modulus', '1e9']
TIMES = 'seconds', 'setup_seconds'


def main():
    """Runs the test classes of the calling script with the two commands and mpirun of the command line."""
    global COMMAND, SERIAL, MPIEXEC
    COMMAND, SERIAL, MPIEXEC = (os.path.abspath(sys.argv.pop(1)) for _ in range(3))
    unittest.main(module='__main__')


def with_boundary(arguments):
    return [*arguments] if '--boundary' in arguments else [*arguments, '--boundary', 'free']


def on_ranks(ranks, *arguments):
    return [MPIEXEC, '-n', str(ranks), COMMAND, *map(str, with_boundary(arguments))]


def rough(ny=96, nx=64, seed=1):
    return harness.rough(ny, nx, seed=seed)


def said(folder, times=False):
    """summary.json, without the times."""
    summary = json.loads((folder / 'summary.json').read_text())
    for step in summary['steps']:
        for name in () if times else TIMES:
            del step[name]
    return summary


class RanksTest(harness.CommandTest):
    def run_ranks(self, ranks, *arguments, code=0):
        done = subprocess.run(on_ranks(ranks, *arguments), cwd=self.folder, encoding='utf-8', capture_output=True, timeout=300, env=ENVIRONMENT)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def run_serial(self, *arguments):
        return subprocess.run([SERIAL, 'solve', *map(str, with_boundary(arguments))], cwd=self.folder, encoding='utf-8', capture_output=True, timeout=300,
                              env={**ENVIRONMENT, 'PATH': '/nonexistent'}, check=True)

    def messages(self, done):
        """The lines of the command itself, without those of mpirun."""
        return [line for line in done.stderr.splitlines() if line.startswith('roughcontact')]

    def assert_same(self, one, other):
        self.assertEqual(said(self.folder / one), said(self.folder / other))
        names = sorted(path.name for path in (self.folder / one).iterdir())
        self.assertEqual(names, sorted(path.name for path in (self.folder / other).iterdir()))
        for path in (self.folder / one).glob('*.npy'):
            self.assertEqual(path.read_bytes(), (self.folder / other / path.name).read_bytes(), path.name)
