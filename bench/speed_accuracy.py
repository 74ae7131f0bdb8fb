"""Speed against accuracy: every method that makes sense, at a sequence of tolerances, and kernels and grids, against the truth."""
import json
import os
import sys
import time

import numpy as np
import roughcontact as rc

from case import Progress, in_child, peak_memory, resident_memory
from contact import names, runs, status_of, time_solve
from options import ALL_THREADS, folder, listed, one_of, percent, question, ranged
from samples import total_seconds
from surfaces import NAMES, best_truth, make_scene, search_approach, solve_certified
from store import Store

MOST_FACTORED = 4000  # candidates up to which factoring backends run
GRID_DIGITS = [1, 2, 3, 4, 6, 8]  # tolerances 10^-digits of the coarser and finer grids
LEAST_SINGLE_TOL = 1e-5  # of fft.precision=single


def rounded(value):
    """Four digits: no measurement is better, and the file stays short."""
    return float(f'{value:.3e}')


def methods_for(system, load, candidates):
    """(key, options, least tolerance) of every method that makes sense. A product of backend split is worth its price where contact is
    sparse, and then with the solvers that need few; a stored matrix, with those that solve systems on it or multiply by it and no more."""
    found = [(('auto', 'auto', ''), {}, 0)]
    known = {option.key for option in rc.options()}
    for backend in names(rc.backends):
        for solver in names(rc.solvers):
            conjugate = solver in ('haar-cg', 'polonsky-keer')
            stored = backend not in ('fft', 'split')
            sense = (backend == 'fft' or (conjugate or solver == 'nnls' if backend == 'split' else solver not in ('cmr', 'gp')))
            if not sense or (stored and candidates > MOST_FACTORED) or not runs(solver, backend, system, load):
                continue
            variants = [('', {}, 0)]
            if backend == 'fft' and solver + '.products' in known:
                variants.append(('double', {solver + '.products': 'double'}, 0))
            if backend == 'fft' and conjugate and 'fft.precision' in known:
                variants.append(('single', {'fft.precision': 'single'}, LEAST_SINGLE_TOL))
            found += [((solver, backend, name), {'solver': solver, 'backend': backend, **more}, least) for name, more, least in variants]
    return found


