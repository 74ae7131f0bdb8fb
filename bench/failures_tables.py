"""Tables and the picture of docs/failures.md, from failures.json and histories.json."""
import os

from charts import FILTERS, Panels, axes, style, ticks
from samples import chosen, groups, mean_of, solved, values_of
from store import load
from tables import error, provenance, records, table

ATLAS = 'method={row}; trigger; what happens={happens}; detected as={detected}; what the library does={library}'
GP = 'kernel; step length={lipschitz}; restart; iterations; products; status'
ADMM = 'rho; iterations; residual={residual:err}; status'
CMR = ('surface; sub-sampled [%]={subsample:%.2f}; mean [%]={mean:%.2f}; max [%]={max:%.2f}; unresolved={unresolved:.2f}; trustworthy; '
       'certified={certified:err}; rounds; candidates kept [%]={kept:%.0f}')
HISTORIES = ('solver=`{solver}`; grid, backend={n}², {backend}; surfaces; cold products={cold_products:.0f}; warm products={warm_products:.0f}; '
             'warm / cold={ratio:.2f}; load difference={load_difference:err}; status')


def percent(value):
    return f'{100 * value:.2g}' if 0 < abs(value) < 0.1 else f'{100 * value:.0f}'


def by_points(rows, cell, last=None):
    """A line for each kernel and spacing, a column for each number of points, and one more, (title, of a line's rows)."""
    sizes, lines = values_of(chosen(rows, spacing=1), 'n'), []
    for (kernel, spacing), line in groups(rows, 'kernel', 'spacing').items():
        found = {row['n']: cell(row) for row in line}
        lines.append([kernel, str(spacing), *(found.get(n, '') for n in sizes), *([last[1](line)] if last else [])])
    return table(['kernel', 'spacing', *(f'n = {n}{" [%]" if last else ""}' for n in sizes), *([last[0]] if last else [])], lines)


def greedy_table(rows):
    return by_points(rows, lambda row: f'{percent(row["share"])} ({percent(row["lower"])} to {percent(row["upper"])})',
                     ('largest error of p [%]', lambda line: percent(max([r['pressure_error'] for r in line if r['failures']], default=0))))


def cmr_table(rows):
    lines = []
    for (surface,), found in groups(rows, 'surface').items():
        best, lost = chosen(found, filter='max'), {kind: mean_of(chosen(found, filter=kind), 'plain_error') for kind in FILTERS}
        lines.append({'surface': surface, **lost, 'unresolved': mean_of(best, 'unresolved'), 'kept': mean_of(best, 'kept'),
                      'trustworthy': 'yes' if all(r['trustworthy'] for r in best) else 'no', 'rounds': max(r['rounds'] for r in found),
                      'certified': max(abs(r['certified_error']) for r in found)})
    return records(CMR, lines)


def conditioning_table(rows):
    solvers, lines = list(dict.fromkeys(row['solver'] for row in rows)), []
    for (scene,), line in groups(rows, 'scene').items():
        found = {r['solver']: str(r['iterations']) if r['status'] == 'RC_OK' else r['status'] for r in line}
        lines.append([scene, *(found.get(solver, '') for solver in solvers), error(max(r['difference'] for r in solved(line)))])
    return table(['problem', *solvers, 'largest error of p'], lines)


def history_table(rows):
    lines = []
    for _, found in groups([row for row in rows if 'error' not in row], 'solver', 'backend').items():
        lines.append({**found[0], **{key: mean_of(found, key) for key in ('cold_products', 'warm_products', 'ratio')}, 'surfaces': len(found),
                      'load_difference': max(r['load_difference'] for r in found), 'status': ', '.join(values_of(found, 'status'))})
    return records(HISTORIES, lines)


def sections(results):
    failures = load(results, 'failures')
    data = failures['data']
    return {'provenance': provenance(failures), 'atlas': records(ATLAS, failures['atlas']), 'greedy': greedy_table(data['greedy']),
            'inverse': by_points(data['inverse'], lambda row: f'{row["coupling"]:+.1e}'), 'cmr': cmr_table(data['cmr']),
            'gp': records(GP, data['gp']), 'admm': records(ADMM, data['admm']), 'conditioning': conditioning_table(data['conditioning']),
            'histories': history_table(load(results, 'histories')['histories'])}


def pictures(results, images):
    data = load(results, 'failures')['data']
    drawing, curves, entries = Panels(800, 530, 2, 1, 150), [], []
    drawing.script.append('unset logscale\nset format "%g"\n')
    for number, (kernel,) in enumerate(groups(data['greedy'], 'kernel')):
        shift = 1 + 0.05 * (number - 2)  # so that the kernels that never fail do not hide each other
        points = [(shift * r['n'], 100 * r['share'], 100 * r['lower'], 100 * r['upper']) for r in chosen(data['greedy'], kernel=kernel, spacing=1)]
        curves += drawing.bars(points, style(number))
        entries.append((f'kernel {kernel}', style(number)))
    drawing.panel(0, 0, 'greedy: share of wrong answers, Example 1',
                  axes('points n', '% of draws', (18, 560), (-3, 100), 'set logscale x\nset xtics (25,100,400)', 1.5), curves)

    surfaces, curves = [name for (name,) in groups(data['cmr'], 'surface')], []
    looks = [*(('plain_error', kind, f'as published, {kind}', look) for kind, look in FILTERS.items()),
             ('certified_error', 'max', 'certified', 'pt 7 lc rgb "#000000"')]
    for key, kind, name, look in looks:
        largest = [100 * max(abs(r[key]) for r in chosen(data['cmr'], surface=surface, filter=kind)) for surface in surfaces]
        curves.append(drawing.curve([(i, max(value, 1e-8)) for i, value in enumerate(largest)], f'points ps 1.3 {look}'))
        entries.append((name.replace('subsample', 'sub-sampled'), f'points ps 1.3 {look}'))
    settings = (f'unset logscale x\nset logscale y\nset format y "10^{{%T}}"\nset ytics 1e-8,100,100\n'
                f'{ticks("x", [(name, i) for i, name in enumerate(surfaces)])} rotate by 25 right font ",8" noenhanced\n'
                f'set bmargin at screen {(150 + 85) / 530}')
    drawing.panel(1, 0, 'cascade multi-resolution: error of the load',
                  axes('', '% of the load', (-0.6, len(surfaces) - 0.4), (1e-8, 200), settings, 1), curves)
    drawing.draw(os.path.join(images, 'failures.png'), entries, 2)
