"""Option accuracy: how often the goal is met, on which grids, and what it saves: the tables of the page speed-accuracy.md, from goal.json."""
import sys

from contact import solve, status_of
from options import ALL_THREADS, folder, listed, one_of, question, ranged
from samples import chosen, columns, median, rows_of, values_of
from surfaces import NAMES, RANDOM, TITLES, make_scene, search_approach
from store import Store
from tables import records, table

EXACT = 1e-9
QUANTITIES = ('load', 'area')
CONTROLS = ('approach', 'load')
KEPT = ('goal of={quantity}; prescribed={control}; goal={goal:%g} %; runs; within it={within}; on a coarser grid={coarser}; '
        'there: estimate over error={slack:.1f}; whole grid\'s time over this={saved:.1f}; otherwise: time over the whole grid\'s alone={other:.2f}')


def seconds(result):
    return result.seconds + result.setup_seconds


class Pressed:
    """A gap pressed to one approach, and answers with option accuracy beside the exact one."""

    def __init__(self, system, gap, approach, threads):
        self.system, self.gap, self.threads = system, gap, threads
        self.exact = self.solve('approach', approach, EXACT)

    def solve(self, control, target, tol, **more):
        return solve(self.system, self.gap, {'threads': self.threads, 'tol': tol, **more}, want_pressure=False, **{control: target})

    def compared(self, control, quantity, goal):
        target = self.exact.load if control == 'load' else self.exact.approach
        found, exact = self.solve(control, target, EXACT, accuracy=goal, **{'accuracy.of': quantity}), self.exact
        there = self.solve('approach', found.approach, EXACT) if control == 'load' and quantity == 'load' else found
        error = abs(found.contact_area / exact.contact_area - 1) if quantity == 'area' else abs(there.load / exact.load - 1)
        return {'status': status_of(found), 'model': found.accuracy.model_nx, 'estimate': found.accuracy.error_estimate, 'error': error,
                'seconds': seconds(found), 'whole_seconds': seconds(self.solve(control, target, goal / 100))}


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
        for control, quantity in ((c, q) for c in CONTROLS for q in QUANTITIES):
            key = {'scene': name, 'points': n, 'seed': seed, 'contact': contact, 'control': control, 'quantity': quantity}
            if store.measured('runs', key):
                continue
            if not pressed:
                approach = scene.known(contact / 100).target if scene.known else search_approach(scene, contact / 100, request.threads)
                pressed = Pressed(scene.system(n), scene.gap(n), approach, request.threads)
            store.put('runs', key, {'goals': columns([{'goal': goal, **pressed.compared(control, quantity, goal)} for goal in request.goals])})
        print(f'{name}, surface {seed}, {contact:g} % in contact', file=sys.stderr)


def summary_of(rows, **values):
    """The summary of the rows with these values, without medians of nothing."""
    rows = chosen(rows, **values)
    coarser, others = chosen(rows, status='RC_WITHIN_GOAL'), [row for row in rows if row['status'] != 'RC_WITHIN_GOAL']
    within = sum(row['error'] <= row['goal'] for row in rows)
    found = {**values, 'runs': len(rows), 'within': within, 'coarser': len(coarser), 'within_percent': 100 * within / len(rows) if rows else None}
    for name, values in (('slack', [row['estimate'] / row['error'] for row in coarser if row['error'] > 0]),
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
    if store.rows('runs'):
        print(goal_section(store.document), grids_section(store.document), sep='\n\n')


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
    rows = [{**run, **row} for run in document['runs'] for row in rows_of(run['goals'])]
    goals, whole = values_of(rows, 'goal')[::-1], summary_of(rows)
    kept = [summary_of(rows, quantity=quantity, control=control, goal=goal) for quantity in QUANTITIES for control in CONTROLS for goal in goals]
    saved = (f' The whole grid, solved to a hundredth of the goal, took {whole["saved"]:.2f} times the time in the median of the '
             f'{whole["coarser"]} that did without.' if whole['coarser'] else '')
    sentence = (f'{whole["within"]} of {len(rows)} runs ({whole["within_percent"]:.2f} %) over {len({(row["scene"], row["seed"]) for row in rows})} '
                f'surfaces were within their goal of the answer on the whole grid.{saved}')
    return f'{sentence}\n\n{records(KEPT, [row for row in kept if row["runs"]])}'


def grids_section(document):
    rows = [{**run, **row} for run in document['runs'] for row in rows_of(run['goals'])]
    return ('Grids that were solved, in points a side over those given, for a goal of the load under a given approach; by contact:\n\n' +
            grids_table(rows, values_of(rows, 'goal')[::-1]))


GOALS = listed(ranged(float, 1e-6, 0.5))
question('goal', 'option accuracy: how often the goal is met, on which grids, and what it saves', run, {
    'scenes': (listed(one_of(*NAMES)), NAMES, 'what is pressed'), 'surfaces': (folder, '', 'folder with measured surfaces'),
    'points': (int, 512, 'points per side of surfaces that are not measured, a power of two'),
    'seeds': (ranged(int, 1, 1000), 6, 'surfaces of each random scene'),
    'contacts': (listed(ranged(float, 0.1, 95)), [1, 10, 40, 90], 'contact areas in percent of the grid'),
    'goals': (GOALS, [0.1, 0.03, 0.01, 0.003], 'values of option accuracy'), **ALL_THREADS})
