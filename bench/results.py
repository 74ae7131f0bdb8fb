"""Reads what roughcontact-bench writes. Shared by charts.py and tables.py."""
import json
import os


def load(folder, name):
    with open(os.path.join(folder, name + '.json')) as file:
        return json.load(file)


def load_known(folder, name):
    """The results of a benchmark that may not have run yet: then None."""
    return load(folder, name) if os.path.exists(os.path.join(folder, name + '.json')) else None


def groups(rows, *keys):
    """Rows by the values of keys, in order of appearance."""
    found = {}
    for row in rows:
        found.setdefault(tuple(row[key] for key in keys), []).append(row)
    return found


def scaling_rows(document, **values):
    """Certified cold solves by everything that `auto` chooses, or with other values of their keys, by growing size."""
    wanted = {'tol': 1e-8, 'precision': 'mixed', 'solver_option': 'auto', 'backend_option': 'auto', **values}
    rows = [row for row in solved(document['solves']) if all(row.get(key) == value for key, value in wanted.items())]
    return sorted(rows, key=lambda row: row['n'])


def solved(rows):
    return [row for row in rows if row.get('status') == 'RC_OK']


def total_seconds(row):
    return row['setup_seconds'] + row['solve_seconds']
