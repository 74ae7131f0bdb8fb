"""Rows of pareto.json, what they say about methods and grids, and the tables and pictures of docs/development/speed-accuracy.md."""
import os

from charts import Panels, axes, decades, line, style
from goals import goal_section
from samples import chosen, groups, median, rows_of
from surfaces import TITLES
from json_tables import load
from tables import error, provenance, table

USUAL_KERNELS = ('love', 'spectral')
FAST = 'haar-cg, fft'
LEVELS = (1e-6, 1e-10)  # pressure errors, beside the grid's own
SHOWN = ('auto', FAST, 'haar-cg, fft, double', 'haar-cg, fft, single', 'haar-cg, split', 'polonsky-keer, fft',
         'polonsky-keer, fft, single', 'nnls, fft', 'nnls, split', 'nnls, dense', 'nnls, cholmod', 'cmr, fft', 'gp, fft', 'admm, fft',
         'greedy, fft', 'greedy, dense')
KEYS = ('load_error', 'pressure_error')
CONTACTS = (0.01, 0.1, 0.4, 0.9)
FLOOR = 1e-12  # of errors that a grid can be said to make


def name_of(row):
    """solver, backend and what is set beside them."""
    return 'auto' if row['solver'] == 'auto' else ', '.join(part for part in (row['solver'], row['backend'], row['variant']) if part)


def title_of(case):
    return f'{TITLES[case["scene"]]}, {case["n"]}², {100 * case["contact"]:g} %'


def cases(document, **values):
    """Cases that are measured to the end, as scenes appear in TITLES and by contact."""
    return sorted(chosen(document.get('cases', []), **values), key=lambda case: (list(TITLES).index(case['scene']), case['contact']))


def of_case(document, part, case):
    return chosen(document.get(part, []), **{key: case[key] for key in ('scene', 'contact', 'n')})


def lines(document, case):
    """Certified points of every method by its name, from loose to tight."""
    return {name_of(row): rows_of(row['points']) for row in of_case(document, 'methods', case) if row['points']}


def grids(document, case, usual=True):
    """{(grid, kernel): certified points}; errors in keys that begin with true_."""
    return {(row['grid'], row['kernel']): rows_of(row['points']) for row in of_case(document, 'grids', case)
            if row['points'] and (row['kernel'] in USUAL_KERNELS or not usual)}


def grid_error(document, case, key):
    """What the grid costs: the error of its own solution, None where that is not measured."""
    for (grid, _), points in grids(document, case).items():
        if grid == case['n']:
            return points[-1]['true_' + key]
    return None


def front(points):
    """The (time, error) pairs that no other pair beats in both, by growing time."""
    found = []
    for time, error in sorted(points):
        if not found or error < found[-1][1]:
            found.append((time, error))
    return found


def time_to(points, level, key='pressure_error'):
    """Seconds of the fastest point with an error of at most level, or None."""
    times = [point['seconds'] for point in points if point[key] <= level]
    return min(times) if times else None


def enough(points, levels):
    """The loosest tolerance from which on every error of {key: level} is at most its level, or None."""
    best = None
    for point in sorted(points, key=lambda each: each['tol']):
        if any(point[key] > level for key, level in levels.items()):
            break
        best = point['tol']
    return best


def times(value):
    return f'{value:.1f}' if value < 10 else f'{value:.0f}'


def bounded(document, case):
    """The grid's own errors, no smaller than what a certified solution can show."""
    return {key: max(grid_error(document, case, key) or 0, FLOOR) for key in KEYS}


def slower(document, name, level):
    """How many times the time of the fastest method it takes, in every case where it gets to the level; and cases where it ran. level:
    pressure error, None: that of the grid."""
    ratios, ran = [], 0
    for case in cases(document):
        known = lines(document, case)
        if name not in known:
            continue
        ran += 1
        wanted = bounded(document, case)['pressure_error'] if level is None else level
        own, others = time_to(known[name], wanted), [time_to(points, wanted) for points in known.values()]
        if own:
            ratios.append(own / min(time for time in others if time))
    return ratios, ran


def against(document, name, other, level, wanted=lambda case: True):
    """Times of one method over those of another, case by case, to a pressure error."""
    ratios = []
    for case in cases(document):
        known = lines(document, case)
        if wanted(case) and name in known and other in known:
            both = time_to(known[name], level), time_to(known[other], level)
            if all(both):
                ratios.append(both[0] / both[1])
    return ratios


def bytes_per_point(document, name):
    found = []
    for case in cases(document):
        found += [row['memory_bytes'] / case['points'] for row in of_case(document, 'methods', case)
                  if name_of(row) == name and row['points'] and case['points'] >= 128**2]
    return found


