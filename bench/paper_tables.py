"""Rows of paper.json, the claims of Bemporad & Paggi (2015) beside what they say, and the tables of docs/development/paper.md. What has
not been measured is named with the command that does."""
from samples import chosen, groups, median, median_interval, ratios, rows_of, values_of
from json_tables import load
from tables import error, missing, provenance, records, table

METHODS = ['greedy CG', 'P&K 1999', 'P&K 1999, warm', 'ADMM, warm', 'NNLS', 'NNLS, warm', 'NNLS + 100 GP', 'NNLS by blocks, warm', 'haar-cg, warm']
BEST_OF_PAPER = 'NNLS + 100 GP'


def measured(document, name, **values):
    """Rows of a list with these values, and without an error."""
    return [{**row, 'radii': rows_of(row['radii'])} if 'radii' in row else row for row in chosen(document.get(name, []), **values) if 'error' not in row]


def some(parts, between='; '):
    if not parts:
        raise LookupError
    return between.join(parts)


def figure(value):
    return f'{value:.2g}' if value < 10 else f'{value:.0f}'


def spread(values, unit=''):
    middle, low, high = median_interval(values)
    return f'{figure(middle)}{unit} ({figure(low)} to {figure(high)})' if len(values) > 1 else f'{figure(middle)}{unit}'


class Claims:
    def __init__(self, document):
        self.document = document

    def rows(self, name, **values):
        return measured(self.document, name, **values)

    def fails_often(self):
        shares = [f'n = {row["n"]}: {100 * row["share"]:.0f} %' for n in (25, 100, 400, 900)
                  for row in self.rows('example_1', kernel='eq9', spacing=1, n=n)[:1]]
        return f'yes, with kernel `eq9`: {some(shares, ", ")}'

    def never_elsewhere(self):
        found = [r for r in self.rows('example_1') if r['kernel'] != 'eq9' or r['spacing'] == 2]
        spaced, others = chosen(found, spacing=2), chosen(found, spacing=1)

        def wrong(rows):
            return f'{sum(r["failures"] for r in rows)} of {sum(r["draws"] for r in rows)}'
        return f'yes: {wrong(spaced)} draws; at a spacing of 1 with {some([f"`{r}`" for r in values_of(others, "kernel")], ", ")} {wrong(others)}'

    def smooth_never(self):
        found = self.rows('smooth', shape='spheres between the points')
        counts = some(['{failures} of {draws} spheres with `{kernel}`'.format(**r) for r in found], ', ')
        return ('not always: ' if any(r['failures'] for r in found) else 'yes: ') + counts

    def speed(self, slower, factor):
        """How much longer than NNLS with gradient steps, by setting."""
        parts, reached = [], False
        for setting, words in (('small', 'dense products'), ('dense', 'dense products, larger'), ('fft', 'FFT products')):
            mine, best = (self.rows('figure_4', setting=setting, method=method) for method in (slower, BEST_OF_PAPER))
            values = ratios(mine, best)
            if values:
                stopped = ' (stopped for time)' if chosen(best, status='RC_STOP_TIME') else ''
                parts.append(f'{spread(values)} times on {mine[0]["points_a_side"]}², {words}{stopped}')
                reached = reached or median(values) >= factor / 2
        return ('' if reached else 'no: ') + some(parts)

    def cause(self):
        found = {r['variant']: r for r in self.rows('algorithm_2', kernel='eq9')}
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
            cold, warm = (self.rows('figure_4', setting=setting, method=method + words) for words in ('', ', warm'))
            if cold and warm:
                parts.append(f'{spread(ratios(warm, cold, "products"))} of the products on {cold[0]["points_a_side"]}²'
                             f'{", FFT" if setting == "fft" else ", dense"}')
        return some(parts)

    def inner(self, name, storing=True):
        parts = []
        for n in values_of(self.rows('figure_5'), 'n'):
            mine, cg = (self.rows('figure_5', n=n, inner=inner) for inner in (name, 'cg'))
            mine = [{**r, 'cpu_seconds': r['cpu_seconds'] - (0 if storing else r['storing_seconds'])} for r in mine]
            parts += [f'n = {n}: {figure(median(values))}' for values in [ratios(mine, cg)] if values]
        return f'time divided by that of conjugate gradients: {some(parts, ", ")}' + ('' if storing else ', the time to store the matrix not counted')

    def projections(self):
        found = self.rows('figure_6', pivoting='single')
        times = {count: median([r['cpu_seconds'] for r in chosen(found, projections=count)]) for count in values_of(found, 'projections')}
        words = ', '.join(f'K = {count}: {figure(value / times[0])}' for count, value in times.items() if count)
        return f'time over that without: {words}; least at K = {min(times, key=times.get)}'

    def by_exponent(self, value):
        found = self.rows('figure_8', backend='fft', kernel='eq9')
        return found, {h: [value(r['load_error']) for r in chosen(found, hurst=h)] for h in values_of(found, 'hurst')}

    def losses(self):
        found, lost = self.by_exponent(lambda error: 100 * error)
        parts = [f'H = {h:g}: {median(values):.2g} % ({min(values):.2g} % at worst)' for h, values in lost.items()]
        return f'in the median of {len(values_of(found, "seed"))} surfaces: ' + some(parts, ', ')

    def falls(self):
        medians = [median(values) for values in self.by_exponent(abs)[1].values()]
        steady = ', at every step' if all(a > b for a, b in zip(medians, medians[1:])) else ''
        return f'yes: from {100 * medians[0]:.2g} % to {100 * medians[-1]:.2g} %{steady}' if medians[-1] < medians[0] else 'no'

    def half_saved(self):
        parts = []
        for backend, words in (('dense', 'dense products'), ('fft', 'FFT products')):
            found = self.rows('figure_8', backend=backend, kernel='eq9')
            if found:
                plain, sound = (spread([r[key] / r['whole_cpu_seconds'] for r in found]) for key in ('cpu_seconds', 'certified_cpu_seconds'))
                parts.append(f'{words}: {plain} of the time of the whole problem, certified {sound}')
        return some(parts)

    def radius(self):
        parts = []
        for i in (0, -1):
            found = [r['radii'][i] for r in self.rows('figure_9', backend='fft')]
            lost, kept = median([100 * abs(r['load_error']) for r in found]), median([r['kept'] for r in found])
            parts.append(f'h = {found[0]["h"]:g}: {lost:.2g} % lost, n_p/n {kept:.2f}')
        return some(parts)

    def spectra(self):
        parts = [f'{row["surface"]}: {", ".join(format(100 * case["load_error"], ".2g") for case in chosen(row["cases"], part=5))} %'
                 for row in self.rows('figure_10')]
        return 'load error with coarse grids by sub-sampling, means, maxima: ' + some(parts)

    def said(self, claim, *given):
        """What the results say, or that they have nothing to say it from."""
        try:
            return claim(self, *given)
        except (LookupError, ValueError, StopIteration, ZeroDivisionError):
            return 'not measured yet'


