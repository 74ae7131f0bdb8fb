"""Rows by the values of keys, and statistics of samples: medians with their intervals, shares, ratios, slopes."""
import math
from statistics import fmean, linear_regression, median


def fits(row, values):
    return all(key in row and row[key] == value for key, value in values.items())


def chosen(rows, **values):
    """Rows with these values."""
    return [row for row in rows if fits(row, values)]


def columns(rows):
    """{key: values of the rows, None where one has none}"""
    return {key: [row.get(key) for row in rows] for key in dict.fromkeys(key for row in rows for key in row)}


def rows_of(found):
    """The rows of columns."""
    return [dict(zip(found, values)) for values in zip(*found.values())]


def groups(rows, *keys):
    """Rows by the values of keys, in order of appearance."""
    found = {}
    for row in rows:
        found.setdefault(tuple(row[key] for key in keys), []).append(row)
    return found


def values_of(rows, key):
    return sorted({row[key] for row in rows})


def solved(rows):
    return chosen(rows, status='RC_OK')


def total_seconds(row):
    return row['setup_seconds'] + row['solve_seconds']


def mean_of(rows, key):
    return fmean(row[key] for row in rows)


def median_interval(values, confidence=0.95):
    """Median and the distribution-free interval that holds the true one with at least this confidence, from order statistics
    (Conover 1999, 3.2); least and greatest value where there are too few."""
    ordered = sorted(values)
    count = len(ordered)
    below, tail = 0, 0.5**count
    while tail + math.comb(count, below + 1) * 0.5**count <= (1 - confidence) / 2:
        below += 1
        tail += math.comb(count, below) * 0.5**count
    return median(ordered), ordered[below], ordered[count - 1 - below]


def wilson(hits, trials, z=1.959963984540054):
    """Wilson's score interval (1927) for a proportion."""
    share, shrink = hits / trials, 1 + z * z / trials
    middle = (share + z * z / (2 * trials)) / shrink
    half = z / shrink * math.sqrt(share * (1 - share) / trials + z * z / (4 * trials**2))
    return 0 if hits == 0 else max(0.0, middle - half), 1 if hits == trials else min(1.0, middle + half)


def ratios(found, others, key='cpu_seconds'):
    """key of found over that of others, seed by seed."""
    first, second = ({row['seed']: row[key] for row in rows} for rows in (found, others))
    return [first[seed] / second[seed] for seed in sorted(first.keys() & second.keys())]


def slope(points):
    """Least squares of log y over log x."""
    return linear_regression(*zip(*[(math.log(x), math.log(y)) for x, y in points])).slope
