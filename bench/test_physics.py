#!/usr/bin/env python3
"""test_physics.py BENCH: a quick run gives certified rows that agree with each other, a second one measures nothing anew, and physics.py
fills the page and draws every picture from it."""
import json
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
PAGE = os.path.join(HERE, '..', 'docs', 'physics.md')
QUICK = (sys.argv[1], 'physics', '--quick', '--threads', '1', '--json')


def check_rows(document):
    points = document['surface']['points']
    curves = {}
    for row in document['rows']:
        assert row['status'] == 'RC_OK' and row['kkt_control'] <= row['tol'], row
        assert 0.527 * row['area'] < row['corrected_area'] <= row['area'], row
        if row['n'] == points:
            curves.setdefault(row['seed'], []).append(row)
    assert len(curves) == 2 and all(len(rows) == 11 for rows in curves.values())
    for rows in curves.values():
        for low, high in zip(rows, rows[1:]):
            assert low['area'] < high['area'] and low['mean_gap'] > high['mean_gap'] >= 0, high
            if 'stiffness' in high:  # between two loads the slope of the load lies between its ends
                slope = (high['pressure'] - low['pressure']) / (low['mean_gap'] - high['mean_gap'])
                assert low['stiffness'] < slope < high['stiffness'], (low, high)
        for row in rows:
            if 'histogram' in row:
                share = sum(row['histogram']['density']) * row['histogram']['width'] + row['histogram']['above'] / points**2
                assert abs(share / row['area'] - 1) < 1e-12, row
                assert sum(row['patch_octaves']) == row['patches'] > 1 and 0 < row['largest_patch'] <= 1, row


def check_summary(document):
    fits = document['fits']
    assert fits['corrected_kappa']['mean'] < fits['kappa']['mean'], fits
    assert 1.2 < fits['corrected_kappa']['mean'] < 2.6, fits
    assert abs(fits['decay']['mean'] / fits['stiffness_decay']['mean'] - 1) < 0.25, fits
    for row in document['curve']:
        assert row['surfaces'] == 2 and abs(row['area'] - row['persson']) < 0.2, row
    assert document['curve'][-1]['area'] > 0.95
    assert len(document['meshes']) == 6
    for row in document['meshes'][:-1]:
        assert row['raw_error'] > 0 and abs(row['corrected_error']) < row['raw_error'], row


def sections(text):
    return {part.split(' -->', 1)[0]: part.split('-->\n', 1)[1].split('<!-- end')[0] for part in text.split('<!-- begin ')[1:]}


with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, 'physics.json')
    subprocess.run([*QUICK, file], check=True, stdout=subprocess.DEVNULL)
    with open(file, encoding='utf-8') as text:
        first = json.load(text)
    check_rows(first)
    check_summary(first)
    again = subprocess.run([*QUICK, file], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True).stderr
    assert all('measured before' in line for line in again.splitlines()) and again, again
    with open(file, encoding='utf-8') as text:
        second = json.load(text)
    assert all(second[key] == first[key] for key in ('rows', 'curve', 'fits', 'meshes'))

    page = os.path.join(folder, 'physics.md')
    shutil.copy(PAGE, page)
    subprocess.run([sys.executable, '-B', os.path.join(HERE, 'physics.py'), folder, folder, page], check=True)
    with open(page, encoding='utf-8') as text:
        filled = sections(text.read())
    assert set(filled) == {'fits', 'curve', 'meshes', 'provenance'}, filled.keys()
    assert filled['curve'].count('\n') == 2 + 11 and filled['meshes'].count('\n') == 2 + 6, filled
    assert f'{first["fits"]["corrected_kappa"]["mean"]:.2f} (' in filled['fits'], filled['fits']
    if shutil.which('gnuplot'):
        for name in ('area', 'gap', 'patches', 'mesh'):
            assert os.path.getsize(os.path.join(folder, f'physics-{name}.png')) > 5000, name
