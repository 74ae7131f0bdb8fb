"""Side by side: roughcontact, the textbook method and the peers on the same surfaces, every answer judged by roughcontact's
certificate."""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile

import numpy as np
import roughcontact as rc

import peers_codes
from case import plain
from contact import find_load, unit_square
from options import listed, question
from peers_codes import CODES, LARGEST_MATRIX, LEVELS, cases, write_surface
from peers_report import best, print_case, total
from samples import chosen, columns
from json_tables import load
from store import Store, processor

HERE = os.path.dirname(os.path.abspath(__file__))
SHOWN = ('tol', 'setup_seconds', 'solve_seconds', 'other_cores', 'products', 'start_bytes', 'peak_bytes', 'residual')  # of a run
REPEATED = 10  # seconds: longer solves are not repeated
ALLOWED = 0.01  # of the largest Hertz pressure
THREAD_VARIABLES = ('OMP_NUM_THREADS', 'OPENBLAS_NUM_THREADS', 'MKL_NUM_THREADS', 'NUMEXPR_NUM_THREADS')
SCENES = ('hertz', 'self-affine', 'rmd-0.7', 'afm_film')  # of the comparison of speed with accuracy
SCENE_CODES = ('aspher-fft', 'aspher-h2', 'tamaas-free', 'contactmechanics')


class Judge:
    """The one judge of every code, for the cases of one grid and boundary: a fresh product with H over all points."""

    def __init__(self, n, boundary, threads):
        self.contact = rc.Contact(unit_square(n, boundary), options={'threads': threads})

    def judge(self, control, target, gap, pressure):
        """Residuals of pressures [force/length^2] for a load or an approach. The load of a code that keeps the mean pressure is mean
        pressure x 1, because the cells fill the unit square with modulus 1."""
        pressure = np.array(pressure, dtype=np.float64).reshape(gap.shape)
        if not np.isfinite(pressure).all():
            return {'residual': math.inf, 'reason': 'pressures are not finite'}
        result = self.contact.certify(pressure, undeformed_gap=gap, check=False, **{control: target})
        values = {key: getattr(result, 'kkt_' + key) for key in ('primal', 'dual', 'complementarity', 'control')}
        worst = math.inf if any(math.isnan(value) for value in values.values()) else result.residual
        return {'residual': worst, **values, 'area': result.contacts / gap.size, 'load': result.load, 'approach': result.approach}


