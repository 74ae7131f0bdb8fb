"""The failure atlas: where methods for this contact problem fail, how the library tells, and what it does about it."""
import sys
from statistics import fmean

import numpy as np
import roughcontact as rc

from contact import FILTERS, OK, cascade_note, cascade_options, cascade_verdict, certified, difference, names, press, runs, status_of
from options import listed, one_of, question
from samples import wilson
from store import Store
from surfaces import (CLASSES, Scene, below_highest, example_one, hertz_scene, influence, measured_scene, rough_scene, strained_scenes, tied_scene)

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


def dense(solver, tol, **more):
    return {'solver': solver, 'backend': 'dense', 'tol': tol, **more}


def truth_of(scene):
    """Pressures by nnls on the dense backend, to 1e-12."""
    return certified(press(scene, dense('nnls', 1e-12))[0]).pressure


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
    """Example 1 of Bemporad & Paggi (2015): N x N cells, all of them candidates, compenetrations uniform on (0, 1)."""
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
              f'{worst["deepest_overlap"]:.2f} of the compenetration, loads are off by up to {worst["load_error"]:.1e} and pressures by up to '
              f'{100 * worst["pressure_error"]:.0f} % of the largest',
              'RC_UNCERTIFIED with a note that counts the overlapping points, in each of the draws; wrong answers with status RC_OK: '
              f'{sum(row["dishonest"] for row in rows)}',
              'every other solver lets points come back; greedy.repair = 1 hands what greedy found over to nnls: draws it left unsolved: '
              f'{sum(row["unrepaired"] for row in rows)}')
    atlas.add('greedy', 'the same with kernels love, disc, galerkin or punch, or with every second cell left out',
              f'{sum(row["failures"] for row in others)} of {sum(row["draws"] for row in others)} draws fail',
              'not needed, checked all the same', 'kernel love is the default')
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
              'cell is left out', 'a property of kernel and grid, tabled as "inverse"',
              'galerkin and punch are exact on random surfaces only; see docs/paper.md')


def polonsky_keer(atlas):
    options = dense('polonsky-keer', 1e-10)
    below = press(hertz_scene(32 if atlas.quick else 96), dense('polonsky-keer', 1e-16))[0]
    atlas.record('polonsky-keer', trigger='tolerance 1e-16', status=status_of(below), iterations=below.iterations, residual=below.residual)
    atlas.add('polonsky-keer', 'a tolerance below what double precision can reach: Hertz, tol 1e-16',
              f'the updated gap goes on shrinking while the true residual stays at {below.residual:.1e}',
              f'{status_of(below)} after {below.iterations} iterations: the residual counts only with a fresh product, and must fall by a '
              'tenth in 300 iterations', 'the answer is delivered with its residual')
    rough = rough_scene(5 if atlas.quick else 6, 1)
    cold = press(rough, options)[0]
    heavy = press(rough.but(approach=8 * rough.approach), options)[0].pressure
    again, lighter = (press(rough, options, start)[0] for start in (cold.pressure, heavy))
    none = press(rough.but(approach=0.0), options)[0]
    statuses = [status_of(result) for result in (again, none, lighter)]
    atlas.record('polonsky-keer', trigger='starts', cold=cold.products, exact=again.products, heavier=lighter.products,
                 exact_status=statuses[0], heavier_status=statuses[2], no_approach_status=statuses[1])
    atlas.add('polonsky-keer', 'an exact start, no approach at all, a start from 8 times the approach: as printed 0/0, or far from the answer',
              f'products: cold {cold.products}, exact start {again.products}, no approach {none.products}, heavy start '
              f'{lighter.products}', ', '.join(statuses),
              'the certificate ends an exact start at once; a start worse than none is cut to its best multiple')


