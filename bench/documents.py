"""The documents that are made from measurements: what each measures, and the tables and pictures that it takes from the results."""
import os
import shutil
import subprocess
import time

import failures_tables
import paper_pictures
import paper_tables
import peers_report
import physics_tables
import scaling_tables
import speed_accuracy_pictures
import speed_accuracy_tables
from options import Question, folder
from store import library_hash, load_known
from tables import fill

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MEASURED = os.path.join(ROOT, '..', 'shared', 'data')


class Remake:
    """One document. Interrupted and called again it goes on where it stopped: what the same library has measured is not measured again."""

    def __init__(self, name, request):
        build = os.environ['RC_BENCH_BUILD']
        self.name, self.request, self.quick, self.begun = name, request, request.quick, time.monotonic()
        self.program = os.path.join(build, 'bin', 'roughcontact-bench')
        self.results, self.images, self.page = (os.path.join(ROOT, *place) for place in (('bench', 'results'), ('docs', 'images'), ('docs', f'{name}.md')))
        if self.quick:  # instead of the source tree
            self.results = self.images = os.path.join(build, f'{name}-quick')
            os.makedirs(self.results, exist_ok=True)
            self.page = shutil.copy(self.page, self.results)
        self.threads = ['--threads', str(request.threads)] if request.threads else []
        self.surfaces = ['--surfaces', request.surfaces] if request.surfaces else []

    def left(self):
        """Seconds of the budget."""
        return 60 * self.request.budget - (time.monotonic() - self.begun)

    def run(self, command, *options, into=None):
        """A sub-command whose results go into RESULTS/into.json."""
        if self.left() <= 0:
            print(f'the budget is spent: {command} is left out')
            return
        file = os.path.join(self.results, f'{into or command}.json')
        print(f'== {command} {" ".join(options)}', flush=True)
        subprocess.run([self.program, command, *options, '--json', file], check=True)

    def once(self, command, *options):
        """Results that are written whole, unless this library has them."""
        known = load_known(self.results, command)
        if known and known['provenance'].get('library') == library_hash():
            print(f'== {command}: measured before')
        else:
            self.run(command, *options)

    def rows(self, *options):
        """Rows of the scaling table, each kept as soon as it is there."""
        self.run('scaling', '--time-limit', f'{max(self.left(), 1):.0f}', *options)

    def finish(self, sections, pictures=None):
        if pictures and shutil.which('gnuplot'):
            pictures(self.results, self.images)
        elif pictures:
            print('no gnuplot: the pictures stay as they are')
        fill(self.page, sections(self.results))
        print(f'written: {self.page}')


def benchmarks(remake):
    remake.run('products', *remake.threads)


def failures(remake):
    remake.run('failures', *(['--surface', remake.request.surface] if remake.request.surface else []))
    remake.run('histories', '--seeds', '1,2', *remake.threads)


def paper(remake):
    figures = ['--figure', remake.request.figures] if remake.request.figures else []
    remake.run('paper', *(['--quick'] if remake.quick else []), *figures, *remake.threads, *remake.surfaces)


def performance(remake):
    """The most important first."""
    if remake.quick:
        remake.rows('--sizes', '128,256', '--percents', '0.1,10', '--budget', '0')
        for command, *options in (('products', '--sizes', '128'), ('limits', '--sizes', '128'), ('busy', '--points', '128'),
                                  ('deterministic', '--points', '128'), ('batch', '--surfaces', '5', '--points', '32', '--steps', '3')):
            remake.once(command, '--quick', *options)
        remake.once('dilute', '--sizes', '256', '--contacts', '1', '--threads', '1', '--budget', '0')
    else:
        single = '--controls', 'load', '--budget', '0'
        remake.rows('--sizes', '128,256,512,1024,2048,4096', '--percents', '10,0.1,1,40')
        for command, *options in (('busy',), ('deterministic',), ('products', '--sizes', '512,1024,2048,4096'), ('limits',), ('dilute',)):
            remake.once(command, *options)
        remake.rows('--sizes', '1024,2048,4096,8192,16384', '--percents', '0.04,10', '--precision', 'single', '--tol', '1e-4', *single)
        remake.once('batch')
        remake.once('profile')
        remake.rows('--sizes', '8192,16384', '--percents', '0.1,10', *single)
        try:
            remake.run('peers', '--only', 'ours,baseline', '--sizes', '512,1024,2048,4096', '--percents', '10', '--budget',
                       f'{max(remake.left() / 60, 0):.0f}')
        except subprocess.CalledProcessError:
            print('the standard method is not compared')


def peers(remake):
    remake.run('peers', *(['--quick'] if remake.quick else []), *remake.threads)


def physics(remake):
    remake.run('physics', *(['--quick'] if remake.quick else []), *remake.threads)


def speed_accuracy(remake):
    exported = os.path.join(remake.results if remake.quick else os.environ['RC_BENCH_BUILD'], 'scenes')
    same, goals = [*remake.threads, *remake.surfaces], []
    if remake.quick:
        same, goals = [*same, '--quick'], ['--scenes', 'hertz,self-affine', '--points', '128', '--seeds', '2', '--contacts', '10']
    limit = ['--time-limit', f'{remake.left():.0f}'] if remake.request.budget < 1e5 else []
    remake.run('pareto', *same, *limit, '--export', exported)
    remake.run('goal', *[option for option in same if option != '--quick'], *goals)
    if not remake.quick:
        remake.run('peers', '--scenes', exported, *remake.threads, into='pareto')


# What is measured, the tables and the pictures.
DOCUMENTS = {'speed-accuracy': (speed_accuracy, speed_accuracy_tables.sections, speed_accuracy_pictures.pictures),
             'paper': (paper, paper_tables.sections, paper_pictures.pictures),
             'physics': (physics, physics_tables.sections, physics_tables.pictures),
             'benchmarks': (benchmarks, scaling_tables.product_sections, None),
             'failures': (failures, failures_tables.sections, failures_tables.pictures),
             'performance': (performance, scaling_tables.sections, scaling_tables.pictures),
             'peers': (peers, peers_report.sections, peers_report.pictures)}


def run(request):
    for name in request.names or DOCUMENTS:
        measure, sections, pictures = DOCUMENTS[name]
        remake = Remake(name, request)
        if not request.written:
            measure(remake)
        remake.finish(sections, pictures)
    

QUESTION = Question('documents', 'measures what documents say and show, and writes their tables and pictures', run, {
    'written': (bool, False, 'measure nothing: tables and pictures from the results that are there'),
    'surfaces': (folder, MEASURED if os.path.isdir(MEASURED) else '', 'folder with measured surfaces'),
    'surface': (str, '', 'a measured surface for the failure atlas'), 'figures': (str, '', 'of the paper, 4,6 and the like; all'),
    'threads': (int, 0, 'threads; 0: what each sub-command takes by itself'),
    'budget': (float, 1e6, 'minutes after which nothing begins')},
    {}, 'small cases, into folders of the build instead of the source tree', names=tuple(DOCUMENTS))
