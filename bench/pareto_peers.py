#!/usr/bin/env python3
"""pareto_peers.py JSON FOLDER: solves the scenes that `roughcontact-bench pareto --export FOLDER` wrote with the other codes that this
Python has, each at its own tolerances and under the load of the certified solution, and adds a list "peers" to JSON. What is there
already is not solved again. Run by the environment that bench/peers/peers.sh installs."""
import argparse
import importlib.util
import json
import os
import sys
import tempfile

import numpy as np

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'peers'))
from plan import CODES  # noqa: E402
from process import solve  # noqa: E402

SCENES = ('hertz', 'self-affine', 'rmd-0.7', 'afm_film')
WANTED = ('aspher-fft', 'aspher-h2', 'tamaas-free', 'contactmechanics')
LEAST_SIDE = 64  # of ASPHER's grids


def installed(code):
    return importlib.util.find_spec(CODES[code].package) is not None


def errors(pressure, truth, scene):
    return {'load_error': abs(float(pressure.mean()) / scene['load'] - 1),  # the grid has the area 1
            'area_error': abs(np.count_nonzero(pressure > 0) / np.count_nonzero(truth > 0) - 1),
            'pressure_error': float(np.linalg.norm(pressure - truth) / np.linalg.norm(truth))}


def sweep(code, scene, threads, limit, folder):
    """One row for every tolerance, from loose to tight, until the code fails or takes too long."""
    truth = np.load(scene['pressure'])
    out = os.path.join(folder, 'pressure.npy')
    for tol in CODES[code].tols:
        request = {'gap': scene['gap'], 'out': out, 'n': scene['n'], 'target': scene['load'], 'tol': tol, 'threads': threads,
                   'boundary': 'free', 'control': 'load'}
        answer = solve(CODES[code], request, limit)[0]
        row = {'scene': scene['scene'], 'contact': scene['contact'], 'n': scene['n'], 'code': code, 'tol': tol}
        if 'error' in answer:
            yield {**row, 'error': answer['error']}
            return
        row.update({key: answer[key] for key in ('version', 'setup_seconds', 'solve_seconds', 'cpu_seconds') if key in answer})
        yield {**row, 'memory_bytes': answer['peak_bytes'] - answer['start_bytes'], **errors(np.load(out), truth, scene)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('json')
    parser.add_argument('folder')
    parser.add_argument('--threads', type=int, default=os.cpu_count())
    parser.add_argument('--limit', type=float, default=10, help='seconds for one solve')
    parser.add_argument('--scenes', default=','.join(SCENES))
    arguments = parser.parse_args()
    with open(os.path.join(arguments.folder, 'scenes.json')) as file:
        scenes = [scene for scene in json.load(file) if scene['scene'] in arguments.scenes.split(',') and scene['n'] >= LEAST_SIDE]
    with open(arguments.json) as file:
        document = json.load(file)
    rows = document.setdefault('peers', [])
    for code in WANTED:
        if not installed(code):
            print(f'{CODES[code].title} is not installed: left out')
            continue
        for scene in scenes:
            if any((row['code'], row['scene'], row['n']) == (code, scene['scene'], scene['n']) for row in rows):
                print(f'{CODES[code].title}, {scene["scene"]}: measured before')
                continue
            with tempfile.TemporaryDirectory() as folder:
                for row in sweep(code, scene, arguments.threads, arguments.limit, folder):
                    rows.append(row)
                    print(f'{CODES[code].title}, {scene["scene"]}, tol {row["tol"]:g}: '
                          + (row['error'] if 'error' in row else f'pressure error {row["pressure_error"]:.1e}'), flush=True)
            with open(arguments.json + '.part', 'w') as out:
                json.dump(document, out, indent=1)
                out.write('\n')
            os.replace(arguments.json + '.part', arguments.json)


if __name__ == '__main__':
    main()
