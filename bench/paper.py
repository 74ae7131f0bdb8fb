"""The figures of Bemporad & Paggi (2015), measured anew: the rows behind docs/development/paper.md."""
import os
import random
from functools import partial
from itertools import product

import numpy as np
import roughcontact as rc

from case import Progress, cpu_seconds, in_child, repeats
from contact import FILTERS, OK, cascade_note, cascade_options, cascade_verdict, certified, press, status_of
from failures import greedy_on_draws
from histories import History
from options import folder, listed, one_of, question, threads
from samples import columns
from store import Store
from surfaces import Scene, SurfaceClass, example_one, hertz_scene, influence, measured_scene, rough_scene

# Below the folder of measured surfaces.
MEASURED = ('measured/afm_selfaffine_10um.gsf', 'measured/afm_film_10um.gsf', 'measured-lgpl/fv_rubber_2mm.gsf', 'measured-lgpl/fv_skibase_4mm.gsf')
SIDE, RMS_HEIGHT = 100e-6, 1e-6  # of generated surfaces [m]
COARSEST_SIDE = 64  # of the cascade, the paper's


def greedy(scene, **more):
    return press(scene, {'solver': 'greedy', 'backend': 'dense', **more})[0]


def first_wrong_draw(kernel, n):
    """Figure 2: the first draw of n points that greedy gets wrong."""
    side, seed, found = round(n**0.5), -1, None
    while found is None or status_of(found) == OK:
        seed += 1
        scene = example_one(side, 1, seed, kernel)
        found = greedy(scene, tol=1e-10)
    truth = certified(press(scene, {'solver': 'nnls', 'backend': 'dense', 'tol': 1e-10})[0])
    u = (scene.approach - scene.gap).ravel()
    return {'seed': seed, 'status': status_of(found), 'u': u, 'w': influence(kernel, side) @ found.pressure.ravel() - u,
            'greedy': found.pressure.ravel(), 'exact': truth.pressure.ravel()}


def smooth(draws, shape, kernel):
    """Shapes on which greedy elimination is said never to fail."""
    if shape == 'spheres between the points':
        failures, draw, n, radius = 0, random.Random(1).random, 24, 100
        for _ in range(draws):  # paraboloids whose tip lies anywhere between the points, contact radii of 3 to 9 cells
            x, y = np.arange(n)[None, :] - (n / 2 - draw()), np.arange(n)[:, None] - (n / 2 - draw())
            contact = 3 + 6 * draw()
            scene = Scene(shape, (x * x + y * y) / (2 * radius), contact**2 / radius, kernel=kernel)
            failures += status_of(greedy(scene, tol=1e-10, **{'greedy.inner': 'cholesky'})) != OK
        return {'draws': draws, 'failures': failures}
    scene = hertz_scene(96) if shape == 'sphere' else Scene(shape, np.zeros((20, 20)), 1.0)
    found = greedy(scene.but(kernel=kernel))
    row = {'draws': 1, 'failures': int(status_of(found) != OK)}
    if shape == 'sphere':  # Hertz: load 4/3 E* sqrt(R d^3), for a radius of curvature of n cells
        row['load_error'] = found.load / (4 / 3 * (96 * scene.approach**3)**0.5) - 1
    return row


def example_1(request):
    draws = [('eq9', 5, 1, 10000, 1000, 3e-4), ('eq9', 10, 1, 5000, 500, 1e-3), ('eq9', 20, 1, 1000, 60, 1e-2), ('eq9', 30, 1, 400, 0, 0.1),
             ('eq9', 5, 2, 1000, 0, 3e-4), ('eq9', 10, 2, 1000, 200, 1e-3), ('eq9', 20, 2, 1000, 0, 1e-2), ('love', 10, 1, 1000, 200, 1e-3),
             ('punch', 10, 1, 1000, 200, 1e-3), ('disc', 10, 1, 1000, 0, 1e-3), ('galerkin', 10, 1, 1000, 0, 1e-3)]
    for kernel, side, spacing, full, quick, cost in draws:
        count = quick if request.quick else full
        if count:
            yield 'example_1', {'kernel': kernel, 'n': side * side, 'spacing': spacing, 'draws': count}, cost * count, greedy_on_draws
    yield 'figure_2', {'kernel': 'eq9', 'n': 100}, 0.1, first_wrong_draw
    count = 60 if request.quick else 2000
    for kernel, (shape, cost) in product(('eq9', 'love'), (('sphere', 0.5), ('flat punch', 0.1), ('spheres between the points', 5e-3 * count))):
        yield 'smooth', {'shape': shape, 'kernel': kernel}, cost, partial(smooth, count)


