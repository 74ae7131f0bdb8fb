"""Option accuracy: how often the goal is met, on which grids, and what it saves."""
import sys

from contact import share_in_contact, solve, status_of
from options import THREADS, Question, folder, listed, one_of, ranged, threads
from samples import median
from scenes import NAMES, RANDOM, make_scene
from store import Store, fits
from tables import show
from truth import search_approach

EXACT = 1e-9
QUANTITIES = ('load', 'area')


def seconds(result):
    return result.seconds + result.setup_seconds


class Pressed:
    """A gap pressed to one approach, and answers with option accuracy beside the exact one. more: options of every solve."""

    def __init__(self, system, gap, approach, options, mask=None):
        self.system, self.gap, self.options, self.mask = system, gap, options, mask
        self.exact = self.solve('displacement', approach, EXACT)

    def solve(self, control, target, tol, **more):
        return solve(self.system, self.gap, {**self.options, 'tol': tol, **more}, mask=self.mask, want_pressure=False, **{control: target})

    def target(self, control):
        return self.exact.load if control == 'load' else self.exact.approach

    def to_goal(self, control, quantity, goal):
        return self.solve(control, self.target(control), EXACT, accuracy=goal, **{'accuracy.of': quantity})

    def area_error(self, found):
        return abs(found.contact_area / self.exact.contact_area - 1)

    def error(self, found, control, quantity):
        """Where the load is given, that of the exact answer at the approach found."""
        if quantity == 'area':
            return self.area_error(found)
        there = self.solve('displacement', found.approach, EXACT) if control == 'load' else found
        return abs(there.load / self.exact.load - 1)

    def compared(self, control, quantity, goal):
        found, whole = self.to_goal(control, quantity, goal), self.solve(control, self.target(control), goal / 100)
        return {'status': status_of(found), 'model': found.accuracy.model_nx, 'estimate': found.accuracy.error_estimate,
                'error': self.error(found, control, quantity), 'left_out': found.accuracy.left_out, 'seconds': seconds(found),
                'whole_seconds': seconds(whole)}


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
        for control, quantity, goal in ((c, q, g) for c in ('displacement', 'load') for q in QUANTITIES for g in request.goals):
            key = {'scene': name, 'points': n, 'seed': seed, 'contact': contact, 'control': control, 'quantity': quantity, 'goal': goal}
            if store.find('rows', {**key, 'library': store.library}):
                continue
            if not pressed:
                approach = scene.known(contact / 100).target if scene.known else search_approach(scene, contact / 100, request.threads)
                pressed = Pressed(scene.system(n), scene.gap(n), approach, {'threads': request.threads})
            store.put('rows', key, {'share': share_in_contact(pressed.exact), **pressed.compared(control, quantity, goal)})
        print(f'{name}, surface {seed}, {contact:g} % in contact', file=sys.stderr)


def median_or_zero(values):
    return median(values) if values else 0


def summary_of(rows, values):
    rows = [row for row in rows if fits(row, values)]
    within, coarser = sum(row['error'] <= row['goal'] for row in rows), [row for row in rows if row['status'] == 'RC_WITHIN_GOAL']
    found = {**values, 'runs': len(rows), 'within': within, 'coarser': len(coarser)}
    if rows:
        found.update(within_percent=100 * within / len(rows), speedup=median([row['whole_seconds'] / row['seconds'] for row in rows]),
                     slack=median_or_zero([row['estimate'] / row['error'] for row in coarser if row['error'] > 0]))
    return found


def run(request):
    """Prints a table for each quantity; goes on where a file of results stopped."""
    store, summaries = Store(request.json, 'goal', request.threads), []
    for name in request.scenes:
        for seed in range(1, (request.seeds if name in RANDOM else 1) + 1):
            measure(request, store, name, seed)
    rows = store.document.get('rows', [])
    for control in ('displacement', 'load'):
        for quantity in QUANTITIES:
            of = {'control': control, 'quantity': quantity}
            part = [summary_of(rows, {**of, 'scene': name, 'goal': goal}) for name in request.scenes for goal in request.goals]
            part += [{**summary_of(rows, {**of, 'goal': goal}), 'scene': 'all'} for goal in request.goals]
            print(f'accuracy of the {quantity}, {control} control')
            show('scene; goal; runs; within goal=within; %=within_percent; on a coarser grid=coarser; estimate/error=slack:.1f; '
                 'whole/this s=speedup:.2f', part)
            print()
            summaries += part
    whole = summary_of(rows, {})
    print(f'{whole["within"]} of {whole["runs"]} runs within their goal')
    store.document.update(summaries=summaries, all=whole)
    store.save()


GOALS = listed(ranged(float, 1e-6, 0.5))
QUESTION = Question('goal', 'option accuracy: how often the goal is met, on which grids, and what it saves', run, {
    'scenes': (listed(one_of(*NAMES)), NAMES, 'what is pressed'), 'surfaces': (folder, '', 'folder with measured surfaces'),
    'points': (int, 512, 'points per side of surfaces that are not measured, a power of two'),
    'seeds': (ranged(int, 1, 1000), 6, 'surfaces of each random scene'),
    'contacts': (listed(ranged(float, 0.1, 95)), [1, 10, 40, 90], 'contact areas in percent of the grid'),
    'goals': (GOALS, [0.1, 0.03, 0.01, 0.003], 'values of option accuracy'), 'threads': (threads, THREADS, 'threads')})
