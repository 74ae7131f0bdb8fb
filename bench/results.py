"""Reads what roughcontact-bench writes. Shared by charts.py and tables.py."""
import json
import os


def load(folder, name):
    with open(os.path.join(folder, name + '.json')) as file:
        return json.load(file)


def groups(rows, *keys):
    """Rows by the values of keys, in order of appearance."""
    found = {}
    for row in rows:
        found.setdefault(tuple(row[key] for key in keys), []).append(row)
    return found


def solved(rows):
    return [row for row in rows if row.get('status') == 'RC_OK']


def total_seconds(row):
    return row['setup_seconds'] + row['solve_seconds']


def scene_title(scene, n):
    family = 'Hertz' if scene == 'hertz' else 'self-affine'
    return f'{family}, {n}²'
