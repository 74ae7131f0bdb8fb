"""Tables and pictures of docs/scale-out.md, from ranks.json. Every line says whether it was measured, simulated or computed."""
import math
import os

from charts import Panels, axes, decades, style
from ranks_model import WHOLE_SECONDS, counted_transposed
from samples import chosen, groups
from json_tables import load
from tables import missing, provenance, records, seconds, table

COMMAND = 'roughcontact-bench ranks'
PAIRS = ('kind=measured; grid={n}²; 1 process x 2 threads [s]={process[seconds]:s}; 2 ranks x 1 thread [s]={ranks[seconds]:s}; ratio={time:.2f}; '
         'CPU seconds, ratio={cpu:.2f}; memory [MB]={process_megabytes:.0f}; memory of both ranks [MB]={ranks_megabytes:.0f}; ratio={memory:.2f}; '
         'products={ranks[products]}; same pressures={same}')
COUNTS = ('kind; products in={numbers}; grid={n}²; ranks; iterations={distributed_iterations}; products; reductions={reductions}; '
          'reductions an iteration={a:.2f}; transpositions a product, in parts={t:.2f}; sent [MB]={sent:.3f}; by the model [MB]={model:.3f}; '
          'counted / model={ratio:.3f}; '
          'given to sums, an iteration [kB]={sums:.1f}; gathered, a product [kB]={gathers:.1f}')
SIMULATED = ('kind; network; grid={n}²; ranks; points a rank={each:.3g}; seconds={seconds:s}; speed-up={speedup}; efficiency [%]={efficiency}; '
             'work of a rank, mean [s]={own_seconds:s}; of the busiest [s]={most_own_seconds:s}; products; by the fitted model [s]={model:s}')
COMPUTED = ('kind; network; grid={n}²; ranks; ranks with rows={with_rows}; seconds={seconds:s}; communication [%]={communication:%.0f}; '
            'memory a rank [GB]={gigabytes_a_rank:.3g}; most time={limit}')
NETWORKS = {'fast': '12.5 GB/s, 1.5 µs', 'slow': '1.25 GB/s, 20 µs'}


def good(document, name):
    return [row for row in document.get(name, []) if row.get('status') == 'RC_OK']


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
        sent, model = row['transposed'], counted_transposed(row['n'], row['ranks'], products)
        found.append({**row, 'kind': 'measured', 'a': row['reductions'] / iterations, 't': row['transpositions'] / products, 'sent': sent / 1e6,
                      'model': model / 1e6, 'ratio': sent / model, 'sums': row['reduced'] / iterations / 1e3,
                      'gathers': row['gathered'] / products / 1e3})
        if row['numbers'] == 'mixed':  # and on coarser grids as well
            del found[-1]['model'], found[-1]['ratio']
    return found


def simulations(document, weak):
    """Strong: rows of a grid that several numbers of ranks have. Weak: 2^20 points a rank."""
    rows, errors = good(document, 'simulated'), document.get('model', {}).get('errors', [])
    told = [{**row, 'model': row['seconds'] * (1 + error)} for row, error in zip(rows, errors)] if len(errors) == len(rows) else rows
    found = []
    for (network, n), same in sorted(groups(told, 'network', 'n').items()):
        first = min(same, key=lambda row: row['ranks'])
        if not weak and len(same) < 2:
            continue
        for row in sorted(same, key=lambda row: row['ranks']):
            each = n * n / row['ranks']
            if weak and each != 2**20:
                continue
            row = {**row, 'network': NETWORKS[network], 'each': each, 'speedup': '', 'efficiency': ''}
            if weak:
                one = next((other for other in told if other['network'] == network and other['ranks'] == 1 and other['n'] == 1024), None)
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


def coefficients(model):
    a, i, r, m, b = model['coefficients']
    errors = [abs(error) for error in model['errors']]
    return (f'a = {a:.3g} s, i = {i:.3g} s, t = {WHOLE_SECONDS:.3g} s, r = {seconds(r)} s, m = {m:.3g}, b = {b:.3g}; over {len(errors)} simulated solves the model is off by '
            f'{100 * sum(errors) / len(errors):.0f} % on the mean, {100 * max(errors):.0f} % at most. Memory: {model["bytes_a_point"]:.0f} bytes a point, '
            f'and {model["bytes_a_rank"] / 1e6:.0f} MB a rank.')


def sections(results):
    document = load(results, 'ranks')
    if not document:
        return {'picture': '', **{name: missing(COMMAND) for name in ('measured', 'counted', 'strong', 'weak', 'model', 'computed', 'failed', 'provenance')}}
    model = document.get('model', {})
    picture = '![Seconds of solves against ranks, simulated and computed](images/ranks.png)' if good(document, 'simulated') else ''
    return {'picture': picture, 'measured': records(PAIRS, pairs(document)), 'counted': records(COUNTS, counts(document)),
            'strong': records(SIMULATED, simulations(document, False)), 'weak': records(SIMULATED, simulations(document, True)),
            'model': coefficients(model) if model else missing(COMMAND),
            'computed': records(COMPUTED, [{**row, 'network': NETWORKS[row['network']]} for row in model['rows']]) if model else missing(COMMAND),
            'failed': failed(document), 'provenance': provenance(document)}


def pictures(results, images):
    document = load(results, 'ranks')
    rows, model = good(document, 'simulated'), document.get('model', {})
    if not rows:
        return
    drawing, simulated, computed, entries = Panels(800, 430, 2, 1, 90), [], [], []
    series = groups(sorted(rows, key=lambda row: row['ranks']), 'network', 'n')
    series = {key: same for key, same in series.items() if len(same) > 1}
    for number, ((network, n), same) in enumerate(sorted(series.items())):
        simulated.append(drawing.curve([(row['ranks'], row['seconds']) for row in same], style(number)))
        entries.append((f'{n}², {NETWORKS[network]}', style(number)))
    for number, ((network, n), same) in enumerate(sorted(groups(model.get('rows', []), 'network', 'n').items()), len(series)):
        computed.append(drawing.curve([(row['ranks'], row['seconds']) for row in same], style(number)))
        entries.append((f'{n}², {NETWORKS[network]}', style(number)))
    powers = 'set format x "%g"\nset logscale x 2'
    drawing.panel(0, 0, 'simulated', axes('ranks', 'seconds', (0.8, 320), decades([row['seconds'] for row in rows]), powers), simulated or ['NaN notitle'])
    if computed:
        drawing.panel(1, 0, 'computed', axes('ranks', 'seconds', (800, 20000), decades([row['seconds'] for row in model['rows']]), powers), computed)
    drawing.draw(os.path.join(images, 'ranks.png'), entries, 2)
