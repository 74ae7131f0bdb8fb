"""Histories of many small contacts in one call, with one thread and with several."""
import sys
import time

import numpy as np
import roughcontact as rc

from case import Failure, cpu_seconds
from contact import OK, unit_square
from options import CONTROLS, THREADS, Question, ranged, threads
from scaling_tables import batch_table
from store import Store
from surfaces import SurfaceClass, below_highest
from tables import show_table

BLOCK = 40  # surfaces that are in memory at a time; one thread and several take turns on them
ROUGH = SurfaceClass('roll-off at 4 waves', hurst=0.8, roll_off=4)


class Total:
    """What one way of solving needed for all blocks."""

    def __init__(self, request, threads):
        self.request, self.threads = request, threads
        self.seconds = self.cpu = self.certified = self.products = 0
        self.status = OK

    def solve(self, gaps, control, targets):
        """Loads [surfaces, steps]."""
        options = {'solver': self.request.solver, 'backend': self.request.backend, 'tol': self.request.tol, 'threads': self.threads}
        begun, cpu = time.perf_counter(), cpu_seconds()
        found = rc.batch(undeformed_gap=gaps, system=unit_square(self.request.points), options=options, check=False, **{control: targets})
        self.seconds += time.perf_counter() - begun
        self.cpu += cpu_seconds() - cpu
        self.certified += found.certified
        self.products += int(np.maximum(found.applications, 0).sum())
        self.status = 'RC_' + found.status.name if self.status == OK else self.status
        return found.load

    def row(self):
        request, solves = self.request, self.request.surfaces * self.request.steps
        same = {key: getattr(request, key) for key in ('steps', 'control', 'solver', 'backend', 'tol')}
        return {'threads': self.threads, 'surfaces': request.surfaces, 'n': request.points, **same, 'seconds': self.seconds,
                'cpu_seconds': self.cpu, 'surfaces_per_second': request.surfaces / self.seconds, 'solves_per_second': solves / self.seconds,
                'products': self.products, 'certified': self.certified, 'status': self.status}


def run(request):
    store = Store(request.json, 'batch', request.threads)
    approaches, one, several = Total(request, request.threads), Total(request, 1), Total(request, request.threads)
    for first in range(0, request.surfaces, BLOCK):
        seeds = range(first + 1, min(first + BLOCK, request.surfaces) + 1)
        gaps = np.stack([below_highest(ROUGH.heights(request.points, seed)) for seed in seeds])
        # Increasing approaches up to half the mean gap, or the loads found there.
        targets = 0.5 * gaps.mean(axis=(1, 2))[:, None] * np.arange(1, request.steps + 1) / request.steps
        if request.control == 'load':
            targets = approaches.solve(gaps, 'displacement', targets)
        order = [one, several] if first // BLOCK % 2 == 0 else [several, one]
        alone, shared = (total.solve(gaps, request.control, targets) for total in order)
        if alone.tobytes() != shared.tobytes():
            raise Failure('loads depend on the number of threads')
        print(f'{seeds[-1]} of {request.surfaces} surfaces', file=sys.stderr)
    rows, scaling, growth = [one.row(), several.row()], one.seconds / several.seconds, several.cpu / one.cpu
    store.document.update(batch=rows, scaling=scaling, cpu_growth=growth)
    store.save()
    show_table(batch_table(store.document))
    print(f'\n{request.threads} threads: {scaling:g} times as fast as one, with {growth:g} of its CPU time')


QUESTION = Question('batch', 'histories of many small contacts in one call, with one thread and with several', run, {
    'surfaces': (ranged(int, 1, 1000000), 1000, 'contacts'), 'points': (ranged(int, 16, 4096), 128, 'points per side'),
    'steps': (ranged(int, 1, 1000), 10, 'of each history'), 'threads': (threads, THREADS, 'threads, against one'),
    'control': (CONTROLS, 'displacement', 'displacement, or load'), 'solver': (str, 'haar-cg', 'by name, or auto'),
    'backend': (str, 'fft', 'by name, or auto'), 'tol': (float, 1e-8, 'certified tolerance')}, {'surfaces': 40}, '40 surfaces')