class SpeedAccuracy:
    def __init__(self, request):
        self.request, self.store = request, Store(request.json, 'pareto', request.threads)
        self.begun, self.exports = time.monotonic(), []
        self.measured = self.failed = self.before = self.left = 0

    def known(self, name, key):
        found = self.store.measured(name, key) is not None
        self.before += found
        return found

    def time_is_up(self):
        up = 0 < self.request.time_limit <= time.monotonic() - self.begun
        self.left += up
        return up

    def target_of(self, scene, contact):
        if scene.known:
            return scene.known(contact).target
        key = {'scene': scene.name, 'contact': contact, 'n': scene.n}
        known = self.store.find('approaches', key)
        return (known or self.store.put('approaches', key, {'approach': search_approach(scene, contact, self.request.threads)}))['approach']

    def solve(self, scene, target, gap, options, truths):
        """One solve and its errors, in a process of its own. truths: by the first part of the keys of errors."""
        def work():
            pressure = np.full(gap.shape, 0.0)
            before = resident_memory()
            result, record = time_solve(scene.system(len(gap)), gap, options, self.request.budget, scene.control, target, pressure)
            errors = {prefix + key: rounded(value) for prefix, truth in truths.items() for key, value in truth.errors(result).items()}
            return {'status': record['status'], **{key: rounded(record[key]) for key in ('setup_seconds', 'solve_seconds', 'cpu_seconds')},
                    'memory_bytes': max(peak_memory() - before, 0), 'products': result.products, 'residual': rounded(result.residual),
                    'chosen': f'{result.solver}, {result.backend}', **errors}
        return in_child(work)

    def sweep(self, name, key, scene, target, gap, digits, least_tol, settings, truths):
        """One method from loose tolerances to tight ones, unless it is measured. False where the time is up."""
        key = {**key, 'threads': self.request.threads, 'digits': digits}
        if self.known(name, key):
            return True
        if self.time_is_up():
            return False
        points, spent = [], 0
        for tol in (float(f'1e-{digit}') for digit in digits):
            if tol < least_tol or spent > self.request.method_limit:
                break
            options = {**settings, 'tol': tol, 'threads': self.request.threads, 'time_limit': self.request.solve_limit}
            point = {'tol': tol, **self.solve(scene, target, gap, options, truths)}
            points.append(point)
            self.measured += 1
            if 'error' in point:
                self.failed += 1
                break
            spent += total_seconds(point)
            if point['status'] == 'RC_STOP_TIME':
                break
        self.store.put(name, key, {'points': points})
        return True

    def compare_methods(self, same, scene, target, exact, result, truth):
        gap, truths = scene.gap(scene.n), {'': exact, 'true_': truth.on(scene.n)}
        for (solver, backend, variant), options, least_tol in methods_for(scene.system(scene.n), scene.control == 'load', result.candidates):
            key = {**same, 'solver': solver, 'backend': backend, 'variant': variant}
            if not self.sweep('methods', key, scene, target, gap, self.request.digits, least_tol, options, truths):
                return

    def compare_grids(self, same, scene, target, truth):
        """Every kernel on coarser and finer grids; tolerances with the kernel that the library takes by itself."""
        usual = 'spectral' if scene.boundary == 'periodic' else 'love'
        for points in (scene.n // 2, scene.n, 2 * scene.n):
            gap, truths = scene.gap(points), {'true_': truth.on(points)}
            for kernel in names(rc.kernels):
                if (kernel == 'spectral') != (usual == 'spectral'):
                    continue
                digits = GRID_DIGITS if kernel == usual else GRID_DIGITS[-1:]
                if not self.sweep('grids', {**same, 'grid': points, 'kernel': kernel}, scene, target, gap, digits, 0, {'kernel': kernel}, truths):
                    return

    def export(self, same, scene, truth):
        """Gap and certified pressures, for other codes."""
        os.makedirs(self.request.export, exist_ok=True)
        files = {}
        for what, values in (('gap', scene.gap(scene.n)), ('pressure', truth.pressure)):
            files[what] = os.path.join(self.request.export, f'{scene.name}-{100 * same["contact"]:g}-{what}.npy')
            np.save(files[what], values)
        self.exports.append({**same, 'load': truth.load, 'area': truth.area, **files})

    def one_case(self, scene, contact, exported):
        same = {'scene': scene.name, 'contact': contact, 'n': scene.n}
        key = {**same, 'threads': self.request.threads, 'digits': self.request.digits, 'grid_digits': GRID_DIGITS}
        known = self.known('cases', key)
        if (known and not exported) or (not known and self.time_is_up()):
            return
        target = self.target_of(scene, contact)
        exact, result = solve_certified(scene, target, scene.n, 1e-13, self.request.threads)
        if exported:
            self.export(same, scene, exact)
        if known:
            return
        (truth, source), left = best_truth(scene, contact, target, self.request.threads), self.left
        self.compare_methods(same, scene, target, exact, result, truth)
        self.compare_grids(same, scene, target, truth)
        if self.left == left:  # else it is to be gone on with
            self.store.put('cases', key, {
                'boundary': scene.boundary, 'control': scene.control, 'target': target, 'points': result.points, 'candidates': result.candidates,
                'contacts': result.contacts, 'load': exact.load, 'truth': source, 'certified_status': status_of(result),
                'certified_residual': rounded(result.residual)})

    def run(self):
        scenes, cases = [], []
        for name in self.request.scenes:
            scene, missing = make_scene(name, self.request.points, self.request.surfaces)
            if scene:
                scenes.append(scene)
            else:
                print(f'scene {name} is left out: {missing}', file=sys.stderr)
        for place, contact in enumerate(value / 100 for value in self.request.contacts):
            for scene in scenes:
                if scene.full and place == 0:
                    cases.append((scene, 1.0, False))
                elif not scene.full and contact <= scene.most_contact:
                    cases.append((scene, contact, bool(self.request.export) and scene.boundary == 'free' and place == 0))
        progress = Progress(len(cases))
        for scene, contact, exported in cases:
            self.one_case(scene, contact, exported)
            progress.done(f'{scene.name}, {100 * contact:g} % in contact')
        if self.request.export:
            os.makedirs(self.request.export, exist_ok=True)
            with open(os.path.join(self.request.export, 'scenes.json'), 'w') as out:
                json.dump(self.exports, out, indent=1)
        print(f'{self.measured} measured, {self.failed} of them failed; {self.before} measured before' +
              (f'; {self.left} not begun, the time is up' if self.left else ''))


question('pareto', 'speed against accuracy of every method, kernel and grid', lambda request: SpeedAccuracy(request).run(), {
    'scenes': (listed(one_of(*NAMES)), NAMES, 'what is pressed'),
    'contacts': (listed(percent), [10, 1, 40, 90], 'contact areas in percent of the grid, in the order of measuring'),
    'points': (int, 256, 'points per side of surfaces that are not measured, a power of two'),
    'digits': (listed(ranged(int, 1, 15)), [2, 3, 4, 5, 6, 8, 10, 12], 'tolerances 10^-digits'),
    'surfaces': (folder, '', 'folder with measured surfaces'), **ALL_THREADS,
    'budget': (float, 0.1, 'seconds for repeats of each solve'), 'solve_limit': (float, 2, 'seconds for one solve; 0: none'),
    'method_limit': (float, 4, 'seconds after which a method goes on to no tighter tolerance'),
    'time_limit': (float, 0, 'seconds after which nothing begins; 0: none'),
    'export': (str, '', 'write gaps and certified pressures into this folder, for other codes')},
    {'scenes': ['hertz', 'self-affine'], 'contacts': [10], 'digits': [2, 4, 8], 'points': 64, 'budget': 0, 'method_limit': 1},
    'a sphere and a rough surface on 64^2, three tolerances')
