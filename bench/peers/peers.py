#!/usr/bin/env python3
"""Side by side: roughcontact, the field's standard method and the peers on the same surfaces, every answer judged by roughcontact's
certificate. bench/peers/peers.sh runs this in an environment that has the peers."""
import argparse
import hashlib
import math
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

import process
import surfaces
from calibration import calibrate
from certificate import LEVELS, Judge
from library import Contact, Library
from plan import CODES, LARGEST_MATRIX, Case, cases
from report import print_case
from store import Store, best, total

REPEATED = 10  # seconds: longer solves are not repeated
SPENT = 'budget spent'


class Bench:
    def __init__(self, arguments):
        self.arguments = arguments
        self.build = os.path.abspath(arguments.build)
        self.threads = arguments.threads
        self.library = Library(self.build)
        self.store = Store(arguments.json, arguments.fresh)
        self.begun = time.monotonic()
        self.usable = {}
        self.files = {}
        with open(self.library.file, 'rb') as file:
            self.fingerprint = hashlib.blake2b(file.read(), digest_size=8)
        plugins = os.path.join(os.path.dirname(self.library.file), 'roughcontact')
        for folder, _, names in sorted(os.walk(plugins)):
            for name in sorted(names):
                with open(os.path.join(folder, name), 'rb') as file:
                    self.fingerprint.update(file.read())
        self.fingerprint = self.fingerprint.hexdigest()

    # What runs

    def find_codes(self):
        codes = self.store.document['codes']
        for name in self.arguments.only or CODES:
            code = CODES[name]
            version, reason = self.calibrate(name)
            codes[name] = {'title': code.title, 'version': version or self.library.version()}
            if reason and 'ModuleNotFoundError' in reason:
                reason = 'not installed: ' + (self.installer_said(code) or reason)
                codes[name]['version'] = None
            if reason:
                codes[name]['not_run'] = reason
                print(f'{code.title}: {reason}')
            else:
                self.usable[name] = code
        codes['mirco'] = {'title': 'MIRCO', 'version': None, 'not_run': 'not installed: not on the package index'}
        self.store.save()

    def installer_said(self, code):
        """The line that peers.sh wrote for a package it could not install."""
        if not self.arguments.not_installed or not os.path.exists(self.arguments.not_installed):
            return None
        with open(self.arguments.not_installed) as text:
            return next((line.split('\t', 1)[1].strip() for line in text if line.split('\t')[0] == code.package), None)

    def calibrate(self, name):
        """Hertz for every boundary the code has. Returns its version, and why it must not run or None."""
        version = None
        for boundary in CODES[name].boundaries:
            row = calibrate(self, name, boundary)
            self.store.document['calibration'][f'{name}, {boundary}'] = row
            if row.get('error'):
                return version, f'Hertz, {boundary}: {row["error"]}'
            version = row['version']
            if not row['passed']:
                return version, f'Hertz, {boundary}: largest pressure {100 * row["deviation"]:+.2f} % off'
        return version, None

    # Problems

    def surface(self, kind, n):
        if (kind, n) not in self.files:
            self.files[kind, n] = surfaces.write(kind, n, self.arguments.work)
        return self.files[kind, n]

    def problem(self, case):
        """Target of a case for the wanted area: loose solves in load control, kept in the results for the same surface."""
        surface = self.surface(case.surface, case.n)
        known = self.store.document['cases'].get(case.key, {})
        if known.get('digest') == surface['digest']:
            return {**known, 'file': surface['file']}
        gap = np.load(surface['file'])
        pressure = np.zeros_like(gap)
        share, load, slope, last = case.percent / 100, 0.2 * case.percent / 100, 1.0, None
        near = [entry['load'] for entry in self.store.document['cases'].values()
                if (entry['surface'], entry['boundary'], entry['percent']) == (case.surface, case.boundary, case.percent)]
        load = near[-1] if near else load
        with Contact(self.library, case.n, case.boundary, threads=self.threads, tol=1e-3) as contact:
            for _ in range(8):
                result = contact.solve('load', load, gap, pressure)
                area = max(result.contacts, 1) / gap.size
                if abs(area / share - 1) < 0.05:
                    break
                if last and area != last[1]:
                    slope = min(max(math.log(load / last[0]) / math.log(area / last[1]), 0.5), 3)
                last = load, area
                load *= (share / area)**slope
            result = contact.solve('load', load, gap, pressure)
        entry = {'title': case.title, 'surface': case.surface, 'maker': surface['maker'], 'digest': surface['digest'], 'n': case.n,
                 'boundary': case.boundary, 'control': case.control, 'percent': case.percent, 'load': load,
                 'area': result.contacts / gap.size, 'target': load if case.control == 'load' else result.displacement}
        self.store.document['cases'][case.key] = entry
        self.store.document['groups'] = [group for group in self.store.document['groups']
                                         if group['case'] != case.key or group['digest'] == surface['digest']]
        return {**entry, 'file': surface['file']}

    def request(self, case, problem, tol):
        return {'build': self.build, 'gap': problem['file'], 'n': case.n, 'boundary': case.boundary, 'control': case.control,
                'target': problem['target'], 'tol': tol, 'threads': self.threads,
                'out': os.path.join(self.arguments.work, 'pressure.npy')}

    # Runs

    def solve(self, name, case, problem, tol, judge, gap):
        """One process; its answers judged."""
        self.wait_until_idle()
        answers = process.solve(CODES[name], self.request(case, problem, tol), self.arguments.limit)
        for answer in answers:
            if not answer.get('error'):
                answer.update(judge.judge(case.control, problem['target'], gap, np.load(answer['file'])))
                os.remove(answer.pop('file'))
        return answers

    def wait_until_idle(self):
        """Until the other work on the machine takes less than a tenth of a core, for as long as asked."""
        until = time.monotonic() + self.arguments.wait_idle
        while time.monotonic() < until:
            before = process.busy_seconds()
            time.sleep(1)
            if before is None or process.busy_seconds() - before < 0.1:
                return

    def measured(self, name, key):
        """A group that need not be measured again."""
        group = self.store.group(key, name)
        return (not self.arguments.again and group and group['threads'] == self.threads and group['digest'] == self.store.document['cases'][key]['digest'] and
                (CODES[name].family != 'ours' or group['library'] == self.fingerprint) and
                group['stopped'] != SPENT and not ('limit' in group['stopped'] and group['limit'] < self.arguments.limit))

    def too_slow_before(self, name, case):
        """A problem of the same family, with no more points and contact, on which even the loosest tolerance was over the limit."""
        for group in self.store.document['groups']:
            known = self.store.document['cases'][group['case']]
            if (group['code'] == name and group['case'] != case.key and known['n'] <= case.n and group['limit'] >= self.arguments.limit and
                    not any('residual' in run for run in group['runs']) and 'limit' in group['stopped'] and
                    (known['surface'], known['boundary'], known['control']) == (case.surface, case.boundary, case.control) and
                    known['percent'] <= case.percent):
                return f'not run: {group["stopped"]} at {known["n"]}², {known["percent"]:g} %'
        return None

    def run_case(self, case):
        """First a sweep of tolerances, then repeats of the runs that matter; the codes take turns in both."""
        names = [name for name in case.codes() if name in self.usable]
        problem = self.problem(case)
        groups = {name: {'case': case.key, 'code': name, 'threads': self.threads, 'limit': self.arguments.limit,
                         'digest': problem['digest'], 'library': self.fingerprint if CODES[name].family == 'ours' else '',
                         'date': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime()), 'runs': [],
                         'stopped': self.too_slow_before(name, case) or ''}
                  for name in names if not self.measured(name, case.key)}
        gap = np.load(problem['file'])
        judge = Judge(self.library, case.n, case.boundary, self.threads)
        try:
            self.sweep(case, problem, {name: group for name, group in groups.items() if not group['stopped']}, judge, gap)
            self.repeat(case, problem, groups, judge, gap)
        finally:
            judge.close()
        for group in groups.values():
            self.store.put(group)
        print_case(self.store, case.key)

    def sweep(self, case, problem, groups, judge, gap):
        waiting = {name: list(CODES[name].tols) for name in groups}
        backwards = False
        while any(waiting.values()):
            for name in sorted(groups, reverse=backwards):
                if waiting[name] and self.out_of_budget():
                    groups[name]['stopped'], waiting[name] = SPENT, []
                if not waiting[name]:
                    continue
                answers = self.solve(name, case, problem, waiting[name].pop(0), judge, gap)
                group = groups[name]
                group['runs'] += [answer for answer in answers if not answer.get('error')]
                errors = [answer['error'] for answer in answers if answer.get('error')]
                if errors:
                    group['stopped'], waiting[name] = errors[0], []
                if CODES[name].family != 'ours' and best(group, LEVELS[-1]):
                    waiting[name] = []
            backwards = not backwards

    def repeat(self, case, problem, groups, judge, gap):
        for turn in range(1, self.arguments.repeats):
            for name in sorted(groups, reverse=turn % 2 == 1):
                chosen = [best(groups[name], level) for level in LEVELS]
                tols = {run['tol'] for run in chosen if run and total(run) < REPEATED}
                if CODES[name].family == 'baseline':
                    tols = set(list(tols)[:1])
                for tol in () if self.out_of_budget() else sorted(tols):
                    answers = self.solve(name, case, problem, tol, judge, gap)
                    groups[name]['runs'] += [{**answer, 'repeat': turn} for answer in answers if not answer.get('error')]

    def out_of_budget(self):
        return time.monotonic() - self.begun > 60 * self.arguments.budget

    def provenance(self):
        try:
            commit = subprocess.run(['git', '-C', process.HERE, 'describe', '--always', '--dirty', '--abbrev=12'], text=True,
                                    capture_output=True, check=True).stdout.strip()
        except (OSError, subprocess.CalledProcessError):
            commit = 'unknown'
        with open('/proc/cpuinfo') as info:
            cpu = next((line.split(':', 1)[1].strip() for line in info if line.startswith('model name')), 'unknown')
        return {'date': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime()), 'version': self.library.version(), 'commit': commit,
                'library': self.fingerprint, 'cpu': cpu, 'cpu_threads': os.cpu_count(), 'threads': self.threads,
                'python': sys.version.split()[0], 'numpy': np.__version__, 'load_average_at_start': os.getloadavg()[0],
                'quick': self.arguments.quick, 'limit_seconds': self.arguments.limit, 'repeats': self.arguments.repeats}

    def run(self):
        self.store.document['provenance'] = self.provenance()
        self.find_codes()
        wanted = cases(self.arguments.sizes, self.arguments.percents, self.arguments.quick)
        left = []
        for case in wanted:
            if not [name for name in case.codes() if name in self.usable]:
                continue
            if self.out_of_budget():
                left.append(case.title)
            else:
                self.run_case(case)
        self.store.document['left_out'] = left
        self.store.save()
        for title in left:
            print('not run, budget spent:', title)


