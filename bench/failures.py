"""The failure atlas of greedy elimination and the cascade: where they fail, how the library tells, and what it does about it."""
import sys
from statistics import fmean

import numpy as np
import roughcontact as rc

from contact import FILTERS, OK, cascade_note, cascade_options, cascade_verdict, certified, difference, press, status_of
from options import listed, one_of, question
from samples import wilson
from store import Store
from surfaces import CLASSES, Scene, below_highest, example_one, influence, measured_scene

KERNELS = ('eq9', 'punch', 'galerkin', 'love', 'disc')


class Atlas:
    """What a family reports: the atlas' rows for readers, and every number behind them."""

    def __init__(self, quick, surface):
        self.quick, self.surface, self.rows, self.data = quick, surface, [], {}

    def add(self, family, trigger, happens, detected, library):
        self.rows.append({'row': family, 'trigger': trigger, 'happens': happens, 'detected': detected, 'library': library})
        print(f'[{family}] {trigger}\n  happens:  {happens}\n  detected: {detected}\n  library:  {library}', flush=True)

    def record(self, name, **values):
        self.data.setdefault(name, []).append(values)
        return values


def greedy_on_draws(kernel, n, spacing, draws):
    """How many of the first draws of example_one greedy solves wrongly, with Wilson's 95 % interval, and how wrong; every answer is
    compared with that of nnls, which must be certified. dishonest: certified, but not the solution, or the reverse."""
    side = round(n**0.5)
    system = example_one(side, spacing, 0).system

    def contact(**options):
        return rc.Contact(system, options={'kernel': kernel, 'backend': 'dense', 'tol': 1e-10, **options})

    greedy = {'solver': 'greedy', 'greedy.inner': 'cholesky'}
    exact, plain, repairing = contact(solver='nnls'), contact(**greedy), contact(**greedy, **{'greedy.repair': 1})
    failures = dishonest = unrepaired = 0
    deepest = load_error = pressure_error = 0.0
    for seed in range(draws):
        scene = example_one(side, spacing, seed)
        step = {'approach': scene.approach, 'undeformed_gap': scene.gap, 'mask': scene.mask, 'warm_start': False, 'check': False}
        found, known = plain.solve(**step), certified(exact.solve(**step))
        off = difference(found.pressure, known.pressure)
        wrong = status_of(found) != OK
        dishonest += (off > 1e-6) != wrong
        failures += wrong
        unrepaired += wrong and status_of(repairing.solve(**step)) != OK
        deepest, pressure_error = max(deepest, found.kkt_dual), max(pressure_error, off)
        load_error = max(load_error, abs(found.load / known.load - 1))
    lower, upper = wilson(failures, draws)
    return {'kernel': kernel, 'n': n, 'spacing': spacing, 'draws': draws, 'failures': failures, 'share': failures / draws,
            'lower': lower, 'upper': upper, 'dishonest': dishonest, 'unrepaired': unrepaired, 'deepest_overlap': deepest,
            'load_error': load_error, 'pressure_error': pressure_error}


def largest_inverse_coupling(kernel, side, spacing):
    """The largest (H^-1)_jk, j != k, over the smallest (H^-1)_kk. Greedy elimination solves H p - u >= 0, p >= 0, p (H p - u) = 0 for every
    u if and only if it is not positive: it is then Chandrasekaran's method (1970) for such matrices. Not positive: greedy is exact for
    every u on this set and, as the property is inherited, on each of its subsets."""
    inverse = np.linalg.inv(influence(kernel, side, spacing))
    smallest = inverse.diagonal().min()
    np.fill_diagonal(inverse, -np.inf)
    return inverse.max() / smallest


