"""Algorithm 2 of Bemporad & Paggi (2015) as printed, and with its errata put right one after the other: how far each gets. For the benchmark
alone; the library's polonsky-keer has them all."""
import numpy as np

from surfaces import influence

TOL = 1e-8
# Whether every point is clipped at zero and may come back, not those of the active set alone; whether directions and norms are restricted to
# the contact set; whether norms are squared in the ratio that makes directions conjugate.
VARIANTS = {'as printed': (False, False, False), 'every point clipped and admitted': (True, False, False),
            'and norms on the contact set': (True, True, False), 'and squared norms: Polonsky & Keer (1999)': (True, True, True)}


def problem_of(scene):
    """(matrix, compenetrations) of the candidates of a scene with square cells."""
    gap = scene.gap.ravel()
    points = np.flatnonzero(gap < scene.approach)
    matrix = influence(scene.kernel, len(scene.gap))[np.ix_(points, points)]
    return matrix, (scene.approach - gap[points]) / scene.approach


def residual_of(p, w, height):
    """Largest violation of p >= 0, w >= 0, p w = 0, relative to the largest pressure and compenetration."""
    worst = np.max(np.where(p > 0, np.abs(w), -w)) / height
    return max(0.0, worst, -p.min() / np.abs(p).max())


def algorithm_2(scene, variant, most):
    every_point, on_contact, squared = VARIANTS[variant]
    matrix, u = problem_of(scene)
    p, t, w, active = np.zeros_like(u), np.zeros_like(u), -u, np.full(u.size, True)
    height, direction, least, iterations, stopped = u.max(), 0, 1.0, 0, {}

    def norm_of():
        counted = np.where(active, w, 0) if on_contact else w
        return counted @ counted if squared else np.linalg.norm(counted)

    if on_contact:
        active = w < 0
    norm, last_norm, all_points = norm_of(), 1.0, np.linalg.norm(w)
    with np.errstate(all='ignore'):
        while least > TOL and iterations < most:
            t = w + direction * norm / last_norm * t
            if on_contact:
                t = np.where(active, t, 0)
            step = (w @ t) / (t @ (matrix @ t))
            if not np.isfinite(step):
                break
            p -= step * t
            seen = np.full(u.size, True) if every_point else active
            p = np.where(seen, np.maximum(p, 0), p)
            back = seen & (p == 0) & (w < 0)
            p[back] -= step * w[back]
            active = back | (p > 0)
            direction, last_norm = int(not back.any()), norm
            w = matrix @ p - u
            norm, iterations = norm_of(), iterations + 1
            residual, now = residual_of(p, w, height), np.linalg.norm(w)
            if not np.isfinite(residual):
                break
            least = min(least, residual)
            # The printed test: the norm over all points changes little.
            if not stopped and abs(now - all_points) <= TOL * all_points:
                stopped = {'stopped': iterations, 'residual_at_stop': residual}
            all_points = now
        lowest = p.min() / np.abs(p).max()
    return {'candidates': u.size, 'iterations': iterations, 'most': most, 'residual': least, 'lowest_pressure': lowest, **stopped}
