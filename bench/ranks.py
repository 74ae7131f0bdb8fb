"""Contacts shared by ranks. Measured: two ranks of one thread beside one process of two. Simulated: whole solves on modelled networks
(ranks_simulation.py)."""
import math
import os
import sys

from options import listed, question, ranged, side, threads
from ranks_simulation import answer_of, program, simulated
from ranks_tables import NETWORKS, PAIRS, SIMULATED, pairs, simulations
from store import Store
from tables import show

MAPPED = str(1 << 17)  # bytes of a block from which on malloc gives it back, where memory is measured; its own default, which here does not grow
LIMIT = 3600  # seconds of one run
WAYS = {'process': (1, 2), 'ranks': (2, 1)}  # ranks, threads of each


def measured_command(way, n, products):
    ranks, count = WAYS[way]
    return [program('RC_BENCH_MPIEXEC', 'MPI'), '-n', str(ranks), program('RC_BENCH_RANK_SOLVER', 'MPI'), str(n), str(count), way, products]


class Ranks:
    def __init__(self, request):
        self.request = request
        self.store = Store(request.json, 'ranks', max(count for _, count in WAYS.values()))

    def put(self, kind, key, what, answer):
        self.store.put(kind, key, {'kind': kind, **answer})
        print(f'{what}: {answer.get("error") or "{seconds:.3g} s, {products} products".format(**answer)}', file=sys.stderr)

    def measure(self):
        """The least times of runs that alternate."""
        for n in self.request.sizes:
            what = f'{n}^2 on two ranks'
            if all(self.store.known('measured', {'n': n, 'way': way}) for way in WAYS):
                continue
            best = {}
            for _ in range(self.request.repeats):
                for way in WAYS:
                    answer = answer_of(measured_command(way, n, 'mixed'), LIMIT)
                    if way not in best or answer.get('seconds', math.inf) < best[way].get('seconds', math.inf):
                        best[way] = answer
            for way, answer in best.items():
                memory = answer_of(measured_command(way, n, 'mixed'), LIMIT, MALLOC_MMAP_THRESHOLD_=MAPPED)
                answer.update({'peak_bytes': memory['peak_bytes']} if 'peak_bytes' in memory else {})
                self.put('measured', {'n': n, 'way': way}, what if way == 'ranks' else f'{n}^2 in one process', {'ranks': WAYS[way][0], **answer})

    def count(self):
        """What products in double precision send."""
        for n in self.request.sizes[:2]:
            if not self.store.known('counted', {'n': n}):
                self.put('counted', {'n': n}, f'{n}^2, products in double precision', {'ranks': 2, **answer_of(measured_command('ranks', n, 'double'), LIMIT)})

    def simulate(self, n, ranks):
        keys = {network: {'n': n, 'ranks': ranks, 'network': network} for network in NETWORKS}
        missing = [network for network, key in keys.items() if (self.store.measured('simulated', key) or {}).get('runs', 0) < self.request.runs]
        if not missing:
            return
        records = self.request.records and os.path.join(self.request.records, self.store.library)
        answers = simulated(n, ranks, missing, self.request.runs, records, LIMIT)
        for network, answer in answers.items():
            self.put('simulated', keys[network], f'{n}^2 on {ranks} ranks, {network} network', answer)

    def run(self):
        self.measure()
        self.count()
        for ranks in self.request.weak:
            self.simulate(round(1024 * math.sqrt(ranks)), ranks)
        for n in self.request.strong:
            for ranks in self.request.ranks:
                self.simulate(n, ranks)
        self.store.save()
        show(PAIRS, pairs(self.store.document))
        for weak in (False, True):
            show(SIMULATED, simulations(self.store.document, weak))


question('ranks', 'contacts shared by ranks: two ranks here, many on simulated networks', lambda request: Ranks(request).run(), {
    'sizes': (listed(side), [1024, 2048, 4096, 8192], 'points a side, measured'),
    'strong': (listed(side), [4096], 'points a side, simulated'),
    'ranks': (listed(ranged(int, 1, 256)), [1, 4, 16, 64], 'of each of them'),
    'weak': (listed(ranged(int, 1, 256)), [1, 4, 16], 'ranks of 2^20 points each, simulated'),
    'records': (str, '', 'a folder that keeps what was run; a later call takes the least of its own runs and of these'),
    'runs': (ranged(int, 1, 100), 3, 'of what is simulated; the least time of each burst between two exchanges counts'),
    'repeats': (ranged(int, 1, 100), 5, 'of what is measured; the least time counts'),
    'threads': (threads, 2, 'not more than the cores')},
    {'sizes': [128, 256], 'strong': [256], 'ranks': [1, 4], 'weak': [], 'repeats': 1, 'runs': 2}, '256^2 on four ranks')