def method_table(document):
    rows = []
    for name in SHOWN:
        cells = []
        for level in (None, *LEVELS):
            ratios, ran = slower(document, name, level)
            cells.append(f'{times(median(ratios))} ({len(ratios)} of {ran})' if ratios else f'- (0 of {ran})')
        if ran:
            memory = bytes_per_point(document, name)
            rows.append([name, *cells, f'{median(memory):.0f}' if memory else ''])
    return table(['method', 'times slower than the fastest, to the grid\'s error', *(f'to {level:.0e}' for level in LEVELS),
                  'memory [bytes/point]'], rows)


def tolerance_of(document, case):
    points = lines(document, case).get(FAST)
    return enough(points, bounded(document, case)) if points else None


def tolerance_table(document):
    rows = []
    for scene in TITLES:
        known = {case['contact']: case for case in cases(document, scene=scene)}
        if not known:
            continue
        middle = known[min(known, key=lambda contact: abs(contact - 0.1))]
        cells = []
        for contact in CONTACTS:
            case = known.get(contact)
            tol = tolerance_of(document, case) if case else None
            cells.append('' if not case else f'{tol:.0e}' if tol else '< 1e-12')
        if 1.0 in known:
            tol = tolerance_of(document, known[1.0])
            cells[-1] = f'{tol:.0e} (100 %)' if tol else '< 1e-12 (100 %)'
        own = [grid_error(document, middle, key) for key in KEYS]
        rows.append([f'{TITLES[scene]}, {middle["n"]}²', *(error(value) if value is not None else '' for value in own), *cells])
    return table(['scene', 'grid\'s error of the load', 'of the pressure', 'tol that is enough at 1 %', '10 %', '40 %', '90 %'], rows)


