"""Option accuracy: how often the goal is met, on which grids, and what it saves: the rows and tables of docs/speed-accuracy.md, from goal.json. And
how often an answer without a solve of the whole grid is beyond its goal on surfaces that are made to mislead it."""
import sys

from contact import share_in_contact, solve, status_of
from options import ALL_THREADS, folder, listed, one_of, question, ranged, threads
from samples import chosen, median, values_of
from surfaces import NAMES, RANDOM, TITLES, make_scene, search_approach
from store import Store
from tables import records, show, table
from trial_surfaces import KINDS, make_surface

EXACT = 1e-9
QUANTITIES = ('load', 'area')
CONTROLS = {'approach': 'approach', 'load': 'load'}
COLUMNS = ('control; quantity; scene; goal={goal:g}; runs; within goal={within}; %={within_percent:g}; on a coarser grid={coarser}; '
           'estimate/error={slack:.1f}; whole/this s={speedup:.2f}')
KEPT = ('goal of={quantity}; prescribed; goal={goal:%g} %; runs; within it={within}; on a coarser grid={coarser}; '
        'there: estimate over error={slack:.1f}; whole grid\'s time over this={saved:.1f}; otherwise: time over the whole grid\'s alone={other:.2f}')


def seconds(result):
    return result.seconds + result.setup_seconds


class Pressed:
    """A gap pressed to one approach, and answers with option accuracy beside the exact one. more: options of every solve."""

    def __init__(self, system, gap, approach, options, mask=None):
        self.system, self.gap, self.options, self.mask = system, gap, options, mask
        self.exact = self.solve('approach', approach, EXACT)

    def solve(self, control, target, tol, **more):
        return solve(self.system, self.gap, {**self.options, 'tol': tol, **more}, mask=self.mask, want_pressure=False, **{control: target})

    def compared(self, control, quantity, goal, whole_tol=None):
        """whole_tol: of a solve of the whole grid, for its time."""
        target = self.exact.load if control == 'load' else self.exact.approach
        found, exact = self.solve(control, target, EXACT, accuracy=goal, **{'accuracy.of': quantity}), self.exact
        there = self.solve('approach', found.approach, EXACT) if control == 'load' and quantity == 'load' else found
        area_error = abs(found.contact_area / exact.contact_area - 1)
        row = {'status': status_of(found), 'model': found.accuracy.model_nx, 'estimate': found.accuracy.error_estimate,
               'error': area_error if quantity == 'area' else abs(there.load / exact.load - 1), 'left_out': found.accuracy.left_out,
               'area_error': area_error, 'area_estimate': found.accuracy.area_estimate, 'seconds': seconds(found)}
        return {**row, 'whole_seconds': seconds(self.solve(control, target, whole_tol))} if whole_tol else row


