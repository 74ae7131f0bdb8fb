"""Tables and the picture of docs/performance.md, and those of docs/benchmarks.md. What has not been measured is named with the command that does."""
import os

import scaling_targets as targets
from charts import OPEN_MARKERS, PROPORTIONAL, TARGET, Panels, decades, style
from samples import groups, scaling_rows, total_seconds
from store import load, load_known
from tables import error, missing, provenance, seconds, table

BENCH = 'roughcontact-bench'


def percent(value):
    return f'{100 * value:.3g}'


def limits_tables(document):
    if not document:
        return {name: missing(BENCH + ' limits') for name in ('machine', 'product-limits', 'pass-limits')}
    machine = [['memory, triad', '', str(row['threads']), f'{row["gigabytes_per_second"]:.1f} GB/s'] for row in document['bandwidth']]
    machine += [[f'complex transform of {row["length"]}', row['precision'], str(row['threads']), f'{row["gigaflops"]:.1f} GFlop/s']
                for row in document['transforms']]
    product = [[f'{row["n"]}²', row['precision'], str(row['threads']), f'{row["operations_per_point"]:.0f}', f'{row["bytes_per_point"]:.0f}',
                *(f'{1000 * row[key]:.3g}' for key in ('seconds', 'operation_seconds', 'byte_seconds')), f'{row["gigaflops"]:.1f}',
                f'{row["gigabytes_per_second"]:.1f}', f'{row["fraction"]:.2f}'] for row in document['products']]
    passes = [[f'{row["n"]}²', row['precision'], str(row['threads']), str(row['iterations']), str(row['products']),
               *(f'{1000 * row[key]:.3g}' for key in ('seconds', 'product_seconds', 'other_seconds')), f'{row["tree_bytes_per_point"]:.0f}',
               f'{row["vector_bytes_per_point"]:.0f}', f'{1000 * row["byte_seconds"]:.3g}', f'{row["fraction_of_bandwidth"]:.2f}']
              for row in document['passes']]
    return {'machine': table(['limit', 'precision', 'threads', 'measured'], machine) + '\n\n' + provenance(document),
            'product-limits': table(['grid', 'precision', 'threads', 'operations/point', 'bytes/point', 'measured [ms]',
                                     'by operations [ms]', 'by bytes [ms]', 'GFlop/s', 'GB/s', 'fraction'], product),
            'pass-limits': table(['grid', 'precision', 'threads', 'iterations', 'products', 'solve [ms]', 'in products [ms]', 'besides [ms]',
                                  'trees [bytes/point]', 'vectors [bytes/point]', 'by bytes [ms]', 'fraction'], passes)}


def product_table(document):
    rows = []
    for row in document['products']:
        rows.append([f'{row["n"]}²', str(row['threads'])])
        for of in ('', 'single_') if 'single_ratio' in row else ('',):
            times = [row[of + key] for key in ('estimate_best', 'measure_best', 'padded_estimate_best', 'padded_measure_best')]
            rows[-1] += [f'{1000 * t:.3g}' for t in times] + [f'{times[3] / times[0]:.2f}', error(row[of + 'difference'])]
    names = ['fft [ms]', 'fft, measured plan', 'padded [ms]', 'padded, measured plan', 'ratio', 'difference']
    both = 'single_ratio' in document['products'][0]
    return table(['grid', 'threads'] + names + ([f'single: {name}' for name in names] if both else []), rows)


def scaling_table(document, rows):
    newest = document['provenance'].get('library')
    lines = []
    for row in rows:
        mark = '' if row.get('library') == newest else '*'
        product = f'{1000 * row["product_seconds_best"]:.3g}' if 'product_seconds_best' in row else ''
        lines.append([f'{row["n"]}²{mark}', percent(row['area_found']), row['control'], f'{row["solver"]}, {row["backend"]}',
                      *(seconds(row[key]) for key in ('setup_seconds', 'solve_seconds', 'cpu_seconds')), str(row['iterations']),
                      str(row['products']), product, f'{row["bytes_per_point"]:.0f}',
                      f'{row["bytes_per_point_in_all"]:.0f}' if 'bytes_per_point_in_all' in row else '', str(row['candidates']),
                      str(row['modelled']), str(row['contacts']), error(max(row[key] for key in row if key.startswith('kkt_')))])
    text = table(['grid', 'contact [%]', 'control', 'solver, backend', 'set-up [s]', 'solve [s]', 'CPU [s]', 'iterations', 'products',
                  'product [ms]', 'bytes/point', 'in all', 'candidates', 'modelled', 'contacts', 'residual'], lines)
    return text + ('\n\n`*`: measured with another build than the last run.' if any('²*' in line[0] for line in lines) else '')


