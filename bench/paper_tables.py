"""Tables of docs/paper.md. What has not been measured is named with the command that does."""
import math

from paper_claims import claims_table
from paper_rows import BEST_OF_PAPER, METHODS, rows
from samples import groups, median_interval, ratios, values_of
from store import load_known
from tables import error, missing, provenance, table

# Shares of wrong answers by an independent program, with half of their 95 % intervals [%].
INDEPENDENT = {25: (17.1, 2.3), 100: (35.9, 3.0), 400: (63.1, 3.0), 900: (85.0, 3.5)}

SETTINGS = {'small': 'dense, eq9', 'small, love': 'dense, love', 'dense': 'dense, eq9', 'fft': 'FFT, eq9'}


def unmeasured(figure):
    return missing(f'roughcontact-bench documents paper --figures {figure}')


def number(value):
    return '0' if value == 0 else f'{value:.2g}' if abs(value) < 10 else f'{value:.0f}'


def interval(values, scale=1, form=number):
    middle, low, high = (scale * value for value in median_interval(values))
    return f'{form(middle)} ({form(low)} to {form(high)})' if len(values) > 1 else form(middle)


def provenance_text(document):
    if not document:
        return unmeasured('2,4,5,6,8,9,10')
    newest = document['provenance']['library']
    older = sorted(name for name, found in document.items() if isinstance(found, list) and any(r.get('library') != newest for r in found))
    text = provenance(document)
    if document.get('quick'):
        text += ' **Small grids and few seeds: `--quick`.**'
    return text + (f' With an earlier build: {", ".join(older)}.' if older else '')


def example_1_table(document):
    lines = []
    for row in rows(document, 'example_1'):
        known = row['kernel'] == 'eq9' and row['spacing'] == 1 and row['n'] in INDEPENDENT
        share, half = INDEPENDENT.get(row['n'], (0, 0))
        paper = 'about 40 of 100' if known and row['n'] == 100 else 'at any n' if known else 'none' if row['spacing'] == 2 else ''
        lines.append([row['kernel'], str(row['spacing']), str(row['n']), str(row['draws']),
                      f'{100 * row["share"]:.1f} ({100 * row["lower"]:.1f} to {100 * row["upper"]:.1f})',
                      f'{share} ± {half}' if known else '', paper, f'{100 * row["pressure_error"]:.0f}' if row['failures'] else '',
                      error(row['load_error']) if row['failures'] else ''])
    return table(['kernel', 'spacing', 'n', 'draws', 'wrong [%]', 'independent program [%]', 'the paper', 'largest error of p [% of max p]',
                  'largest error of the load'], lines)


def figure_2_text(document):
    row = rows(document, 'figure_2')[0]
    largest = max(row['exact'])
    overlapping = [i + 1 for i, value in enumerate(row['w']) if value < -1e-9]
    pairs = list(zip(row['greedy'], row['exact']))
    false = [i + 1 for i, (p, truth) in enumerate(pairs) if p > 0 and truth == 0]
    missed = [i + 1 for i, (p, truth) in enumerate(pairs) if p == 0 and truth > 0]
    off = sum(p > 0 and truth > 0 and abs(p - truth) > 0.05 * truth for p, truth in pairs)

    def named(elements):
        return 'none' if not elements else ', '.join(map(str, elements))

    return (f'The first wrong draw here (number {row["seed"] + 1}): w < 0 in element {named(overlapping)}, deepest {min(row["w"]):.2g}; '
            f'contacts that are none: {named(false)}; contacts that are not found: {named(missed)}; {off} of '
            f'{sum(truth > 0 for _, truth in pairs)} forces off by more than 5 %, the worst by '
            f'{100 * max(abs(p - truth) for p, truth in pairs) / largest:.0f} % of the largest. The total is off by '
            f'{100 * (sum(row["greedy"]) / sum(row["exact"]) - 1):+.2g} %.')


def smooth_table(document):
    lines = []
    for row in rows(document, 'smooth'):
        lines.append([row['shape'], row['kernel'], str(row['draws']), str(row['failures']),
                      f'{100 * row["load_error"]:+.2g} %' if 'load_error' in row else ''])
    return table(['shape', 'kernel', 'draws', 'wrong', 'load against Hertz'], lines)


def marked(found):
    """`*` for answers that are not certified, `†` for histories that ran out of time."""
    statuses = {row['status'] for row in found}
    return ('†' if 'RC_STOP_TIME' in statuses else '') + ('*' if statuses - {'RC_OK', 'RC_STOP_TIME'} else '')