def measure(request, store, name, seed):
    scene, missing = make_scene(name, request.points // 4, request.surfaces, seed)
    if not scene:
        print(f'{name}: left out, {missing}', file=sys.stderr)
        return
    if scene.control == 'load':
        return  # pressed flat, the approach tells nothing
    for contact in [100] if scene.full else request.contacts:
        if contact / 100 > scene.most_contact:
            continue
        n, pressed = 4 * scene.n, None
        for control, quantity, goal in ((c, q, g) for c in CONTROLS for q in QUANTITIES for g in request.goals):
            key = {'scene': name, 'points': n, 'seed': seed, 'contact': contact, 'control': control, 'quantity': quantity, 'goal': goal}
            if store.measured('rows', key):
                continue
            if not pressed:
                approach = scene.known(contact / 100).target if scene.known else search_approach(scene, contact / 100, request.threads)
                pressed = Pressed(scene.system(n), scene.gap(n), approach, {'threads': request.threads})
            store.put('rows', key, {'share': share_in_contact(pressed.exact), **pressed.compared(control, quantity, goal, goal / 100)})
        print(f'{name}, surface {seed}, {contact:g} % in contact', file=sys.stderr)


def summary_of(rows, **values):
    """Of the rows with these values; medians are left out where there is nothing to take them of."""
    rows = chosen(rows, **values)
    coarser, others = chosen(rows, status='RC_WITHIN_GOAL'), [row for row in rows if row['status'] != 'RC_WITHIN_GOAL']
    within = sum(row['error'] <= row['goal'] for row in rows)
    found = {**values, 'runs': len(rows), 'within': within, 'coarser': len(coarser), 'within_percent': 100 * within / len(rows) if rows else None}
    for name, values in (('slack', [row['estimate'] / row['error'] for row in coarser if row['error'] > 0]),
                         ('speedup', [row['whole_seconds'] / row['seconds'] for row in rows]),
                         ('saved', [row['whole_seconds'] / row['seconds'] for row in coarser]),
                         ('other', [row['seconds'] / row['whole_seconds'] for row in others])):
        found.update({name: median(values)} if values else {})
    return found


def run(request):
    """Goes on where a file of results stopped."""
    store = Store(request.json, 'goal', request.threads)
    for name in request.scenes:
        for seed in range(1, (request.seeds if name in RANDOM else 1) + 1):
            measure(request, store, name, seed)
    rows = store.document.get('rows', [])
    summaries = [{**summary_of(rows, control=control, quantity=quantity, goal=goal, **({'scene': name} if name != 'all' else {})), 'scene': name}
                 for control in CONTROLS for quantity in QUANTITIES for name in (*request.scenes, 'all') for goal in request.goals]
    show(COLUMNS, summaries)
    whole = summary_of(rows)
    print(f'{whole["within"]} of {whole["runs"]} runs within their goal')
    store.save(summaries=summaries, all=whole)


def grid_used(rows):
    """Points a side of the grid that was solved, as parts of the given ones: median of the runs."""
    factor = median([row['points'] / row['model'] for row in rows])
    return 'all' if factor < 1.5 else f'1/{factor:.0f}'


def grids_table(rows, goals):
    """For a goal of the load under a given approach."""
    lines = []
    for scene, title in TITLES.items():
        found = chosen(rows, scene=scene, quantity='load', control='approach')
        if found:
            used = {goal: [f'{contact:g} %: {grid_used(chosen(found, goal=goal, contact=contact))}' for contact in values_of(found, 'contact')]
                    for goal in goals}
            lines.append([f'{title}, {found[0]["points"]}²', *map(', '.join, used.values())])
    return table(['scene', *[f'within {100 * goal:g} %' for goal in goals]], lines)


def goal_section(document):
    rows = document['rows']
    goals, whole = values_of(rows, 'goal')[::-1], summary_of(rows)
    kept = [{**summary_of(rows, quantity=quantity, control=control, goal=goal), 'prescribed': prescribed}
            for quantity in QUANTITIES for control, prescribed in CONTROLS.items() for goal in goals]
    saved = (f' The whole grid, solved to a hundredth of the goal, took {whole["saved"]:.2f} times the time in the median of the '
             f'{whole["coarser"]} that did without.' if whole['coarser'] else '')
    sentence = (f'{whole["within"]} of {len(rows)} runs ({whole["within_percent"]:.2f} %) over {len({(row["scene"], row["seed"]) for row in rows})} '
                f'surfaces were within their goal of the answer on the whole grid.{saved}')
    return '\n\n'.join([sentence, records(KEPT, [row for row in kept if row['runs']]), 'Grids that were solved, in points a side over those '
                        'given, for a goal of the load under a given approach; by contact:', grids_table(rows, goals)])


GOALS = listed(ranged(float, 1e-6, 0.5))
question('goal', 'option accuracy: how often the goal is met, on which grids, and what it saves', run, {
    'scenes': (listed(one_of(*NAMES)), NAMES, 'what is pressed'), 'surfaces': (folder, '', 'folder with measured surfaces'),
    'points': (int, 512, 'points per side of surfaces that are not measured, a power of two'),
    'seeds': (ranged(int, 1, 1000), 6, 'surfaces of each random scene'),
    'contacts': (listed(ranged(float, 0.1, 95)), [1, 10, 40, 90], 'contact areas in percent of the grid'),
    'goals': (GOALS, [0.1, 0.03, 0.01, 0.003], 'values of option accuracy'), **ALL_THREADS})


TRIAL = ('surface; runs; on a coarser grid={coarser}; beyond; estimate/error={slack:.1f}; area beyond its estimate={area_beyond}; '
           'area\'s estimate/error={area_slack:.1f}; whole/this s={saved:.2f}')


def of_surface(request, name, seed):
    """Rows of one surface; those beyond their goal are printed."""
    system, gap, approach, mask = make_surface(name, request.points, seed)
    pressed = Pressed(system, gap, approach, {'bounds': 0, 'threads': request.threads}, mask)
    for control, quantity, goal in ((c, q, g) for c in CONTROLS for q in QUANTITIES for g in request.goals) if pressed.exact.load > 0 else ():
        row = pressed.compared(control, quantity, goal, goal / (1000 if quantity == 'area' else 100) if request.times else None)
        coarser = row['status'] == 'RC_WITHIN_GOAL'
        row.update(surface=name, beyond=coarser and not row['error'] <= goal, area_beyond=coarser and not row['area_error'] <= row['area_estimate'])
        if row['beyond'] or row['area_beyond']:
            print(f'{name}, surface {seed}: goal {goal:g} of the {quantity}, by {CONTROLS[control]}: error {row["error"]:.4f}, estimate '
                  f'{row["estimate"]:.4f}, of the area {row["area_error"]:.4f}, {row["area_estimate"]:.4f}, from {row["model"]} of '
                  f'{gap.shape[1]} points a side', file=sys.stderr)
        yield row


def trial_summary(name, rows):
    coarser = chosen(rows, status='RC_WITHIN_GOAL')
    found = {'surface': name, 'runs': len(rows), 'coarser': len(coarser), **{key: sum(row[key] for row in rows) for key in ('beyond', 'area_beyond')}}
    for key, over, below in (('slack', 'estimate', 'error'), ('area_slack', 'area_estimate', 'area_error'), ('saved', 'whole_seconds', 'seconds')):
        values = [row[over] / row[below] for row in coarser if over in row and row[below] > 0]
        found[key] = median(values) if values else 0
    return {**found, 'beyond_percent': 100 * found['beyond'] / len(coarser) if coarser else 0}


def run_trial(request):
    """Prints a table by surface and, last, the rate of all."""
    store, rows = Store(request.json, 'goal-trial', request.threads), []
    for name in request.kinds:
        rows += [row for seed in range(request.first, request.last + 1) for row in of_surface(request, name, seed)]
        print('{surface}: {beyond} of {coarser}'.format(**trial_summary(name, chosen(rows, surface=name))), file=sys.stderr)
    rows = [trial_summary(name, chosen(rows, surface=name)) for name in request.kinds] + [trial_summary('all', rows)]
    show(TRIAL, rows)
    print('{beyond} of {coarser} answers on a coarser grid beyond their goal, {beyond_percent:.2f} %'.format(**rows[-1]))
    store.save(rows=rows)


question('goal-trial', 'option accuracy on surfaces made to mislead it: answers beyond their goal', run_trial, {
    'kinds': (listed(one_of(*KINDS)), list(KINDS), 'what is pressed'), 'points': (ranged(int, 32, 2048), 160, 'points per side, about'),
    'first': (ranged(int, 1, 1000000), 1, 'seed of each kind'), 'last': (ranged(int, 1, 1000000), 20, 'seed of each kind'),
    'goals': (GOALS, [0.1, 0.03, 0.01], 'values of option accuracy'), 'threads': (threads, 1, 'threads'),
    'times': (bool, False, "solve the whole grid to the goal's tolerance as well, for its time")})
