"""One product over the whole grid against the usual one: a two-dimensional transform of the grid padded to 2n x 2n."""
import sys

import native
from case import in_child
from contact import difference, unit_square
from options import THREADS, listed, question, ranged, threads
from store import Store
from surfaces import self_affine_gap
from tables import show

ROUNDS = 5
TIMES = ('{0}fft [ms]={{{1}fft_best:m.3g}}; {0}padded [ms]={{{1}padded_estimate_best:m.3g}}; '
         '{0}padded, measured plan={{{1}padded_measure_best:m.3g}}; {0}ratio={{{1}ratio:.2f}}; {0}difference={{{1}difference:err}}')
PADDED = f'grid={{n}}²; threads; {TIMES.format("", "")}; {TIMES.format("single: ", "single_")}'


def product_times(request, n, count, single):
    """The library's product on the whole grid against the padded one, in turns, so that other work on the machine meets both."""
    budget, gap, best = request.budget / (4 * ROUNDS), self_affine_gap(n, request.seed), {}
    approach = 2 * gap.max() - gap.min()  # every point is a candidate
    x = (approach - gap) / (approach - gap.min())
    padded = {plan: native.PaddedProduct(n, count, plan == 'measure', request.planning_limit, single) for plan in ('estimate', 'measure')}
    for _ in range(ROUNDS):
        seconds, y = native.time_products(unit_square(n), gap, approach, 'fft', count, budget, single, gap.size)
        found = {'fft_best': seconds}
        for plan, product in padded.items():
            found[f'padded_{plan}_best'], expected = product.time(x, budget)
        best = {key: min(value, best.get(key, value)) for key, value in found.items()}
    return {**best, 'ratio': best['padded_measure_best'] / best['fft_best'], 'difference': difference(y, expected.ravel())}


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


question('products', 'one product against a transform padded to 2n x 2n', products, {
    'sizes': (listed(ranged(int, 16, 8192)), [128, 256, 512, 1024, 2048], 'points per side'), 'seed': (int, 1, 'of the surface'),
    'threads': (threads, THREADS, 'threads, and one'), 'budget': (float, 2, 'seconds for repeats of each row'),
    'planning_limit': (float, 30, 'seconds for FFTW_MEASURE of the padded transform')},
    {'sizes': [128, 256, 512], 'budget': 0.2, 'planning_limit': 1}, 'up to 512^2, few repeats')