def numbers(kind):
    return lambda text: [kind(word) for word in text.split(',')]


def code_names(text):
    names = [name for word in text.split(',') for name in CODES if name == word or name.startswith(word + '-')]
    if not names:
        raise argparse.ArgumentTypeError(f'no code {text}; there are {", ".join(CODES)}')
    return names


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('build', help='a finished build of roughcontact')
    parser.add_argument('--quick', action='store_true', help='256 and 512 points a side, fewer areas, 10 s a run')
    parser.add_argument('--only', type=code_names, help='codes, comma-separated; a first word takes its variants: ' + ', '.join(CODES))
    parser.add_argument('--sizes', type=numbers(int), help=f'points a side; up to {LARGEST_MATRIX} points in all: the dense codes')
    parser.add_argument('--percents', type=numbers(float), help='contact areas')
    parser.add_argument('--threads', type=int, default=2)
    parser.add_argument('--repeats', type=int, help=f'of solves below {REPEATED} s (3; quick: 2)')
    parser.add_argument('--limit', type=float, help='seconds for one run (60; quick: 10)')
    parser.add_argument('--budget', type=float, help='minutes after which no run is begun (38; quick: 2.5)')
    parser.add_argument('--wait-idle', type=float, default=0, help='seconds to wait for an idle machine before every run')
    parser.add_argument('--fresh', action='store_true', help='measure everything anew')
    parser.add_argument('--again', action='store_true', help='measure the chosen codes and problems anew, keep the others')
    parser.add_argument('--json', default=os.path.join(process.HERE, '..', 'results', 'peers.json'), help='results, kept and added to')
    parser.add_argument('--work', help='folder for surfaces and pressures; a temporary one')
    parser.add_argument('--not-installed', help='package, tab, reason a line')
    arguments = parser.parse_args()
    arguments.limit = arguments.limit or (10 if arguments.quick else 60)
    arguments.budget = arguments.budget or (2.5 if arguments.quick else 38)
    arguments.repeats = arguments.repeats or (2 if arguments.quick else 3)
    with tempfile.TemporaryDirectory() as folder:
        arguments.work = arguments.work or folder
        Bench(arguments).run()


if __name__ == '__main__':
    main()
