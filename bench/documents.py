"""The documents that are made from measurements: what each measures, and the tables and pictures that it takes from the results."""
import os
import shutil
import subprocess

import failures_tables
import outdated
import paper_pictures
import paper_tables
import peers_report
import performance
import physics
import published
import ranks_tables
import speed_accuracy_tables
from options import folder, question
from json_tables import load
from store import library_hash
from tables import fill

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MEASURED = os.path.join(ROOT, '..', 'shared', 'data')


class Remake:
    """One document. Interrupted and called again it goes on where it stopped: what the same library has measured is not measured again."""

    def __init__(self, name, request):
        build = os.environ['RC_BENCH_BUILD']
        self.request, self.program = request, os.path.join(build, 'bin', 'roughcontact-bench')
        self.results, self.images, self.page = (os.path.join(ROOT, *place) for place in (('bench', 'results'), ('docs', 'images'), ('docs', 'development', f'{name}.md')))
        if request.quick:  # instead of the source tree
            self.results = self.images = os.path.join(build, f'{name}-quick')
            os.makedirs(self.results, exist_ok=True)
            self.page = shutil.copy(self.page, self.results)
        self.exported = os.path.join(self.results if request.quick else build, 'scenes')
        self.quick = ['--quick'] if request.quick else []
        self.threads, self.surfaces = self.given('threads', request.threads), self.given('surfaces', request.surfaces)

    @staticmethod
    def given(name, value):
        return [f'--{name}', str(value)] if value else []

    def run(self, command, *options, into=None):
        """A sub-command whose results go into RESULTS/into.json."""
        print(f'== {command} {" ".join(options)}', flush=True)
        subprocess.run([self.program, command, *options, '--json', os.path.join(self.results, f'{into or command}.json')], check=True)

    def once(self, command, *options):
        """Results that are written whole, unless this library has them."""
        if load(self.results, command).get('provenance', {}).get('library') == library_hash():
            print(f'== {command}: measured before')
        else:
            self.run(command, *options)

    def finish(self, sections, pictures):
        if pictures:
            pictures(self.results, self.images)
        fill(self.page, sections(self.results))
        print(f'written: {self.page}')


def one_question(command, quick=True):
    return lambda remake: remake.run(command, *(remake.quick if quick else []), *remake.threads)


def measure_performance(remake):
    if remake.quick:
        remake.run('scaling', '--sizes', '128,256', '--percents', '0.1,10', '--budget', '0')
        for command, *options in (('products', '--sizes', '128'), ('batch', '--surfaces', '5', '--points', '32', '--steps', '3'), ('mapped',)):
            remake.once(command, '--quick', *options)
        return
    single = '--controls', 'load', '--budget', '0'
    remake.run('scaling', '--sizes', '128,256,512,1024,2048,4096', '--percents', '10,0.1,1,40')
    for command, *options in (('products', '--sizes', '512,1024,2048,4096'), ('mapped',), ('batch',)):
        remake.once(command, *options)
    remake.run('scaling', '--sizes', '1024,2048,4096,8192,16384', '--percents', '0.04,10', '--precision', 'single', '--tol', '1e-4', *single)
    remake.run('scaling', '--sizes', '8192,16384', '--percents', '0.1,10', *single)


def measure_peers(remake):
    remake.run('peers', *remake.quick, *remake.threads)
    if not remake.request.quick:
        remake.run('peers', '--only', 'ours,baseline', '--sizes', '512,1024,2048', '--percents', '10', '--limit', '100')


def measure_paper(remake):
    remake.run('paper', *remake.quick, *remake.given('figure', remake.request.figures), *remake.threads, *remake.surfaces)


def measure_speed_accuracy(remake):
    remake.run('pareto', *remake.threads, *remake.surfaces, *remake.quick, '--export', remake.exported)
    small = ['--scenes', 'hertz,self-affine', '--points', '128', '--seeds', '2', '--contacts', '10']
    remake.run('goal', *remake.threads, *remake.surfaces, *(small if remake.quick else []))
    if not remake.quick:
        remake.run('peers', '--scenes', remake.exported, *remake.threads, into='pareto')


# The measurements, tables and pictures of each page.
DOCUMENTS = {'speed-accuracy': (measure_speed_accuracy, speed_accuracy_tables.sections, speed_accuracy_tables.pictures),
             'paper': (measure_paper, paper_tables.sections, paper_pictures.pictures),
             'physics': (one_question('physics'), physics.sections, physics.pictures),
             'published': (one_question('published'), published.sections, published.pictures),
             'benchmarks': (one_question('products', quick=False), performance.product_sections, None),
             'failures': (lambda remake: remake.run('failures', *remake.given('surface', remake.request.surface)), failures_tables.sections, failures_tables.pictures),
             'performance': (measure_performance, performance.sections, performance.pictures),
             'scale-out': (lambda remake: remake.run('ranks', *remake.quick), ranks_tables.sections, ranks_tables.pictures),
             'peers': (measure_peers, peers_report.sections, peers_report.pictures)}


def run(request):
    if request.check:
        outdated.check()
    for name in request.names or DOCUMENTS:
        measure, *make = DOCUMENTS[name]
        remake = Remake(name, request)
        if not request.written:
            measure(remake)
        remake.finish(*make)


question('documents', 'measures what documents say and show, and writes their tables and pictures', run, {
    'check': (bool, False, 'measure nothing: list the pages whose numbers are older than the library; exit status 1 if there are any'),
    'written': (bool, False, 'measure nothing: tables and pictures from the results that are there'),
    'surfaces': (folder, MEASURED if os.path.isdir(MEASURED) else '', 'folder with measured surfaces'),
    'surface': (str, '', 'a measured surface for the failure atlas'), 'figures': (str, '', 'of the paper, 4,6 and the like; all'),
    'threads': (int, 0, 'threads; 0: what each sub-command takes by itself')},
    quick_text='small cases, into folders of the build instead of the source tree', names=tuple(DOCUMENTS))
