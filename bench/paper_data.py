"""Rows of paper.json and their statistics. Shared by paper_tables.py and paper_figures.py."""
import math

METHODS = ['greedy CG', 'P&K 1999', 'P&K 1999, warm', 'ADMM, warm', 'NNLS', 'NNLS, warm', 'NNLS + 100 GP', 'NNLS by blocks, warm',
           'haar-cg, warm']
BEST_OF_PAPER = 'NNLS + 100 GP'


def rows(document, name, **values):
    """Measured rows of a list with these values."""
    return [row for row in document.get(name, [])
            if 'error' not in row and all(row.get(key) == value for key, value in values.items())]


def values_of(found, key):
    return sorted({row[key] for row in found})


def median_interval(values, confidence=0.95):
    """Median and the distribution-free interval that holds the true one with at least this confidence, from order statistics
    (Conover 1999, 3.2); least and greatest value where there are too few."""
    ordered = sorted(values)
    count = len(ordered)
    middle = (ordered[(count - 1) // 2] + ordered[count // 2]) / 2
    below, tail = 0, 0.5**count
    while tail + math.comb(count, below + 1) * 0.5**count <= (1 - confidence) / 2:
        below += 1
        tail += math.comb(count, below) * 0.5**count
    return middle, ordered[below], ordered[count - 1 - below]


def median(values):
    return median_interval(values)[0]


def by_seed(found, key):
    return {row['seed']: row[key] for row in found}


def ratios(found, others, key='cpu_seconds'):
    """key of found over that of others, seed by seed."""
    first, second = by_seed(found, key), by_seed(others, key)
    return [first[seed] / second[seed] for seed in sorted(first.keys() & second.keys())]


def reduced_force(row, step):
    """P/(E* A) as if the rms height were a hundredth of the side L: forces are proportional to heights."""
    return step['mean_pressure'] * 0.01 / row['rms_height']
