"""One scene solved cold again and again: what surrounds a solve. Other processes at full load, and results that are bitwise repeatable."""
import hashlib
import os
import signal
import sys
import time

import numpy as np
import roughcontact as rc

from case import Failure, checked, in_child
from contact import OK, cold_call, share_in_contact, status_of, unit_square
from options import THREADS, Question, listed, percent, ranged, side, threads
from scaling import light_load
from scaling_tables import busy_table, deterministic_table
from store import Store
from surfaces import self_affine_gap
from tables import show_table


class ColdSolve:
    """In load control at first, with a share of the grid in contact, about."""

    def __init__(self, n, percent, tol, solver='auto', backend='auto'):
        self.n, self.options = n, {'solver': solver, 'backend': backend, 'tol': tol}
        self.gap, self.pressure = self_affine_gap(n), np.zeros((n, n))
        self.control, self.target, self.result = 'load', light_load(percent / 100), None

    def seconds(self, threads, **more):
        """Seconds of a whole call, its set-up included, with these options besides the scene's."""
        self.result, seconds, _ = cold_call(unit_square(self.n), self.gap, {**self.options, 'threads': threads, **more}, self.control,
                                            self.target, self.pressure)
        if status_of(self.result) != OK:
            raise Failure('not certified: ' + self.result.note)
        return seconds

    def prescribe_approach(self):
        """From now on the approach that the last solve found is prescribed instead of the load."""
        self.control, self.target = 'displacement', self.result.approach

    @property
    def percent(self):
        return 100 * share_in_contact(self.result)


def middle(values):
    return sorted(values)[len(values) // 2]


class Spinners:
    """Processes that do nothing but use a core each."""

    def __init__(self, count):
        self.children = [self.spin() for _ in range(count)]
        time.sleep(0.05)  # until the scheduler has given them their cores

    @staticmethod
    def spin():
        parent, child = os.getpid(), os.fork()
        while child == 0 and os.getppid() == parent:
            for _ in range(1 << 16):
                pass
        if child == 0:
            os._exit(0)
        return child

    def __enter__(self):
        return self

    def __exit__(self, *error):
        for child in self.children:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)


def scene_of(request):
    return ColdSolve(request.points, request.percent, request.tol, request.solver, request.backend)


def busy(request):
    store, solve, rows = Store(request.json, 'busy', THREADS), scene_of(request), []
    for count in request.threads:
        solve.seconds(count)  # loads what is loaded once
        idle, loaded = [], []
        for _ in range(request.repeats):
            idle.append(solve.seconds(count))
            with Spinners(request.others):
                loaded.append(solve.seconds(count))
        median = middle(idle)
        rows.append({'n': request.points, 'contact_percent': solve.percent, 'tol': request.tol, 'solver': solve.result.solver,
                     'backend': solve.result.backend, 'threads': count, 'others': request.others, 'idle_median': median,
                     'idle_largest': max(idle), 'busy_median': middle(loaded), 'busy_largest': max(loaded), 'ratio': middle(loaded) / median,
                     'ratio_largest': max(loaded) / median, 'idle': idle, 'busy': loaded})
        print(f'{count} threads done', file=sys.stderr)
    print(f'Cold solves alone and beside {request.others} processes at full load; largest ratio: the slowest busy one over the median idle one')
    store.document['busy'] = rows
    store.save()
    show_table(busy_table(store.document))


# What may be left out with results that need not repeat: nothing, or plans by measurement too.
CHOICES = {'1': {'deterministic': 1}, '0': {'deterministic': 0}, '0, measured plans': {'deterministic': 0, 'fft.planning': 'measure'}}


def deterministic(request):
    store, solve, rows, one_thread = Store(request.json, 'deterministic', THREADS), scene_of(request), [], {}
    if not any(option.key == 'deterministic' for option in rc.options()):
        raise Failure('this library has no option "deterministic"')

    def twice(count, options):
        """In a process of their own, so that plans of other choices are not known: the first also loads and plans."""
        seconds, bits = [], []
        for _ in range(2):
            seconds.append(solve.seconds(count, **options))
            bits.append(hashlib.blake2b(solve.pressure.tobytes(), digest_size=8).hexdigest())
        return {'seconds': seconds[1], 'contact_percent': solve.percent, 'bits': bits}

    for count in sorted({1, request.threads}):
        runs = {choice: [] for choice in CHOICES}
        for _ in range(request.repeats):  # in turns, so that other work on the machine meets all of them
            for choice, options in CHOICES.items():
                runs[choice].append(checked(in_child(lambda options=options: twice(count, options))))
        times = {choice: [run['seconds'] for run in found] for choice, found in runs.items()}
        for choice, found in runs.items():
            first = found[0]['bits'][0]
            one_thread.setdefault(choice, first)
            rows.append({'n': request.points, 'contact_percent': found[-1]['contact_percent'], 'tol': request.tol, 'threads': count,
                         'choice': choice, 'median': middle(times[choice]), 'best': min(times[choice]),
                         'cost_median': middle(times['1']) / middle(times[choice]) - 1, 'cost_best': min(times['1']) / min(times[choice]) - 1,
                         'same_as_one_thread': 'yes' if one_thread[choice] == first else 'no',
                         'same_again': 'yes' if all(bits == first for run in found for bits in run['bits']) else 'no'})
        print(f'{count} threads done', file=sys.stderr)
    store.document['deterministic'] = rows
    store.save()
    show_table(deterministic_table(store.document))


SCENE = {'points': (side, 1024, 'points per side'), 'percent': (percent, 10, 'contact area in percent of the grid, about'),
         'tol': (float, 1e-8, 'certified tolerance'), 'solver': (str, 'auto', 'by name, or auto'), 'backend': (str, 'auto', 'by name, or auto'),
         'repeats': (ranged(int, 1, 1000), 7, 'of each solve')}
QUICK = {'points': 256, 'repeats': 3}, '256^2, three repeats'
BUSY = Question('busy', 'a solve alone, and beside other processes at full load', busy, {
    **SCENE, 'threads': (listed(threads), [1, 2], 'threads'), 'others': (ranged(int, 0, 1024), 2, 'processes at full load; 0: none')}, *QUICK)
DETERMINISTIC = Question('deterministic', 'what bitwise repeatable results cost', deterministic, {
    **SCENE, 'threads': (threads, THREADS, 'threads, against one')}, *QUICK)