def grid_table(document):
    """What four times as many points buy, and what a tolerance a hundred times as tight does."""
    rows = []
    for scene in ('hertz', 'self-affine', 'rmd-0.3', 'rmd-0.7', 'afm_film', 'fv_rubber'):
        known = cases(document, scene=scene, contact=0.1)
        found = grids(document, known[0]) if known else {}
        sides = {grid: points for (grid, _), points in found.items()}
        n = known[0]['n'] if known else 0
        if not {n // 2, n, 2 * n} <= sides.keys():
            continue
        by_tol = {point['tol']: point for point in sides[n]}
        if 1e-4 not in by_tol or 1e-6 not in by_tol:
            continue
        cells = [error(by_tol[tol]['true_pressure_error']) for tol in (1e-2, 1e-4, 1e-6) if tol in by_tol]
        finer = next((point for point in sides[2 * n] if point['tol'] == 1e-4), sides[2 * n][-1])
        rows.append([f'{TITLES[scene]}, {n}²', *cells, error(finer['true_pressure_error']),
                     f'{by_tol[1e-6]["seconds"] / by_tol[1e-4]["seconds"]:.1f}',
                     f'{finer["seconds"] / by_tol[1e-4]["seconds"]:.1f}'])
    return table(['scene, 10 %', 'pressure error at tol 1e-2', '1e-4', '1e-6', '1e-4, twice the points a side', 'time, 1e-6 over 1e-4',
                  'time, finer grid over this one'], rows) if rows else 'Not measured yet.'


def dense_pick(document):
    found = []
    for case in cases(document):
        known = lines(document, case)
        if 'nnls, dense' in known and FAST in known:
            own, other = (time_to(known[name], 1e-10) for name in ('nnls, dense', FAST))
            if own and other:
                found.append((case['candidates'], own / other))
    if not found:
        return None
    faster, slow = [count for count, ratio in found if ratio < 1], [count for count, ratio in found if ratio >= 1]
    text = '- **A few hundred points that can touch: `nnls` on `dense`.** It is exact, whatever the tolerance. '
    if faster:
        text += f'To 1e-10 it was faster than `{FAST}` in {len(faster)} of {len(found)} contacts, with up to {max(faster)} candidates'
        return text + (f'; it was slower in the others, which have {min(slow)} to {max(slow)}.' if slow else '.')
    return text + f'Here, with {min(slow)} candidates and more, it was slower than `{FAST}` everywhere.'


def pick_list(document):
    picks = []

    def pick(text, ratios):
        if ratios:
            picks.append('- ' + text.format(median=times(median(ratios)), least=times(min(ratios)), most=times(max(ratios)), n=len(ratios)))

    known = cases(document)
    pick('**If in doubt, `auto`.** To the grid\'s own error it took {median} times as long as the fastest method in the median of {n} '
         'contacts, {most} times at worst.', slower(document, 'auto', None)[0])
    pick('**`haar-cg` on `fft`**, which `auto` chooses on such grids: to 1e-10 in the pressures it took {median} times as long as the '
         'fastest method in the median of {n} contacts, {most} times at worst.', slower(document, FAST, 1e-10)[0])
    picks.append(dense_pick(document))
    pick('**`polonsky-keer` on `fft` is our form of the textbook method (Polonsky & Keer 1999).** To 1e-2 in the pressures it took '
         '{median} times the time of `haar-cg`, {least} to {most}, in {n} contacts;', against(document, 'polonsky-keer, fft', FAST, 1e-2))
    if picks and picks[-1] and picks[-1].endswith(';'):
        tight = against(document, 'polonsky-keer, fft', FAST, 1e-8)
        picks[-1] += f' to 1e-8, {times(median(tight))}, {times(min(tight))} to {times(max(tight))}.' if tight else ''
    single = against(document, 'haar-cg, fft, single', FAST, 1e-4)
    memory = [bytes_per_point(document, name) for name in ('haar-cg, fft, single', FAST)]
    if single:
        text = ('- **If memory is short and 1e-5 suffices: `fft.precision=single`.** To 1e-4 it took '
                f'{times(median(single))} times the time of mixed precision')
        if all(memory):
            text += f', and {median(memory[0]):.0f} bytes a point in addition to gap and pressures, instead of {median(memory[1]):.0f}'
        picks.append(text + '.')
    pick('**Only double-precision products** (`haar-cg.products=double`) took {median} times the time of mixed ones to 1e-8, {least} to '
         '{most}, without reaching smaller errors.', against(document, 'haar-cg, fft, double', FAST, 1e-8))
    pick('**Backend `split` is for sparse contact on large grids**, see [performance](performance.md). At 1 % of grids as small as these '
         'it took {median} times the time of `fft`, to 1e-6.',
         against(document, 'haar-cg, split', FAST, 1e-6, lambda case: case['contact'] == 0.01))
    slow = []
    for name in ('cmr, fft', 'gp, fft', 'admm, fft', 'greedy, fft'):
        ratios, ran = slower(document, name, 1e-6)
        if ran:
            found = f'{times(median(ratios))} times the time of the fastest method' if ratios else 'never reached it'
            slow.append(f'`{name.split(",")[0]}` {found} ({len(ratios)} of {ran} contacts within the limit)')
    if slow:
        picks.append('- **The other methods of the paper are for comparison.** To 1e-6: ' + '; '.join(slow) + '.')
    wanted = [tolerance_of(document, case) for case in known if bounded(document, case)['pressure_error'] > FLOOR]
    wanted = [tol for tol in wanted if tol]
    if wanted:
        shares = [f'in {sum(value >= tol for value in wanted)} with tol {tol:.0e}' for tol in sorted(set(wanted), reverse=True)]
        picks.append(f'- **Tolerance.** In {len(wanted)} contacts the errors of load and pressure by the solver were compared with those by the grid. '
                     'The solver\'s were smaller ' + ', '.join(shares) + '. A smaller tolerance serves only to agree with another code on the same grid, or to give an outer '
                     'iteration smooth derivatives.')
    return '\n'.join(pick for pick in picks if pick)


def sections(results):
    document = load(results, 'pareto')
    return {'provenance': provenance(document), 'picks': pick_list(document), 'methods': method_table(document),
            'tolerances': tolerance_table(document), 'grids': grid_table(document), 'goals': goal_section(load(results, 'goal'))}


LEAST = 1e-14  # errors against a solution of tolerance 1e-13 say nothing below
GRID = 'lines lw 1.4 lc rgb "#222222" dt (12,6)'
FRONT = 'lines lw 7 lc rgb "#C4C4C4" dt 1'
LOOKS = {name: line(look) for name, look in {  # methods that are drawn: colour, dash and marker each tell them apart
    FAST: 'lc rgb "#000000" dt 1 pt 7', 'haar-cg, fft, single': 'lc rgb "#D55E00" dt 1 pt 9',
    'haar-cg, split': 'lc rgb "#0072B2" dt (12,4) pt 5', 'polonsky-keer, fft': 'lc rgb "#E69F00" dt (12,4,2,4) pt 13',
    'nnls, fft': 'lc rgb "#009E73" dt (2,3) pt 11', 'nnls, dense': 'lc rgb "#CC79A7" dt (8,8) pt 15',
    'gp, fft': 'lc rgb "#56B4E9" dt (8,3) pt 4'}.items()}
PEERS = {code: (title, f'points pt "{letter}" tc rgb "{colour}"') for code, title, letter, colour in (  # a letter marks each
    ('aspher-fft', 'ASPHER, fft', 'A', '#AA0000'), ('aspher-h2', 'ASPHER, h2', 'H', '#7A4A00'), ('tamaas-free', 'Tamaas', 'T', '#5B2C9F'),
    ('contactmechanics', 'ContactMechanics', 'C', '#00572F'))}
BETTER = 'set label 2 "↙ better" at screen left, graph -0.2\n'
AXES = {'pressure_error': 'pressure', 'true_load_error': 'load', 'true_pressure_error': 'pressure'}


def clipped(points, key):
    """(time, error)"""
    return [(point['seconds'], max(point[key], LEAST)) for point in points]


def errors_panel(drawing, document, place, case):
    """Time against the error of the solver, and the error that the grid makes anyway."""
    key, known = 'pressure_error', lines(document, case)
    drawn = {name: known[name] for name in LOOKS if name in known}
    others = [row for row in of_case(document, 'peers', case) if row['code'] in PEERS and 'error' not in row]
    peers = {code: rows for (code,), rows in groups(others, 'code').items()}
    curves = [drawing.curve(front(clipped(sum(known.values(), []), key)), FRONT)]
    curves.append(f'{max(grid_error(document, case, key) or 0, LEAST)!r} with {GRID}')
    curves += [drawing.curve(clipped(points, key), LOOKS[name]) for name, points in drawn.items()]
    curves += [drawing.curve(clipped(points, key), PEERS[code][1]) for code, points in peers.items()]
    times = decades([point['seconds'] for points in [*drawn.values(), *peers.values()] for point in points])
    settings = axes('set-up and solve [s]', 'relative error', times, (LEAST, 1), BETTER + 'set ytics 1e-14,100,1')
    drawing.panel(*place, f'{title_of(case)}: {AXES[key]}', settings, curves)
    return drawn.keys() | peers.keys()


def errors_picture(document, file, shown):
    """Panels of cases, two in a row."""
    rows = (len(shown) + 1) // 2
    drawing, drawn = Panels(800, 265 * rows, 2, rows), set()
    for i, case in enumerate(shown):
        drawn |= errors_panel(drawing, document, (i % 2, i // 2), case)
    entries = [entry for name, entry in {**{name: (name, look) for name, look in LOOKS.items()}, **PEERS}.items() if name in drawn]
    drawing.draw(file, entries + [('Pareto front of all methods', FRONT), ("the grid's own error", GRID)], 2)


def middle(document, scenes):
    """The case of each scene whose contact is next to 10 %."""
    known = [cases(document, scene=scene) for scene in scenes]
    return [min(found, key=lambda case: abs(case['contact'] - 0.1)) for found in known if found]


def best_known(document, *wanted):
    """The cases wanted, and others in the place of those that are not there."""
    known = cases(document)
    found = [case for scene, contact in wanted for case in known if (case['scene'], case['contact']) == (scene, contact)]
    return (found + [case for case in known if case not in found])[:len(wanted)]


def grid_picture(document, file):
    """Error against the truth by tolerance, one line a grid: where a line turns down no more, the grid is the limit."""
    chosen = middle(document, ['hertz', 'self-affine', 'rmd-0.5', 'afm_film'])
    drawing = Panels(800, 265 * len(chosen), 2, len(chosen))
    for row, case in enumerate(chosen):
        for column, key in enumerate(['true_load_error', 'true_pressure_error']):
            found = [clipped(points, key) for _, points in sorted(grids(document, case).items())]
            times, errors = (decades(values) for values in zip(*sum(found, [])))
            drawing.panel(column, row, f'{title_of(case)}: {AXES[key]}',
                          axes('set-up and solve [s]', 'error against the truth', times, errors, 'set ytics autofreq'),
                          [drawing.curve(points, style(number)) for number, points in enumerate(found)])
    names = ['half as many points a side', 'the grid of the other pictures', 'twice as many']
    drawing.draw(file, [(name, style(number)) for number, name in enumerate(names)], 3)


def pictures(results, images):
    document = load(results, 'pareto')
    shown = best_known(document, ('hertz', 0.1), ('self-affine', 0.1), ('rmd-0.7', 0.4), ('afm_film', 0.1))
    if not shown:
        return
    errors_picture(document, os.path.join(images, 'speed-accuracy.png'), shown)
    grid_picture(document, os.path.join(images, 'speed-accuracy-grids.png'))
