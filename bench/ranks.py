"""Contacts shared by ranks. Measured: two ranks of one thread beside one process of two. Simulated: whole solves on modelled networks, by SimGrid's
SMPI, which runs the program itself. Computed: a model fitted to both, for grids and ranks that no machine here has."""
import json
import math
import os
import subprocess
import sys
import tempfile
import time

from case import Failure, available_memory
from options import listed, one_of, question, ranged, side, threads
from ranks_model import WINDOW, fitted
from store import Store
from tables import show

ROOT = os.path.dirname(os.path.abspath(__file__))
NETWORKS = {'fast': (12.5e9, 1.5e-6), 'slow': (1.25e9, 20e-6)}  # bytes a second, seconds; as in platforms/*.xml
EXACT = '--cfg=smpi/lat-factor:0:1', '--cfg=smpi/bw-factor:0:1'  # else SMPI has the corrections of another network
MAPPED = str(1 << 20)  # bytes of a block from which on malloc gives it back, where memory is measured
GUESS_BYTES = 120  # a point, where nothing was measured
WAYS = {'process': (1, 2), 'ranks': (2, 1)}  # ranks, threads of each
ENVIRONMENT = {'OMPI_ALLOW_RUN_AS_ROOT': '1', 'OMPI_ALLOW_RUN_AS_ROOT_CONFIRM': '1', 'OMPI_MCA_rmaps_base_oversubscribe': '1',
               'OMPI_MCA_hwloc_base_binding_policy': 'none'}
COLUMNS = 'kind; n; way; ranks; seconds={seconds:.3g}; CPU s={cpu_seconds:.3g}; iterations; products; GB={peak_gigabytes:.3g}; status'
SIMULATED = 'kind; n; network; ranks; seconds={seconds:.3g}; iterations; products; status'


def program(variable, what):
    found = os.environ.get(variable, '')
    if not found:
        raise Failure(f'this build has no {what}')
    return found


def answer_of(command, limit, **environment):
    """The line of JSON that rank_solver prints, or {'error': text}."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, env={**os.environ, **ENVIRONMENT, **environment}, check=False)
    except subprocess.TimeoutExpired:
        return {'error': f'not finished within {limit:.0f} s'}
    lines = [line for line in done.stdout.splitlines() if line.startswith('{')]
    if done.returncode != 0 or not lines:
        return {'error': (done.stderr.strip().splitlines() or [f'exit code {done.returncode}'])[-1][:300]}
    return json.loads(lines[0])


def measured_command(way, n, products):
    ranks, count = WAYS[way]
    return [program('RC_BENCH_MPIEXEC', 'MPI'), '-n', str(ranks), program('RC_BENCH_RANK_SOLVER', 'MPI'), str(n), str(count), way, products]


def simulated_command(network, n, ranks, folder):
    hosts = os.path.join(folder, 'hosts')
    with open(hosts, 'w', encoding='utf-8') as out:
        out.write(''.join(f'node{k}\n' for k in range(ranks)))
    collectives = ['--cfg=smpi/coll-selector:ompi'] if ranks > 1 else []  # which fails on one
    return [program('RC_BENCH_SMPIRUN', "SimGrid's SMPI"), '-np', str(ranks), '-platform', os.path.join(ROOT, 'platforms', f'{network}.xml'),
            '-hostfile', hosts, '--cfg=smpi/host-speed:1Gf', *EXACT, *collectives, '--log=root.thres:error',
            program('RC_BENCH_RANK_SIMULATION', "SimGrid's SMPI"), str(n), '1', 'ranks', 'mixed']


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
        rest = [row for row in self.store.document.get('left_out', []) if row['what'] != what]
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

    def simulate(self, network, n, ranks):
        what = f'{n}^2 on {ranks} ranks, {network} network'
        key = {'n': n, 'ranks': ranks, 'network': network}
        if self.store.known('simulated', key):
            return
        alone = self.store.rows('simulated', n=n, ranks=1)
        if ranks == 1 and alone and 'error' not in alone[0]:  # which sends nothing
            self.put('simulated', key, what, {**alone[0], **key})
            return
        if not self.room('simulated', what, n, ranks):
            return
        with tempfile.TemporaryDirectory() as folder:
            begun = time.monotonic()
            answer = answer_of(simulated_command(network, n, ranks, folder), max(self.left(), 60))
        self.put('simulated', key, what, {**answer, 'window': WINDOW, 'wall_seconds': time.monotonic() - begun})

    def run(self):
        self.measure()
        self.count()
        for ranks in self.request.weak:
            for network in self.request.networks:
                self.simulate(network, round(1024 * math.sqrt(ranks)), ranks)
        for n in self.request.strong:
            for ranks in self.request.ranks:
                for network in self.request.networks:
                    self.simulate(network, n, ranks)
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
    'networks': (listed(one_of(*NETWORKS)), list(NETWORKS), 'fast, slow'),
    'repeats': (ranged(int, 1, 100), 5, 'of what is measured; the least time counts'),
    'budget': (float, 60, 'minutes after which nothing begins'), 'threads': (threads, 2, 'not more than the cores')},
    {'sizes': [128, 256], 'strong': [256], 'ranks': [1, 4], 'weak': [], 'repeats': 1}, '256^2 on four ranks')
