"""Tables and pictures of docs/peers.md, from peers.json, and the lines that a run prints."""
import os

from charts import Panels, decades
from peers_plan import LEVELS
from store import load
from tables import aligned, seconds, table

BUSY = 0.2  # cores that others took: such a time is marked


def total(run):
    return run['setup_seconds'] + run['solve_seconds']


def best(group, level):
    """The fastest run that is certified at a level, or None."""
    met = [run for run in group['runs'] if run.get('residual') is not None and run['residual'] <= level]
    return min(met, key=total) if met else None


def growth(run):
    return run['peak_bytes'] - run['start_bytes']


def time_cell(group, level):
    run = best(group, level)
    if run is None:
        if 'limit' in group['stopped']:
            return f'> {group["limit"]:g}'
        return 'not measured' if group['stopped'] else 'not reached'
    return seconds(total(run)) + ('*' if (run.get('other_cores') or 0) > BUSY else '')


def lines(store, key):
    """One line a code: times to the levels, then the parts of the tightest level met."""
    groups = {group['code']: group for group in store['groups'] if group['case'] == key}
    ours = groups.get('ours')
    found = []
    for name in store['codes']:
        if name not in groups:
            continue
        group = groups[name]
        line = [store['codes'][name]['title']] + [time_cell(group, level) for level in LEVELS]
        tightest = next(((level, run) for level in reversed(LEVELS) if (run := best(group, level))), None)
        if tightest:
            level, run = tightest
            mine = best(ours, level) if ours else None
            line += [f'{level:.0e}', seconds(run['setup_seconds']), seconds(run['solve_seconds']), str(run.get('products', '')),
                     f'{growth(run) / 2**20:.0f}', f'{run["peak_bytes"] / 2**20:.0f}',
                     f'{total(run) / total(mine):.2f}' if mine else '', f'{run["residual"]:.0e}']
        else:
            line += [''] * 8
        found.append(line + [group['stopped']])
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
    return table(['code', 'version', 'largest Hertz pressure off by', 'not run'], rows)


def cases_tables(document):
    parts = []
    for key, case in document['cases'].items():
        rows = lines(document, key)
        if rows:
            parts.append(f'**{case["title"]}**, contact {100 * case["area"]:.3g} % (surface by {case["maker"]})\n\n' +
                         table(TITLES, rows))
    return '\n\n'.join(parts)


def provenance_text(document):
    known = document['provenance']
    left = document.get('left_out') or []
    text = (f'{known["cpu"]}, {known["threads"]} threads a code; roughcontact {known["version"]} ({known["commit"]}), library '
            f'{known["library"]}; Python {known["python"]}, NumPy {known["numpy"]}; {known["date"][:10]}; load average at the start '
            f'{known["load_average_at_start"]:.1f}.')
    return text + (f' Not run, because the budget was spent: {"; ".join(left)}.' if left else '')


def sections(results):
    document = load(results, 'peers')
    return {'provenance': provenance_text(document), 'codes': codes_table(document), 'cases': cases_tables(document)}


# A colour a code, a dash and a marker a variant.
STYLES = {'ours': 'lc rgb "#000000" dt 1 pt 7', 'ours-float': 'lc rgb "#000000" dt 2 pt 6', 'baseline': 'lc rgb "#777777" dt 1 pt 5',
          'aspher-fft': 'lc rgb "#D55E00" dt 1 pt 9', 'aspher-h2': 'lc rgb "#D55E00" dt (8,4) pt 11',
          'aspher-fft-float': 'lc rgb "#E69F00" dt 1 pt 8', 'aspher-h2-float': 'lc rgb "#E69F00" dt (8,4) pt 10',
          'aspher-periodic': 'lc rgb "#D55E00" dt (2,3) pt 9', 'tamaas': 'lc rgb "#0072B2" dt 1 pt 13',
          'tamaas-free': 'lc rgb "#0072B2" dt (8,4) pt 12', 'contactmechanics': 'lc rgb "#009E73" dt 1 pt 15',
          'nnls': 'lc rgb "#CC79A7" dt 1 pt 4', 'osqp': 'lc rgb "#56B4E9" dt 1 pt 6'}