def units(atlas, scene, options, truth, lengths):
    """(largest difference from the truth, whether every solve was certified after as many iterations)"""
    plain = press(scene, options)[0]
    errors, same = [], True
    for length in lengths:
        for pressure in (1e-9, 1e11):
            found = press(scene.but(gap=scene.gap * length, approach=scene.approach * length, pitch=tuple(length * h for h in scene.pitch),
                                    modulus=scene.modulus * pressure), options)[0]
            errors.append(difference(found.pressure / pressure, plain.pressure if truth is None else truth))
            same = same and found.iterations == plain.iterations and status_of(found) == OK
            atlas.record('units', solver=options['solver'], length=length, pressure=pressure, iterations=found.iterations,
                         difference=errors[-1], status=status_of(found))
    return max(errors), 'equal' if same else 'NOT equal'


def nnls(atlas):
    options, rough = dense('nnls', 1e-10), rough_scene(5, 1)
    worst, same = units(atlas, rough, options, None, (1e-9, 1.0, 1e9))
    atlas.add('nnls', 'lengths times 1e-9 to 1e9, pressures times 1e-9 to 1e11',
              'with the printed absolute tolerance eps = 1e-08 a compenetration of 1e-9 is no contact, and forces of 1e-9 may pull',
              f'largest difference of the pressures {worst:.1e}, iterations {same}',
              'solvers see a dimensionless problem; all tolerances are relative')

    ties = tied_scene(8 if atlas.quick else 16)
    block, single, other = (press(ties, each)[0] for each in (options, {**options, 'nnls.pivoting': 'single'}, dense('polonsky-keer', 1e-10)))
    off = max(difference(result.pressure, block.pressure) for result in (single, other))
    atlas.record('ties', block=block.iterations, single=single.iterations, block_contacts=block.contacts, single_contacts=single.contacts,
                 polonsky_keer_contacts=other.contacts, difference=off)
    atlas.add('nnls', 'points that touch without pressure: p = 0 and gap = 0',
              f'contacts counted: block {block.contacts}, single {single.contacts}, polonsky-keer {other.contacts}; pressures differ by '
              f'{off:.1e} at most', f'{", ".join(map(status_of, (block, single, other)))}: pressures, loads and gaps are certified, a count '
              'of contacts is not', 'area_lower and area_upper say what is proven')

    pulling = np.full(rough.gap.size, 1e3)
    pulling[::2] = -1e3
    tensile, plain = press(rough, options, pulling.reshape(rough.gap.shape))[0], press(rough, options)[0]
    off = difference(tensile.pressure, plain.pressure)
    atlas.record('tensile', status=status_of(tensile), difference=off)
    atlas.add('nnls', 'a start with tension', 'as printed it may be returned as the answer when forces are small',
              f'{status_of(tensile)}, pressures differ by {off:.1e} from the cold answer', 'negative pressures of a start are taken as 0')

    warm = rough_scene(6 if atlas.quick else 7, 1).but(kernel='eq9')
    warm = warm.but(approach=1.5 * warm.approach) if atlas.quick else warm
    printed = {'gp.lipschitz': 'frobenius', 'gp.restart': 0}
    solves = {}
    for pivoting, counts in (('single', (0, 10, 50, 100)), ('block', (0, 10, 100))):
        for steps in counts:
            warmup = {'warmup': 'gp', 'warmup.iterations': steps} if steps else {}
            found = press(warm, {**options, **printed, 'nnls.pivoting': pivoting, 'max_iter': 1000000, **warmup})[0]
            # The warm-up counts as iterations, too; it ends early where it has solved the problem.
            spent = press(warm, {**dense('gp', 1e-10), **printed, 'max_iter': steps})[0].iterations if steps else 0
            solves[pivoting, steps] = found.iterations - spent
            atlas.record('warm_up', pivoting=pivoting, warmup='gp' if steps else 'none', steps=steps, solves=solves[pivoting, steps],
                         candidates=found.candidates, contacts=found.contacts, status=status_of(found))
    atlas.add('nnls', 'too short a warm-up by gradient projection, one exchange per solve as printed; kernel eq9',
              'linear solves: cold {}, after 10 steps {}, 50 steps {}, 100 steps {}'.format(*(solves['single', k] for k in (0, 10, 50, 100))),
              'no failure of the answer, only of speed: each superfluous point costs a solve',
              'nnls.pivoting = block, the default, exchanges all at once: {} cold, {} after 10 steps, {} after 100'.format(
                  *(solves['block', k] for k in (0, 10, 100))))


