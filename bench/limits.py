"""Products with H against a padded transform, products and solver passes against what memory and in-cache transforms allow; one scene solved cold
again and again: beside other processes, with results that are bitwise repeatable, and where the processor time goes, by Linux' perf."""
import contextlib
import hashlib
import math
import os
import re
import subprocess
import sys
import tempfile
import time
from statistics import median

import numpy as np

import native
from case import Failure, checked, in_child, repeats
from contact import OK, cold_call, difference, share_in_contact, status_of, unit_square
from options import NAMED, THREADS, listed, percent, question, ranged, side, threads
from scaling import light_load
from store import Store
from surfaces import self_affine_gap
from tables import show

ROUNDS = 5
TIMES = ('{0}fft [ms]={{{1}fft_best:m.3g}}; {0}padded [ms]={{{1}padded_estimate_best:m.3g}}; '
         '{0}padded, measured plan={{{1}padded_measure_best:m.3g}}; {0}ratio={{{1}ratio:.2f}}; {0}difference={{{1}difference:err}}')
PADDED = f'grid={{n}}²; threads; {TIMES.format("", "")}; {TIMES.format("single: ", "single_")}'
MACHINE = 'limit; precision; threads; measured'
PRODUCTS = ('grid={n}²; precision; threads; operations/point={operations_per_point:.0f}; bytes/point={bytes_per_point:.0f}; '
            'measured [ms]={seconds:m.3g}; by operations [ms]={operation_seconds:m.3g}; by bytes [ms]={byte_seconds:m.3g}; GFlop/s={gigaflops:.1f}; '
            'GB/s={gigabytes_per_second:.1f}; fraction={fraction:.2f}')
PASSES = ('grid={n}²; precision; threads; iterations; products; solve [ms]={seconds:m.3g}; in products [ms]={product_seconds:m.3g}; '
          'besides [ms]={other_seconds:m.3g}; trees [bytes/point]={tree_bytes_per_point:.0f}; vectors [bytes/point]={vector_bytes_per_point:.0f}; '
          'by bytes [ms]={byte_seconds:m.3g}; fraction={fraction_of_bandwidth:.2f}')


def machine_rows(document):
    memory = [{**row, 'limit': 'memory, triad', 'precision': '', 'measured': f'{row["gigabytes_per_second"]:.1f} GB/s'}
              for row in document['bandwidth']]
    return memory + [{**row, 'limit': f'complex transform of {row["length"]}', 'measured': f'{row["gigaflops"]:.1f} GFlop/s'}
                     for row in document['transforms']]


def product_times(request, n, count, single):
    """The library's product on the whole grid against the padded one, in turns, so that other work on the machine meets both."""
    budget, gap = request.budget / (4 * ROUNDS), self_affine_gap(n, request.seed)
    approach = 2 * gap.max() - gap.min()  # every point is a candidate
    x = (approach - gap) / (approach - gap.min())
    padded = {plan: native.PaddedProduct(n, count, plan == 'measure', request.planning_limit, single) for plan in ('estimate', 'measure')}
    runs = {key: [] for key in ('fft', 'padded_estimate', 'padded_measure')}
    for _ in range(ROUNDS):
        ours = native.time_products(unit_square(n), gap, approach, 'fft', count, budget, single, want=gap.size)
        runs['fft'].append(ours)
        for plan in ('estimate', 'measure'):
            times, expected = padded[plan].time(x, budget)
            runs['padded_' + plan].append(times)
    best = {key: min(found, key=lambda run: run['best']) for key, found in runs.items()}
    row = {f'{key}_{kind}': best[key][kind] for key in best for kind in ('best', 'median')}
    seconds = {key: found['best'] for key, found in best.items()}
    return {**row, 'padded_measure_planning_seconds': padded['measure'].planning_seconds,
            'ratio': seconds['padded_measure'] / seconds['fft'], 'difference': difference(ours['y'], expected.ravel())}


def products(request):
    store, rows = Store(request.json, 'products', request.threads), []
    for n in request.sizes:
        for count in sorted({1, request.threads}):
            print(f'products on {n}^2, {count} threads', file=sys.stderr)

            def work():
                single = product_times(request, n, count, True)
                return {**product_times(request, n, count, False), **{'single_' + key: value for key, value in single.items()}}

            rows.append({'n': n, 'threads': count, **in_child(work)})
    store.save(products=rows)
    print('Product with H over the whole grid; ratio: time of the FFT padded to 2n x 2n with measured plans over that of backend fft,\n'
          'in the same precision')
    show(PADDED, rows)