class Bench:
    def __init__(self, request):
        self.request, self.threads, self.usable, self.files = request, request.threads, {}, {}
        self.store = Store(request.json, 'peers', self.threads)
        document = self.store.document
        for key, empty in (('codes', {}), ('calibration', {}), ('cases', {}), ('groups', [])):
            document.setdefault(key, empty)
        document['provenance'].update(python=sys.version.split()[0], numpy=np.__version__)

    # Runs

    def find_codes(self):
        codes = self.store.document['codes']
        for name in self.request.only or CODES:
            code = CODES[name]
            version, reason = self.calibrate(name)
            codes[name] = {'title': code.title, 'version': version or (None if code.package else self.store.document['provenance']['version'])}
            if reason:
                codes[name]['not_run'] = reason
                print(f'{code.title}: {reason}')
            else:
                self.usable[name] = code
        codes['mirco'] = {'title': 'MIRCO', 'version': None, 'not_run': 'not installed: not on the package index'}
        self.store.save()

    def calibrate(self, name):
        """Each code first solves a Hertz contact of radius 1, E* = 1, for every boundary that it has. A code whose largest pressure is off is not
        compared: its units or operator are not what the comparison takes them for. Returns its version, and why it must not run or None."""
        code, version = CODES[name], None
        for boundary in code.boundaries:
            n, radius = (32, 0.3) if code.small else (256, 0.1)  # 0.1 keeps periodic images away; dense codes have few cells
            load, exact, control = 4 * radius**3 / 3, 2 * radius / math.pi, code.controls[0]
            file = self.surface('sphere', n)['file']
            target, tol = load if control == 'load' else radius**2, 1e-4 if 'float' in name else 1e-6
            answer = self.ask(name, file, n, boundary, control, target, tol if code.tols[0] else 0.0, 60)[-1]
            place = f'{name}, {boundary}'
            if answer.get('error'):
                missing = f'not installed: {installer_said(code.package) or answer["error"]}' if answer.get('missing') else None
                self.store.document['calibration'][place] = {'error': answer['error']}
                return version, missing or f'Hertz, {boundary}: {answer["error"]}'
            pressure, version = np.load(answer['file']), answer.get('version')
            residual = Judge(n, boundary, self.threads).judge(control, target, np.load(file), pressure)['residual']
            off = float(pressure.max()) / exact - 1
            self.store.document['calibration'][place] = plain({
                'version': version, 'n': n, 'largest_pressure': pressure.max(), 'exact': exact, 'deviation': off,
                'load_deviation': pressure.mean() / load - 1, 'residual': residual, 'passed': abs(off) <= ALLOWED})
            if abs(off) > ALLOWED:
                return version, f'Hertz, {boundary}: largest pressure {100 * off:+.2f} % off'
        return version, None

    def ask(self, name, gap, n, boundary, control, target, tol, limit):
        """Answers of one process."""
        return peers_codes.solve(CODES[name], {'gap': gap, 'n': n, 'boundary': boundary, 'control': control, 'target': target, 'tol': tol,
                                               'threads': self.threads, 'out': os.path.join(self.request.work, 'pressure.npy')}, limit)

    # Problems

    def surface(self, kind, n):
        if (kind, n) not in self.files:
            self.files[kind, n] = write_surface(kind, n, self.request.work)
        return self.files[kind, n]

    def problem(self, case):
        """Target of a case for the wanted area: loose solves in load control, kept in the results for the same surface."""
        surface, document = self.surface(case.surface, case.n), self.store.document
        known = document['cases'].get(case.key, {})
        if known.get('digest') == surface['digest']:
            return {**known, 'file': surface['file']}
        gap, share = np.load(surface['file']), case.percent / 100
        near = chosen(document['cases'].values(), surface=case.surface, boundary=case.boundary, percent=case.percent)
        found = find_load(unit_square(case.n, case.boundary), gap, share, near[-1]['load'] if near else 0.2 * share, 8, {'threads': self.threads})
        entry = {'title': case.title, 'surface': case.surface, 'maker': surface['maker'], 'digest': surface['digest'], 'n': case.n,
                 'boundary': case.boundary, 'control': case.control, 'percent': case.percent, 'load': found.load,
                 'area': found.contacts / gap.size, 'target': found.load if case.control == 'load' else found.approach}
        document['cases'][case.key] = entry
        document['groups'] = [group for group in document['groups'] if group['case'] != case.key or group['digest'] == surface['digest']]
        return {**entry, 'file': surface['file']}

    # Runs

    def solve(self, name, case, problem, tol, judge, gap):
        """One process; its answers judged."""
        answers = self.ask(name, problem['file'], case.n, case.boundary, case.control, problem['target'], tol, self.request.limit)
        for answer in answers:
            if not answer.get('error'):
                answer.update(judge.judge(case.control, problem['target'], gap, np.load(answer['file'])))
                os.remove(answer.pop('file'))
        return answers

    def measured(self, name, key):
        """Whether a group need not be measured again."""
        group = self.store.find('groups', {'case': key, 'code': name})
        return (not self.request.again and group and group['threads'] == self.threads and group.get('cpu') == processor() and
                group['digest'] == self.store.document['cases'][key]['digest'] and
                (CODES[name].family != 'ours' or group['library'] == self.store.library) and
                not ('limit' in group['stopped'] and group['limit'] < self.request.limit))

    def too_slow_before(self, name, case):
        """A problem of the same family, with no more points and contact, on which even the loosest tolerance was over the limit."""
        for group in self.store.document['groups']:
            known = self.store.document['cases'][group['case']]
            if (group['code'] == name and group.get('cpu') == processor() and group['case'] != case.key and known['n'] <= case.n and
                    group['limit'] >= self.request.limit and
                    not group['runs'] and 'limit' in group['stopped'] and
                    (known['surface'], known['boundary'], known['control']) == (case.surface, case.boundary, case.control) and
                    known['percent'] <= case.percent):
                return f'not run: {group["stopped"]} at {known["n"]}², {known["percent"]:g} %'
        return ''

    def run_case(self, case):
        """First a sweep of tolerances, then repeats of the runs that matter; the codes take turns in both."""
        names, problem = [name for name in case.codes() if name in self.usable], self.problem(case)
        groups = {name: {'threads': self.threads, 'cpu': processor(), 'limit': self.request.limit, 'digest': problem['digest'],
                         'library': self.store.library if CODES[name].family == 'ours' else '',
                         'runs': [], 'stopped': self.too_slow_before(name, case)}
                  for name in names if not self.measured(name, case.key)}
        gap, judge = np.load(problem['file']), Judge(case.n, case.boundary, self.threads)
        self.sweep(case, problem, {name: group for name, group in groups.items() if not group['stopped']}, judge, gap)
        self.repeat(case, problem, groups, judge, gap)
        for name, group in groups.items():
            fastest = {id(run): run for run in (best(group, level) for level in LEVELS) if run}.values()
            group['runs'] = columns([{key: run[key] for key in SHOWN if key in run} for run in fastest])
            self.store.put('groups', {'case': case.key, 'code': name}, group)
        print_case(self.store.document, case.key)

    def sweep(self, case, problem, groups, judge, gap):
        waiting, backwards = {name: list(CODES[name].tols) for name in groups}, False
        while any(waiting.values()):
            for name in sorted(groups, reverse=backwards):
                group = groups[name]
                if not waiting[name]:
                    continue
                answers = self.solve(name, case, problem, waiting[name].pop(0), judge, gap)
                group['runs'] += [answer for answer in answers if not answer.get('error')]
                errors = [answer['error'] for answer in answers if answer.get('error')]
                if errors:
                    group['stopped'], waiting[name] = errors[0], []
                if CODES[name].family != 'ours' and best(group, LEVELS[-1]):
                    waiting[name] = []
            backwards = not backwards

    def repeat(self, case, problem, groups, judge, gap):
        for turn in range(1, self.request.repeats):
            for name in sorted(groups, reverse=turn % 2 == 1):
                chosen = [best(groups[name], level) for level in LEVELS]
                tols = sorted({run['tol'] for run in chosen if run and total(run) < REPEATED})
                for tol in tols[:1] if CODES[name].family == 'baseline' else tols:
                    answers = self.solve(name, case, problem, tol, judge, gap)
                    groups[name]['runs'] += [answer for answer in answers if not answer.get('error')]

    def run(self):
        self.find_codes()
        for case in cases(self.request.sizes, self.request.percents, self.request.quick, self.request.edges):
            if any(name in self.usable for name in case.codes()):
                self.run_case(case)
        self.store.save()


