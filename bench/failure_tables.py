#!/usr/bin/env python3
"""failure_tables.py RESULTS DOCUMENT: writes the tables of failures.json and histories.json in the folder RESULTS between the markers of
DOCUMENT, docs/failures.md."""
import sys

from results import groups, load
from tables import error, fill, provenance, table


def mean(rows, key):
    return sum(row[key] for row in rows) / len(rows)


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
        rows.append([surface] + [f'{100 * mean(by_filter[(f,)], "plain_error"):.2f}' for f in ('subsample', 'mean', 'max')] +
                    [f'{mean(best, "unresolved"):.2f}', 'yes' if all(r['trustworthy'] for r in best) else 'no',
                     error(max(abs(r['certified_error']) for r in lines)), str(max(r['rounds'] for r in lines)),
                     f'{100 * mean(best, "kept"):.0f}'])
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
                     f'{mean(lines, "cold_products"):.0f}', f'{mean(lines, "warm_products"):.0f}', f'{mean(lines, "ratio"):.2f}',
                     error(max(r['load_difference'] for r in lines)), ', '.join(sorted({r['status'] for r in lines}))])
    return table(['solver', 'grid, backend', 'surfaces', 'cold products', 'warm products', 'warm / cold', 'load difference', 'status'],
                 rows)


def main():
    results, file = sys.argv[1:]
    failures, histories = load(results, 'failures'), load(results, 'histories')
    fill(file, {'provenance': provenance(failures), 'atlas': atlas_table(failures), 'greedy': greedy_table(failures),
                'inverse': inverse_table(failures), 'cmr': cmr_table(failures), 'gp': gp_table(failures), 'admm': admm_table(failures),
                'conditioning': conditioning_table(failures), 'histories': history_table(histories)})


if __name__ == '__main__':
    main()
