"""Option accuracy on surfaces that are made to mislead it: how often an answer without a solve of the whole grid is beyond its goal."""
import sys

import roughcontact as rc

from goals import GOALS, QUANTITIES, Pressed, median_or_zero, seconds
from options import Question, listed, one_of, ranged, threads
from store import Store
from tables import show
from trial_surfaces import KINDS, make_surface


class Tally:
    def __init__(self, name):
        self.name, self.runs, self.coarser, self.beyond, self.area_beyond = name, 0, 0, 0, 0
        self.slack, self.area_slack, self.saved = [], [], []

    def add(self, other):
        for name, value in vars(other).items():
            if name != 'name':
                setattr(self, name, getattr(self, name) + value)

    def summary(self):
        return {'surface': self.name, 'runs': self.runs, 'coarser': self.coarser, 'beyond': self.beyond,
                'beyond_percent': 100 * self.beyond / self.coarser if self.coarser else 0, 'slack': median_or_zero(self.slack),
                'area_beyond': self.area_beyond, 'area_slack': median_or_zero(self.area_slack), 'saved': median_or_zero(self.saved)}

    def run(self, request, pressed, control, quantity, goal, label):
        found = pressed.to_goal(control, quantity, goal)
        self.runs += 1
        if found.status != rc.Status.WITHIN_GOAL:
            return
        area_error, error = pressed.area_error(found), pressed.error(found, control, quantity)
        beyond, area_beyond = not error <= goal, not area_error <= found.accuracy.area_estimate
        self.coarser, self.beyond, self.area_beyond = self.coarser + 1, self.beyond + beyond, self.area_beyond + area_beyond
        self.slack += [found.accuracy.error_estimate / error] if error > 0 else []
        self.area_slack += [found.accuracy.area_estimate / area_error] if area_error > 0 else []
        if beyond or area_beyond:
            print(f'{label}: goal {goal:g} of the {quantity}, by {"load" if control == "load" else "approach"}: error {error:.4f}, estimate '
                  f'{found.accuracy.error_estimate:.4f}, of the area {area_error:.4f}, {found.accuracy.area_estimate:.4f}, from {found.accuracy.model_nx} of '
                  f'{pressed.gap.shape[1]} points a side', file=sys.stderr)
        if request.times:
            whole = pressed.solve(control, pressed.target(control), goal / (1000 if quantity == 'area' else 100))
            self.saved.append(seconds(whole) / seconds(found))


def of_surface(request, name, seed):
    surface, tally = make_surface(name, request.points, seed), Tally(name)
    pressed = Pressed(surface.system, surface.gap, surface.approach, {'bounds': 0, 'threads': request.threads}, surface.mask)
    if pressed.exact.load > 0:
        for control in ('displacement', 'load'):
            for quantity in QUANTITIES:
                for goal in request.goals:
                    tally.run(request, pressed, control, quantity, goal, f'{name}, surface {seed}')
    return tally


def run(request):
    """Prints a table by surface and, last, the rate of all."""
    store, rows, whole = Store(request.json, 'goal-trial', request.threads), [], Tally('all')
    for name in request.kinds:
        tally = Tally(name)
        for seed in range(request.first, request.last + 1):
            tally.add(of_surface(request, name, seed))
        rows.append(tally.summary())
        whole.add(tally)
        print(f'{name}: {tally.beyond} of {tally.coarser}', file=sys.stderr)
    rows.append(whole.summary())
    show('surface; runs; on a coarser grid=coarser; beyond; estimate/error=slack:.1f; area beyond its estimate=area_beyond; '
         'area\'s estimate/error=area_slack:.1f; whole/this s=saved:.2f', rows)
    print(f'{whole.beyond} of {whole.coarser} answers on a coarser grid beyond their goal, {rows[-1]["beyond_percent"]:.2f} %')
    store.document['rows'] = rows
    store.save()


QUESTION = Question('goal-trial', 'option accuracy on surfaces made to mislead it: answers beyond their goal', run, {
    'kinds': (listed(one_of(*KINDS)), list(KINDS), 'what is pressed'), 'points': (ranged(int, 32, 2048), 160, 'points per side, about'),
    'first': (ranged(int, 1, 1000000), 1, 'seed of each kind'), 'last': (ranged(int, 1, 1000000), 20, 'seed of each kind'),
    'goals': (GOALS, [0.1, 0.03, 0.01], 'values of option accuracy'), 'threads': (threads, 1, 'threads'),
    'times': (bool, False, "solve the whole grid to the goal's tolerance as well, for its time")})