def solve_scenes(request):
    """Solves the scenes that `pareto --export FOLDER` wrote with other codes, each at its own tolerances, from loose to tight, and under the load
    of the certified solution, and adds a list "peers" to its results. What is there already is not solved again."""
    store = Store(request.json, 'pareto', request.threads)
    scenes = [scene for scene in load(request.scenes, 'scenes')['scenes'] if scene['scene'] in SCENES and scene['n'] >= 64]  # ASPHER's least grid
    for code in SCENE_CODES:
        for scene in scenes:
            name, out = f'{CODES[code].title}, {scene["scene"]}', os.path.join(request.work, 'pressure.npy')
            key, truth = {'scene': scene['scene'], 'contact': scene['contact'], 'n': scene['n'], 'code': code}, np.load(scene['pressure'])
            if store.find('peers', {name: key[name] for name in ('scene', 'n', 'code')}):
                print(f'{name}: measured before')
                continue
            for tol in CODES[code].tols:
                answer = peers_codes.solve(CODES[code], {
                    'gap': scene['gap'], 'out': out, 'n': scene['n'], 'target': scene['load'], 'tol': tol, 'threads': request.threads,
                    'boundary': 'free', 'control': 'load'}, request.limit)[0]
                if answer.get('missing'):
                    print(f'{CODES[code].title} is not installed: left out')
                    break
                if 'error' in answer:
                    store.put('peers', {**key, 'tol': tol}, {'error': answer['error']})
                    break
                pressure = np.load(out)
                row = store.put('peers', {**key, 'tol': tol}, {
                    'seconds': total(answer),
                    'pressure_error': np.linalg.norm(pressure - truth) / np.linalg.norm(truth)})
                print(f'{name}, tol {tol:g}: pressure error {row["pressure_error"]:.1e}', flush=True)


