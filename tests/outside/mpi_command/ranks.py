"""What the tests of roughcontact-mpi share: running it on a number of ranks."""
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
from test_resume import assert_same_results, said  # noqa: F401

COMMAND = MPIEXEC = ''
ENVIRONMENT = {**os.environ, **MPI, 'OMP_NUM_THREADS': '1'}
PRESS = ['--pitch', '1e-6', '--modulus', '1e9']


def main():
    """Runs the test classes of the calling script with the command and mpirun of the command line."""
    global COMMAND, MPIEXEC
    COMMAND, MPIEXEC = (os.path.abspath(sys.argv.pop(1)) for _ in range(2))
    unittest.main(module='__main__')


def on_ranks(ranks, *arguments):
    boundary = () if '--boundary' in arguments else ('--boundary', 'free')
    return [MPIEXEC, '-n', str(ranks), COMMAND, *map(str, arguments), *boundary]


def rough(ny=96, nx=64, seed=1):
    return harness.rough(ny, nx, seed=seed)


class RanksTest(harness.CommandTest):
    def run_ranks(self, ranks, *arguments, code=0):
        done = subprocess.run(on_ranks(ranks, *arguments), cwd=self.folder, encoding='utf-8', capture_output=True, timeout=300, env=ENVIRONMENT)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def messages(self, done):
        """The lines of the command itself, without those of mpirun."""
        return [line for line in done.stderr.splitlines() if line.startswith('roughcontact')]

    def assert_same(self, one, other):
        assert_same_results(self, self.folder / one, self.folder / other)