def scaling_tables(document):
    if not document:
        return {name: missing(BENCH + ' scaling') for name in ('scaling', 'scaling-single', 'growth')}
    single = scaling_rows(document, precision='single', tol=1e-4)
    growth = targets.growth_of(document)
    return {'scaling': scaling_table(document, scaling_rows(document)) + '\n\n' + provenance(document),
            'scaling-single': scaling_table(document, single) if single else
            missing(BENCH + ' scaling --precision single --tol 1e-4 --sizes 4096,8192,16384 --percents 0.04,10'),
            'growth': table(['contact [%]', 'control', 'grids', 'products', 'growth'],
                            [[percent(area), control, f'{low}² to {high}²', f'{least} to {most}', f'N^{exponent:.2f}']
                             for area, control, low, high, least, most, exponent in growth])}


def baseline_table(document):
    ratios = targets.against(document, 'baseline', 'rough') if document else []
    if not ratios:
        return missing(BENCH + ' peers --only ours,baseline')
    rows = []
    for each in ratios:
        more = '> ' if each.at_least else ''
        rows.append([f'{each.case["n"]}²', f'{each.case["percent"]:g}', each.case['control'], f'{each.level:.0e}', seconds(each.ours),
                     more + seconds(each.theirs), f'{more}{each.ratio:.1f}', '' if each.at_least else f'{each.memory:.2f}'])
    return table(['grid', 'contact [%]', 'control', 'level', 'roughcontact [s]', 'standard method [s]', 'ratio', 'memory ratio'], rows)


def dilute_table(document):
    if not document:
        return missing(BENCH + ' dilute')
    solves = []
    for row in document.get('solves', ()):
        auto, whole = row.get('auto', {}), row.get('fft', {})
        solves.append([row['scene'], f'{row["n"]}²', f'{auto["contact_percent"]:.3g}' if 'contact_percent' in auto else '', row['control'],
                       error(row['tol']), f'{auto.get("solver", "")}, {auto.get("backend", "")}',
                       *(seconds(of['seconds']) if 'seconds' in of else '' for of in (auto, whole)),
                       f'{row["ratio"]:.1f}' if 'ratio' in row else '', str(auto.get('products', '')),
                       *(f'{of["peak_megabytes"]:.0f}' if 'peak_megabytes' in of else '' for of in (auto, whole))])
    products = [[f'{row["n"]}²', f'{row["contact_percent"]:.3g}', str(row['threads']),
                 *(f'{row[key]:.3g}' if key in row else '' for key in ('fft_ms', 'split_ms', 'ratio', 'fft_float_ms', 'split_float_ms',
                                                                       'float_ratio')), error(row['difference'])]
                for row in document.get('dilute', ()) if 'split_ms' in row]
    parts = [table(['surface', 'grid', 'contact [%]', 'control', 'tol', 'auto', 'auto [s]', 'full grid [s]', 'ratio', 'products',
                    'auto, peak [MB]', 'full grid, peak [MB]'], solves),
             table(['grid', 'contact [%]', 'threads', 'fft [ms]', 'split [ms]', 'ratio', 'fft, single [ms]', 'split, single [ms]', 'ratio',
                    'difference'], products)]
    return '\n\n'.join(parts)


def busy_table(document):
    if not document:
        return missing(BENCH + ' busy')
    rows = [[f'{row["n"]}²', f'{row["contact_percent"]:.1f}', str(row['threads']), str(row['others']), seconds(row['idle_median']),
             seconds(row['busy_median']), f'{row["ratio"]:.2f}', f'{row["ratio_largest"]:.2f}'] for row in document['busy']]
    return table(['grid', 'contact [%]', 'threads', 'others', 'alone [s]', 'beside others [s]', 'ratio', 'largest ratio'], rows)


def deterministic_table(document):
    if not document or 'deterministic' not in document:
        return missing(BENCH + ' deterministic')
    rows = [[f'{row["n"]}²', str(row['threads']), row['choice'], seconds(row['median']), seconds(row['best']),
             f'{100 * row["cost_median"]:+.1f} %', f'{100 * row["cost_best"]:+.1f} %', row['same_as_one_thread'], row['same_again']]
            for row in document['deterministic']]
    return table(['grid', 'threads', '`deterministic`', 'median [s]', 'best [s]', '1 costs, of medians', 'of bests', 'bits of one thread',
                  'same bits again'], rows)


def batch_table(document):
    if not document:
        return missing(BENCH + ' batch')
    rows = [[str(row['threads']), str(row['surfaces']), f'{row["n"]}²', str(row['steps']), row['control'], seconds(row['seconds']),
             f'{row["surfaces_per_second"]:.1f}', f'{row["solves_per_second"]:.0f}', str(row['products']), str(row['certified'])]
            for row in document['batch']]
    return (table(['threads', 'surfaces', 'grid', 'steps', 'control', 'time [s]', 'surfaces/s', 'solves/s', 'products', 'certified'], rows) +
            f'\n\nAll threads are {document["scaling"]:.2f} times as fast as one.')