SINGLE = {'solver': 'nnls', 'nnls.pivoting': 'single'}
STEPS = {'warmup': 'gp', 'warmup.iterations': 100, 'gp.lipschitz': 'frobenius', 'gp.restart': 0}
METHODS = {  # options, whether warm, whether on stored matrices alone: one solve for every point of the contact set
    'P&K 1999': ({'solver': 'polonsky-keer'}, False, False), 'P&K 1999, warm': ({'solver': 'polonsky-keer'}, True, False),
    'greedy CG': ({'solver': 'greedy'}, False, False), 'ADMM, warm': ({'solver': 'admm', 'admm.relaxation': 1.5}, True, False),
    'NNLS': (SINGLE, False, True), 'NNLS, warm': (SINGLE, True, True), 'NNLS + 100 GP': ({**SINGLE, **STEPS}, False, False),
    'NNLS by blocks, warm': ({'solver': 'nnls'}, True, False), 'haar-cg, warm': ({'solver': 'haar-cg'}, True, False)}


def shown_steps(found, shown, *keys):
    """Values of all steps by their keys, of a history that a picture shows."""
    return {'steps': {'cpu_seconds': [cpu for _, cpu in found], **{key: [getattr(result, key) for result, _ in found] for key in keys}}} if shown else {}


def worst_status(steps):
    return next((status_of(result) for result, _ in reversed(steps) if status_of(result) != OK), OK)


def loading(levels, backend, kernel, most, threads, setting, method, seed):
    """Figure 4: steps with up to `most` candidates of one loading history."""
    options, warm, _ = METHODS[method]
    history = History(levels, 0.7, seed, 10)
    history.approaches = fitting = [approach for approach in history.approaches if np.count_nonzero(history.gap < approach) <= most]
    found = history.run({'backend': backend, 'kernel': kernel, 'tol': 1e-8, 'max_iter': 100000, 'bounds': 0, 'threads': threads, 'time_limit': 60,
                         **options}, warm)
    return {'points_a_side': history.n, 'rms_height': history.gap.std(), 'steps_of_ten': len(fitting), 'cpu_seconds': sum(cpu for _, cpu in found),
            'products': sum(result.products for result, _ in found), 'status': worst_status(found),
            'largest': max((result.candidates for result, _ in found), default=0), **shown_steps(found, seed == 1, 'mean_pressure')}


def figure_4(request):
    """The algorithms of sections 3 and 4 on one loading history, with dense products as in the paper and with FFT products."""
    settings = [('small', 7, 'dense', 'eq9', 10, 1e12, 2), ('small, love', 7, 'dense', 'love', 10, 1e12, 2), ('dense', 9, 'dense', 'eq9', 3, 6000, 20),
                ('fft', 9, 'fft', 'eq9', 5, 1e12, 10)]
    if request.quick:
        settings = [('small', 6, 'dense', 'eq9', 2, 1e12, 0.1), ('small, love', 6, 'dense', 'love', 2, 1e12, 0.1),
                    ('dense', 7, 'dense', 'eq9', 1, 600, 0.3), ('fft', 7, 'fft', 'eq9', 1, 1e12, 1)]
    for setting, levels, backend, kernel, seeds, most, cost in settings:
        for seed, (method, (_, _, dense_only)) in product(range(1, seeds + 1), METHODS.items()):
            if backend == 'dense' or not dense_only:
                yield ('figure_4', {'setting': setting, 'method': method, 'seed': seed}, cost,
                       partial(loading, levels, backend, kernel, most, request.threads))


ALGORITHM_2_TOL = 1e-8
# Algorithm 2 as printed, and with its errata put right one after the other: how far each gets. The library's polonsky-keer has them all.
# Whether every point is clipped at zero and may come back, not those of the active set alone; whether directions and norms are restricted to
# the contact set; whether norms are squared in the ratio that makes directions conjugate.
VARIANTS = {'as printed': (False, False, False), 'every point clipped and admitted': (True, False, False),
            'and norms on the contact set': (True, True, False), 'and squared norms: Polonsky & Keer (1999)': (True, True, True)}


def problem_of(scene):
    """(matrix, penetrations) of the candidates of a scene with square cells."""
    gap = scene.gap.ravel()
    points = np.flatnonzero(gap < scene.approach)
    matrix = influence(scene.kernel, len(scene.gap))[np.ix_(points, points)]
    return matrix, (scene.approach - gap[points]) / scene.approach