def figure_4_tables(document):
    found = rows(document, 'figure_4')
    names = [name for name in SETTINGS if any(r['setting'] == name for r in found)]
    titles, steps = ['method'], []
    for name in names:
        some = [r for r in found if r['setting'] == name]
        titles.append(f'{some[0]["points_a_side"]}² {SETTINGS[name]}')
        fitting = sorted({r['steps_of_ten'] for r in some})
        largest = max(step['candidates'] for r in some for step in r['steps'])
        steps.append(f'{titles[-1]}: {len(values_of(some, "seed"))} surface{"s" if len(values_of(some, "seed")) > 1 else ""}, '
                     f'{fitting[0]}{" to " + str(fitting[-1]) if len(fitting) > 1 else ""} steps, n up to {largest}')

    def cells(method, cell):
        line = [method]
        for name in names:
            mine = [r for r in found if r['setting'] == name and r['method'] == method]
            line.append(cell(name, mine) + marked(mine) if mine else '')
        return line

    def relative(name, mine):
        best = [r for r in found if r['setting'] == name and r['method'] == BEST_OF_PAPER]
        values = ratios(mine, best)
        return interval(values) if values else ''

    def products(_, mine):
        return interval([r['products'] for r in mine], form=lambda value: f'{value:.0f}')

    times = table(titles, [cells(m, lambda _, mine: interval([r['cpu_seconds'] for r in mine])) for m in METHODS])
    shares = table(titles, [cells(m, relative) for m in METHODS])
    counts = table(titles, [cells(m, products) for m in METHODS])
    return (f'{"; ".join(steps)}.\n\nCPU time of the history [s]:\n\n{times}\n\nCPU time over that of {BEST_OF_PAPER}:\n\n{shares}\n\n'
            f'Products with H:\n\n{counts}\n\n`*`: not every step is certified (greedy elimination with kernel `eq9`: its answers overlap). '
            '`†`: a step took more than 60 s, and the history ended there.')


def algorithm_2_table(document):
    lines = []
    for row in rows(document, 'algorithm_2'):
        reached = row['residual'] <= 1e-8
        stop = f'{row["stopped"]}, residual {error(row["residual_at_stop"])}' if 'stopped' in row else 'never'
        lines.append([row['kernel'], row['variant'], str(row['iterations']) if reached else f'not in {row["iterations"]}',
                      error(row['residual']), stop, f'{-row["lowest_pressure"]:.0%}' if row['lowest_pressure'] < 0 else 'none'])
    return table(['kernel', 'Algorithm 2', 'iterations to 1e-8', 'least residual', 'stops by its own test after', 'tension left [of max p]'], lines)


def figure_5_table(document):
    found = rows(document, 'figure_5')
    lines = []
    for n in values_of(found, 'n'):
        mine = {inner: [r for r in found if r['n'] == n and r['inner'] == inner] for inner in ('cg', 'cholesky', 'gauss-seidel')}
        sweeps = mine['gauss-seidel']
        cg = mine['cg']
        bare = [dict(r, cpu_seconds=r['cpu_seconds'] - r['storing_seconds']) for r in sweeps]
        lines.append([str(n), *(interval([r['cpu_seconds'] for r in some]) if some else '' for some in mine.values()),
                      interval(ratios(mine['cholesky'], cg)) if mine['cholesky'] else '', interval(ratios(bare, cg)) if bare else '',
                      interval([r['iterations'] for r in cg], form=lambda value: f'{value:.0f}'),
                      interval(ratios(sweeps, cg, 'iterations')) if sweeps else ''])
    return table(['n', 'conjugate gradients [s]', 'Cholesky [s]', 'Gauss-Seidel [s]', 'Cholesky / CG', 'Gauss-Seidel / CG, storing not counted',
                  'CG iterations', 'sweeps / CG iterations'], lines)


def figure_6_table(document):
    found = rows(document, 'figure_6')
    lines = []
    for count in values_of(found, 'projections'):
        line = [str(count)]
        for pivoting in ('single', 'block'):
            some = [r for r in found if r['projections'] == count and r['pivoting'] == pivoting]
            line += [interval([r['solves'] for r in some], form=lambda value: f'{value:.0f}'), interval([r['cpu_seconds'] for r in some])]
        lines.append(line)
    return table(['K', 'linear solves, one exchange each', 'CPU [s]', 'linear solves, blocks', 'CPU [s]'], lines)


def loss(values):
    return interval(values, 100, form=lambda value: f'{value:.2g}') + f', {100 * min(values):.2g}'