def environment():
    """The folder of the virtual environment that the peers are installed into."""
    cache = os.environ.get('XDG_CACHE_HOME')
    return os.path.join(cache, 'roughcontact-peers') if cache else os.path.join(os.environ['RC_BENCH_BUILD'], 'peers')


def installer_said(package):
    """Why a package could not be installed."""
    return load(environment(), 'not-installed').get(package)


def install():
    """A package that cannot be installed leaves its reason; the others run without it."""
    folder, refused = environment(), {}
    with open(os.path.join(HERE, 'peers_requirements.txt')) as file:
        wanted = file.read().split()
    python = os.path.join(folder, 'bin', 'python3')
    if load(folder, 'installed').get('packages') != wanted:
        subprocess.run([sys.executable, '-m', 'venv', folder], check=True)
        for requirement in wanted:
            print('installing', requirement)
            found = subprocess.run([python, '-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', requirement], text=True,
                                   stderr=subprocess.PIPE)
            if found.returncode:
                refused[requirement.split('==')[0]] = next((line for line in found.stderr.splitlines()[::-1] if 'error' in line.lower()), '')
        subprocess.run([python, '-c', 'import numpy'], check=True)
        for name, content in (('not-installed.json', refused), ('installed.json', {'packages': wanted})):
            with open(os.path.join(folder, name), 'w') as out:
                json.dump(content, out)
    return python


def run(request):
    variables = {name: str(request.threads) for name in THREAD_VARIABLES}
    if not request.here or any(os.environ.get(name) != value for name, value in variables.items()):
        program = os.path.join(os.environ['RC_BENCH_BUILD'], 'bin', 'roughcontact-bench')  # again, with the peers' Python and these threads
        python = sys.executable if request.here else install()
        sys.stdout.flush()
        os.execve(program, [program, *sys.argv[1:], *([] if request.here else ['--here'])], {**os.environ, **variables, 'PYTHON': python})
    request.limit = request.limit or (10 if request.quick or request.scenes else 20)
    request.repeats = request.repeats or 2
    with tempfile.TemporaryDirectory() as folder:
        request.work = request.work or folder
        if request.scenes:
            solve_scenes(request)
        else:
            Bench(request).run()


def code_names(text):
    names = [name for word in text.split(',') for name in CODES if name == word or name.startswith(word + '-')]
    if not names:
        raise argparse.ArgumentTypeError(f'no code {text}')
    return names


question('peers', 'side by side with the textbook method and other codes', run, {
    'only': (code_names, [], 'codes; a first word takes its variants: ' + ', '.join(CODES)),
    'sizes': (listed(int), [], f'points a side; up to {LARGEST_MATRIX} points in all: the dense codes'),
    'percents': (listed(float), [], 'contact areas'), 'edges': (str, '', 'free or periodic; both unless given'), 'threads': (int, 2, 'threads'),
    'repeats': (int, 0, f'of solves below {REPEATED} s; 0: 2'), 'limit': (float, 0, 'seconds for one run; 0: 20, quick 10'),
    'again': (bool, False, 'measure the chosen codes and problems anew, keep the others'),
    'work': (str, '', 'folder for surfaces and pressures; a temporary one'),
    'here': (bool, False, 'with the packages of this Python: installs nothing'),
    'scenes': (str, '', 'the scenes in this folder, into the results of pareto')}, {}, '256 and 512 points a side, fewer areas, 10 s a run')
