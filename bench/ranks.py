"""Contacts shared by ranks. Measured: two ranks of one thread beside one process of two. Simulated: whole solves on modelled networks
(ranks_simulation.py). Computed: a model fitted to both, for grids and ranks that no machine here has."""
import math
import os
import sys
import time

from case import available_memory
from options import listed, one_of, question, ranged, side, threads
from ranks_model import WINDOW, fitted
from ranks_simulation import answer_of, program, simulated
from store import Store
from tables import show

NETWORKS = {'fast': (12.5e9, 1.5e-6), 'slow': (1.25e9, 20e-6)}  # bytes a second, seconds; as in platforms/*.xml
MAPPED = str(1 << 17)  # bytes of a block from which on malloc gives it back, where memory is measured; its own default, which here does not grow
GUESS_BYTES = 120  # a point, where nothing was measured
WAYS = {'process': (1, 2), 'ranks': (2, 1)}  # ranks, threads of each
COLUMNS = 'kind; n; way; ranks; seconds={seconds:.3g}; CPU s={cpu_seconds:.3g}; iterations; products; GB={peak_gigabytes:.3g}; status'
SIMULATED = 'kind; n; network; ranks; seconds={seconds:.3g}; iterations; products; status'


def measured_command(way, n, products):
    ranks, count = WAYS[way]
    return [program('RC_BENCH_MPIEXEC', 'MPI'), '-n', str(ranks), program('RC_BENCH_RANK_SOLVER', 'MPI'), str(n), str(count), way, products]


class Ranks:
    def __init__(self, request):
        self.request, self.begun = request, time.monotonic()
        self.store = Store(request.json, 'ranks', max(count for _, count in WAYS.values()))

    def left(self):
        return 60 * self.request.budget - (time.monotonic() - self.begun)

    def leave_out(self, kind, what, why):
        print(f'{what}: left out, {why}', file=sys.stderr)
        self.store.put('left_out', {'kind': kind, 'what': what}, {'why': why})

    def room(self, kind, what, n, ranks):
        """Whether time and memory are there; else it is told what was left out."""
        known = [row for row in self.store.rows('measured', way='ranks') if 'peak_bytes' in row and row['n'] >= 1024]
        point = max((row['peak_bytes'] / row['n']**2 for row in known), default=GUESS_BYTES)
        need = 1.3 * point * n * n + 3e7 * ranks
        if need > available_memory():
            self.leave_out(kind, what, f'it needs about {need / 1e9:.0f} GB of memory, {available_memory() / 1e9:.0f} GB are free')
            return False
        seconds = [row['wall_seconds'] * (n / row['n'])**2 for row in self.store.rows(kind) if 'wall_seconds' in row and row['n'] <= n]
        if self.left() < min(seconds, default=0):
            self.leave_out(kind, what, f'it takes about {min(seconds):.0f} s, {max(self.left(), 0):.0f} s of the budget are left')
            return False
        return True

    def put(self, kind, key, what, answer):
        self.store.put(kind, key, {'kind': kind, **answer})
        rest = [row for row in self.store.document.get('left_out', []) if not what.startswith(row['what'])]
        self.store.save(left_out=rest)
        print(f'{what}: {answer.get("error") or "{seconds:.3g} s, {products} products".format(**answer)}', file=sys.stderr)

    def measure(self):
        """The least times of runs that alternate."""
        for n in self.request.sizes:
            what = f'{n}^2 on two ranks'
            if all(self.store.known('measured', {'n': n, 'way': way}) for way in WAYS) or not self.room('measured', what, n, 2):
                continue
            best, begun = {}, time.monotonic()
            for k in range(self.request.repeats):
                if k > 0 and self.left() < (time.monotonic() - begun) / k:
                    break
                for way in WAYS:
                    answer = answer_of(measured_command(way, n, 'mixed'), max(self.left(), 60))
                    if way not in best or answer.get('seconds', math.inf) < best[way].get('seconds', math.inf):
                        best[way] = answer
            wall = (time.monotonic() - begun) / 2
            for way, answer in best.items():
                memory = answer_of(measured_command(way, n, 'mixed'), max(self.left(), 60), MALLOC_MMAP_THRESHOLD_=MAPPED)
                answer.update({name: memory[name] for name in ('peak_bytes', 'most_peak_bytes') if name in memory})
            for way, answer in best.items():
                if 'error' not in answer:
                    answer.update(peak_gigabytes=answer['peak_bytes'] / 1e9, wall_seconds=wall)
                self.put('measured', {'n': n, 'way': way}, what if way == 'ranks' else f'{n}^2 in one process', {'ranks': WAYS[way][0], **answer})

    def count(self):
        """What products in double precision send, beside the model's."""
        for n in self.request.sizes[:2]:
            if not self.store.known('counted', {'n': n}):
                self.put('counted', {'n': n}, f'{n}^2, products in double precision', {'ranks': 2, **answer_of(measured_command('ranks', n, 'double'), 600)})

    def simulate(self, n, ranks):
        def key(network):
            return {'n': n, 'ranks': ranks, 'network': network}
        def lacks(network):
            return not self.store.known('simulated', key(network)) or self.store.find('simulated', key(network)).get('runs', 0) < self.request.runs
        missing = [network for network in self.request.networks if lacks(network)]
        what = f'{n}^2 on {ranks} ranks'
        if not missing and self.request.networks or not self.room('simulated', what, n, ranks):
            return
        begun = time.monotonic()
        records = self.request.records and os.path.join(self.request.records, self.store.library)
        answers = simulated(n, ranks, missing, self.request.runs, records, lambda: max(self.left(), 60))
        for network, answer in answers.items():
            self.put('simulated', key(network), f'{what}, {network} network', {**answer, 'window': WINDOW, 'wall_seconds': time.monotonic() - begun})

    def run(self):
        self.measure()
        self.count()
        for ranks in self.request.weak:
            self.simulate(round(1024 * math.sqrt(ranks)), ranks)
        for n in self.request.strong:
            for ranks in self.request.ranks:
                self.simulate(n, ranks)
        self.store.save(model=fitted(self.store.document, NETWORKS))
        show(COLUMNS, self.store.rows('measured'))
        show(SIMULATED, self.store.rows('simulated'))
        for row in self.store.rows('left_out'):
            print(f'left out: {row["what"]}: {row["why"]}')


question('ranks', 'contacts shared by ranks: two ranks here, many on simulated networks, more by a model', lambda request: Ranks(request).run(), {
    'sizes': (listed(side), [1024, 2048, 4096, 8192], 'points a side, measured'),
    'strong': (listed(side), [4096, 8192], 'points a side, simulated'),
    'ranks': (listed(ranged(int, 1, 256)), [1, 4, 16, 64, 256], 'of each of them'),
    'weak': (listed(ranged(int, 1, 256)), [1, 4, 16, 64], 'ranks of 2^20 points each, simulated'),
    'networks': (listed(one_of(*NETWORKS)), list(NETWORKS), 'fast, slow; none: only what --records keeps'),
    'records': (str, '', 'a folder that keeps what was run; a later call takes the least of its own runs and of these'),
    'runs': (ranged(int, 1, 100), 3, 'of what is simulated; the least time of each burst between two exchanges counts'),
    'repeats': (ranged(int, 1, 100), 5, 'of what is measured; the least time counts'),
    'budget': (float, 60, 'minutes after which nothing begins'), 'threads': (threads, 2, 'not more than the cores')},
    {'sizes': [128, 256], 'strong': [256], 'ranks': [1, 4], 'weak': [], 'repeats': 1, 'runs': 2}, '256^2 on four ranks')