def profile_table(document):
    if not document:
        return missing(BENCH + ' profile')
    scenes = groups(document['rows'], 'scene')
    parts = list(dict.fromkeys(row['part'] for row in document['rows']))
    shares = {(row['scene'], row['part']): row['share'] for row in document['rows']}
    rows = [[part] + [f'{100 * shares.get((scene, part), 0):.1f}' for (scene,) in scenes] for part in parts]
    return table(['share of the processor time [%]'] + [scene for (scene,) in scenes], rows)


def targets_table(documents):
    rows = [[target.text, target.wanted, measured, verdict, f'`{target.command}`'] for target, measured, verdict in targets.judged(documents)]
    return table(['', 'target', 'measured', '', 'command'], rows)


def product_sections(results):
    """Of docs/benchmarks.md."""
    document = load(results, 'products')
    return {'provenance': provenance(document), 'products': product_table(document)}


def sections(results):
    documents = {name: load_known(results, name) for name in targets.RESULTS}
    found = {'targets': targets_table(documents)}
    for name, make in (('baseline', baseline_table), ('dilute', dilute_table), ('busy', busy_table), ('deterministic', deterministic_table),
                       ('batch', batch_table), ('profile', profile_table)):
        found[name] = make(documents['peers' if name == 'baseline' else name])
    return {**found, **limits_tables(documents['limits']), **scaling_tables(documents['scaling'])}


def pictures(results, images):
    document = load(results, 'scaling')
    rows = scaling_rows(document)
    single = scaling_rows(document, tol=1e-4, precision='single')
    areas = [(area,) for area in sorted({r['area_wanted'] for r in rows + single})]
    hollow = 'points ps 1.5 lw 1.4 lc rgb "#555555"'
    drawing = Panels(800, 830, 2, 2, 110)

    def curves(value, of=rows):
        result = []
        families = groups(of, 'area_wanted', 'control')
        for (area, control), found in families.items():
            second = control == 'load' and (area, 'displacement') in families
            points = drawing.block([(r['n'] ** 2, value(r)) for r in found])
            number = areas.index((area,))
            look = f'{hollow} pt {OPEN_MARKERS[number % len(OPEN_MARKERS)]}' if second else style(number)
            result.append(f'{points} with {look}')
        return result

    def target(value):
        return f'{value!r} with {TARGET}'

    sides = sorted({r['n'] for r in rows + single})
    tics = ', '.join(f'"{n}²" {n * n}' for n in sides[-1::-2][::-1])
    settings = f'set xrange [{sides[0] ** 2 / 1.6}:{sides[-1] ** 2 * 1.6}]\nset xtics ({tics})\nset xlabel "points" offset 0,0.4\n'

    def seconds_axis(of):
        lowest, highest = decades([total_seconds(r) for r in of])
        return (settings + f'set format y "10^{{%T}}"\nset yrange [{lowest}:{highest}]\nset ytics autofreq\n'
                'set ylabel "set-up and solve [s]" offset 1.2,0')

    slope = 0.25 * min(total_seconds(r) / r['n'] ** 2 for r in rows if r['n'] == max(r['n'] for r in rows))
    drawing.panel(0, 0, 'time to certified 10^{-8}', seconds_axis(rows),
                  curves(total_seconds) + [f'{slope!r}*x with lines {PROPORTIONAL}'])
    drawing.panel(1, 0, 'products with H', settings + 'set format y "%g"\nset yrange [2:200]\n'
                  'set ytics (2,5,10,20,30,50,100,200)\nset ylabel "products" offset 1,0', curves(lambda r: r['products']) + [target(30)])
    memory = settings + ('set format y "%g"\nset yrange [4:2000]\nset ytics (5,10,20,50,100,200,500,1000,2000)\n'
                         'set ylabel "peak memory [bytes/point]" offset 1,0')
    drawing.panel(0, 1, 'memory beside gap and pressure', memory,
                  curves(lambda r: max(r['bytes_per_point'], 1e-3)) + [target(110)])
    if single:
        drawing.panel(1, 1, 'single precision, time to certified 10^{-4}', seconds_axis(single), curves(total_seconds, single))
    entries = [(f'{100 * area:g} % contact', style(number)) for number, (area,) in enumerate(areas)]
    entries += [('load control (hollow)', hollow + ' pt 6'), ('proportional to points', f'lines {PROPORTIONAL}'), ('target', TARGET)]
    drawing.draw(os.path.join(images, 'scaling.png'), entries, 3)
