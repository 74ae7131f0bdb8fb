"""The claims of Bemporad & Paggi (2015) beside what paper.json says of them."""
from paper_rows import BEST_OF_PAPER, rows
from samples import median, median_interval, ratios, values_of
from tables import table


def some(parts, between='; '):
    if not parts:
        raise LookupError
    return between.join(parts)


def said(claim, *given):
    """What the results say, or that they have nothing to say it from."""
    try:
        return claim(*given)
    except (LookupError, ValueError, StopIteration, ZeroDivisionError):
        return 'not measured yet'


def figure(value):
    return f'{value:.2g}' if value < 10 else f'{value:.0f}'


def spread(values, scale=1, unit=''):
    middle, low, high = (scale * value for value in median_interval(values))
    return f'{figure(middle)}{unit} ({figure(low)} to {figure(high)})' if len(values) > 1 else f'{figure(middle)}{unit}'


class Claims:
    def __init__(self, document):
        self.document = document

    def share(self, n):
        found = rows(self.document, 'example_1', kernel='eq9', spacing=1, n=n)
        return f'n = {n}: {100 * found[0]["share"]:.0f} %' if found else None

    def fails_often(self):
        shares = [text for text in map(self.share, (25, 100, 400, 900)) if text]
        return f'yes, with kernel `eq9`: {some(shares, ", ")}'

    def never_elsewhere(self):
        found = [r for r in rows(self.document, 'example_1') if r['kernel'] != 'eq9' or r['spacing'] == 2]
        spaced = [r for r in found if r['spacing'] == 2]
        others = [r for r in found if r['spacing'] == 1]
        return (f'yes: {sum(r["failures"] for r in spaced)} of {sum(r["draws"] for r in spaced)} draws; at a spacing of 1 with '
                f'{some([f"`{r}`" for r in values_of(others, "kernel")], ", ")} {sum(r["failures"] for r in others)} of '
                f'{sum(r["draws"] for r in others)}')

    def smooth_never(self):
        found = {r['kernel']: r for r in rows(self.document, 'smooth', shape='spheres between the points')}
        counts = some([f'{r["failures"]} of {r["draws"]} spheres with `{kernel}`' for kernel, r in found.items()], ', ')
        return ('not always: ' if any(r['failures'] for r in found.values()) else 'yes: ') + counts

    def speed(self, slower, factor):
        """How much longer than NNLS with gradient steps, by setting."""
        parts = []
        for setting, words in (('small', 'dense products'), ('dense', 'dense products, larger'), ('fft', 'FFT products')):
            mine = rows(self.document, 'figure_4', setting=setting, method=slower)
            best = rows(self.document, 'figure_4', setting=setting, method=BEST_OF_PAPER)
            values = ratios(mine, best)
            if values:
                side = mine[0]['points_a_side']
                stopped = any(r['status'] == 'RC_STOP_TIME' for r in best)
                parts.append((median(values), f'{spread(values)} times on {side}², {words}' + (' (stopped for time)' if stopped else '')))
        reached = any(value >= factor / 2 for value, _ in parts)
        return ('' if reached else 'no: ') + some([text for _, text in parts])

    def cause(self):
        found = {r['variant']: r for r in rows(self.document, 'algorithm_2', kernel='eq9')}
        right = next(r for name, r in found.items() if name.startswith('and squared'))
        others = [r for r in found.values() if r is not right]
        if any(r['residual'] <= 1e-8 for r in others):
            return 'some printed variants converge, see figure 4'
        most = max(r['iterations'] for r in others)
        return (f'Algorithm 2 as printed, or with some of its errata put right, is not there after {most} iterations; with all of them '
                f'{right["iterations"]}, {figure(most / right["iterations"])} times fewer')

    def warm(self, method):
        parts = []
        for setting in ('small', 'dense', 'fft'):
            cold = rows(self.document, 'figure_4', setting=setting, method=method)
            warm = rows(self.document, 'figure_4', setting=setting, method=method + ', warm')
            if cold and warm:
                parts.append(f'{spread(ratios(warm, cold, "products"))} of the products on {cold[0]["points_a_side"]}²'
                             f'{", FFT" if setting == "fft" else ", dense"}')
        return some(parts)

    def inner(self, name, storing=True):
        found = rows(self.document, 'figure_5')
        parts = []
        for n in values_of(found, 'n'):
            mine = [dict(r, cpu_seconds=r['cpu_seconds'] - (0 if storing else r['storing_seconds'])) for r in found
                    if r['n'] == n and r['inner'] == name]
            values = ratios(mine, [r for r in found if r['n'] == n and r['inner'] == 'cg'])
            if values:
                parts.append(f'n = {n}: {figure(median(values))}')
        return f'time over that of conjugate gradients: {some(parts, ", ")}'

    def projections(self):
        found = rows(self.document, 'figure_6', pivoting='single')
        times = {count: median([r['cpu_seconds'] for r in found if r['projections'] == count]) for count in values_of(found, 'projections')}
        best = min(times, key=times.get)
        words = ', '.join(f'K = {count}: {figure(value / times[0])}' for count, value in times.items() if count)
        return f'time over that without: {words}; least at K = {best}'

    def losses(self):
        found = [r for r in rows(self.document, 'figure_8', backend='fft', kernel='eq9')]
        parts = []
        for h in values_of(found, 'hurst'):
            values = [100 * r['load_error'] for r in found if r['hurst'] == h]
            parts.append(f'H = {h:g}: {median(values):.2g} % ({min(values):.2g} % at worst)')
        return f'in the median of {len(values_of(found, "seed"))} surfaces: ' + some(parts, ', ')

    def falls(self):
        found = rows(self.document, 'figure_8', backend='fft', kernel='eq9')
        medians = [median([abs(r['load_error']) for r in found if r['hurst'] == h]) for h in values_of(found, 'hurst')]
        steady = all(a > b for a, b in zip(medians, medians[1:]))
        return (f'yes: from {100 * medians[0]:.2g} % to {100 * medians[-1]:.2g} %' + (', at every step' if steady else '')
                if medians[-1] < medians[0] else 'no')

    def half_saved(self):
        parts = []
        for backend, words in (('dense', 'dense products'), ('fft', 'FFT products')):
            found = rows(self.document, 'figure_8', backend=backend, kernel='eq9')
            if found:
                values = [r['cpu_seconds'] / r['whole_cpu_seconds'] for r in found]
                sound = [r['certified_cpu_seconds'] / r['whole_cpu_seconds'] for r in found]
                parts.append(f'{words}: {spread(values)} of the time of the whole problem, certified {spread(sound)}')
        return some(parts)

    def radius(self):
        found = rows(self.document, 'figure_9', backend='fft')
        parts = []
        for i in (0, len(found[0]['radii']) - 1):
            values = [100 * abs(r['radii'][i]['load_error']) for r in found]
            kept = [r['radii'][i]['kept'] for r in found]
            parts.append(f'h = {found[0]["radii"][i]["h"]:g}: {median(values):.2g} % lost, n_p/n {median(kept):.2f}')
        return some(parts)

    def spectra(self):
        parts = []
        for row in rows(self.document, 'figure_10'):
            losses = [f'{100 * case["load_error"]:.2g}' for case in row['cases'] if case['part'] == 5]
            parts.append(f'{row["surface"]}: {", ".join(losses)} %')
        return 'load error with coarse grids by ' + 'sub-sampling, means, maxima: ' + some(parts)


