"""Loading histories, and those of many small contacts in one call, with one thread and with several."""
import sys
import time

import numpy as np
import roughcontact as rc

from case import Failure, cpu_seconds
from contact import status_of, unit_square
from options import CONTROLS, THREADS, question, ranged, threads
from store import Store
from surfaces import SurfaceClass, below_highest, midpoint_surface
from tables import show


class History:
    """Increasing approaches, down to half of the height of the highest point above the mean, on a midpoint displacement surface."""

    def __init__(self, levels, hurst, seed, steps):
        self.n, self.gap = 1 << levels, below_highest(midpoint_surface(levels, hurst, seed))
        self.approaches = [self.gap.mean() / 2 * k / steps for k in range(1, steps + 1)]

    def run(self, options, warm):
        """[(result, processor time)] of the steps; the first that runs out of time is the last."""
        found = []
        with rc.Contact(unit_square(self.n), options=options) as contact:
            for k, approach in enumerate(self.approaches):
                before = cpu_seconds()
                result = contact.solve(approach=approach, undeformed_gap=None if warm and k else self.gap, warm_start=warm, want_pressure=False,
                                       check=False)
                found.append((result, cpu_seconds() - before))
                if status_of(result) == 'RC_STOP_TIME':
                    break  # the later steps are no shorter
                if not warm:
                    contact.reset()
        return found


BLOCK = 40  # surfaces that are in memory at a time; one thread and several take turns on them
BATCH = ('threads; surfaces; grid={n}²; steps; control; time [s]={seconds:s}; surfaces/s={surfaces_per_second:.1f}; '
           'solves/s={solves_per_second:.0f}; products; certified')
ROUGH = SurfaceClass('roll-off at 4 waves', hurst=0.8, roll_off=4)


class Total:
    """What one way of solving needed for all blocks."""

    def __init__(self, request, threads):
        self.request, self.threads = request, threads
        self.seconds = self.certified = self.products = 0

    def solve(self, gaps, control, targets):
        """Loads [surfaces, steps]."""
        options = {'solver': 'haar-cg', 'backend': 'fft', 'tol': self.request.tol, 'threads': self.threads}
        begun = time.perf_counter()
        found = rc.batch(undeformed_gap=gaps, system=unit_square(self.request.points), options=options, check=False, **{control: targets})
        self.seconds += time.perf_counter() - begun
        self.certified += found.certified
        self.products += int(np.maximum(found.products, 0).sum())
        return found.load

    def row(self):
        request, solves = self.request, self.request.surfaces * self.request.steps
        return {'threads': self.threads, 'surfaces': request.surfaces, 'n': request.points, 'steps': request.steps, 'control': request.control,
                'seconds': self.seconds, 'surfaces_per_second': request.surfaces / self.seconds, 'solves_per_second': solves / self.seconds,
                'products': self.products, 'certified': self.certified}


def run_batch(request):
    store = Store(request.json, 'batch', request.threads)
    approaches, one, several = Total(request, request.threads), Total(request, 1), Total(request, request.threads)
    for first in range(0, request.surfaces, BLOCK):
        seeds = range(first + 1, min(first + BLOCK, request.surfaces) + 1)
        gaps = np.stack([below_highest(ROUGH.heights(request.points, seed)) for seed in seeds])
        # Increasing approaches up to half the mean gap, or the loads found there.
        targets = 0.5 * gaps.mean(axis=(1, 2))[:, None] * np.arange(1, request.steps + 1) / request.steps
        if request.control == 'load':
            targets = approaches.solve(gaps, 'approach', targets)
        order = [one, several] if first // BLOCK % 2 == 0 else [several, one]
        alone, shared = (total.solve(gaps, request.control, targets) for total in order)
        if alone.tobytes() != shared.tobytes():
            raise Failure('loads depend on the number of threads')
        print(f'{seeds[-1]} of {request.surfaces} surfaces', file=sys.stderr)
    rows, scaling = [one.row(), several.row()], one.seconds / several.seconds
    store.save(batch=rows, scaling=scaling)
    show(BATCH, rows)
    print(f'\n{request.threads} threads: {scaling:g} times as fast as one')


question('batch', 'histories of many small contacts in one call, with one thread and with several', run_batch, {
    'surfaces': (ranged(int, 1, 1000000), 1000, 'contacts'), 'points': (ranged(int, 16, 4096), 128, 'points per side'),
    'steps': (ranged(int, 1, 1000), 10, 'of each history'), 'threads': (threads, THREADS, 'threads, against one'),
    'control': (CONTROLS, 'approach', 'approach, or load'), 'tol': (float, 1e-8, 'certified tolerance')}, {'surfaces': 40}, '40 surfaces')
