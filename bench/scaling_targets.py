"""The targets of docs/performance.md, and what the results say about them."""
import math
from dataclasses import dataclass
from typing import Callable

from peers_report import best, growth as memory_growth, total
from samples import groups, scaling_rows, slope, total_seconds

RESULTS = ('scaling', 'products', 'limits', 'busy', 'deterministic', 'batch', 'dilute', 'peers', 'profile')
GROWING = range(512, 4097)  # grids whose products are counted
TIGHT = 1e-8


def growth_of(document):
    """Products of each area and control: area, control, first and last side, least and most, exponent of the side."""
    found = []
    for (area, control), rows in groups(scaling_rows(document), 'area_wanted', 'control').items():
        rows = [row for row in rows if row['n'] in GROWING]
        if len({row['n'] for row in rows}) > 1:
            counts = [row['products'] for row in rows]
            found.append((area, control, rows[0]['n'], rows[-1]['n'], min(counts), max(counts),
                          slope([(row['n'], row['products']) for row in rows])))
    return found


def over_limit(group):
    """Seconds that a code was given without an answer at a tighter level, or None."""
    return group['limit'] if 'limit' in group['stopped'] else None


@dataclass(frozen=True)
class Comparison:
    case: dict
    level: float
    ours: float            # seconds
    theirs: float          # seconds
    at_least: bool         # the code was stopped there, without an answer
    memory: float          # ours over theirs

    @property
    def ratio(self):
        return self.theirs / self.ours

    @property
    def label(self):
        return f'{self.case["n"]}² {self.case["percent"]:g} % {self.case["control"]}, {"> " if self.at_least else ""}{self.level:.0e}'


def against(document, code, surface, control=None):
    """Comparisons at the tightest level that we met and that they met or were stopped before, by size and contact."""
    found = []
    own = {group['code']: {} for group in document['groups']}
    for group in document['groups']:
        own[group['code']][group['case']] = group
    single = own.get('ours-float', {}) if code.endswith('-float') else {}
    mine = {**own.get('ours', {}), **single}
    for group in document['groups']:
        case = document['cases'][group['case']]
        if group['code'] != code or case['surface'] != surface or case['control'] != (control or case['control']):
            continue
        for level in (1e-8, 1e-6, 1e-4):
            ours, theirs = best(mine[group['case']], level) if group['case'] in mine else None, best(group, level)
            if ours and theirs:
                memory = memory_growth(ours) / memory_growth(theirs) if memory_growth(theirs) > 0 else math.nan
                found.append(Comparison(case, level, total(ours), total(theirs), False, memory))
                break
            if ours and over_limit(group):
                found.append(Comparison(case, level, total(ours), over_limit(group), True, math.nan))
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
    found = [(f'{code} {each.label}' if len(codes) > 1 or control else each.label, getattr(each, value), limit(each))
             for code in codes for each in against(document, code, surface, control)]
    return [entry for entry in found if entry[2] and not math.isnan(entry[1])]


def grown(document, place, limit):
    return [(f'{100 * row[0]:g} % {row[1]}', row[place], limit) for row in growth_of(document)]


def load_control(document):
    rows = {(row['n'], row['area_wanted'], row['control']): row['products'] for row in scaling_rows(document)}
    return [(f'{n}² {100 * area:g} %', rows[n, area, 'load'] / count, 1.3) for (n, area, control), count in rows.items()
            if control == 'displacement' and n >= 512 and (n, area, 'load') in rows]


def with_percent(rows):
    return [{**row, 'percent': f'{100 * row["area_wanted"]:g} %'} for row in rows]


def memory(document, limit, **values):
    return listed(with_percent(scaling_rows(document, **values)), '{n}² {percent}',
                  lambda row: row.get('bytes_per_point_in_all', row['bytes_per_point'] + 16), limit,
                  lambda row: row['n'] >= 2048 and row['control'] == 'load')


def large(document, area, value, limit):
    return listed(with_percent(scaling_rows(document, precision='single', tol=1e-4)), '{percent} {control}', value, limit,
                  lambda row: row['n'] == 16384 and row['area_wanted'] == area)


def gigabytes(row):
    return row['peak_bytes'] / 1e9


def dilute(document, scene, limits):
    return listed(document.get('solves', ()), '{n}² {control}', 'ratio', lambda row: limits.get(row['n']),
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
    Target('products to 1e-8, 512² to 4096²', '<= 30', BENCH + 'scaling', 'scaling', lambda d: grown(d, 5, 30)),
    Target('their growth', '<= N^0.2', BENCH + 'scaling', 'scaling', lambda d: grown(d, 6, 0.2), form='{:.2f}'),
    Target('products in load over displacement control, from 512² on', '<= 1.3', BENCH + 'scaling', 'scaling', load_control),
    Target('0.1 % of a rough surface: full-grid solver, times slower', '>= 8, 15, 30 at 1024², 2048², 4096²', BENCH + 'dilute', 'dilute',
           lambda d: dilute(d, 'rough', {1024: 8, 2048: 15, 4096: 30}), True),
    Target('one asperity on 4096²: full-grid solver, times slower', '>= 100', BENCH + 'dilute', 'dilute', lambda d: dilute(d, 'asperity', {4096: 100}),
           True),
    Target('16384², single, 1e-4, 10 %', '<= 200 s', SINGLE + '10', 'scaling', lambda d: large(d, 0.1, total_seconds, 200)),
    Target('its memory in all', '<= 13 GB', SINGLE + '10', 'scaling', lambda d: large(d, 0.1, gigabytes, 13)),
    Target('16384², single, 1e-4, 0.04 %', '<= 4 s', SINGLE + '0.04', 'scaling', lambda d: large(d, 0.0004, total_seconds, 4)),
    Target('its memory in all', '<= 4 GB', SINGLE + '0.04', 'scaling', lambda d: large(d, 0.0004, gigabytes, 4)),
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
    Target('our memory over ASPHER\'s', '<= 0.5', PEERS, 'peers',
           lambda d: compared(d, ASPHER, 'rough', lambda each: 0.5, 'load', 'memory')),
    Target('Tamaas, periodic, times slower', '>= 10', PEERS, 'peers', lambda d: compared(d, ('tamaas',), 'wavy', lambda each: 10, 'load'), True),
)


def judged(documents):
    """(target, measured, verdict): how many values meet it, the furthest from it, and by how much that misses."""
    for target in TARGETS:
        document = documents[target.source]
        found = target.find(document) if document else []
        if not found:
            yield target, 'not measured', ''
            continue
        margin = (lambda value, limit: value / limit) if target.more else (lambda value, limit: limit / value if value > 0 else math.inf)
        label, value, limit = min(found, key=lambda entry: margin(*entry[1:]))
        missed = [entry for entry in found if margin(*entry[1:]) < 1]
        measured = ('yes' if value else 'no') if target.wanted == 'yes' else target.form.format(value)
        others = f' (the furthest of {len(found)})' if len(found) > 1 else ''
        verdict = 'met' if not missed else f'missed by {len(missed)} of {len(found)}' if len(found) > 1 else 'missed'
        if missed and target.wanted != 'yes':
            verdict += f'; {target.form.format(value)} for {target.form.format(limit)}'
        yield target, f'{measured}: {label}{others}', verdict
