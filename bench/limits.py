"""Products with H against a padded transform, and products and solver passes against what memory and in-cache transforms allow."""
import math
import sys

import native
from case import Failure, checked, in_child, repeats
from contact import difference, unit_square
from options import THREADS, listed, question, ranged, threads
from repeated import ColdSolve
from store import Store
from surfaces import self_affine_gap
from tables import show

ROUNDS = 5
TIMES = ('{0}fft [ms]={{{1}estimate_best:m.3g}}; {0}fft, measured plan={{{1}measure_best:m.3g}}; {0}padded [ms]={{{1}padded_estimate_best:m.3g}}; '
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
    runs = {key: [] for key in ('estimate', 'measure', 'padded_estimate', 'padded_measure')}
    for _ in range(ROUNDS):
        for plan in ('estimate', 'measure'):
            ours = native.time_products(unit_square(n), gap, approach, 'fft', plan, count, budget, single, want=gap.size)
            times, expected = padded[plan].time(x, budget)
            runs[plan].append(ours)
            runs['padded_' + plan].append(times)
    best = {key: min(found, key=lambda run: run['best']) for key, found in runs.items()}
    row = {f'{key}_{kind}': best[key][kind] for key in best for kind in ('best', 'median')}
    seconds = {key: found['best'] for key, found in best.items()}
    return {**row, 'padded_measure_planning_seconds': padded['measure'].planning_seconds,
            'ratio_estimate': seconds['padded_estimate'] / seconds['estimate'], 'ratio_measure': seconds['padded_measure'] / seconds['measure'],
            'ratio': seconds['padded_measure'] / seconds['estimate'], 'difference': difference(ours['y'], expected.ravel())}


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
    print('Product with H over the whole grid; ratio: time of the FFT padded to 2n x 2n with measured plans over that of backend fft with\n'
          'estimated ones, in the same precision')
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
        iterations, number = solve.result.iterations, solve.result.applications
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


question('products', 'one product against a transform padded to 2n x 2n', products, {
    'sizes': (listed(ranged(int, 16, 8192)), [128, 256, 512, 1024, 2048], 'points per side'), 'seed': (int, 1, 'of the surface'),
    'threads': (threads, THREADS, 'threads, and one'), 'budget': (float, 2, 'seconds for repeats of each row'),
    'planning_limit': (float, 30, 'seconds for FFTW_MEASURE of the padded transform')},
    {'sizes': [128, 256, 512], 'budget': 0.2, 'planning_limit': 1}, 'up to 512^2, few repeats')
question('limits', 'products and passes against what memory and in-cache transforms allow', limits, {
    'sizes': (listed(ranged(int, 64, 8192)), [1024, 2048, 4096], 'points per side, powers of two'),
    'threads': (threads, THREADS, 'threads, and one'), 'budget': (float, 1, 'seconds for repeats of each measurement')},
    {'sizes': [256], 'budget': 0.05}, '256^2, few repeats')
