"""Rows of paper.json."""

METHODS = ['greedy CG', 'P&K 1999', 'P&K 1999, warm', 'ADMM, warm', 'NNLS', 'NNLS, warm', 'NNLS + 100 GP', 'NNLS by blocks, warm',
           'haar-cg, warm']
BEST_OF_PAPER = 'NNLS + 100 GP'


def rows(document, name, **values):
    """Measured rows of a list with these values."""
    return [row for row in document.get(name, [])
            if 'error' not in row and all(row.get(key) == value for key, value in values.items())]


def reduced_force(row, step):
    """P/(E* A) as if the rms height were a hundredth of the side L: forces are proportional to heights."""
    return step['mean_pressure'] * 0.01 / row['rms_height']
