"""Tables and pictures of docs/development/scale-out.md, from ranks.json. Every line says whether it was measured or simulated."""
import math
import os

from charts import Panels, axes, decades, style
from samples import chosen, groups
from json_tables import load
from tables import missing, provenance, records, table

COMMAND = 'roughcontact-bench ranks'
PAIRS = ('kind=measured; grid={n}²; 1 process x 2 threads [s]={process[seconds]:s}; 2 ranks x 1 thread [s]={ranks[seconds]:s}; ratio={time:.2f}; '
         'CPU seconds, ratio={cpu:.2f}; memory [MB]={process_megabytes:.0f}; memory of both ranks [MB]={ranks_megabytes:.0f}; ratio={memory:.2f}; '
         'products={ranks[products]}; same pressures={same}')
COUNTS = ('kind; products in={numbers}; grid={n}²; ranks; iterations={distributed_iterations}; products; reductions={reductions}; '
          'reductions an iteration={a:.2f}; transpositions a product, in parts={t:.2f}; sent [MB]={sent:.3f}; by the formula [MB]={formula:.3f}; '
          'given to sums, an iteration [kB]={sums:.1f}; gathered, a product [kB]={gathers:.1f}')
SIMULATED = ('kind; network; grid={n}²; ranks; points a rank={each:.3g}; seconds={seconds:s}; speed-up={speedup}; efficiency [%]={efficiency}; '
             'work of a rank, mean [s]={own_seconds:s}; of the busiest [s]={most_own_seconds:s}; products')
NETWORKS = {'fast': '12.5 GB/s, 1.5 µs', 'slow': '1.25 GB/s, 20 µs'}


def good(document, name):
    return [row for row in document.get(name, []) if row.get('status') == 'RC_OK']


def transposed(n, ranks, size):
    """Bytes that all ranks send to others in a product with free boundaries whose numbers have `size` bytes. The spectra of the rows, n
    complex waves each, are transposed twice."""
    return 4 * n**2 * size * (1 - 1 / ranks)


def eigenvalues(n, ranks):
    """Bytes that are sent of the eigenvalues, once."""
    return 8 * n**2 * (1 - 1 / ranks)


def pairs(document):
    found = []
    for (n,), rows in sorted(groups(good(document, 'measured'), 'n').items()):
        ways = {row['way']: row for row in rows}
        if len(ways) < 2:
            continue
        one, two = ways['process'], ways['ranks']
        busy = one['cpu_seconds'] or math.nan  # 0 where the clock has not ticked
        found.append({'n': n, **ways, 'time': two['seconds'] / one['seconds'], 'cpu': two['cpu_seconds'] / busy,
                      'memory': two['peak_bytes'] / one['peak_bytes'], 'process_megabytes': one['peak_bytes'] / 1e6,
                      'ranks_megabytes': two['peak_bytes'] / 1e6, 'same': 'yes' if one['bits'] == two['bits'] else 'no'})
    return found


def counts(document):
    rows = [{'numbers': 'double', **row} for row in good(document, 'counted')]
    rows += [{'numbers': 'mixed', **row} for row in chosen(good(document, 'measured'), way='ranks')]
    found = []
    for row in rows:
        products, iterations = max(row['products'], 1), max(row['distributed_iterations'], 1)
        sent, formula = row['transposed'], products * transposed(row['n'], row['ranks'], 8) + eigenvalues(row['n'], row['ranks'])
        found.append({**row, 'kind': 'measured', 'a': row['reductions'] / iterations, 't': row['transpositions'] / products, 'sent': sent / 1e6,
                      'formula': formula / 1e6, 'sums': row['reduced'] / iterations / 1e3,
                      'gathers': row['gathered'] / products / 1e3})
        if row['numbers'] == 'mixed':  # and on coarser grids as well
            del found[-1]['formula']
    return found


def simulations(document, weak):
    """Strong: rows of a grid that several numbers of ranks have. Weak: 2^20 points a rank."""
    stated, found = good(document, 'simulated'), []
    for (network, n), same in sorted(groups(stated, 'network', 'n').items()):
        first = min(same, key=lambda row: row['ranks'])
        if not weak and len(same) < 2:
            continue
        for row in sorted(same, key=lambda row: row['ranks']):
            each = n * n / row['ranks']
            if weak and each != 2**20:
                continue
            row = {**row, 'network': NETWORKS[network], 'each': each, 'speedup': '', 'efficiency': ''}
            if weak:
                one = next((other for other in stated if other['network'] == network and other['ranks'] == 1 and other['n'] == 1024), None)
                if one:
                    row['efficiency'] = f'{100 * one["seconds"] / row["seconds"]:.0f}'
            else:
                gain = first['seconds'] / row['seconds']
                row['speedup'] = f'{gain:.1f}' + (f' of {row["ranks"] / first["ranks"]:.0f}' if first['ranks'] > 1 else '')
                row['efficiency'] = f'{100 * gain * first["ranks"] / row["ranks"]:.0f}'
            found.append(row)
    return found


def failed(document):
    lines = [[name, f'{row["n"]}²', str(row.get('ranks', '')), row.get('network', ''), row.get('error') or row['status']]
             for name in ('measured', 'counted', 'simulated') for row in document.get(name, []) if row.get('status') != 'RC_OK']
    return table(['kind', 'grid', 'ranks', 'network', 'what it said'], lines) if lines else 'Nothing.'


def sections(results):
    document = load(results, 'ranks')
    if not document:
        return {'picture': '', **{name: missing(COMMAND) for name in ('measured', 'counted', 'strong', 'weak', 'failed', 'provenance')}}
    picture = '![Seconds of solves against ranks, simulated](../images/ranks.png)' if good(document, 'simulated') else ''
    return {'picture': picture, 'measured': records(PAIRS, pairs(document)), 'counted': records(COUNTS, counts(document)),
            'strong': records(SIMULATED, simulations(document, False)), 'weak': records(SIMULATED, simulations(document, True)),
            'failed': failed(document), 'provenance': provenance(document)}


def pictures(results, images):
    document = load(results, 'ranks')
    rows = good(document, 'simulated')
    if not rows:
        return
    drawing, simulated, entries = Panels(480, 340, 1, 1), [], []
    series = groups(sorted(rows, key=lambda row: row['ranks']), 'network', 'n')
    series = {key: same for key, same in series.items() if len(same) > 1}
    for number, ((network, n), same) in enumerate(sorted(series.items())):
        simulated.append(drawing.curve([(row['ranks'], row['seconds']) for row in same], style(number)))
        entries.append((f'{n}², {NETWORKS[network]}', style(number)))
    powers = 'set format x "%g"\nset logscale x 2'
    drawing.panel(0, 0, 'simulated', axes('ranks', 'seconds', (0.8, 320), decades([row['seconds'] for row in rows]), powers), simulated or ['NaN notitle'])
    drawing.draw(os.path.join(images, 'ranks.png'), entries, 2)
