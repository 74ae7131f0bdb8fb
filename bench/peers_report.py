"""Tables and pictures of docs/development/peers.md, from peers.json, and the lines that a run prints."""
import collections
import math
import os
from statistics import median_low

import headline
from charts import Panels, axes, decades, ticks
from peers_codes import CODES, LEVELS
from samples import chosen, groups, rows_of, total_seconds as total
from json_tables import load
from tables import aligned, error, seconds, table

BUSY = 0.2  # cores that others took: such a time is marked
SHOWN = (1e-4, 1e-8)


def best(group, level):
    """The fastest run that is certified at a level, or None."""
    runs = rows_of(group['runs']) if isinstance(group['runs'], dict) else group['runs']  # stored, or those of now
    met = [run for run in runs if run.get('residual') is not None and run['residual'] <= level]
    return min(met, key=total) if met else None


def tightest(group, levels=LEVELS):
    """(level, run) of the tightest level met, or None."""
    return next(((level, run) for level in reversed(levels) if (run := best(group, level))), None)


def growth(run):
    return run['peak_bytes'] - run['start_bytes']


def time_cell(group, level):
    run = best(group, level)
    if run is None:
        return f'> {group["limit"]:g}' if 'limit' in group['stopped'] else 'not reached'
    return seconds(total(run)) + ('*' if (run.get('other_cores') or 0) > BUSY else '')


def lines(document, key):
    """One line a code: times to the levels, then the parts of the tightest level met."""
    groups = {group['code']: group for group in chosen(document['groups'], case=key)}
    found = []
    for name in document['codes']:
        if name not in groups:
            continue
        group, parts = groups[name], [''] * 8
        if tightest(group):
            level, run = tightest(group)
            mine = best(groups['ours'], level) if 'ours' in groups else None
            parts = [error(level), seconds(run['setup_seconds']), seconds(run['solve_seconds']), str(run.get('products', '')),
                     f'{growth(run) / 2**20:.0f}', f'{run["peak_bytes"] / 2**20:.0f}', f'{total(run) / total(mine):.2f}' if mine else '',
                     f'{run["residual"]:.0e}']
        found.append([document['codes'][name]['title'], *(time_cell(group, level) for level in LEVELS), *parts, group['stopped']])
    return found


TITLES = ['code', '1e-4 [s]', '1e-6 [s]', '1e-8 [s]', 'level', 'set-up [s]', 'solve [s]', 'products', 'memory [MiB]', 'peak [MiB]',
          'times ours', 'residual', 'remark']


def print_case(document, key):
    case = document['cases'][key]
    print(f'\n{case["title"]}: contact {100 * case["area"]:.3g} %, target {case["target"]:.6g}')
    print(aligned([TITLES] + lines(document, key)), flush=True)


def codes_table(document):
    rows = []
    for name, code in document['codes'].items():
        hertz = [f'{boundary} {100 * document["calibration"][key]["deviation"]:+.2f} %' for boundary in ('free', 'periodic')
                 if 'deviation' in document['calibration'].get(key := f'{name}, {boundary}', {})]
        rows.append([code['title'], code['version'] or '', ', '.join(hertz), code.get('not_run', '')])
    return table(['code', 'version', 'error of the largest Hertz pressure', 'not run'], rows)


def family(document, name):
    """A code's name without that of the variant."""
    return document['codes'][name]['title'].partition(',')[0]


def medians_table(document):
    """Over the cases of each boundary: the time of a code's fastest variant over ours, infinite if none was certified in time."""
    rows = []
    for boundary in ('free', 'periodic'):
        for level in SHOWN:
            ratios = collections.defaultdict(list)
            for (key,), found in groups(document['groups'], 'case').items():
                mine = best(chosen(found, code='ours')[0], level) if document['cases'][key]['boundary'] == boundary else None
                for (name,), variants in groups([{**group, 'family': family(document, group['code'])} for group in found], 'family').items():
                    if mine and name != family(document, 'ours'):
                        runs = [run for group in variants if (run := best(group, level))]
                        ratios[name].append(min((total(run) / total(mine) for run in runs), default=math.inf))
            for name, values in ratios.items():
                met, middle = [value for value in values if value < math.inf], median_low(values)
                rows.append([boundary, error(level), name, str(len(values)), seconds(middle) if middle < math.inf else 'over the limit',
                             f'{seconds(min(met))} to {seconds(max(met))}' if met else '', str(len(values) - len(met))])
    return table(['edges', 'certified to', 'code', 'cases', 'times ours, median', 'range', 'not in time'], rows)


