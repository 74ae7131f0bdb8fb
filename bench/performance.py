"""docs/performance.md: its targets and what the results say about them, tables and the picture. What has not been measured is named with the
command that does."""
import math
import os
from dataclasses import dataclass
from typing import Callable

import histories
import limits
import mapped
import passes
from charts import OPEN_MARKERS, PROPORTIONAL, TARGET, Panels, decades, style
from peers_report import best, growth as memory_growth, total
from samples import groups, total_seconds
from scaling import DILUTE_PRODUCTS, DILUTE_SOLVES, GROWTH, certified_rows, growth_of
from store import load
from tables import error, missing, provenance, records, seconds, table

TIGHT = 1e-8
MOST_PRODUCTS = 26


@dataclass(frozen=True)
class Comparison:
    """Seconds, memory ours over theirs; at_least: the code was stopped there, without an answer."""
    case: dict
    level: float
    ours: float
    theirs: float
    at_least: bool
    memory: float = math.nan

    @property
    def ratio(self):
        return self.theirs / self.ours

    @property
    def label(self):
        return f'{self.case["n"]}² {self.case["percent"]:g} % {self.case["control"]}, {"> " if self.at_least else ""}{self.level:.0e}'


def against(document, code, surface, control=None):
    """Comparisons at the tightest level that we met and that they met or were stopped before, by size and contact."""
    own, found = {name: {group['case']: group for group in same} for (name,), same in groups(document['groups'], 'code').items()}, []
    mine = {**own.get('ours', {}), **(own.get('ours-float', {}) if code.endswith('-float') else {})}
    for key, group in own.get(code, {}).items():
        case = document['cases'][key]
        if key not in mine or case['surface'] != surface or case['control'] != (control or case['control']):
            continue
        for level in (1e-8, 1e-6, 1e-4):
            ours, theirs = best(mine[key], level), best(group, level)
            if ours and theirs:
                memory = memory_growth(ours) / memory_growth(theirs) if memory_growth(theirs) > 0 else math.nan
                found.append(Comparison(case, level, total(ours), total(theirs), False, memory))
                break
            if ours and 'limit' in group['stopped']:
                found.append(Comparison(case, level, total(ours), group['limit'], True))
                break
    return sorted(found, key=lambda each: (each.case['n'], each.case['percent'], each.case['control']))


@dataclass(frozen=True)
class Target:
    """`find` gives (label, value, limit) for everything measured, `more` whether values should be above their limits."""
    text: str
    wanted: str
    command: str
    source: str
    find: Callable
    more: bool = False
    form: str = '{:.3g}'


def listed(rows, label, value, limit, chosen=lambda row: True):
    """(label, value, limit) of rows; value: a key or a function, limit: a number, or a function that gives None for rows without one."""
    found = []
    for row in rows:
        bound = limit(row) if callable(limit) else limit
        if bound is not None and chosen(row):
            found.append((label.format(**row), value(row) if callable(value) else row[value], bound))
    return found


def compared(document, codes, surface, limit, control=None, value='ratio'):
    """A code that was stopped before the time that a target asks of it tells nothing, and is left out."""
    found = [(f'{code} {each.label}' if len(codes) > 1 or control else each.label, getattr(each, value), limit(each), each.at_least)
             for code in codes for each in against(document, code, surface, control)]
    return [(label, reached, wanted) for label, reached, wanted, at_least in found
            if wanted and not math.isnan(reached) and not (at_least and reached < wanted)]


def grown(document, key, limit):
    return [(f'{100 * row["area_wanted"]:g} % {row["control"]}', row[key], limit) for row in growth_of(certified_rows(document))]


def load_control(document):
    rows = {(row['n'], row['area_wanted'], row['control']): row['products'] for row in certified_rows(document)}
    return [(f'{n}² {100 * area:g} %', rows[n, area, 'load'] / count, 1.3) for (n, area, control), count in rows.items()
            if control == 'approach' and n >= 512 and (n, area, 'load') in rows]


def with_percent(rows):
    return [{**row, 'percent': f'{100 * row["area_wanted"]:g} %'} for row in rows]


def memory(document, limit, **values):
    return listed(with_percent(certified_rows(document, **values)), '{n}² {percent}',
                  lambda row: row.get('bytes_per_point_in_all', row['bytes_per_point'] + 16), limit,
                  lambda row: row['n'] >= 2048 and row['control'] == 'load')


def large(document, area, value, limit):
    return listed(with_percent(certified_rows(document, precision='single', tol=1e-4)), '{percent} {control}', value, limit,
                  lambda row: row['n'] == 16384 and row['area_wanted'] == area)