def gradient(atlas):
    rough = rough_scene(5 if atlas.quick else 6, 1)
    for kernel in ('love', 'eq9'):
        scene = rough.but(kernel=kernel)
        truth, found = truth_of(scene), []
        for lipschitz, restart in (('frobenius', 0), ('collatz', 0), ('frobenius', 1), ('collatz', 1), ('polonsky-keer', None)):
            if restart is None:
                options = dense('polonsky-keer', 1e-8, max_iter=100000)
            else:
                options = dense('gp', 1e-8, max_iter=100000, **{'gp.lipschitz': lipschitz, 'gp.restart': restart})
            result = press(scene, options)[0]
            found.append(atlas.record('gp', kernel=kernel, lipschitz=lipschitz, restart={0: 'no', 1: 'yes', None: ''}[restart],
                                      iterations=result.iterations, products=result.products, status=status_of(result),
                                      difference=difference(result.pressure, truth)))
        atlas.add('gp', f'no restart of the acceleration, step from the Frobenius norm, as printed; kernel {kernel}',
                  'iterations to 1e-8: as printed {}, tight step {}, with restart {}, both {}; polonsky-keer {}'.format(
                      *(row['iterations'] for row in found)), ', '.join(row['status'] for row in found[:4]) + ': slow, never wrong',
                  'gp.restart = 1 and gp.lipschitz = collatz are the defaults')


def admm(atlas):
    scene = rough_scene(5 if atlas.quick else 6, 1)
    truth, rows = truth_of(scene), []
    for rho in ('1e-6', '1e-3', '1e-1', '1', '1e1', '1e3', '1e6', '0'):
        found = press(scene, dense('admm', 1e-8, max_iter=1000 if atlas.quick else 5000, **{'admm.rho': rho}))[0]
        rows.append(atlas.record('admm', rho='automatic' if rho == '0' else rho, iterations=found.iterations, status=status_of(found),
                                 residual=found.residual, difference=difference(found.pressure, truth)))
    wrong = sum(row['status'] == OK and row['difference'] > 1e-5 for row in rows)
    atlas.add('admm', 'a penalty rho far from the scale of H',
              'iterations, rho in units of E* and the cell: ' + ', '.join(f'{row["rho"]}: {row["iterations"]}' for row in rows),
              f'{", ".join(row["status"] for row in rows)}; wrong answers with status RC_OK: {wrong}',
              'admm.rho = 0, the default, takes it from bounds of the eigenvalues and balances the residuals')
    worst, same = units(atlas, scene, dense('admm', 1e-8), truth, (1e-9, 1.0))
    atlas.add('admm', 'rho = 1 of the paper is a stiffness: it works only in units in which H is about 1',
              f'lengths times 1e-9, pressures times 1e-9 and 1e11: iterations {same}, pressures differ from the exact ones by {worst:.1e}',
              'units do not reach the solver', 'rho is relative to E* and the cell')