def figure_8_table(document):
    found = rows(document, 'figure_8')
    lines = []
    for h in values_of(found, 'hurst'):
        fft = [r for r in found if r['hurst'] == h and r['backend'] == 'fft' and r['kernel'] == 'eq9']
        love = [r for r in found if r['hurst'] == h and r['kernel'] == 'love']
        dense = [r for r in found if r['hurst'] == h and r['backend'] == 'dense']

        def share(some, key):
            return interval([r[key] / r['whole_cpu_seconds'] for r in some]) if some else ''

        lines.append([f'{h:g}', loss([r['load_error'] for r in fft]), loss([r['load_error'] for r in love]),
                      loss([r['diagonal']['load_error'] for r in fft]), interval([r['kept'] for r in fft]), share(dense, 'cpu_seconds'),
                      share(fft, 'cpu_seconds'), share(dense, 'certified_cpu_seconds'), share(fft, 'certified_cpu_seconds'),
                      error(max(abs(r['certified_error']) for r in fft + love + dense))])
    return table(['H', 'load error [%], worst', '`love` [%], worst', 'radius h √2 δ [%], worst', 'n_p / n', 'time, dense', 'time, FFT',
                  'certified, dense', 'certified, FFT', 'certified: largest error'], lines)


def figure_9_table(document):
    found = rows(document, 'figure_9')
    fft, dense = ([r for r in found if r['backend'] == name] for name in ('fft', 'dense'))
    lines = []
    for i, first in enumerate(found[0]['radii']):
        def share(some, key):
            return interval([r['radii'][i][key] / r['whole_cpu_seconds'] for r in some]) if some else ''

        lines.append([f'{first["h"]:g}', loss([r['radii'][i]['load_error'] for r in fft]), interval([r['radii'][i]['kept'] for r in fft]),
                      share(dense, 'cpu_seconds'), share(fft, 'cpu_seconds'), share(dense, 'certified_cpu_seconds')])
    return table(['h', 'load error [%], worst', 'n_p / n', 'time, dense', 'time, FFT', 'certified, dense'], lines)


def wavelength(q):
    if not q:
        return 'none seen'
    metres = 2 * math.pi / q
    return f'{1e9 * metres:.3g} nm' if metres < 1e-6 else f'{1e6 * metres:.3g} µm'


def figure_10_tables(document):
    found = rows(document, 'figure_10')
    spectra = [[row['surface'], row['origin'], f'{row["nx"]} x {row["ny"]}', f'{1e9 * row["hx"]:.3g} nm', f'{1e9 * row["rms_height"]:.3g} nm',
                f'{row["hurst"]:.2f} ± {row["hurst_error"]:.2f}' if row['hurst'] is not None else 'no power law',
                f'{wavelength(row["q_max"])} to {wavelength(row["q_min"])}' if row['q_min'] else '', wavelength(row['q_rolloff']),
                wavelength(row['q_cutoff']), str(row['textures'])] for row in found]
    losses = []
    for row in found:
        for (part,), cases in groups(row['cases'], 'part').items():
            first = cases[0]
            losses.append([row['surface'], f'(max - mean)/{part:g}', f'{first["contacts"]} of {first["candidates"]}', str(first['halvings'] + 1),
                           *(f'{100 * case["load_error"]:.2g}' for case in cases), ', '.join(f'{case["kept"]:.2f}' for case in cases),
                           ', '.join(f'{case["cpu_seconds"] / case["whole_cpu_seconds"]:.1f}' for case in cases),
                           f'{first["unresolved"]:.2f}, {"yes" if first["trustworthy"] else "no"}',
                           error(max(abs(case['certified_error']) for case in cases))])
    kinds = [case['filter'] for case in found[0]['cases'][:3]]
    text = table(['surface', 'origin', 'points', 'pixel', 'rms height', 'Hurst exponent', 'power law from', 'roll-off', 'cut-off', 'textures'], spectra)
    text += '\n\n' + table(['surface', 'approach', 'contacts of candidates', 'grids', *(f'load error, {kind} [%]' for kind in kinds), 'n_p / n',
                            'CPU time / whole', 'unresolved, trusted', 'certified: largest error'], losses)
    if not any(row['origin'] == 'measured' for row in found):
        text += '\n\nMeasured surfaces were not at hand: generated ones alone.'
    return text


SECTIONS = {'example-1': ('example_1', 2, example_1_table), 'figure-2': ('figure_2', 2, figure_2_text), 'smooth': ('smooth', 2, smooth_table),
            'figure-4': ('figure_4', 4, figure_4_tables), 'algorithm-2': ('algorithm_2', 4, algorithm_2_table),
            'figure-5': ('figure_5', 5, figure_5_table),
            'figure-6': ('figure_6', 6, figure_6_table), 'figure-8': ('figure_8', 8, figure_8_table),
            'figure-9': ('figure_9', 9, figure_9_table), 'figure-10': ('figure_10', 10, figure_10_tables)}


def sections(results):
    document = load_known(results, 'paper') or {}
    filled = {name: make(document) if rows(document, of) else unmeasured(figure) for name, (of, figure, make) in SECTIONS.items()}
    return {'provenance': provenance_text(document), 'claims': claims_table(document), **filled}
