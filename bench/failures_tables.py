"""Tables and the picture of docs/failures.md, from failures.json and histories.json."""
import os

from charts import Panels, style
from samples import groups, mean
from store import load
from tables import error, provenance, table


def mean_of(rows, key):
    return mean(row[key] for row in rows)


def percent(value):
    return f'{100 * value:.2g}' if 0 < abs(value) < 0.1 else f'{100 * value:.0f}'


def atlas_table(document):
    return table(['method', 'trigger', 'what happens', 'detected as', 'what the library does'],
                 [[row[key] for key in ('row', 'trigger', 'happens', 'detected', 'library')] for row in document['atlas']])


def greedy_table(document):
    rows = []
    for (kernel, spacing), line in groups(document['data']['greedy'], 'kernel', 'spacing').items():
        rows.append([kernel, str(spacing)] + [f'{percent(r["share"])} ({percent(r["lower"])} to {percent(r["upper"])})' for r in line] +
                    [percent(max(r['pressure_error'] for r in line)) if any(r['failures'] for r in line) else '0'])
    sizes = [f'n = {row["n"]} [%]' for row in next(iter(groups(document['data']['greedy'], 'kernel', 'spacing').values()))]
    return table(['kernel', 'spacing', *sizes, 'largest error of p [%]'], rows)


def inverse_table(document):
    rows = document['data']['inverse']
    sizes = sorted({row['n'] for row in rows if row['spacing'] == 1})
    lines = []
    for (kernel, spacing), line in groups(rows, 'kernel', 'spacing').items():
        found = {row['n']: f'{row["coupling"]:+.1e}' for row in line}
        lines.append([kernel, str(spacing)] + [found.get(n, '') for n in sizes])
    return table(['kernel', 'spacing'] + [f'n = {n}' for n in sizes], lines)


def cmr_table(document):
    rows = []
    for (surface,), lines in groups(document['data']['cmr'], 'surface').items():
        by_filter = groups(lines, 'filter')
        best = by_filter[('max',)]
        rows.append([surface] + [f'{100 * mean_of(by_filter[(f,)], "plain_error"):.2f}' for f in ('subsample', 'mean', 'max')] +
                    [f'{mean_of(best, "unresolved"):.2f}', 'yes' if all(r['trustworthy'] for r in best) else 'no',
                     error(max(abs(r['certified_error']) for r in lines)), str(max(r['rounds'] for r in lines)),
                     f'{100 * mean_of(best, "kept"):.0f}'])
    return table(['surface', 'sub-sampled [%]', 'mean [%]', 'max [%]', 'unresolved', 'trustworthy', 'certified', 'rounds',
                  'candidates kept [%]'], rows)


def gp_table(document):
    return table(['kernel', 'step length', 'restart', 'iterations', 'products', 'status'],
                 [[r['kernel'], r['lipschitz'], r['restart'], str(r['iterations']), str(r['products']), r['status']]
                  for r in document['data']['gp']])


def admm_table(document):
    return table(['rho', 'iterations', 'residual', 'status'],
                 [[r['rho'], str(r['iterations']), error(r['residual']), r['status']] for r in document['data']['admm']])


def conditioning_table(document):
    scenes = groups(document['data']['conditioning'], 'scene')
    solvers = [row['solver'] for row in next(iter(scenes.values()))]
    rows = []
    for (scene,), line in scenes.items():
        found = {r['solver']: f'{r["iterations"]}' if r['status'] == 'RC_OK' else r['status'] for r in line}
        rows.append([scene] + [found.get(solver, '') for solver in solvers] +
                    [error(max(r['difference'] for r in line if r['status'] == 'RC_OK'))])
    return table(['problem', *solvers, 'largest error of p'], rows)


