"""Tables and the picture of docs/development/failures.md, from failures.json."""
import os

from charts import FILTERS, Panels, axes, style, ticks
from samples import chosen, groups, mean_of, values_of
from json_tables import load
from tables import provenance, records, table

ATLAS = 'method={row}; trigger; what happens={happens}; detected as={detected}; what the library does={library}'
CMR = ('surface; sub-sampled [%]={subsample:%.2f}; mean [%]={mean:%.2f}; max [%]={max:%.2f}; unresolved={unresolved:.2f}; trustworthy; '
       'certified={certified:err}; rounds; candidates kept [%]={kept:%.0f}')


def inverse_table(rows):
    """A line for each kernel, a column for each number of points, cells side by side."""
    beside, lines = chosen(rows, spacing=1), []
    sizes = values_of(beside, 'n')
    for (kernel,), line in groups(beside, 'kernel').items():
        found = {row['n']: f'{row["coupling"]:+.1e}' for row in line}
        lines.append([kernel, *(found[n] for n in sizes)])
    return table(['kernel', *(f'n = {n}' for n in sizes)], lines)


def cmr_table(rows):
    lines = []
    for (surface,), found in groups(rows, 'surface').items():
        best, lost = chosen(found, filter='max'), {kind: mean_of(chosen(found, filter=kind), 'plain_error') for kind in FILTERS}
        lines.append({'surface': surface, **lost, 'unresolved': mean_of(best, 'unresolved'), 'kept': mean_of(best, 'kept'),
                      'trustworthy': 'yes' if all(r['trustworthy'] for r in best) else 'no', 'rounds': max(r['rounds'] for r in found),
                      'certified': max(abs(r['certified_error']) for r in found)})
    return records(CMR, lines)


def sections(results):
    data = load(results, 'failures')
    return {'provenance': provenance(data), 'atlas': records(ATLAS, [row for row in data['atlas'] if row['row'] != 'cmr']),
            'inverse': inverse_table(data['inverse']), 'cmr': cmr_table(data['cmr'])}


def pictures(results, images):
    data = load(results, 'failures')
    drawing, curves, entries = Panels(800, 380, 2, 1), [], []
    drawing.script.append('unset logscale\nset format "%g"\n')
    for number, (kernel,) in enumerate(groups(data['greedy'], 'kernel')):
        shift = 1 + 0.05 * (number - 2)  # so that the kernels that never fail do not hide each other
        points = [(shift * r['n'], 100 * r['share'], 100 * r['lower'], 100 * r['upper']) for r in chosen(data['greedy'], kernel=kernel, spacing=1)]
        curves += drawing.bars(points, style(number))
        entries.append((f'kernel {kernel}', style(number)))
    drawing.panel(0, 0, 'greedy: share of wrong answers, Example 1',
                  axes('points n', '% of draws', (18, 560), (-3, 100), 'set logscale x\nset xtics (25,100,400)'), curves)

    surfaces, curves = [name for (name,) in groups(data['cmr'], 'surface')], []
    looks = [*(('plain_error', kind, f'as published, {kind}', look) for kind, look in FILTERS.items()),
             ('certified_error', 'max', 'certified', 'pt 7 lc rgb "#000000"')]
    for key, kind, name, look in looks:
        largest = [100 * max(abs(r[key]) for r in chosen(data['cmr'], surface=surface, filter=kind)) for surface in surfaces]
        curves.append(drawing.curve([(max(value, 1e-8), i) for i, value in enumerate(largest)], f'points ps 1.3 {look}'))
        entries.append((name.replace('subsample', 'sub-sampled'), f'points ps 1.3 {look}'))
    settings = 'set format x "10^{%T}"\nset xtics 1e-8,100\n' + ticks('y', [(name, i) for i, name in enumerate(surfaces)]) + ' noenhanced'
    drawing.panel(1, 0, 'cascade multi-resolution',
                  axes('error of the load [%]', '', (1e-8, 200), (len(surfaces) - 0.4, -0.6), settings), curves, 180)
    drawing.draw(os.path.join(images, 'failures.png'), entries, 2)