def residual_of(p, w, height):
    """Largest violation of p >= 0, w >= 0, p w = 0, relative to the largest pressure and penetration."""
    worst = np.max(np.where(p > 0, np.abs(w), -w)) / height
    return max(0.0, worst, -p.min() / np.abs(p).max())


def algorithm_2(scene, most, kernel, variant):
    every_point, on_contact, squared = VARIANTS[variant]
    matrix, u = problem_of(scene.but(kernel=kernel))
    p, t, w, active = np.zeros_like(u), np.zeros_like(u), -u, np.full(u.size, True)
    height, direction, least, iterations, stopped = u.max(), 0, 1.0, 0, {}

    def norm_of():
        counted = np.where(active, w, 0) if on_contact else w
        return counted @ counted if squared else np.linalg.norm(counted)

    if on_contact:
        active = w < 0
    norm, last_norm, all_points = norm_of(), 1.0, np.linalg.norm(w)
    with np.errstate(all='ignore'):
        while least > ALGORITHM_2_TOL and iterations < most:
            t = w + direction * norm / last_norm * t
            if on_contact:
                t = np.where(active, t, 0)
            step = (w @ t) / (t @ (matrix @ t))
            if not np.isfinite(step):
                break
            p -= step * t
            seen = np.full(u.size, True) if every_point else active
            p = np.where(seen, np.maximum(p, 0), p)
            back = seen & (p == 0) & (w < 0)
            p[back] -= step * w[back]
            active = back | (p > 0)
            direction, last_norm = int(not back.any()), norm
            w = matrix @ p - u
            norm, iterations = norm_of(), iterations + 1
            residual, now = residual_of(p, w, height), np.linalg.norm(w)
            if not np.isfinite(residual):
                break
            least = min(least, residual)
            # The printed test: the norm over all points changes little.
            if not stopped and abs(now - all_points) <= ALGORITHM_2_TOL * all_points:
                stopped = {'stopped': iterations, 'residual_at_stop': residual}
            all_points = now
        lowest = p.min() / np.abs(p).max()
    return {'iterations': iterations, 'residual': least, 'lowest_pressure': lowest, **stopped}


def algorithm_2_plan(request):
    levels, most, cost = (5, 500, 0.1) if request.quick else (7, 5000, 10)
    for kernel, variant in product(('eq9', 'love'), VARIANTS):
        yield 'algorithm_2', {'kernel': kernel, 'variant': variant}, cost, partial(algorithm_2, rough_scene(levels, 1), most)