def product_operations(n):
    """Of one product over n x n points by transforms of length P = 2n, docs/performance.md. Rows: n real transforms of 5/2 P log2 P forward
    and as many back. Columns: n + 1 complex ones of 5 P log2 P forward and back, and 2 P products with eigenvalues each."""
    length = 2 * n
    line = 5 * length * math.log2(length)
    return n * line + (n + 1) * (2 * line + 2 * length)


def product_values(n):
    """x read, half spectra of rows written; those read and written again by the columns, eigenvalues read; half spectra read, y written."""
    return n * n + 2 * n * (n + 1) + (4 * n * (n + 1) + (n + 1)**2) + 2 * n * (n + 1) + n * n


def pass_bytes(real):
    """(trees, vectors): what the solver's own passes read and write for a point and an iteration, docs/performance.md."""
    # Two trees, applied side by side: residuals and the contact set read going up and going down, z written, q read; loads of the
    # finest blocks written and pressures read; on the coarser levels, with a twelfth of the points, blocks of 20 bytes and values.
    applied = 4 * real + 6 + 2 * (2 * 20 / 12 + 4)
    set_up = (3 + 2 * (20 / 12 + 2)) / 2  # every second iteration: the contact set read, blocks written
    turn, curvature, advance = 4 * real + 1, 2 * real, 16 + 4 * real
    # Every second iteration: what was cut off, the residual with its measures, the choice of the contact set.
    bound = (real + (3 * real + 16) + (8 + real + 2)) / 2
    return applied + set_up, turn + curvature + advance + bound