def from_file(document, n, value, limit):
    return listed(document['solves'], '{contact_percent:.2g} %', value, limit, lambda row: row['n'] == n and row.get('status') == 'OK')


def gigabytes(row):
    return row['peak_bytes'] / 1e9


def dilute(document, scene, limit_by_side):
    return listed(document.get('solves', ()), '{n}² {control}', 'ratio', lambda row: limit_by_side.get(row['n']),
                  lambda row: row['scene'] == scene and row['tol'] == TIGHT and 'ratio' in row and
                  (scene == 'asperity' or row['area_wanted'] == 0.001))


def product_ratio(document, key, limit):
    return listed(document['products'], '{n}² {threads} threads', key, limit, lambda row: row['n'] >= 1024 and key in row)


def bitwise(row):
    return int(row['same_as_one_thread'] == row['same_again'] == 'yes')


STANDARD = {512: 8, 1024: 15, 2048: 25, 4096: 30}
ASPHER = ('aspher-fft', 'aspher-h2', 'aspher-fft-float', 'aspher-h2-float')
BENCH = 'roughcontact-bench '
SINGLE = BENCH + 'scaling --precision single --tol 1e-4 --sizes 16384 --percents '
PEERS = BENCH + 'peers'
TARGETS = (
    Target('standard method, 10 %, times slower', '>= 8, 15, 25, 30 at 512², 1024², 2048², 4096²', PEERS + ' --only ours,baseline', 'peers',
           lambda d: compared(d, ('baseline',), 'rough', lambda each: STANDARD.get(each.case['n'])
                              if each.case['percent'] == 10 and each.level == TIGHT else None), True),
    Target('products to 1e-8, 512² to 4096²', '<= 26 (20)', BENCH + 'scaling', 'scaling', lambda d: grown(d, 'most', MOST_PRODUCTS)),
    Target('their growth', '<= N^0.2', BENCH + 'scaling', 'scaling', lambda d: grown(d, 'exponent', 0.2), form='{:.2f}'),
    Target('products in load over approach control, from 512² on', '<= 1.3', BENCH + 'scaling', 'scaling', load_control),
    Target('0.1 % of a rough surface: full-grid solver, times slower', '>= 8, 15, 30 at 1024², 2048², 4096²', BENCH + 'dilute', 'dilute',
           lambda d: dilute(d, 'rough', {1024: 8, 2048: 15, 4096: 30}), True),
    Target('one asperity on 4096²: full-grid solver, times slower', '>= 100', BENCH + 'dilute', 'dilute', lambda d: dilute(d, 'asperity', {4096: 100}),
           True),
    Target('16384², single, 1e-4, 10 %', '<= 75 s', SINGLE + '10', 'scaling', lambda d: large(d, 0.1, total_seconds, 75)),
    Target('its memory in all', '<= 12 GB', SINGLE + '10', 'scaling', lambda d: large(d, 0.1, gigabytes, 12)),
    Target('16384², single, 1e-4, 0.04 %', '<= 4 s', SINGLE + '0.04', 'scaling', lambda d: large(d, 0.0004, total_seconds, 4)),
    Target('its memory in all', '<= 4 GB', SINGLE + '0.04', 'scaling', lambda d: large(d, 0.0004, gigabytes, 4)),
    Target('32768², single, 1e-4, 0.04 %, gap of floats', '<= 12 s', BENCH + 'mapped', 'mapped', lambda d: from_file(d, 32768, 'seconds', 12)),
    Target('its memory in all', '<= 12 GB', BENCH + 'mapped', 'mapped', lambda d: from_file(d, 32768, 'peak_gigabytes', 12)),
    Target('65536², single, 1e-4, 0.02 %, gap of floats: memory in all', '<= 20 GB', BENCH + 'mapped', 'mapped',
           lambda d: from_file(d, 65536, 'peak_gigabytes', 20)),
    Target('bytes a point in all, mixed, from 2048² on', '<= 110 (80)', BENCH + 'scaling', 'scaling', lambda d: memory(d, 110)),
    Target('bytes a point in all, single, from 2048² on', '<= 51 (38)', BENCH + 'scaling --precision single --tol 1e-4', 'scaling',
           lambda d: memory(d, 51, precision='single', tol=1e-4)),
    Target('padded product, double, times slower, from 1024² on', '>= 1.7', BENCH + 'products', 'products', lambda d: product_ratio(d, 'ratio', 1.7), True),
    Target('padded product, single', '>= 2', BENCH + 'products', 'products', lambda d: product_ratio(d, 'single_ratio', 2), True),
    Target('product, share of in-cache FFTW speed', '(0.6)', BENCH + 'limits', 'limits',
           lambda d: listed(d['products'], '{n}² {precision} {threads} threads', 'fraction_of_transforms', 0.6), True),
    Target('both cores loaded by others, times slower', '<= 2.5', BENCH + 'busy', 'busy',
           lambda d: listed(d['busy'], '{n}² {threads} threads', 'ratio', 2.5)),
    Target('`deterministic=1`: one thread and more, run after run, bitwise equal', 'yes', BENCH + 'deterministic', 'deterministic',
           lambda d: listed(d.get('deterministic', ()), '{n}² {threads} threads', bitwise, 1, lambda row: row['choice'] == '1'), True),
    Target('`deterministic=1`: cost', '<= 10 %', BENCH + 'deterministic', 'deterministic',
           lambda d: listed(d.get('deterministic', ()), '{choice}, {threads} threads', 'cost_median', 0.1, lambda row: row['choice'] != '1'),
           form='{:+.1%}'),
    Target('batch: all threads over one', '>= 1.8', BENCH + 'batch', 'batch',
           lambda d: listed(d['batch'][:1], '{surfaces} surfaces of {n}²', lambda row: d['scaling'], 1.8), True),
    Target('ASPHER, times slower', '>= 10 from 10 % on, >= 5 at 0.1 to 1 %', PEERS, 'peers',
           lambda d: compared(d, ASPHER, 'rough', lambda each: 10 if each.case['percent'] >= 10 else 5, 'load'), True),
    Target('its hierarchical operator, single, 1e-4, 0.1 to 1 %, 512² to 2048²', '>= 7 (10)', PEERS, 'peers',
           lambda d: compared(d, ('aspher-h2-float',), 'rough',
                              lambda each: 7 if each.case['percent'] <= 1 and each.case['n'] <= 2048 else None, 'load'), True),
    Target('ASPHER, periodic, times slower', '>= 5 (8) at 0.1 to 1 %, >= 8 (12) from 8 % on', PEERS, 'peers',
           lambda d: compared(d, ('aspher-periodic',), 'wavy', lambda each: 8 if each.case['percent'] >= 8 else 5, 'load'), True),
    Target('our memory over ASPHER\'s', '<= 0.5', PEERS, 'peers', lambda d: compared(d, ASPHER, 'rough', lambda each: 0.5, 'load', 'memory')),
    Target('Tamaas, periodic, times slower', '>= 10', PEERS, 'peers', lambda d: compared(d, ('tamaas',), 'wavy', lambda each: 10, 'load'), True),
)


