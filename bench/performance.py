"""Tables and the picture of docs/development/performance.md, and the table of benchmarks.md. What has not been measured is named
with the command that does."""
import os

import histories
import mapped
from charts import OPEN_MARKERS, PROPORTIONAL, Panels, decades, style
from products import PADDED
from samples import chosen, groups, total_seconds
from scaling import GROWTH, certified_rows, growth_of
from json_tables import load
from tables import missing, provenance, records

BENCH = 'roughcontact-bench '
SCALING = ('grid={n}²{mark}; contact [%]={area_found:%.3g}; solver, backend={solver}, {backend}; set-up [s]={setup_seconds:s}; '
           'solve [s]={solve_seconds:s}; CPU [s]={cpu_seconds:s}; products; bytes/point={bytes_per_point:.0f}; in all={bytes_per_point_in_all:.0f}')


def scaling_table(document, rows):
    """By load; the results have both controls and more columns."""
    newest = document['provenance'].get('library')
    rows = [{**row, 'mark': '' if row.get('library') == newest else '*'} for row in chosen(rows, control='load')]
    return records(SCALING, rows) + ('\n\n`*`: measured with another build than the last run.' if any(row['mark'] for row in rows) else '')


def single_table(document):
    rows = certified_rows(document, precision='single', tol=1e-4)
    return rows and scaling_table(document, rows)


SECTIONS = {  # results, a table of them, the options that measure it
    'batch': ('batch', lambda d: f'{records(histories.BATCH, d["batch"])}\n\nAll threads are {d["scaling"]:.2f} times as fast as one.', ''),
    'scaling': ('scaling', lambda d: scaling_table(d, certified_rows(d)) + '\n\n' + provenance(d), ''),
    'scaling-single': ('scaling', single_table, ' --precision single --tol 1e-4 --sizes 4096,8192,16384 --percents 0.04,10'),
    'mapped': ('mapped', lambda d: records(mapped.COLUMNS, d['solves']) + '\n\n' + provenance(d), ''),
    'growth': ('scaling', lambda d: records(GROWTH, growth_of(certified_rows(d))), '')}


def sections(results):
    known = {source: load(results, source) for source, _, _ in SECTIONS.values()}
    return {name: known[source] and make(known[source]) or missing(BENCH + source + options) for name, (source, make, options) in SECTIONS.items()}


def product_sections(results):
    """The tables of docs/development/benchmarks.md."""
    document = load(results, 'products')
    return {'provenance': provenance(document), 'products': records(PADDED, document['products'])}


def pictures(results, images):
    document = load(results, 'scaling')
    rows = certified_rows(document)
    single = certified_rows(document, tol=1e-4, precision='single')
    areas = sorted({r['area_wanted'] for r in rows + single})
    hollow = 'points ps 1.5 lw 1.4 lc rgb "#555555"'
    drawing = Panels(800, 720, 2, 2)

    def curves(value, of=rows):
        result, families = [], groups(of, 'area_wanted', 'control')
        for (area, control), found in families.items():
            number, second = areas.index(area), control == 'load' and (area, 'approach') in families
            look = f'{hollow} pt {OPEN_MARKERS[number % len(OPEN_MARKERS)]}' if second else style(number)
            result.append(drawing.curve([(r['n'] ** 2, value(r)) for r in found], look))
        return result

    sides = sorted({r['n'] for r in rows + single})
    tics = ', '.join(f'"{n}²" {n * n}' for n in sides[-1::-2][::-1])
    settings = f'set xrange [{sides[0] ** 2 / 1.6}:{sides[-1] ** 2 * 1.6}]\nset xtics ({tics})\nset xlabel "points" offset 0,0.4\n'

    def seconds_axis(of):
        lowest, highest = decades([total_seconds(r) for r in of])
        return (settings + f'set format y "10^{{%T}}"\nset yrange [{lowest}:{highest}]\nset ytics autofreq\n'
                'set ylabel "set-up and solve [s]" offset 1.2,0')

    slope = 0.25 * min(total_seconds(r) / r['n'] ** 2 for r in rows if r['n'] == max(r['n'] for r in rows))
    drawing.panel(0, 0, 'time to certified 10^{-8}', seconds_axis(rows), curves(total_seconds) + [f'{slope!r}*x with lines {PROPORTIONAL}'])
    drawing.panel(1, 0, 'products with H', settings + 'set format y "%g"\nset yrange [2:200]\n'
                  'set ytics (2,5,10,20,30,50,100,200)\nset ylabel "products" offset 1,0',
                  curves(lambda r: r['products']))
    memory_axis = settings + ('set format y "%g"\nset yrange [4:2000]\nset ytics (5,10,20,50,100,200,500,1000,2000)\n'
                              'set ylabel "peak memory [bytes/point]" offset 1,0')
    drawing.panel(0, 1, 'memory without gap and pressure', memory_axis, curves(lambda r: max(r['bytes_per_point'], 1e-3)))
    if single:
        drawing.panel(1, 1, 'single precision, time to certified 10^{-4}', seconds_axis(single), curves(total_seconds, single))
    entries = [(f'{100 * area:g} % contact', style(number)) for number, area in enumerate(areas)]
    entries += [('load control (hollow)', hollow + ' pt 6'), ('proportional to points', f'lines {PROPORTIONAL}')]
    drawing.draw(os.path.join(images, 'scaling.png'), entries, 3)