CLAIMS = (
    ('greedy fails in about 40 % of Example 1, n = 100, and at any n', 'Example 1', Claims.fails_often),
    ('never at a spacing of 2 cells', 'Example 1', Claims.never_elsewhere), ('never on smooth shapes', 'Example 1', Claims.smooth_never),
    ('when greedy works is an open question', '`ctest -R failures.greedy`',
     lambda _: 'answered: for every surface if and only if H^-1 has no positive entry off its diagonal, see [failures](failures.md#greedy-elimination)'),
    ('NNLS with 100 projections is 26 times faster than conjugate gradients', 'figure 4', Claims.speed, 'P&K 1999', 26),
    ('possible origin of such a factor', 'figure 4', Claims.cause),
    ('NNLS with 100 projections is two orders of magnitude faster than greedy CG', 'figure 4', Claims.speed, 'greedy CG', 100),
    ('and than ADMM', 'figure 4', Claims.speed, 'ADMM, warm', 100), ('the loading history helps NNLS', 'figure 4', Claims.warm, 'NNLS'),
    ('and conjugate gradients', 'figure 4', Claims.warm, 'P&K 1999'),
    ('Cholesky makes greedy 30 to 40 % faster at any n', 'figure 5', Claims.inner, 'cholesky'),
    ('Gauss-Seidel takes three times as long as CG', 'figure 5', Claims.inner, 'gauss-seidel', False),
    ('projections before NNLS pay up to K = 100, not beyond', 'figure 6', Claims.projections),
    ('CMR loses less as H grows', 'figure 8', Claims.falls), ('less than 2 % for H > 0.5', 'figure 8', Claims.losses),
    ('CMR saves half of the time, whatever H', 'figure 8', Claims.half_saved),
    ('less than 1 % and n_p/n of 0.4 to 0.8 for h = 1.25 to 3, 0.01 % at h = 3', 'figure 9', Claims.radius),
    ('CMR: -0.4 % with a power law, -98 % with a cut-off to it', 'figure 10', Claims.spectra))


# Shares of wrong answers by an independent program, with half of their 95 % intervals [%].
INDEPENDENT = {25: (17.1, 2.3), 100: (35.9, 3.0), 400: (63.1, 3.0), 900: (85.0, 3.5)}
SETTINGS = {'small': 'dense, eq9', 'small, love': 'dense, love', 'dense': 'dense, eq9', 'fft': 'FFT, eq9'}
EXAMPLE_1 = ('n; draws; wrong [%]={share:%.1f} ({lower:%.1f} to {upper:%.1f}); independent program [%]={independent}; '
             'the paper={paper}; largest error of p [% of max p]={worst:%.0f}; largest error of the load={load:err}')
ALGORITHM_2 = ('kernel; Algorithm 2={variant}; iterations to 1e-8={reached}; least residual={residual:err}; stops by its own test after={stop}; '
               'tension left [of max p]={tension}')