SHOWN = (1e-4, 1e-8)


def look(name):
    return f'linespoints lw {2.4 if name == "ours" else 1.6} ps 1.1 {STYLES[name]}'


def series(document, name, chosen, x, y):
    """Points (x(case), y(group)) of a code over the cases that `chosen` takes, without those that it did not reach."""
    points = []
    for group in document['groups']:
        case = document['cases'][group['case']]
        if group['code'] == name and chosen(case) and (value := y(group)) is not None:
            points.append((x(case), value))
    return sorted(points)


def time_to(level):
    def value(group):
        run = best(group, level)
        return total(run) if run else None
    return value


def memory_per_point(document):
    def value(group):
        n = document['cases'][group['case']]['n']
        run = next((run for level in reversed(SHOWN) if (run := best(group, level))), None)
        return growth(run) / n**2 if run and growth(run) > 0 else None
    return value


def side_tics(sides):
    return 'set xtics (' + ', '.join(f'"{n}²" {n}' for n in sides) + ')'


def draw(document, file, panels):
    """panels: (title, chosen, x of a case, y of a group, axes, y label), two in a row."""
    filled = []
    for title, chosen, x, y, axes, label in panels:
        curves = {name: points for name in document['codes'] if (points := series(document, name, chosen, x, y))}
        if curves:
            filled.append((title, curves, axes, label))
    if not filled:
        return
    rows = (len(filled) + 1) // 2
    names = [name for name in document['codes'] if any(name in curves for _, curves, _, _ in filled)]
    legend = 20 + 22 * ((len(names) + 1) // 2)
    drawing = Panels(800, legend + 320 * rows, 2, rows, legend)
    for number, (title, curves, axes, label) in enumerate(filled):
        xs = [x for points in curves.values() for x, _ in points]
        low, high = decades([y for points in curves.values() for _, y in points])
        settings = (f'set xrange [{min(xs) / 1.5}:{max(xs) * 1.5}]\nset yrange [{low}:{high}]\n{axes(sorted(set(xs)))}\n'
                    f'set ylabel "{label}" offset 1.2,0')
        drawing.panel(number % 2, number // 2, title, settings,
                      [f'{drawing.block(points)} with {look(name)}' for name, points in curves.items()])
    drawing.draw(file, [(document['codes'][name]['title'], look(name)) for name in names], 2)


def is_family(boundary, control, percent=None, n=None):
    return lambda case: ((case['boundary'], case['control']) == (boundary, control) and percent in (None, case['percent']) and
                         n in (None, case['n']))


def widest(document, boundary):
    """The grid with the most contact areas, the larger of equal ones."""
    counts = {}
    for case in document['cases'].values():
        if is_family(boundary, 'load')(case):
            counts[case['n']] = counts.get(case['n'], 0) + 1
    return max(counts, key=lambda n: (counts[n], n), default=None)


def pictures(results, images):
    document = load(results, 'peers')
    side = (lambda case: case['n']), (lambda xs: side_tics(xs) + '\nset xlabel "points" offset 0,0.4')
    share = ((lambda case: case['percent']),
             (lambda xs: 'set xtics (' + ', '.join(f'"{x:g}" {x}' for x in xs) + ')\nset xlabel "contact [%]" offset 0,0.4'))
    boundaries = 'free', 'periodic'
    draw(document, os.path.join(images, 'peers-size.png'),
         [(f'{boundary}, 10 % contact, certified {level:.0e}', is_family(boundary, 'load', 10), side[0], time_to(level), side[1],
           'set-up and solve [s]') for boundary in boundaries for level in SHOWN])
    contact = []
    for boundary in boundaries:
        n = widest(document, boundary)
        contact += [(f'{boundary}, {n}², certified {level:.0e}', is_family(boundary, 'load', n=n), share[0], time_to(level), share[1],
                     'set-up and solve [s]') for level in SHOWN]
    draw(document, os.path.join(images, 'peers-contact.png'), contact)
    draw(document, os.path.join(images, 'peers-memory.png'),
         [(f'{boundary}, 10 % contact', is_family(boundary, 'load', 10), side[0], memory_per_point(document), side[1],
           'peak memory [bytes/point]') for boundary in boundaries])