def judged(target, document):
    """(measured, verdict): how many values meet it, the furthest from it, and by how much that misses."""
    found = target.find(document) if document else []
    if not found:
        return 'not measured', ''
    margin = (lambda value, limit: value / limit) if target.more else (lambda value, limit: limit / value if value > 0 else math.inf)
    label, value, limit = min(found, key=lambda entry: margin(*entry[1:]))
    missed = [entry for entry in found if margin(*entry[1:]) < 1]
    measured = ('yes' if value else 'no') if target.wanted == 'yes' else target.form.format(value)
    others = f' (the furthest of {len(found)})' if len(found) > 1 else ''
    verdict = 'met' if not missed else f'missed by {len(missed)} of {len(found)}' if len(found) > 1 else 'missed'
    if missed and target.wanted != 'yes':
        verdict += f'; {target.form.format(value)} for {target.form.format(limit)}'
    return f'{measured}: {label}{others}', verdict


SCALING = ('grid={n}²{mark}; contact [%]={area_found:%.3g}; control; solver, backend={solver}, {backend}; set-up [s]={setup_seconds:s}; '
           'solve [s]={solve_seconds:s}; CPU [s]={cpu_seconds:s}; iterations; products; product [ms]={product_seconds_best:m.3g}; '
           'bytes/point={bytes_per_point:.0f}; in all={bytes_per_point_in_all:.0f}; candidates; modelled; contacts; residual={residual:err}')


def scaling_table(document, rows):
    newest = document['provenance'].get('library')
    rows = [{**row, 'mark': '' if row.get('library') == newest else '*', 'residual': max(row[key] for key in row if key.startswith('kkt_'))}
            for row in rows]
    return records(SCALING, rows) + ('\n\n`*`: measured with another build than the last run.' if any(row['mark'] for row in rows) else '')


def single_table(document):
    rows = certified_rows(document, precision='single', tol=1e-4)
    return rows and scaling_table(document, rows)


def baseline_table(document):
    rows = []
    for each in against(document, 'baseline', 'rough') if document else ():
        more = '> ' if each.at_least else ''
        rows.append([f'{each.case["n"]}²', f'{each.case["percent"]:g}', each.case['control'], error(each.level), seconds(each.ours),
                     more + seconds(each.theirs), f'{more}{each.ratio:.1f}', '' if each.at_least else f'{each.memory:.2f}'])
    titles = ['grid', 'contact [%]', 'control', 'level', 'roughcontact [s]', 'standard method [s]', 'ratio', 'memory ratio']
    return rows and table(titles, rows)


