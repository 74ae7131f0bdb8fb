"""What the tests of roughcontact-mpi share: running it on a number of ranks, beside roughcontact itself."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print('skipped: NumPy is not installed')
    sys.exit(77)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'behaviour', 'ranks'))
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
    """A smooth random surface, rms 0.1 um."""
    noise = np.fft.rfft2(np.random.default_rng(seed).normal(size=(ny, nx)))
    q = np.hypot(np.fft.fftfreq(ny)[:, None], np.fft.rfftfreq(nx)[None, :])
    q[0, 0] = 1
    z = np.fft.irfft2(noise * np.where(q > 0.02, q**-1.8, 0), s=(ny, nx))
    return z * 1e-7 / z.std()


def said(folder, times=False):
    """summary.json, without the times."""
    summary = json.loads((folder / 'summary.json').read_text())
    for step in summary['steps']:
        for name in () if times else TIMES:
            del step[name]
    return summary


class RanksTest(unittest.TestCase):
    """Every test has an empty working folder of its own."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def npy(self, z, name='surface.npy'):
        np.save(self.folder / name, z)
        return name

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