def history_table(document):
    rows = []
    for (solver, _), lines in groups([r for r in document['histories'] if 'error' not in r], 'solver', 'backend').items():
        rows.append([f'`{solver}`', f'{lines[0]["n"]}², {lines[0]["backend"]}', str(len(lines)),
                     f'{mean_of(lines, "cold_products"):.0f}', f'{mean_of(lines, "warm_products"):.0f}', f'{mean_of(lines, "ratio"):.2f}',
                     error(max(r['load_difference'] for r in lines)), ', '.join(sorted({r['status'] for r in lines}))])
    return table(['solver', 'grid, backend', 'surfaces', 'cold products', 'warm products', 'warm / cold', 'load difference', 'status'],
                 rows)


def sections(results):
    failures, histories = load(results, 'failures'), load(results, 'histories')
    return {'provenance': provenance(failures), 'atlas': atlas_table(failures), 'greedy': greedy_table(failures),
            'inverse': inverse_table(failures), 'cmr': cmr_table(failures), 'gp': gp_table(failures), 'admm': admm_table(failures),
            'conditioning': conditioning_table(failures), 'histories': history_table(histories)}


def pictures(results, images):
    data = load(results, 'failures')['data']
    drawing = Panels(800, 530, 2, 1, 150)
    drawing.script.append('unset logscale\nset format "%g"\n')
    kernels = list(groups(data['greedy'], 'kernel'))
    curves = []
    for number, (kernel,) in enumerate(kernels):
        line = [r for r in data['greedy'] if r['kernel'] == kernel and r['spacing'] == 1]
        shift = 1 + 0.05 * (number - 2)  # so that the kernels that never fail do not hide each other
        name = drawing.block([(shift * r['n'], 100 * r['share'], 100 * r['lower'], 100 * r['upper']) for r in line])
        look = style(number).replace('linespoints', '')
        curves += [f'{name} with linespoints {look}', f'{name} using 1:2:3:4 with yerrorbars {look}']
    drawing.panel(0, 0, 'greedy: share of wrong answers, Example 1',
                  'set logscale x\nset xrange [18:560]\nset yrange [-3:100]\nset xtics (25,100,400)\n'
                  'set xlabel "points n" offset 0,0.4\nset ylabel "% of draws" offset 1.5,0', curves)

    surfaces = [name for (name,) in groups(data['cmr'], 'surface')]
    tics = ', '.join(f'"{name}" {i}' for i, name in enumerate(surfaces))

    def largest(surface, kind, key):
        return 100 * max(abs(r[key]) for r in data['cmr'] if r['surface'] == surface and r['filter'] == kind)

    looks = [('subsample', 'plain_error'), ('mean', 'plain_error'), ('max', 'plain_error'), ('max', 'certified_error')]
    styles = ['pt 9 lc rgb "#D55E00"', 'pt 5 lc rgb "#0072B2"', 'pt 13 lc rgb "#E69F00"', 'pt 7 lc rgb "#000000"']
    curves = [drawing.block([(i, max(largest(surface, kind, key), 1e-8)) for i, surface in enumerate(surfaces)]) +
              f' with points ps 1.3 {styles[number]}' for number, (kind, key) in enumerate(looks)]
    drawing.panel(1, 0, 'cascade multi-resolution: error of the load',
                  f'unset logscale x\nset logscale y\nset format y "10^{{%T}}"\nset xrange [-0.6:{len(surfaces) - 0.4}]\nset yrange [1e-8:200]\n'
                  f'set ytics 1e-8,100,100\nset xtics ({tics}) rotate by 25 right font ",8" noenhanced\nset bmargin at screen {(150 + 85) / 530}\n'
                  'unset xlabel\nset ylabel "% of the load" offset 1,0', curves)
    entries = [(f'kernel {kernel}', style(number)) for number, (kernel,) in enumerate(kernels)]
    names = ['as published, sub-sampled', 'as published, mean', 'as published, max', 'certified']
    entries += [(name, f'points ps 1.3 {look}') for name, look in zip(names, styles)]
    drawing.draw(os.path.join(images, 'failures.png'), entries, 2)