def profile_table(document):
    scenes = groups(document['rows'], 'scene')
    parts = list(dict.fromkeys(row['part'] for row in document['rows']))
    shares = {(row['scene'], row['part']): row['share'] for row in document['rows']}
    rows = [[part] + [f'{100 * shares.get((scene, part), 0):.1f}' for (scene,) in scenes] for part in parts]
    return table(['share of the processor time [%]'] + [scene for (scene,) in scenes], rows)


SECTIONS = {  # results, a table of them, the options that measure it
    'baseline': ('peers', baseline_table, ' --only ours,baseline'),
    'dilute': ('dilute', lambda d: records(DILUTE_SOLVES, d.get('solves', ())) + '\n\n' +
               records(DILUTE_PRODUCTS, [row for row in d.get('dilute', ()) if 'split_ms' in row]), ''),
    'busy': ('busy', lambda d: records(limits.BUSY, d['busy']), ''),
    'deterministic': ('deterministic', lambda d: records(limits.DETERMINISTIC, d['deterministic']), ''),
    'batch': ('batch', lambda d: f'{records(histories.BATCH, d["batch"])}\n\nAll threads are {d["scaling"]:.2f} times as fast as one.', ''),
    'profile': ('profile', profile_table, ''),
    'machine': ('limits', lambda d: records(limits.MACHINE, limits.machine_rows(d)) + '\n\n' + provenance(d), ''),
    'product-limits': ('limits', lambda d: records(limits.PRODUCTS, d['products']), ''),
    'pass-limits': ('limits', lambda d: records(limits.PASSES, d['passes']), ''),
    'pass-rates': ('passes', lambda d: records(passes.COLUMNS, d['rows']) + f'\n\nThe triad: {d["triad_gigabytes_per_second"]:.1f} GB/s. ' + provenance(d), ''),
    'scaling': ('scaling', lambda d: scaling_table(d, certified_rows(d)) + '\n\n' + provenance(d), ''),
    'scaling-single': ('scaling', single_table, ' --precision single --tol 1e-4 --sizes 4096,8192,16384 --percents 0.04,10'),
    'mapped': ('mapped', lambda d: records(mapped.COLUMNS, d['solves']) + '\n\n' + provenance(d), ''),
    'growth': ('scaling', lambda d: records(GROWTH, growth_of(certified_rows(d))), '')}


def sections(results):
    known = {name: load(results, name) for name in {'products', *(source for source, _, _ in SECTIONS.values())}}
    filled = {name: known[source] and make(known[source]) or missing(BENCH + source + options) for name, (source, make, options) in SECTIONS.items()}
    targets = [[target.text, target.wanted, *judged(target, known[target.source]), f'`{target.command}`'] for target in TARGETS]
    return {'targets': table(['', 'target', 'measured', '', 'command'], targets), **filled}


def product_sections(results):
    """Of docs/benchmarks.md."""
    document = load(results, 'products')
    return {'provenance': provenance(document), 'products': records(limits.PADDED, document['products'])}


def pictures(results, images):
    document = load(results, 'scaling')
    rows = certified_rows(document)
    single = certified_rows(document, tol=1e-4, precision='single')
    areas = sorted({r['area_wanted'] for r in rows + single})
    hollow = 'points ps 1.5 lw 1.4 lc rgb "#555555"'
    drawing = Panels(800, 830, 2, 2, 110)

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
                  curves(lambda r: r['products']) + [f'{MOST_PRODUCTS} with {TARGET}'])
    memory_axis = settings + ('set format y "%g"\nset yrange [4:2000]\nset ytics (5,10,20,50,100,200,500,1000,2000)\n'
                              'set ylabel "peak memory [bytes/point]" offset 1,0')
    drawing.panel(0, 1, 'memory beside gap and pressure', memory_axis, curves(lambda r: max(r['bytes_per_point'], 1e-3)) + [f'110 with {TARGET}'])
    if single:
        drawing.panel(1, 1, 'single precision, time to certified 10^{-4}', seconds_axis(single), curves(total_seconds, single))
    entries = [(f'{100 * area:g} % contact', style(number)) for number, area in enumerate(areas)]
    entries += [('load control (hollow)', hollow + ' pt 6'), ('proportional to points', f'lines {PROPORTIONAL}'), ('target', TARGET)]
    drawing.draw(os.path.join(images, 'scaling.png'), entries, 3)