def inner_solver(levels, n, inner, seed):
    """Figure 5: greedy elimination by conjugate gradients, a Cholesky factor, and Gauss & Seidel's method, which stores the matrix before its
    first iteration."""
    scene = rough_scene(levels, seed)
    approach = np.partition(scene.gap, n, axis=None)[n]  # n points are nearer
    options = {'solver': 'greedy', 'greedy.inner': inner, 'backend': 'dense', 'kernel': 'eq9', 'tol': 1e-8, 'max_iter': 100000, 'bounds': 0}

    def one():
        first, before = [], cpu_seconds()
        with rc.Contact(scene.system, options=options, progress=lambda _: first.append(cpu_seconds()) if not first else None) as contact:
            result = contact.solve(approach=approach, undeformed_gap=scene.gap, check=False, want_pressure=False)
        return cpu_seconds() - before, (first or [before])[0] - before, result

    found = repeats(one, 0.3)
    cpu, storing, results = zip(*found)
    row = {'cpu_seconds': sorted(cpu)[len(cpu) // 2], 'iterations': results[-1].iterations}
    return {**row, 'storing_seconds': sorted(storing)[len(cpu) // 2]} if inner == 'gauss-seidel' else row


def figure_5(request):
    levels, seeds, sizes = (7, 2, (100, 300)) if request.quick else (9, 6, (250, 500, 1000, 2000, 4000))
    for seed, n, inner in product(range(1, seeds + 1), sizes, ('cg', 'cholesky', 'gauss-seidel')):
        if n <= 2000 or inner != 'gauss-seidel':  # the matrix is stored by n products
            yield ('figure_5', {'n': n, 'inner': inner, 'seed': seed}, 0.4 + (1 if inner == 'gauss-seidel' else 0.1) * (n / 1000)**3,
                   partial(inner_solver, levels))


def projected(levels, pivoting, projections, seed):
    """Figure 6: how many gradient projections pay before NNLS."""
    history = History(levels, 0.7, seed, 10)
    common = {'nnls.pivoting': pivoting, 'backend': 'dense', 'kernel': 'eq9', 'tol': 1e-8, 'bounds': 0, 'gp.lipschitz': 'frobenius', 'gp.restart': 0}
    warmup = {'warmup': 'gp', 'warmup.iterations': projections} if projections else {}
    steps = history.run({**common, 'solver': 'nnls', 'max_iter': 1000000, **warmup}, False)
    # The projections count as iterations, too, and end early where they have solved the problem.
    alone = history.run({**common, 'solver': 'gp', 'max_iter': projections}, False) if projections else []
    solves, spent = (sum(result.iterations for result, _ in found) for found in (steps, alone))
    return {'cpu_seconds': sum(cpu for _, cpu in steps), 'solves': solves - spent,
            **shown_steps(steps, seed == 1 and pivoting == 'single', 'candidates', 'contacts')}


def figure_6(request):
    levels, seeds, cost = (6, 2, 0.02) if request.quick else (7, 8, 1)
    for seed, pivoting, projections in product(range(1, seeds + 1), ('single', 'block'), (0, 10, 50, 100, 200)):
        yield ('figure_6', {'pivoting': pivoting, 'projections': projections, 'seed': seed},
               cost * (0.5 if pivoting == 'block' else 8 if projections == 10 else 2), partial(projected, levels))


INNER = {'fft': 'polonsky-keer', 'dense': 'nnls'}  # the solver of the cascade and of the whole problem, by the products


def timed(scene, options, count):
    return press(scene, {'bounds': 0, 'threads': count, **options})


def whole_of(scene, backend, count):
    """(result, record)"""
    whole, cpu = timed(scene, {'solver': INNER[backend], 'backend': backend}, count)
    return certified(whole), {'whole_cpu_seconds': cpu}


def compared(scene, whole, count, *given, **more):
    """Algorithm 6 against the whole problem."""
    (plain, plain_cpu), (sound, sound_cpu) = (timed(scene, cascade_options(*given, **more, certified=each), count) for each in (0, 1))
    return {'load_error': plain.load / whole.load - 1, 'kept': cascade_note(sound.note).share_at_first, 'cpu_seconds': plain_cpu,
            'certified_error': sound.load / whole.load - 1, 'certified_cpu_seconds': sound_cpu}


def by_exponent(levels, count, hurst, kernel, backend, seed):
    scene = rough_scene(levels, seed, hurst).but(kernel=kernel)
    whole, row = whole_of(scene, backend, count)
    products = {'backend': backend, 'inner': INNER[backend]}
    diagonal = compared(scene, whole, count, area='diagonal', **products)
    return {**row, **compared(scene, whole, count, **products), 'diagonal': {key: diagonal[key] for key in ('load_error', 'kept', 'cpu_seconds')}}


def by_radius(levels, radii, count, backend, seed):
    scene = rough_scene(levels, seed).but(kernel='eq9')
    whole, row = whole_of(scene, backend, count)
    entries = [{'h': h, **compared(scene, whole, count, 'subsample', h, backend=backend, inner=INNER[backend])} for h in radii]
    return {**row, 'radii': columns(entries)}


def figure_8(request):
    """Cascade multi-resolution on midpoint displacement surfaces, by Hurst exponent."""
    runs = [('eq9', 'fft', 30, 0.5), ('love', 'fft', 30, 0.5), ('eq9', 'dense', 8, 8)]
    levels, exponents = 8, (0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
    if request.quick:
        runs = [('eq9', 'fft', 8, 0.03), ('love', 'fft', 8, 0.03), ('eq9', 'dense', 2, 0.1)]
        levels, exponents = 6, (0.3, 0.6, 0.9)
    for kernel, backend, seeds, cost in runs:
        for seed, hurst in product(range(1, seeds + 1), exponents):
            yield ('figure_8', {'hurst': hurst, 'kernel': kernel, 'backend': backend, 'seed': seed}, cost,
                   partial(by_exponent, levels, request.threads))


def figure_9(request):
    """The same by radius h."""
    levels, radii = (6, (1.25, 2, 3)) if request.quick else (8, (1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3))
    for backend, seeds, cost in (('fft', 6, 0.2), ('dense', 2, 0.2)) if request.quick else (('fft', 30, 2), ('dense', 6, 30)):
        for seed in range(1, seeds + 1):
            yield 'figure_9', {'backend': backend, 'seed': seed}, cost, partial(by_radius, levels, radii, request.threads)


def spectrum_of(heights, pitch, periodic):
    """Spectrum, what it is like, and the heights along the middle row less their mean."""
    surface = rc.Surface(np.ascontiguousarray(heights), pitch, periodic)
    spectrum, law, moments = rc.surface.psd(surface), rc.surface.power_law(surface), rc.surface.analyze(surface)
    profile = heights[len(heights) // 2]
    numbers = {key: getattr(law, key) for key in ('hurst', 'hurst_error', 'slope', 'prefactor', 'q_min', 'q_max', 'q_rolloff', 'q_cutoff')}
    numbers.update((name, [float(f'{value:.3e}') for value in values]) for name, values in
                   (('q', spectrum.q), ('psd', spectrum.psd), ('profile', profile - profile.mean())))
    return {'nx': heights.shape[1], 'ny': heights.shape[0], 'hx': pitch[0], 'rms_height': moments.rms_height, **numbers, 'textures': len(law.peak_q)}


def classified(make, periodic, count, surface, origin):
    """A surface with or without a power-law spectrum, and what the cascade makes of it, at approaches of the highest point's height over a
    part: the paper's, and that of its section 4."""
    scene = make()
    row, halvings = spectrum_of(-scene.gap, scene.pitch, periodic), 0
    while min(scene.gap.shape) >> (halvings + 1) >= COARSEST_SIDE:
        halvings += 1
    cases = []
    for part in (5.0, 2.0):
        pressed = scene.but(approach=scene.gap.mean() / part)
        verdict, (whole, same) = cascade_verdict(pressed, halvings), whole_of(pressed, 'fft', count)
        same.update(candidates=whole.candidates, contacts=whole.contacts, halvings=halvings, **verdict)
        for kind in FILTERS:
            cases.append({'part': part, 'filter': kind, **compared(pressed, whole, count, kind, 1.5, halvings + 1), **same})
    return {**row, 'cases': cases}


def generated(surface, n):
    heights = RMS_HEIGHT * surface.heights(n, 1)
    return Scene(surface.name, heights.max() - heights, pitch=(SIDE / n, SIDE / n))


def figure_10(request):
    """Figures 10 and 11: surfaces with and without a power-law spectrum, measured and generated."""
    n = 128 if request.quick else 512
    for surface in (SurfaceClass('generated, power law', 0.6), SurfaceClass('generated, roll-off', 0.6, roll_off=n / 10)):
        yield ('figure_10', {'surface': surface.name, 'origin': 'generated'}, 1 if request.quick else 10,
               partial(classified, partial(generated, surface, n), True, request.threads))
    files = [os.path.join(request.surfaces, file) for file in MEASURED if request.surfaces]
    files = [file for file in files if os.path.exists(file)]
    for file in files:
        yield ('figure_10', {'surface': os.path.splitext(os.path.basename(file))[0], 'origin': 'measured'}, 8 if request.quick else 20,
               partial(classified, partial(measured_scene, file), False, request.threads))
    if not files:
        print(f'no measured surfaces in "{request.surfaces}" (--surfaces): figures 10 and 11 show generated ones alone')


# The longest last.
PARTS = ((2, example_1), (4, algorithm_2_plan), (10, figure_10), (5, figure_5), (9, figure_9), (8, figure_8), (6, figure_6), (4, figure_4))
FIGURES = sorted({figure for figure, _ in PARTS})


def run(request):
    """Measures what this library has not measured before, each row in a process of its own, and writes it at once. Prints counts."""
    store = Store(request.json, 'paper', request.threads)
    store.document['quick'] = request.quick
    plan = [entry for figure, part in PARTS if not request.figure or str(figure) in request.figure for entry in part(request)]
    left = [entry for entry in plan if not store.known(*entry[:2])]
    progress, failed = Progress(sum(cost for _, _, cost, _ in left)), 0
    for name, key, cost, work in left:
        row = store.put(name, key, in_child(lambda: work(**key)))
        failed += 'error' in row
        progress.done(f'{name}, {", ".join(f"{what} {value}" for what, value in key.items())}: {row.get("error", "measured")}', cost)
    print(f'{len(left)} measured, {failed} of them failed; {len(plan) - len(left)} measured before')


question('paper', 'the figures of Bemporad & Paggi (2015)', run, {
    'figure': (listed(one_of(*map(str, FIGURES))), [], '2 (with Example 1), 4, 5, 6, 8, 9, 10 (with 11); all'),
    'surfaces': (folder, '', 'folder with measured surfaces for figure 10'), 'threads': (threads, 1, 'threads of FFT products')},
    {}, 'small grids, few seeds')
