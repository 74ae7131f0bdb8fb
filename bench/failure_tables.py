#!/usr/bin/env python3
"""failure_tables.py RESULTS FAILURES PAPER: writes the tables of failures.json, histories.json and paper.json in the folder RESULTS
between the markers of the documents FAILURES and PAPER."""
import sys

from results import groups, load
from tables import error, fill, provenance, table

NNLS_PRINTED = 'nnls+nnls.pivoting=single'
NNLS_GP = NNLS_PRINTED + '+warmup=gp+warmup.iterations=100'


def mean(rows, key):
    return sum(row[key] for row in rows) / len(rows)


def median(values):
    ordered = sorted(values)
    middle = len(ordered) // 2
    return ordered[middle] if len(ordered) % 2 else (ordered[middle - 1] + ordered[middle]) / 2


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


def claims_table(failures, paper):
    data = failures['data']
    share = {r['n']: r for r in data['greedy'] if r['kernel'] == 'eq9' and r['spacing'] == 1}
    others = [r for r in data['greedy'] if not (r['kernel'] == 'eq9' and r['spacing'] == 1)]
    time = {r['solver']: r for r in paper['histories']}
    conjugate = time['polonsky-keer']
    warm_up = {(r['pivoting'], r['warmup'], r['steps']): r['solves'] for r in data['warm_up']}

    def ratio(a, b):
        return f'{time[a]["cold_seconds"] / time[b]["cold_seconds"]:.1f}'

    def by_hurst(exponent, key):
        return [r[key] for r in data['cmr_hurst'] if r['hurst'] == exponent]

    hursts = sorted({r['hurst'] for r in data['cmr_hurst']})
    losses = ', '.join(f'H = {h:g}: {100 * median(by_hurst(h, "plain_error")):.1f} % ({100 * min(by_hurst(h, "plain_error")):.1f} % at worst)'
                       for h in hursts)
    kept = ', '.join(f'{100 * mean([r for r in data["cmr_hurst"] if r["hurst"] == h], "kept"):.0f} %' for h in hursts)
    cost = mean(data['cmr_hurst'], 'certified_products') / mean(data['cmr_hurst'], 'full_products')
    rows = [
        ['greedy fails in about 40 % of Example 1, n = 100',
         'yes, with kernel `eq9`: ' + ', '.join(f'n = {n}: {percent(r["share"])} %' for n, r in share.items()), '`failures --row greedy`'],
        ['at any size n', 'yes, and the share grows with n', 'the same'],
        ['never at a spacing of 2 cells', f'yes: {sum(r["failures"] for r in others)} of {sum(r["draws"] for r in others)} draws, '
         'and none at a spacing of 1 with `love`, `disc`, `galerkin`, `punch`', 'the same'],
        ['when greedy works is an open question', 'answered: for every surface if and only if H^-1 has no positive entry off its '
         'diagonal', '`failures.greedy`'],
        ['NNLS with gradient steps is 26 times faster than conjugate gradients',
         f'no: {ratio("polonsky-keer", NNLS_GP)} times as fast as `polonsky-keer`, both on dense products; with block pivots '
         f'{ratio("polonsky-keer", "nnls")}, warm-started {conjugate["warm_seconds"] / time["nnls"]["warm_seconds"]:.1f} times',
         '`histories`, see below'],
        ['NNLS with gradient steps is two orders faster than greedy with conjugate gradients',
         f'no: {ratio("greedy", NNLS_GP)} times', 'the same'],
        ['Cholesky makes greedy 30 to 40 % faster', f'{ratio("greedy", "greedy+greedy.inner=cholesky")} times as fast, with '
         'factors that are updated', 'the same'],
        ['warm starts from the loading history help NNLS', f'yes: {time[NNLS_PRINTED]["cold_iterations"]:.0f} solves become '
         f'{time[NNLS_PRINTED]["warm_iterations"]:.0f}', 'the same'],
        ['and conjugate gradients', f'little: {100 * (1 - conjugate["ratio"]):.0f} % fewer products', 'the same'],
        ['gradient steps before NNLS pay', f'not a few: {warm_up["single", "none", 0]} solves cold, {warm_up["single", "gp", 10]} after 10 '
         f'steps, {warm_up["single", "gp", 50]} after 50, {warm_up["single", "gp", 100]} after 100; block pivots need '
         f'{warm_up["block", "none", 0]} cold', '`failures --row nnls`'],
        ['ADMM is slow', f'{ratio("admm", "polonsky-keer")} times the time of `polonsky-keer`, with an automatic penalty',
         '`histories`, see below'],
        ['CMR: error below 2 % for H > 0.5', 'in the median: ' + losses, '`failures --row cmr`'],
        ['CMR: half of the time is saved', f'candidates kept: {kept}; certified, with FFT products, it takes {cost:.1f} times the products '
         'of the whole problem on the finest grid alone: none is saved', 'the same'],
        ['CMR fails without a power-law spectrum', 'yes, see the table of [failures](failures.md#cascade-multi-resolution)', 'the same'],
    ]
    return table(['the paper', 'here', 'command'], rows)


def main():
    results, failures_file, paper_file = sys.argv[1:]
    failures, histories, paper = (load(results, name) for name in ('failures', 'histories', 'paper'))
    fill(failures_file, {'provenance': provenance(failures), 'atlas': atlas_table(failures), 'greedy': greedy_table(failures),
                         'inverse': inverse_table(failures), 'cmr': cmr_table(failures), 'gp': gp_table(failures),
                         'admm': admm_table(failures), 'conditioning': conditioning_table(failures),
                         'histories': history_table(histories)})
    fill(paper_file, {'claims': claims_table(failures, paper), 'section-4': history_table(paper)})


if __name__ == '__main__':
    main()
