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


def baseline(document):
    limits = {512: 8, 1024: 15, 2048: 25, 4096: 30}
    return [(each.label, each.ratio, limits[each.case['n']]) for each in against(document, 'baseline', 'rough')
            if each.case['n'] in limits and each.case['percent'] == 10 and each.level == TIGHT]


def products_to_tolerance(document):
    return [(f'{100 * area:g} % {control}', most, 30) for area, control, _, _, _, most, _ in growth_of(document)]


def products_growth(document):
    return [(f'{100 * area:g} % {control}', exponent, 0.2) for area, control, *_, exponent in growth_of(document)]


def load_control(document):
    rows = {(row['n'], row['area_wanted'], row['control']): row['products'] for row in scaling_rows(document)}
    return [(f'{n}² {100 * area:g} %', rows[n, area, 'load'] / count, 1.3) for (n, area, control), count in rows.items()
            if control == 'displacement' and n >= 512 and (n, area, 'load') in rows]


def memory(limit, **values):
    def find(document):
        return [(f'{row["n"]}² {100 * row["area_wanted"]:g} %', row.get('bytes_per_point_in_all', row['bytes_per_point'] + 16), limit)
                for row in scaling_rows(document, **values) if row['n'] >= 2048 and row['control'] == 'load']
    return find


def large(area, key, limit):
    def find(document):
        return [(f'{100 * area:g} % {row["control"]}', total_seconds(row) if key == 'seconds' else row[key] / 1e9, limit)
                for row in scaling_rows(document, precision='single', tol=1e-4) if row['n'] == 16384 and row['area_wanted'] == area]
    return find


def dilute(scene, limits):
    def find(document):
        return [(f'{row["n"]}² {row["control"]}', row['ratio'], limits[row['n']]) for row in document.get('solves', ())
                if row['scene'] == scene and row['n'] in limits and row['tol'] == TIGHT and 'ratio' in row and
                (scene == 'asperity' or row['area_wanted'] == 0.001)]
    return find


def product_ratio(key, limit):
    def find(document):
        return [(f'{row["n"]}² {row["threads"]} threads', row[key], limit) for row in document['products']
                if row['n'] >= 1024 and key in row]
    return find


def transform_fraction(document):
    return [(f'{row["n"]}² {row["precision"]} {row["threads"]} threads', row['fraction_of_transforms'], 0.6) for row in document['products']]


def busy(document):
    return [(f'{row["n"]}² {row["threads"]} threads', row['ratio'], 2.5) for row in document['busy']]


def deterministic_cost(document):
    return [(f'{row["choice"]}, {row["threads"]} threads', row['cost_median'], 0.1) for row in document.get('deterministic', ())
            if row['choice'] != '1']


def deterministic_bits(document):
    return [(f'{row["n"]}² {row["threads"]} threads', int(row['same_as_one_thread'] == row['same_again'] == 'yes'), 1)
            for row in document.get('deterministic', ()) if row['choice'] == '1']


def batch(document):
    return [(f'{document["batch"][0]["surfaces"]} surfaces of {document["batch"][0]["n"]}²', document['scaling'], 1.8)]


def peer(codes, surface, limit_of, what='time'):
    def find(document):
        found = []
        for code in codes:
            for each in against(document, code, surface, 'load'):
                value, limit = each.memory if what == 'memory' else each.ratio, limit_of(each.case['percent'])
                if limit and not math.isnan(value):
                    found.append((f'{code} {each.label}', value, limit))
        return found
    return find


ASPHER = ('aspher-fft', 'aspher-h2', 'aspher-fft-float', 'aspher-h2-float')
BENCH = 'roughcontact-bench '
SINGLE = BENCH + 'scaling --precision single --tol 1e-4 --sizes 16384 --percents '
PEERS = BENCH + 'peers'
TARGETS = (
    Target('standard method, 10 %, times slower', '>= 8, 15, 25, 30 at 512², 1024², 2048², 4096²', PEERS + ' --only ours,baseline', 'peers',
           baseline, True),
    Target('products to 1e-8, 512² to 4096²', '<= 30', BENCH + 'scaling', 'scaling', products_to_tolerance),
    Target('their growth', '<= N^0.2', BENCH + 'scaling', 'scaling', products_growth, form='{:.2f}'),
    Target('products in load over displacement control, from 512² on', '<= 1.3', BENCH + 'scaling', 'scaling', load_control),
    Target('0.1 % of a rough surface: full-grid solver, times slower', '>= 8, 15, 30 at 1024², 2048², 4096²', BENCH + 'dilute', 'dilute',
           dilute('rough', {1024: 8, 2048: 15, 4096: 30}), True),
    Target('one asperity on 4096²: full-grid solver, times slower', '>= 100', BENCH + 'dilute', 'dilute', dilute('asperity', {4096: 100}),
           True),
    Target('16384², single, 1e-4, 10 %', '<= 200 s', SINGLE + '10', 'scaling', large(0.1, 'seconds', 200)),
    Target('its memory in all', '<= 13 GB', SINGLE + '10', 'scaling', large(0.1, 'peak_bytes', 13)),
    Target('16384², single, 1e-4, 0.04 %', '<= 4 s', SINGLE + '0.04', 'scaling', large(0.0004, 'seconds', 4)),
    Target('its memory in all', '<= 4 GB', SINGLE + '0.04', 'scaling', large(0.0004, 'peak_bytes', 4)),
    Target('bytes a point in all, mixed, from 2048² on', '<= 110 (80)', BENCH + 'scaling', 'scaling', memory(110)),
    Target('bytes a point in all, single, from 2048² on', '<= 51 (38)', BENCH + 'scaling --precision single --tol 1e-4', 'scaling',
           memory(51, precision='single', tol=1e-4)),
    Target('padded product, double, times slower, from 1024² on', '>= 1.7', BENCH + 'products', 'products', product_ratio('ratio', 1.7), True),
    Target('padded product, single', '>= 2', BENCH + 'products', 'products', product_ratio('single_ratio', 2), True),
    Target('product, share of in-cache FFTW speed', '(0.6)', BENCH + 'limits', 'limits', transform_fraction, True),
    Target('both cores loaded by others, times slower', '<= 2.5', BENCH + 'busy', 'busy', busy),
    Target('`deterministic=1`: one thread and more, run after run, bitwise equal', 'yes', BENCH + 'deterministic', 'deterministic',
           deterministic_bits, True),
    Target('`deterministic=1`: cost', '<= 10 %', BENCH + 'deterministic', 'deterministic', deterministic_cost, form='{:+.1%}'),
    Target('batch: all threads over one', '>= 1.8', BENCH + 'batch', 'batch', batch, True),
    Target('ASPHER, times slower', '>= 10 from 10 % on, >= 5 at 0.1 to 1 %', PEERS, 'peers',
           peer(ASPHER, 'rough', lambda percent: 10 if percent >= 10 else 5), True),
    Target('our memory over ASPHER\'s', '<= 0.5', PEERS, 'peers', peer(ASPHER, 'rough', lambda percent: 0.5, 'memory')),
    Target('Tamaas, periodic, times slower', '>= 10', PEERS, 'peers', peer(('tamaas',), 'wavy', lambda percent: 10), True),
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
