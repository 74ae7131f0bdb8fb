"""Speed against accuracy: every method that makes sense, at a sequence of tolerances, and kernels and grids, against the truth."""
import os
import sys

import numpy as np
import roughcontact as rc

from case import Progress, in_child, peak_memory, resident_memory
from contact import names, runs, time_solve
from json_tables import lines
from options import ALL_THREADS, folder, listed, one_of, percent, question, ranged
from samples import columns, solved, total_seconds
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
        self.exports, self.measured, self.failed, self.before = [], 0, 0, 0

    def known(self, name, key):
        found = self.store.measured(name, key) is not None
        self.before += found
        return found

    def target_of(self, scene, contact):
        if scene.known:
            return scene.known(contact).target
        key = {'scene': scene.name, 'contact': contact, 'n': scene.n}
        known = self.store.find('approaches', key)
        return (known or self.store.put('approaches', key, {'approach': search_approach(scene, contact, self.request.threads)}))['approach']

    def solve(self, scene, target, gap, options, truth, prefix):
        """One solve and its errors, whose keys begin with the prefix, in a process of its own."""
        def work():
            pressure = np.full(gap.shape, 0.0)
            before = resident_memory()
            result, record = time_solve(scene.system(len(gap)), gap, options, self.request.budget, scene.control, target, pressure)
            errors = {prefix + key: rounded(value) for key, value in truth.errors(result).items()}
            return {'status': record['status'], 'seconds': rounded(total_seconds(record)), 'memory_bytes': max(peak_memory() - before, 0), **errors}
        return in_child(work)

    def sweep(self, name, key, scene, target, gap, digits, least_tol, settings, *truth):
        """One method from loose tolerances to tight ones, unless it is measured."""
        key = {**key, 'threads': self.request.threads}
        if self.known(name, key):
            return
        points, spent = [], 0
        for tol in (float(f'1e-{digit}') for digit in digits):
            if tol < least_tol or spent > self.request.method_limit:
                break
            options = {**settings, 'tol': tol, 'threads': self.request.threads, 'time_limit': self.request.solve_limit}
            point = {'tol': tol, **self.solve(scene, target, gap, options, *truth)}
            self.measured += 1
            if 'error' in point:
                self.failed += 1
                print(f'{key}: {point["error"]}', file=sys.stderr)
                break
            points.append(point)
            spent += point['seconds']
            if point['status'] == 'RC_STOP_TIME':
                break
        memory = max((point.pop('memory_bytes') for point in points), default=0)
        shown = [{key: value for key, value in point.items() if key != 'status'} for point in solved(points)]
        self.store.put(name, key, {'points': columns(shown), **({'memory_bytes': memory} if name == 'methods' else {})})

    def compare_methods(self, same, scene, target, exact, result):
        gap = scene.gap(scene.n)
        for (solver, backend, variant), options, least_tol in methods_for(scene.system(scene.n), scene.control == 'load', result.candidates):
            key = {**same, 'solver': solver, 'backend': backend, 'variant': variant}
            self.sweep('methods', key, scene, target, gap, self.request.digits, least_tol, options, exact, '')

    def compare_grids(self, same, scene, target, truth):
        """Every kernel on coarser and finer grids; tolerances with the kernel that the library takes by itself."""
        usual = 'spectral' if scene.boundary == 'periodic' else 'love'
        for points in (scene.n // 2, scene.n, 2 * scene.n):
            gap = scene.gap(points)
            for kernel in names(rc.kernels):
                if (kernel == 'spectral') != (usual == 'spectral') or kernel == 'layer':  # which needs a thickness
                    continue
                digits = GRID_DIGITS if kernel == usual else GRID_DIGITS[-1:]
                self.sweep('grids', {**same, 'grid': points, 'kernel': kernel}, scene, target, gap, digits, 0, {'kernel': kernel}, truth.on(points),
                           'true_')

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
        key = {**same, 'threads': self.request.threads}
        known = self.known('cases', key)
        if known and not exported:
            return
        target = self.target_of(scene, contact)
        exact, result = solve_certified(scene, target, scene.n, 1e-13, self.request.threads)
        if exported:
            self.export(same, scene, exact)
        if known:
            return
        truth, source = best_truth(scene, contact, target, self.request.threads)
        self.compare_methods(same, scene, target, exact, result)
        self.compare_grids(same, scene, target, truth)
        self.store.put('cases', key, {'points': result.points, 'candidates': result.candidates, 'contacts': result.contacts, 'truth': source,
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
                out.write(lines({'scenes': self.exports}))
        print(f'{self.measured} measured, {self.failed} of them failed; {self.before} measured before')


question('pareto', 'speed against accuracy of every method, kernel and grid', lambda request: SpeedAccuracy(request).run(), {
    'scenes': (listed(one_of(*NAMES)), NAMES, 'what is pressed'),
    'contacts': (listed(percent), [10, 1, 40, 90], 'contact areas in percent of the grid, in the order of measuring'),
    'points': (int, 256, 'points per side of surfaces that are not measured, a power of two'),
    'digits': (listed(ranged(int, 1, 15)), [2, 3, 4, 5, 6, 8, 10, 12], 'tolerances 10^-digits'),
    'surfaces': (folder, '', 'folder with measured surfaces'), **ALL_THREADS,
    'budget': (float, 0.1, 'seconds for repeats of each solve'), 'solve_limit': (float, 2, 'seconds for one solve; 0: none'),
    'method_limit': (float, 4, 'seconds after which a method goes on to no tighter tolerance'),
    'export': (str, '', 'write gaps and certified pressures into this folder, for other codes')},
    {'scenes': ['hertz', 'self-affine'], 'contacts': [10], 'digits': [2, 4, 8], 'points': 64, 'budget': 0, 'method_limit': 1},
    'a sphere and a rough surface on 64^2, three tolerances')
