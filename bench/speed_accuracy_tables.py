"""Tables of docs/speed-accuracy.md, from pareto.json and goal.json."""
from goals_tables import goal_section
from samples import median, total_seconds
from speed_accuracy_rows import FAST, TITLES, cases, enough, grid_error, grids, lines, time_to
from store import load
from tables import error, provenance, table

LEVELS = (1e-6, 1e-10)  # pressure errors, beside the grid's own
SHOWN = ('auto', FAST, 'haar-cg, fft, double', 'haar-cg, fft, single', 'haar-cg, split', 'polonsky-keer, fft',
         'polonsky-keer, fft, single', 'nnls, fft', 'nnls, split', 'nnls, dense', 'nnls, cholmod', 'cmr, fft', 'gp, fft', 'admm, fft',
         'greedy, fft', 'greedy, dense')
KEYS = ('load_error', 'pressure_error')
CONTACTS = (0.01, 0.1, 0.4, 0.9)
FLOOR = 1e-12  # of errors that a grid can be said to make


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


def against(document, name, other, level, chosen=lambda case: True):
    """Times of one method over those of another, case by case, to a pressure error."""
    ratios = []
    for case in cases(document):
        known = lines(document, case)
        if chosen(case) and name in known and other in known:
            both = time_to(known[name], level), time_to(known[other], level)
            if all(both):
                ratios.append(both[0] / both[1])
    return ratios


def bytes_per_point(document, name):
    found = []
    for case in cases(document):
        points = lines(document, case).get(name)
        if points and case['points'] >= 128**2:
            found.append(max(point['memory_bytes'] for point in points) / case['points'])
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
                     f'{total_seconds(by_tol[1e-6]) / total_seconds(by_tol[1e-4]):.1f}',
                     f'{total_seconds(finer) / total_seconds(by_tol[1e-4]):.1f}'])
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
    pick('**`haar-cg` on `fft`**, which `auto` takes on grids like these: to 1e-10 in the pressures it took {median} times as long as the '
         'fastest method in the median of {n} contacts, {most} times at worst.', slower(document, FAST, 1e-10)[0])
    picks.append(dense_pick(document))
    pick('**`polonsky-keer` on `fft` is the standard method.** To 1e-2 in the pressures it took {median} times the time of `haar-cg`, '
         '{least} to {most}, in {n} contacts;', against(document, 'polonsky-keer, fft', FAST, 1e-2))
    if picks and picks[-1] and picks[-1].endswith(';'):
        tight = against(document, 'polonsky-keer, fft', FAST, 1e-8)
        picks[-1] += f' to 1e-8, {times(median(tight))}, {times(min(tight))} to {times(max(tight))}.' if tight else ''
    single = against(document, 'haar-cg, fft, single', FAST, 1e-4)
    memory = [bytes_per_point(document, name) for name in ('haar-cg, fft, single', FAST)]
    if single:
        text = ('- **Short of memory, and 1e-5 is enough: `fft.precision=single`.** To 1e-4 it took '
                f'{times(median(single))} times the time of mixed precision')
        if all(memory):
            text += f', and {median(memory[0]):.0f} bytes a point beside gap and pressures instead of {median(memory[1]):.0f}'
        picks.append(text + '.')
    pick('**Products in double precision alone** (`haar-cg.products=double`) took {median} times the time of mixed ones to 1e-8, {least} to '
         '{most}, and reach nothing that mixed ones do not.', against(document, 'haar-cg, fft, double', FAST, 1e-8))
    pick('**Backend `split` is for sparse contact on large grids**, see [performance](performance.md). At 1 % of grids as small as these '
         'it took {median} times the time of `fft`, to 1e-6.',
         against(document, 'haar-cg, split', FAST, 1e-6, lambda case: case['contact'] == 0.01))
    slow = []
    for name in ('cmr, fft', 'gp, fft', 'admm, fft', 'greedy, fft'):
        ratios, ran = slower(document, name, 1e-6)
        if ran:
            found = f'{times(median(ratios))} times the time of the fastest method' if ratios else 'never got there'
            slow.append(f'`{name.split(",")[0]}` {found} ({len(ratios)} of {ran} contacts within the limit)')
    if slow:
        picks.append('- **The other methods of the paper are there to be compared with.** To 1e-6: ' + '; '.join(slow) + '.')
    wanted = [tolerance_of(document, case) for case in known if bounded(document, case)['pressure_error'] > FLOOR]
    wanted = [tol for tol in wanted if tol]
    if wanted:
        shares = [f'{tol:.0e} in {sum(value >= tol for value in wanted)}' for tol in sorted(set(wanted), reverse=True)]
        picks.append(f'- **Tolerance.** Of {len(wanted)} contacts, errors of load and pressure fell below those of the grid at tol '
                     + ', '.join(shares) + '. What is tighter buys agreement with another code on the same grid, or smooth '
                     'derivatives for an outer iteration.')
    return '\n'.join(pick for pick in picks if pick)


def sections(results):
    document = load(results, 'pareto')
    return {'provenance': provenance(document), 'picks': pick_list(document), 'methods': method_table(document),
            'tolerances': tolerance_table(document), 'grids': grid_table(document), 'goals': goal_section(load(results, 'goal'))}