def cases_tables(document):
    """For each boundary a line a case: seconds to both levels of SHOWN."""
    tables = []
    for boundary in ('free', 'periodic'):
        cases = {key: case for key, case in document['cases'].items() if case['boundary'] == boundary}
        found = {(group['case'], group['code']): group for group in document['groups'] if group['case'] in cases}
        names = [name for name in document['codes'] if any(code == name for _, code in found)]
        rows = [[f'{case["n"]}²', f'{100 * case["area"]:.2g}', case['control'],
                 *(' / '.join(time_cell(found[key, name], level).replace('not reached', '-') for level in SHOWN) if (key, name) in found else ''
                   for name in names)]
                for key, case in sorted(cases.items(), key=lambda item: (item[1]['n'], item[1]['area'], item[1]['control']))]
        tables.append(f'**{boundary.capitalize()} edges**\n\n' +
                      table(['grid', 'contact [%]', 'control', *(document['codes'][name]['title'] for name in names)], rows))
    return '\n\n'.join(tables)


def provenance_text(document):
    return ('{cpu}, {threads} threads a code; roughcontact {version} ({commit}), library {library}; Python {python}, NumPy {numpy}; {date:.10}; '
            'load average at the start {load_average_at_start:.1f}.'.format(**document['provenance']))


def sections(results):
    document = load(results, 'peers')
    return {'provenance': provenance_text(document), 'codes': codes_table(document), 'medians': medians_table(document), 'cases': cases_tables(document)}


def look(name):
    return f'linespoints lw {2.4 if name == "ours" else 1.6} ps 1.1 {CODES[name].look}'


def draw(document, file, panels):
    """panels: (title, boundary, values of a case or None, its key along x, y of a group, y label), two in a row."""
    filled = []
    for title, boundary, wanted, x, y, label in panels:
        curves = {}
        for group in document['groups']:
            case = document['cases'][group['case']]
            value = y(case, group) if chosen([case], boundary=boundary, control='load', **wanted) else None
            if value is not None:
                curves.setdefault(group['code'], []).append((case[x], value))
        if curves:
            filled.append((title, {name: sorted(curves[name]) for name in document['codes'] if name in curves}, x, label))
    if not filled:
        return
    rows, names = (len(filled) + 1) // 2, [name for name in document['codes'] if any(name in curves for _, curves, _, _ in filled)]
    drawing = Panels(800, 320 * rows, 2, rows)
    for number, (title, curves, x, label) in enumerate(filled):
        places = sorted({place for points in curves.values() for place, _ in points})
        named = ticks('x', [(f'{place}²' if x == 'n' else f'{place:g}', place) for place in places])
        settings = axes('points' if x == 'n' else 'contact [%]', label, (places[0] / 1.5, places[-1] * 1.5),
                        decades([value for points in curves.values() for _, value in points]), named)
        drawing.panel(number % 2, number // 2, title, settings, [drawing.curve(points, look(name)) for name, points in curves.items()])
    drawing.draw(file, [(document['codes'][name]['title'], look(name)) for name in names], 2)


def headline_picture(document, file):
    """The contacts of README.md: all runs whose answers are certified to some level."""
    runs = {case: {} for case in headline.CASES}
    for group in document['groups']:
        found = [(total(run), run['residual']) for run in rows_of(group['runs']) if run.get('residual')] if group['case'] in runs else []
        if found:
            runs[group['case']][group['code']] = found
    if not all('ours' in found for found in runs.values()):
        return  # other contacts were measured
    below = ('{cpu}, {threads} threads, second solves, {date:.10}, load average {load_average_at_start:.1f} at the start.'.format(**document['provenance']),
             'Every answer is judged by one certificate. The textbook program is for free edges only.')
    headline.draw(file, runs, below)


def pictures(results, images):
    document, boundaries = load(results, 'peers'), ('free', 'periodic')
    headline_picture(document, os.path.join(images, 'headline.svg'))

    def time_to(level):
        return lambda case, group: total(run) if (run := best(group, level)) else None

    def memory(case, group):
        _, run = tightest(group, SHOWN) or (None, None)
        return growth(run) / case['n']**2 if run and growth(run) > 0 else None

    def widest(boundary):
        """The grid with the most answers, the larger of equal ones."""
        asked = {key for key, case in document['cases'].items() if (case['boundary'], case['control']) == (boundary, 'load')}
        counts = collections.Counter(document['cases'][group['case']]['n'] for group in document['groups']
                                     if group['case'] in asked and tightest(group, SHOWN))
        return max(counts, key=lambda n: (counts[n], n), default=None)

    speed = 'set-up and solve [s]'
    for name, panels in {
            'size': [(f'{boundary}, 10 % contact, certified {level:.0e}', boundary, {'percent': 10}, 'n', time_to(level), speed)
                     for boundary in boundaries for level in SHOWN],
            'contact': [(f'{boundary}, {n}², certified {level:.0e}', boundary, {'n': n}, 'percent', time_to(level), speed)
                        for boundary in boundaries for n in [widest(boundary)] for level in SHOWN],
            'memory': [(f'{boundary}, 10 % contact', boundary, {'percent': 10}, 'n', memory, 'peak memory [bytes/point]')
                       for boundary in boundaries]}.items():
        draw(document, os.path.join(images, f'peers-{name}.png'), panels)