def unmeasured(figure):
    return missing(f'roughcontact-bench documents paper --figures {figure}')


def provenance_text(document):
    if not document:
        return unmeasured('2,4,5,6,8,9,10')
    newest = document['provenance']['library']
    older = sorted(name for name, found in document.items() if isinstance(found, list) and any(r.get('library') != newest for r in found))
    return (provenance(document) + (' **Small grids and few seeds: `--quick`.**' if document.get('quick') else '') +
            (f' With an earlier build: {", ".join(older)}.' if older else ''))


def example_1_table(found):
    """The kernel and the spacing that fail; the claims count the others."""
    lines = []
    for row in chosen(found, kernel='eq9', spacing=1):
        independent = '{} ± {}'.format(*INDEPENDENT[row['n']]) if row['n'] in INDEPENDENT else ''
        wrong = {'worst': row['pressure_error'], 'load': row['load_error']} if row['failures'] else {}
        lines.append({**row, 'independent': independent, 'paper': 'about 40 of 100' if row['n'] == 100 else 'at any n', **wrong})
    return records(EXAMPLE_1, lines)


def figure_2_text(found):
    row = found[0]
    pairs = list(zip(row['greedy'], row['exact']))
    off = sum(p > 0 and truth > 0 and abs(p - truth) > 0.05 * truth for p, truth in pairs)

    def elements(wrong):
        return ', '.join(str(i) for i, each in enumerate(wrong, 1) if each) or 'none'

    return (f'The first wrong draw here (number {row["seed"] + 1}): w < 0 in element {elements(w < -1e-9 for w in row["w"])}, deepest '
            f'{min(row["w"]):.2g}; contacts that are none: {elements(p > 0 and truth == 0 for p, truth in pairs)}; contacts that are not found: '
            f'{elements(p == 0 and truth > 0 for p, truth in pairs)}; {off} of {sum(truth > 0 for _, truth in pairs)} forces off by more than 5 %, '
            f'the worst by {100 * max(abs(p - truth) for p, truth in pairs) / max(row["exact"]):.0f} % of the largest. The total is off by '
            f'{100 * (sum(row["greedy"]) / sum(row["exact"]) - 1):+.2g} %.')


def figure_4_text(found):
    """The cases of the picture."""
    cases = []
    for name, words in SETTINGS.items():
        if same := chosen(found, setting=name):
            fitting, surfaces = values_of(same, 'steps_of_ten'), len(values_of(same, 'seed'))
            cases.append(f'{same[0]["points_a_side"]}² {words}: {surfaces} surface{"s" if surfaces > 1 else ""}, '
                         f'{fitting[0]}{" to " + str(fitting[-1]) if len(fitting) > 1 else ""} steps, n up to {max(r["largest"] for r in same)}')
    return '; '.join(cases) + '.'


def algorithm_2_table(found):
    return records(ALGORITHM_2, [{**row, 'reached': ('{iterations}' if row['residual'] <= 1e-8 else 'not in {iterations}').format(**row),
        'stop': f'{row["stopped"]}, residual {error(row["residual_at_stop"])}' if 'stopped' in row else 'never',
        'tension': f'{-row["lowest_pressure"]:.0%}' if row['lowest_pressure'] < 0 else 'none'} for row in found])


def figure_10_table(found):
    losses = []
    for row in found:
        for (part,), cases in groups(row['cases'], 'part').items():
            first = cases[0]
            losses.append([row['surface'], f'(max - mean)/{part:g}', f'{first["contacts"]} of {first["candidates"]}',
                           *(f'{100 * case["load_error"]:.2g}' for case in cases), f'{first["unresolved"]:.2f}, {"yes" if first["trustworthy"] else "no"}'])
    kinds = [case['filter'] for case in found[0]['cases'][:3]]
    cascades = table(['surface', 'approach', 'contacts of candidates', *(f'load error, {kind} [%]' for kind in kinds), 'unresolved, trusted'], losses)
    alone = '' if chosen(found, origin='measured') else '\n\nMeasured surfaces were not at hand: generated ones alone.'
    return cascades + alone


SECTIONS = {  # rows, figure, text
    'example-1': ('example_1', 2, example_1_table), 'figure-2': ('figure_2', 2, figure_2_text), 'figure-4': ('figure_4', 4, figure_4_text),
    'algorithm-2': ('algorithm_2', 4, algorithm_2_table), 'figure-10': ('figure_10', 10, figure_10_table)}


def sections(results):
    document = load(results, 'paper')
    filled = {name: make(rows) if (rows := measured(document, of)) else unmeasured(figure) for name, (of, figure, make) in SECTIONS.items()}
    claims = [[text, Claims(document).said(*claim), where] for text, where, *claim in CLAIMS]
    return {'provenance': provenance_text(document), 'claims': table(['the paper', 'here', 'where'], claims), **filled}