def greedy(atlas):
    """Example 1 of Bemporad & Paggi (2015): N x N cells, all of them in the trial set, penetrations uniform on (0, 1)."""
    cases = [(kernel, spacing, side) for kernel in KERNELS for spacing in (1, 2) for side in (5, 10, 20)]
    for kernel, spacing, side in cases:
        draws = 1000 if not atlas.quick else 100 if side < 20 else 30
        atlas.record('greedy', **greedy_on_draws(kernel, side * side, spacing, draws))
    rows = atlas.data['greedy']
    shown = [row for row in rows if row['kernel'] == 'eq9' and row['spacing'] == 1]
    others = [row for row in rows if row not in shown]
    worst = next(row for row in shown if row['n'] == 100)
    shares = '; '.join(f'n = {row["n"]}: {100 * row["share"]:.1f} % ({100 * row["lower"]:.1f} to {100 * row["upper"]:.1f})' for row in shown)
    atlas.add('greedy', 'Example 1 of the paper: N x N cells in contact at random depths, kernel eq9',
              f'the answer overlaps in a share of draws that grows with n, {shares}; at n = 100 the deepest overlap is '
              f'{worst["deepest_overlap"]:.2f} of the penetration, loads are off by up to {worst["load_error"]:.1e} and pressures by up to '
              f'{100 * worst["pressure_error"]:.0f} % of the largest',
              'RC_UNCERTIFIED with a note that counts the overlapping points, in each of the draws; wrong answers with status RC_OK: '
              f'{sum(row["dishonest"] for row in rows)}',
              'every other solver lets points come back; greedy.repair = 1 hands what greedy found over to nnls: draws it left unsolved: '
              f'{sum(row["unrepaired"] for row in rows)}')
    atlas.add('greedy', 'the same with kernels love, disc, galerkin or punch, or with every second cell left out',
              f'{sum(row["failures"] for row in others)} of {sum(row["draws"] for row in others)} draws fail',
              'certified nevertheless', 'kernel love is the default')
    couplings = []
    for kernel in KERNELS:
        for spacing, side in ((1, 5), (1, 10), (1, 20), (1, 30), (2, 5), (2, 10), (2, 20)):
            if side <= 20 or not atlas.quick:
                coupling = largest_inverse_coupling(kernel, side, spacing)
                atlas.record('inverse', kernel=kernel, n=side * side, spacing=spacing, coupling=coupling)
                shown = coupling if spacing == 1 else shown
        couplings.append(f'{kernel} {shown:+.1e}')
    atlas.add('greedy', 'why: greedy is exact for every surface if and only if H^-1 has no positive entry off its diagonal',
              f'largest such entry over the smallest on the diagonal: {", ".join(couplings)}; negative for every kernel when every second '
              'cell is left out', 'a property of kernel and grid, in the table of H^-1',
              'galerkin and punch are exact on random surfaces only; see docs/development/paper.md')


def cascades(atlas, scene, halvings):
    """One surface by every filter, as published and certified."""
    full = certified(press(scene, {'solver': 'polonsky-keer', 'backend': 'fft'})[0])
    verdict = cascade_verdict(scene, halvings)
    for kind in FILTERS:
        plain, sound = (press(scene, cascade_options(kind, 1.5, halvings + 1, certified=each))[0] for each in (0, 1))
        note, wrong = cascade_note(sound.note), difference(plain.pressure, full.pressure) > 1e-4
        atlas.record('cmr', surface=scene.name, filter=kind, plain_error=plain.load / full.load - 1, certified_error=sound.load / full.load - 1,
                     rounds=note.rounds, kept=note.share, **verdict, dishonest=int(wrong and status_of(plain) == OK))


def summarise(atlas, name, words):
    rows = [row for row in atlas.data['cmr'] if row['surface'] == name]
    off = [100 * fmean(row['plain_error'] for row in rows if row['filter'] == kind) for kind in FILTERS]
    best = [row for row in rows if row['filter'] == 'max']
    atlas.add('cmr', 'as published, ' + words, 'load off by {:.2f} % (subsample), {:.2f} % (mean), {:.2f} % (max)'.format(*off),
              f'wrong answers with status RC_OK: {max(row["dishonest"] for row in rows)}; the surface\'s spectrum warns: '
              f'{fmean(row["unresolved"] for row in best):.2f} unresolved, trustworthy {fmean(row["trustworthy"] for row in best):.0f}',
              f'certified: load off by {max(abs(row["certified_error"]) for row in rows):.0e} at most, {max(row["rounds"] for row in rows)} '
              'rounds at most')


def cmr(atlas):
    n = 64 if atlas.quick else 256
    for surface in CLASSES:
        if surface.high > n / 2 or surface.roll_off > n / 4:
            continue
        for seed in range(1, 2 if atlas.quick else 5):
            gap = below_highest(surface.heights(n, seed))
            cascades(atlas, Scene(surface.name, gap, gap.mean() / 2), 2)  # halvings as for the paper's measured surfaces
        summarise(atlas, surface.name, surface.name)
    if atlas.surface:
        scene = measured_scene(atlas.surface)
        cascades(atlas, scene, 5)
        summarise(atlas, scene.name, 'measured surface ' + scene.name)


FAMILIES = {'greedy': greedy, 'cmr': cmr}


def run(request):
    store, atlas = Store(request.json, 'failures', 1), Atlas(request.quick, request.surface)
    for name, family in FAMILIES.items():
        if not request.row or name in request.row:
            print(f'atlas: {name}', file=sys.stderr)
            family(atlas)
    store.save(atlas=atlas.rows, **atlas.data)


question('failures', 'the failure atlas: where methods fail, how that shows, what helps', run, {
    'row': (listed(one_of(*FAMILIES)), [], 'families of rows; all'), 'surface': (str, '', 'a measured surface for the rows of cmr')},
    {}, 'fewer draws, smaller surfaces')