class Limits:
    def __init__(self, request):
        self.request, self.threads = request, sorted({1, request.threads})
        self.bandwidth, self.transforms = {}, {}

    def measure_machine(self):
        values = 1 << 20 if self.request.quick else 1 << 24  # three arrays of 128 MiB fit in no cache
        bandwidth, transforms = [], []
        for count in self.threads:  # counted as McCalpin's STREAM does: two reads and a write
            self.bandwidth[count] = 24 * values / native.time_triad(values, count, self.request.budget) / 1e9
            bandwidth.append({'threads': count, 'megabytes': 24 * values / 1e6, 'gigabytes_per_second': self.bandwidth[count]})
        for length in (2 * n for n in self.request.sizes):
            for count in self.threads:
                for precision in ('single', 'double'):  # 5 n log2 n operations for each complex transform
                    times = max(1, (1 << 21) // length)
                    seconds = native.time_transform(length, times, count, self.request.budget, precision == 'single')
                    speed = 5 * length * times * count * math.log2(length) / seconds / 1e9
                    self.transforms[length, precision, count] = speed
                    transforms.append({'length': length, 'precision': precision, 'threads': count, 'gigaflops': speed})
        return {'bandwidth': bandwidth, 'transforms': transforms}

    def of_grid(self, n):
        solve = ColdSolve(n, 10, 1e-3, 'haar-cg', 'fft')
        solve.seconds(self.threads[-1])
        solve.prescribe_approach()
        rows = {'products': [], 'passes': []}
        for count in self.threads:
            timed = {precision: self.product(n, solve.gap, count, precision) for precision in ('double', 'single')}
            rows['products'] += timed.values()
            rows['passes'] += [self.passes(solve, count, precision, timed) for precision in timed]
        return rows

    def product(self, n, gap, count, precision):
        times = native.time_products(unit_square(n), gap, 2 * gap.max() - gap.min(), 'fft', threads=count, budget=self.request.budget,
                                     single=precision == 'single')
        seconds = times['best']
        operations, size = product_operations(n), product_values(n) * (4 if precision == 'single' else 8)
        by_flops, by_bytes = operations / self.transforms[2 * n, precision, count] / 1e9, size / self.bandwidth[count] / 1e9
        return {'n': n, 'precision': precision, 'threads': count, 'operations_per_point': operations / n**2, 'bytes_per_point': size / n**2,
                'seconds': seconds, 'operation_seconds': by_flops, 'byte_seconds': by_bytes, 'gigaflops': operations / seconds / 1e9,
                'gigabytes_per_second': size / seconds / 1e9, 'fraction_of_transforms': by_flops / seconds,
                'fraction_of_bandwidth': by_bytes / seconds, 'fraction': max(by_flops, by_bytes) / seconds}

    def passes(self, solve, count, precision, timed):
        """What a solve takes besides its products. In single precision two are in double: the one that confirms, and the certificate's."""
        single = precision == 'single'
        options = {'haar-cg.nested': 0, 'haar-cg.products': 'mixed' if single else 'double'}
        solve.seconds(count, **options)
        best = min(repeats(lambda: solve.seconds(count, **options), self.request.budget, most=1000))
        iterations, number = solve.result.iterations, solve.result.products
        in_products = number * timed['double']['seconds']
        if single:
            in_products = 2 * timed['double']['seconds'] + (number - 2) * timed['single']['seconds']
        trees, vectors = pass_bytes(4 if single else 8)
        by_bytes = (trees + vectors) * iterations * solve.n**2 / self.bandwidth[count] / 1e9
        return {'n': solve.n, 'precision': precision, 'threads': count, 'iterations': iterations, 'products': number, 'seconds': best,
                'product_seconds': in_products, 'other_seconds': best - in_products, 'share_of_products': in_products / best,
                'tree_bytes_per_point': trees,
                'vector_bytes_per_point': vectors, 'byte_seconds': by_bytes, 'fraction_of_bandwidth': by_bytes / (best - in_products)}


def limits(request):
    if any(n & (n - 1) for n in request.sizes):
        raise Failure('the counts hold for powers of two only')
    store, measured = Store(request.json, 'limits', request.threads), Limits(request)
    found = {**measured.measure_machine(), 'products': [], 'passes': []}
    for n in request.sizes:
        print(f'products and passes on {n}^2', file=sys.stderr)
        for name, rows in checked(in_child(lambda: measured.of_grid(n))).items():
            found[name] += rows
    store.save(**found)
    print('Memory: triad; complex transforms in the cache, FFTW, measured plans')
    show(MACHINE, machine_rows(found))
    print('\nOne product over the whole grid')
    show(PRODUCTS, found['products'])
    print('\nA cold solve to 1e-3 without coarser grids; besides: trees, passes over vectors, set-up, certificate')
    show(PASSES, found['passes'])


BUSY = ('grid={n}²; contact [%]={contact_percent:.1f}; threads; others; alone [s]={idle_median:s}; beside others [s]={busy_median:s}; '
        'ratio={ratio:.2f}; largest ratio={ratio_largest:.2f}')
DETERMINISTIC = ('grid={n}²; threads; `deterministic`={choice}; median [s]={median:s}; best [s]={best:s}; '
                 '1 costs, of medians={cost_median:%+.1f} %; of bests={cost_best:%+.1f} %; bits of one thread={same_as_one_thread}; '
                 'same bits again={same_again}')


class ColdSolve:
    """In load control at first, with a share of the grid in contact, about."""

    def __init__(self, n, percent, tol, solver='auto', backend='auto'):
        self.n, self.options = n, {'solver': solver, 'backend': backend, 'tol': tol}
        self.gap, self.pressure = self_affine_gap(n), np.zeros((n, n))
        self.control, self.target, self.result = 'load', light_load(percent / 100), None

    def seconds(self, threads, **more):
        """Seconds of a whole call, its set-up included, with these options besides the scene's. cpu: its processor time."""
        self.result, seconds, self.cpu = cold_call(unit_square(self.n), self.gap, {**self.options, 'threads': threads, **more}, self.control,
                                            self.target, self.pressure)
        if status_of(self.result) != OK:
            raise Failure('not certified: ' + self.result.note)
        return seconds

    def prescribe_approach(self):
        """From now on the approach that the last solve found is prescribed instead of the load."""
        self.control, self.target = 'approach', self.result.approach

    @property
    def percent(self):
        return 100 * share_in_contact(self.result)


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
        usual = median(idle)
        rows.append({'n': request.points, 'contact_percent': solve.percent, 'tol': request.tol, 'solver': solve.result.solver,
                     'backend': solve.result.backend, 'threads': count, 'others': request.others, 'idle_median': usual,
                     'idle_largest': max(idle), 'busy_median': median(loaded), 'busy_largest': max(loaded), 'ratio': median(loaded) / usual,
                     'ratio_largest': max(loaded) / usual, 'idle': idle, 'busy': loaded})
        print(f'{count} threads done', file=sys.stderr)
    print(f'Cold solves alone and beside {request.others} processes at full load; largest ratio: the slowest busy one over the median idle one')
    store.save(busy=rows)
    show(BUSY, rows)


CHOICES = {'1': {'deterministic': 1}, '0': {'deterministic': 0}}


def first(request):
    def work(n):
        solve = ColdSolve(n, request.percent, request.tol)
        return [1e3 * solve.cpu for _ in range(2) if solve.seconds(1)]
    rows = []
    for n in request.sizes:
        runs = [checked(in_child(lambda n=n: work(n))) for _ in range(request.repeats)]
        rows.append({'n': n, 'first': median(run[0] for run in runs), 'second': median(run[1] for run in runs),
                     'more': median(run[0] - run[1] for run in runs)})
    Store(request.json, 'first', 1).save(rows=rows)
    print('Processor time [ms] of the first solve of a process and of the same again, medians')
    show('grid={n}²; first={first:.2f}; second={second:.2f}; difference={more:.2f}', rows)


def deterministic(request):
    store, solve, rows, one_thread = Store(request.json, 'deterministic', THREADS), scene_of(request), [], {}

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
                         'choice': choice, 'median': median(times[choice]), 'best': min(times[choice]),
                         'cost_median': median(times['1']) / median(times[choice]) - 1, 'cost_best': min(times['1']) / min(times[choice]) - 1,
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
question('first', 'what the first solve of a process takes more than the second', first, {
    'sizes': (listed(side), [16, 32, 64, 128], 'points per side'), 'percent': SCENE['percent'], 'tol': SCENE['tol'],
    'repeats': (ranged(int, 1, 1000), 15, 'processes for each size')}, {'sizes': [32], 'repeats': 3}, '32^2, three processes')
question('deterministic', 'what bitwise repeatable results cost', deterministic, {
    **SCENE, 'threads': (threads, THREADS, 'threads, against one')}, *QUICK)


# The first that matches "library function" counts.
PARTS = (('products: passes', r'rcb_fft\S* .*(Builds|avx)'),
         ('products: other', r'rcb_fft'), ('products: split', r'rcb_split'),
         ('products: dense', r'rcb_dense|Eigen::'), ('trees', r'libroughcontact\S* .*(HaarTree|haar_tree)'),
         ('vector passes of the solver', r'libroughcontact\S* .*(::(baseline|sse2|avx2|avx512)::|Haar|Iteration<|reduce<)'),
         ('coarser grids', r'libroughcontact\S* .*(downsample|start_nested)'), ('trial sets, certificate, bounds, kernel', r'libroughcontact'),
         ('system: memory, threads, copies', r'kernel|libc\.|libstdc|libm\.|ld-linux|\[vdso\]|\[unknown\]'))
OTHERS = re.compile('python|numpy|_ctypes|openblas')  # the scene is made there
PROFILED = ((1024, 10), (2048, 10), (2048, 0.1))


def samples(n, percent, repeats, folder):
    data = os.path.join(folder, 'perf.data')
    program = os.path.join(os.environ['RC_BENCH_BUILD'], 'bin', 'roughcontact-bench')
    command = ['perf', 'record', '-q', '-F', '997', '-o', data, program, 'busy', '--others', '0',
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


question('products', 'one product against a transform padded to 2n x 2n', products, {
    'sizes': (listed(ranged(int, 16, 8192)), [128, 256, 512, 1024, 2048], 'points per side'), 'seed': (int, 1, 'of the surface'),
    'threads': (threads, THREADS, 'threads, and one'), 'budget': (float, 2, 'seconds for repeats of each row'),
    'planning_limit': (float, 30, 'seconds for FFTW_MEASURE of the padded transform')},
    {'sizes': [128, 256, 512], 'budget': 0.2, 'planning_limit': 1}, 'up to 512^2, few repeats')
question('limits', 'products and passes against what memory and in-cache transforms allow', limits, {
    'sizes': (listed(ranged(int, 64, 8192)), [1024, 2048, 4096], 'points per side, powers of two'),
    'threads': (threads, THREADS, 'threads, and one'), 'budget': (float, 1, 'seconds for repeats of each measurement')},
    {'sizes': [256], 'budget': 0.05}, '256^2, few repeats')