def claims_table(document):
    claims = Claims(document)
    lines = [
        ['greedy fails in about 40 % of Example 1, n = 100, and at any n', said(claims.fails_often), 'Example 1'],
        ['never at a spacing of 2 cells', said(claims.never_elsewhere), 'Example 1'],
        ['never on smooth shapes', said(claims.smooth_never), 'Example 1'],
        ['when greedy works is an open question', 'answered: for every surface if and only if H^-1 has no positive entry off its diagonal, see '
         '[failures](failures.md#greedy-elimination)', '`ctest -R failures.greedy`'],
        ['NNLS with 100 projections is 26 times faster than conjugate gradients', said(claims.speed, 'P&K 1999', 26), 'figure 4'],
        ['where a factor like that may come from', said(claims.cause), 'figure 4'],
        ['NNLS with 100 projections is two orders of magnitude faster than greedy CG', said(claims.speed, 'greedy CG', 100), 'figure 4'],
        ['and than ADMM', said(claims.speed, 'ADMM, warm', 100), 'figure 4'],
        ['the loading history helps NNLS', said(claims.warm, 'NNLS'), 'figure 4'],
        ['and conjugate gradients', said(claims.warm, 'P&K 1999'), 'figure 4'],
        ['Cholesky makes greedy 30 to 40 % faster at any n', said(claims.inner, 'cholesky'), 'figure 5'],
        ['Gauss-Seidel takes three times as long as CG', said(claims.inner, 'gauss-seidel', False) + ', the time to store the matrix not counted',
         'figure 5'],
        ['projections before NNLS pay up to K = 100, not beyond', said(claims.projections), 'figure 6'],
        ['CMR loses less as H grows', said(claims.falls), 'figure 8'],
        ['less than 2 % for H > 0.5', said(claims.losses), 'figure 8'],
        ['CMR saves half of the time, whatever H', said(claims.half_saved), 'figure 8'],
        ['less than 1 % and n_p/n of 0.4 to 0.8 for h = 1.25 to 3, 0.01 % at h = 3', said(claims.radius), 'figure 9'],
        ['CMR: -0.4 % with a power law, -98 % with a cut-off to it', said(claims.spectra), 'figure 10'],
    ]
    return table(['the paper', 'here', 'where'], lines)
