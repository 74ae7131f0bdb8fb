"""A campaign of examples/campaign against rc_batch_solve on as many threads: the same solves, by turns, each whole in a process of its own."""
import importlib.util
import os
import subprocess
import sys
import tempfile
import time

import numpy as np
import roughcontact as rc

from case import Failure, checked, in_child
from options import ALL_THREADS, question, ranged, side
from samples import median
from store import Store
from tables import show

CAMPAIGN = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'examples', 'campaign', 'campaign.py')
NEEDED = ('distributed', 'pyarrow')
MODULUS, LOWEST, HIGHEST, SLOPE = 1e9, 1e-3, 0.05, 0.2  # of the mean pressure over E* rms slope
STUDY = """
store = "results"
details = {details}
[[surfaces]]
generator = "spectral"
shape = [{points}, {points}]
pitch = 1.0
rms_slope = {slope}
seeds = {seeds}
[system]
modulus = {modulus}
[loads]
pressure = {pressures}
"""
COLUMNS = ('solves; grid={points}²; details; workers={threads}; batch [s]={batch:.2f}; surfaces [s]={surfaces:.2f}; '
           'campaign [s]={campaign:.2f}; start and end [s]={idle:.2f}; ratio={ratio:.3f}; over surfaces and batch={ratio_made:.3f}; '
           'without start and end={ratio_running:.3f}; same numbers={same}')


def batch_of(request, pressures):
    """Times of the surfaces and of the solves, and the loads' areas. One call a pressure: the gaps are in memory once."""
    begun = time.perf_counter()
    surfaces = [rc.surface.spectral((request.points,) * 2, pitch=1.0, rms_slope=SLOPE, seed=seed) for seed in range(1, request.seeds + 1)]
    made = time.perf_counter()
    found = [rc.batch(surfaces, modulus=MODULUS, pressure=[[pressure]] * request.seeds, threads=request.threads) for pressure in pressures]
    return {'surfaces': made - begun, 'batch': time.perf_counter() - made,
            'areas': [result.contact_area[:, 0].tolist() for result in found]}


def campaign_of(request, pressures, seeds, details):
    """Time of the whole command, and the areas that it stored."""
    import pyarrow.parquet  # where the environment of the benchmark has it

    with tempfile.TemporaryDirectory() as folder:
        study = os.path.join(folder, 'study.toml')
        with open(study, 'w', encoding='utf-8') as file:
            file.write(STUDY.format(points=request.points, slope=SLOPE, seeds=seeds, modulus=MODULUS, pressures=pressures, details=details))
        begun = time.perf_counter()
        done = subprocess.run([sys.executable, CAMPAIGN, study, '--workers', str(request.threads)], capture_output=True, text=True)
        seconds = time.perf_counter() - begun
        if done.returncode:
            raise Failure(f'the campaign ended with {done.returncode}: {done.stderr or done.stdout}')
        table = pyarrow.parquet.read_table(os.path.join(folder, 'results', 'study.parquet')).sort_by([('target', 'ascending'), ('seed', 'ascending')])
        return {'seconds': seconds, 'areas': table['contact_area'].to_numpy().reshape(len(pressures), -1).tolist()}


def run(request):
    absent = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if absent:
        raise Failure(f'{sys.executable} has no {" and no ".join(absent)}; PYTHON=FILE names another interpreter')
    store = Store(request.json, 'campaign', request.threads)
    pressures = [float(p) for p in MODULUS * SLOPE * np.geomspace(LOWEST, HIGHEST, request.loads)]
    found = {'false': [], 'true': []}
    for turn in range(request.rounds):
        idle = checked(in_child(lambda: campaign_of(request, pressures[:1], 1, 'false')))
        batch = checked(in_child(lambda: batch_of(request, pressures)))
        for details, rows in found.items():
            answer = checked(in_child(lambda: campaign_of(request, pressures, request.seeds, details)))
            rows.append({'batch': batch['batch'], 'surfaces': batch['surfaces'], 'campaign': answer['seconds'], 'idle': idle['seconds'],
                         'ratio': answer['seconds'] / batch['batch'], 'ratio_made': answer['seconds'] / (batch['batch'] + batch['surfaces']),
                         'ratio_running': (answer['seconds'] - idle['seconds']) / batch['batch'],
                         'same': answer['areas'] == batch['areas']})
            print(f'turn {turn + 1}: {rows[-1]}', file=sys.stderr)
    for details, rows in found.items():
        middle = {name: median([row[name] for row in rows]) for name in rows[0] if name != 'same'}
        key = {'solves': request.seeds * request.loads, 'points': request.points, 'details': details, 'threads': request.threads}
        store.put('campaigns', key, {**middle, 'same': 'yes' if all(row['same'] for row in rows) else 'no'})
    show(COLUMNS, store.rows('campaigns'))


question('campaign', 'examples/campaign on processes against rc_batch_solve on threads', run, {
    'seeds': (ranged(int, 1, 1000000), 1000, 'surfaces'), 'loads': (ranged(int, 1, 1000), 10, 'loads of each'), 'points': (side, 128, 'points per side'),
    'rounds': (ranged(int, 1, 100), 3, 'turns; medians count'), **ALL_THREADS},
    {'seeds': 4, 'loads': 2, 'points': 32, 'rounds': 1}, '8 solves of 32^2')
