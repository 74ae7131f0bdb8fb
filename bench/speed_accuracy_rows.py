"""Rows of pareto.json, and what they say about methods and grids. Shared by the tables, the pictures and their test."""
from samples import solved, total_seconds

MEASURED = {'afm_film': 'AFM, film', 'afm_selfaffine': 'AFM, self-affine', 'afm_patch': 'AFM, one hill',
            'confocal_lay': 'confocal, machined', 'fv_rubber': 'focus variation, rubber'}
TITLES = {'hertz': 'Hertz', 'wave': 'one wave', 'waves': 'two waves, flat', 'punch': 'square punch', 'self-affine': 'self-affine',
          **{f'rmd-0.{digit}': f'midpoint, H = 0.{digit}' for digit in (3, 5, 7, 9)}, **MEASURED}
USUAL_KERNELS = ('love', 'spectral')
FAST = 'haar-cg, fft'


def name_of(row):
    """solver, backend and what is set beside them."""
    return 'auto' if row['solver'] == 'auto' else ', '.join(part for part in (row['solver'], row['backend'], row['variant']) if part)


def title_of(case):
    return f'{TITLES[case["scene"]]}, {case["n"]}², {100 * case["contact"]:g} %'


def cases(document, **values):
    """Cases that are measured to the end, as scenes appear in TITLES and by contact."""
    found = [case for case in document.get('cases', []) if all(case[key] == value for key, value in values.items())]
    return sorted(found, key=lambda case: (list(TITLES).index(case['scene']), case['contact']))


def of_case(document, part, case):
    keys = ('scene', 'contact', 'n')
    return [row for row in document.get(part, []) if all(row[key] == case[key] for key in keys)]


def lines(document, case):
    """Certified points of every method by its name, from loose to tight."""
    found = {name_of(row): solved(row['points']) for row in of_case(document, 'methods', case)}
    return {name: points for name, points in found.items() if points}


def grids(document, case, usual=True):
    """{(grid, kernel): certified points}; errors in keys that begin with true_."""
    return {(row['grid'], row['kernel']): solved(row['points']) for row in of_case(document, 'grids', case)
            if solved(row['points']) and (row['kernel'] in USUAL_KERNELS or not usual)}


def grid_error(document, case, key):
    """What the grid costs: the error of its own solution, None where that is not measured."""
    for (grid, _), points in grids(document, case).items():
        if grid == case['n']:
            return points[-1]['true_' + key]
    return None


def front(points):
    """Of (time, error) pairs those that no other beats in both, by growing time."""
    found = []
    for time, error in sorted(points):
        if not found or error < found[-1][1]:
            found.append((time, error))
    return found


def time_to(points, level, key='pressure_error'):
    """Seconds of the fastest point with an error of at most level, or None."""
    times = [total_seconds(point) for point in points if point[key] <= level]
    return min(times) if times else None


def enough(points, levels):
    """The loosest tolerance from which on every error of {key: level} is at most its level, or None."""
    best = None
    for point in sorted(points, key=lambda each: each['tol']):
        if any(point[key] > level for key, level in levels.items()):
            break
        best = point['tol']
    return best
