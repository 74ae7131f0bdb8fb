"""One scene solved cold again and again: beside other processes at full load, with results that are bitwise repeatable, and where the processor time
goes, by Linux' perf."""
import contextlib
import hashlib
import os
import re
import subprocess
import sys
import tempfile
import time

import numpy as np
import roughcontact as rc

from case import Failure, checked, in_child
from contact import OK, cold_call, share_in_contact, status_of, unit_square
from options import NAMED, THREADS, listed, percent, question, ranged, side, threads
from scaling import light_load
from store import Store
from surfaces import self_affine_gap
from tables import show

BUSY = ('grid={n}²; contact [%]={contact_percent:.1f}; threads; others; alone [s]={idle_median:s}; beside others [s]={busy_median:s}; '
        'ratio={ratio:.2f}; largest ratio={ratio_largest:.2f}')
DETERMINISTIC = ('grid={n}²; threads; `deterministic`={choice}; median [s]={median:s}; best [s]={best:s}; 1 costs, of medians={cost_median:%+.1f} %; '
                 'of bests={cost_best:%+.1f} %; bits of one thread={same_as_one_thread}; same bits again={same_again}')


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
        self.control, self.target = 'displacement', self.result.displacement

    @property
    def percent(self):
        return 100 * share_in_contact(self.result)


def middle(values):
    return sorted(values)[len(values) // 2]


@contextlib.contextmanager
def spinners(count):
    """Processes that do nothing but use a core each, while this one lives."""
    spin = 'import os\nparent = os.getppid()\nwhile os.getppid() == parent:\n    sum(range(1 << 16))'
    children = [subprocess.Popen([sys.executable, '-c', spin]) for _ in range(count)]
    time.sleep(0.2 if count else 0)  # until they have begun
    try:
        yield
    finally:
        for child in children:
            child.kill()
            child.wait()


def scene_of(request):
    return ColdSolve(request.points, request.percent, request.tol, request.solver, request.backend)


def busy(request):
    store, solve, rows = Store(request.json, 'busy', THREADS), scene_of(request), []
    for count in request.threads:
        solve.seconds(count)  # loads what is loaded once
        idle, loaded = [], []
        for _ in range(request.repeats):
            idle.append(solve.seconds(count))
            with spinners(request.others):
                loaded.append(solve.seconds(count))
        median = middle(idle)
        rows.append({'n': request.points, 'contact_percent': solve.percent, 'tol': request.tol, 'solver': solve.result.solver,
                     'backend': solve.result.backend, 'threads': count, 'others': request.others, 'idle_median': median,
                     'idle_largest': max(idle), 'busy_median': middle(loaded), 'busy_largest': max(loaded), 'ratio': middle(loaded) / median,
                     'ratio_largest': max(loaded) / median, 'idle': idle, 'busy': loaded})
        print(f'{count} threads done', file=sys.stderr)
    print(f'Cold solves alone and beside {request.others} processes at full load; largest ratio: the slowest busy one over the median idle one')
    store.save(busy=rows)
    show(BUSY, rows)


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
    store.save(deterministic=rows)
    show(DETERMINISTIC, rows)


SCENE = {'points': (side, 1024, 'points per side'), 'percent': (percent, 10, 'contact area in percent of the grid, about'),
         'tol': (float, 1e-8, 'certified tolerance'), **NAMED, 'repeats': (ranged(int, 1, 1000), 7, 'of each solve')}
QUICK = {'points': 256, 'repeats': 3}, '256^2, three repeats'
question('busy', 'a solve alone, and beside other processes at full load', busy, {
    **SCENE, 'threads': (listed(threads), [1, 2], 'threads'), 'others': (ranged(int, 0, 1024), 2, 'processes at full load; 0: none')}, *QUICK)
question('deterministic', 'what bitwise repeatable results cost', deterministic, {
    **SCENE, 'threads': (threads, THREADS, 'threads, against one')}, *QUICK)


# The first that matches "library function" counts.
PARTS = (('products: columns', r'rcb_fft\S* .*multiply_columns'),
         ('products: rows (FFTW)', r'libfftw3'),
         ('products: copies, eigenvalues, plans', r'rcb_fft'),
         ('products: split', r'rcb_split'),
         ('products: dense', r'rcb_dense|Eigen::'),
         ('trees', r'libroughcontact\S* .*(HaarTree|haar_tree)'),
         ('vector passes of the solver', r'libroughcontact\S* .*(::(baseline|sse2|avx2|avx512)::|Haar|Iteration<|reduce<)'),
         ('coarser grids', r'libroughcontact\S* .*(downsample|start_nested)'),
         ('trial sets, certificate, bounds, kernel', r'libroughcontact'),
         ('system: memory, threads, copies', r'kernel|libc\.|libstdc|libm\.|ld-linux|\[vdso\]|\[unknown\]'))
OTHERS = re.compile('python|numpy|_ctypes|openblas')  # the scene is made there
PROFILED = ((1024, 10), (2048, 10), (2048, 0.1))


def samples(n, percent, repeats, folder):
    data = os.path.join(folder, 'perf.data')
    command = ['perf', 'record', '-q', '-F', '997', '-o', data, os.path.join(os.environ['RC_BENCH_BUILD'], 'bin', 'roughcontact-bench'), 'busy', '--others', '0',
               '--points', str(n), '--percent', str(percent), '--threads', '2', '--repeats', str(repeats)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return subprocess.run(['perf', 'report', '-i', data, '--stdio', '-q', '--no-children', '--sort', 'dso,symbol', '-F', 'period,dso,symbol'],
                          check=True, capture_output=True, text=True).stdout


def shares(text):
    found = dict.fromkeys([name for name, _ in PARTS] + ['else'], 0)
    for line in text.splitlines():
        match = re.match(r'\s*(\d+)\s+(\S+)\s+\[.\]\s+(.*)', line)
        if match and not OTHERS.search(match[2]):
            line = f'{match[2]} {match[3]}'
            found[next((name for name, pattern in PARTS if re.search(pattern, line)), 'else')] += int(match[1])
    whole = sum(found.values()) or 1
    return {name: count / whole for name, count in found.items() if count}


def profile(request):
    rows = []
    try:
        for n, percent in ((128, 10),) if request.quick else PROFILED:
            with tempfile.TemporaryDirectory() as folder:
                found = shares(samples(n, percent, 2 if request.quick else 10, folder))
            for name, share in sorted(found.items(), key=lambda item: -item[1]):
                rows.append({'scene': f'{n}², {percent:g} %', 'part': name, 'share': share})
                print(f'{n:6} {percent:5g} %  {100 * share:5.1f} %  {name}')
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        print(f'profile: perf is not there or may not be used: {error}', file=sys.stderr)
        return
    Store(request.json, 'profile', 2).save(rows=rows)


question('profile', "where the processor time of a cold solve goes, by Linux' perf", profile, {}, {}, 'one small solve')
