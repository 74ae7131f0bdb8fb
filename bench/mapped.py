"""The largest grids: the gap is a file of floats that is mapped into memory and read tile by tile; the pressures are those of
rc_contact_points. Load control, single precision, certified 1e-4."""
import math
import os
import sys
import tempfile
import time

import numpy as np
import roughcontact as rc

from case import Failure, available_memory, cpu_seconds, in_child, interpreter_memory, peak_memory
from options import ALL_THREADS, folder, listed, percent, question, ranged
from store import Store
from tables import show

TILE = 2048      # most points a side of the rough surface that is repeated
WAVES = 512      # points a side of the long waves, which are interpolated
ROWS = 512       # written at a time
HEADROOM = 4e9   # bytes for the library, at most
COLUMNS = ('grid={n}²; contact [%]={contact_percent:.3g}; file [GB]={file_gigabytes:.2f}; seconds={seconds:.3g}; CPU [s]={cpu_seconds:.3g}; '
           'products; peak in all [GB]={peak_gigabytes:.2f}; without the file={own_gigabytes:.2f}; residual={residual:.0e}; status')


def waves(points, first, last, seed):
    """Random phases, amplitudes k^-1.8 (Hurst exponent 0.8) between these wave numbers, rms 1."""
    k = np.hypot(np.fft.fftfreq(points)[:, None], np.fft.rfftfreq(points)) * points
    amplitude = np.where((k >= first) & (k <= last), np.maximum(k, 1) ** -1.8, 0)
    heights = np.fft.irfft2(amplitude * np.exp(2j * np.pi * np.random.default_rng(seed).random(k.shape)), s=(points, points))
    return (heights / heights.std()).astype(np.float32)


def write_gap(file, n):
    """A rough tile over and over, on waves three times as high that are 16 to 1 to the side. Returns the tile's rms slope for unit cells."""
    points = min(TILE, n // 4)
    tile, long = waves(points, 8, points // 4, 1), waves(WAVES, 1, 16, 2)
    at = (np.arange(n) + 0.5) / n * WAVES - 0.5
    left = np.floor(at).astype(int)
    share = (at - left).astype(np.float32)
    share *= share * (3 - 2 * share)
    gap, lowest = np.memmap(file, np.float32, 'w+', shape=(n, n)), np.inf
    for y in range(n):
        row = long[left[y] % WAVES] * (1 - share[y]) + long[(left[y] + 1) % WAVES] * share[y]
        gap[y] = -3 * (row[left % WAVES] * (1 - share) + row[(left + 1) % WAVES] * share) - 0.5 * np.tile(tile[y % points], n // points)
        lowest = min(lowest, float(gap[y].min()))
    for y in range(0, n, ROWS):
        gap[y:y + ROWS] -= lowest
    gap.flush()
    return 0.5 * np.sqrt(sum(np.mean(np.diff(tile.astype(float), axis=axis) ** 2) for axis in (0, 1)))


def solve(file, n, slope, share, threads, interpreter, want_pressure=False):
    """Bush, Gibson & Thomas (1975): area = sqrt(2 pi) p / (E* rms slope) at light loads."""
    gap = np.memmap(file, np.float32, 'r', shape=(n, n))
    options = {'tol': 1e-4, 'threads': threads, 'fft.precision': 'single'}
    begun, before = time.perf_counter(), cpu_seconds()
    with rc.Contact(rc.HalfSpace(shape=(n, n), pitch=1.0, modulus=1.0, boundary='free'), options=options) as contact:
        result = contact.solve(undeformed_gap=gap, single=True, borrow=True, load=share * slope * n**2 / math.sqrt(2 * math.pi),
                               want_pressure=want_pressure, check=False)
    peak = peak_memory() - interpreter
    return {'status': result.status.name, 'contact_percent': 100 * result.contacts / n**2, 'file_gigabytes': gap.nbytes / 1e9,
            'seconds': time.perf_counter() - begun, 'cpu_seconds': cpu_seconds() - before, 'products': result.products,
            'peak_gigabytes': peak / 1e9, 'own_gigabytes': (peak - gap.nbytes) / 1e9, 'residual': result.residual}


def run(request):
    store, interpreter = Store(request.json, 'mapped', request.threads), interpreter_memory()
    for n, percents in zip(request.sizes, request.percents):
        if 4 * n * n + HEADROOM > available_memory():
            print(f'{n}^2 is left out: it needs {(4 * n * n + HEADROOM) / 1e9:.1f} GB of memory', file=sys.stderr)
            continue
        with tempfile.TemporaryDirectory(dir=request.folder) as place:
            file = os.path.join(place, 'gap.f32')
            try:
                slope = write_gap(file, n)
            except OSError as error:
                raise Failure(f'{file}: {error}') from None
            answer = in_child(lambda: solve(file, n, slope, percents / 100, request.threads, interpreter))
        store.put('solves', {'n': n, 'percent_wanted': percents}, answer)
    show(COLUMNS, store.rows('solves'))


question('mapped', 'the largest grids, whose gap is a mapped file of floats', run, {
    'sizes': (listed(ranged(int, 256, 131072)), [32768, 65536], 'points per side'),
    'percents': (listed(percent), [0.04, 0.02], 'contact area of each, in percent of the grid'),
    'folder': (folder, tempfile.gettempdir(), 'where the files are written: 4 bytes a point'), **ALL_THREADS},
    {'sizes': [2048], 'percents': [0.1]}, '2048^2')