def cascades(atlas, scene, halvings, seed):
    """One surface by every filter, as published and certified."""
    full = certified(press(scene, {'solver': 'polonsky-keer', 'backend': 'fft'})[0])
    verdict = cascade_verdict(scene, halvings)
    for kind in FILTERS:
        plain, sound = (press(scene, cascade_options(kind, 1.5, halvings + 1, certified=each))[0] for each in (0, 1))
        note, wrong = cascade_note(sound.note), difference(plain.pressure, full.pressure) > 1e-4
        atlas.record('cmr', surface=scene.name, seed=seed, filter=kind, plain_error=plain.load / full.load - 1, plain_status=status_of(plain),
                     plain_wrong=int(wrong), certified_error=sound.load / full.load - 1,
                     certified_difference=difference(sound.pressure, full.pressure), certified_status=status_of(sound), rounds=note.rounds,
                     kept=note.share, full_products=full.products, certified_products=sound.products, contacts=full.contacts,
                     **verdict, dishonest=int(wrong and status_of(plain) == OK))


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
            cascades(atlas, Scene(surface.name, gap, gap.mean() / 2), 2, str(seed))  # halvings as for the paper's measured surfaces
        summarise(atlas, surface.name, surface.name)
    if atlas.surface:
        scene = measured_scene(atlas.surface)
        cascades(atlas, scene, 5, '')
        summarise(atlas, scene.name, 'measured surface ' + scene.name)


def conditioning(atlas):
    """Problems that strain double precision, by every solver of the registry."""
    for scene in strained_scenes(16 if atlas.quick else 32):
        truth, rows = truth_of(scene), []
        for solver in names(rc.solvers):
            if not runs(solver, 'dense', scene.system):
                continue
            try:
                found = press(scene, {'solver': solver, 'backend': 'dense', 'max_iter': 100000, 'time_limit': 60})[0]
                values = {'status': status_of(found), 'iterations': found.iterations, 'residual': found.residual,
                          'difference': difference(found.pressure, truth)}
            except rc.RoughContactError as error:
                values = {'status': 'RC_' + error.status.name, 'iterations': 0, 'residual': 0, 'difference': 1}
            rows.append(atlas.record('conditioning', scene=scene.name, solver=solver, **values))
        sound = [row for row in rows if row['status'] == OK]
        refused = ', '.join(f'{row["solver"]} {row["status"]}' for row in rows if row not in sound)
        atlas.add('conditioning', scene.name, f'iterations: {", ".join("{solver} {iterations}".format(**row) for row in rows)}; pressures of '
                  f'certified answers are off by {max((row["difference"] for row in sound), default=0):.1e} at most',
                  f'certified {len(sound)}, wrong with status RC_OK {sum(row["difference"] > 1e-4 for row in sound)}' +
                  (f'; {refused}' if refused else ''),
                  'another solver certifies it; auto never chooses those that cannot' if refused else 'nothing to do')
    growth = []
    for kernel in ('eq9', 'love'):
        for levels in range(4, 7 if atlas.quick else 9):
            scene = rough_scene(levels, 1)
            found = press(scene.but(kernel=kernel, approach=3 * scene.approach), {'solver': 'polonsky-keer', 'backend': 'fft', 'max_iter': 100000})[0]
            atlas.record('kernel_cost', kernel=kernel, side=1 << levels, iterations=found.iterations, products=found.products,
                         status=status_of(found))
            growth.append(f'{kernel} {1 << levels}^2: {found.products}')
    atlas.add('conditioning', 'kernel eq9, whose diagonal is 36 % too small, against love on finer and finer surfaces',
              'products of polonsky-keer: ' + ', '.join(growth), 'certified either way', 'kernel love is the default')


FAMILIES = {'greedy': greedy, 'polonsky-keer': polonsky_keer, 'nnls': nnls, 'gp': gradient, 'admm': admm, 'cmr': cmr, 'conditioning': conditioning}


def run(request):
    store, atlas = Store(request.json, 'failures', 1), Atlas(request.quick, request.surface)
    for name, family in FAMILIES.items():
        if not request.row or name in request.row:
            print(f'atlas: {name}', file=sys.stderr)
            family(atlas)
    store.document.update(atlas=atlas.rows, data=atlas.data)
    store.save()


question('failures', 'the failure atlas: where methods fail, how that shows, what helps', run, {
    'row': (listed(one_of(*FAMILIES)), [], 'families of rows; all'), 'surface': (str, '', 'a measured surface for the rows of cmr')},
    {}, 'fewer draws, smaller surfaces')
