"""Residuals of pressures, independent of the library, for the certificate's tests.

usage: verify_kkt.py JOBS.json RESULTS.json
A job holds penetrations u and forces p (n1 rows of n2 values), kernel, delta (cell size), Es and spacing (distance of elements over
delta); a result neg_p, neg_w, w_contact and compl: the largest of min(p / max p, |w| / max u). Exits with 77 where NumPy is missing.
"""

import json
import sys

try:
    import numpy as np
except ImportError:
    sys.exit(77)

FAR = 4  # cells, from where quadrature over the cell replaces the closed form, whose differences lose digits


def disc(r):
    """A disc of diameter 1 that carries a unit force as uniform pressure: quadrature in polar coordinates."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    angles, radii = np.pi * (nodes + 1) / 2, 0.25 * (nodes + 1)
    total = np.zeros(r.shape)
    for angle, weight in zip(angles, weights):
        for radius, other in zip(radii, weights):
            squared = r * r + radius * radius - 2 * r * radius * np.cos(angle)
            total += np.pi * weight * (0.25 * other) * radius / np.sqrt(np.maximum(squared, 1e-300))
    return np.where(r == 0, 4 / np.pi, total / (np.pi * 0.25) / np.pi)


def once(x, y):
    """F with F_xy = 1/r: corners of a cell under uniform pressure (Love 1929)."""
    r, result = np.hypot(x, y), np.zeros(x.shape)
    for a, b in ((x, y), (y, x)):
        inside = a != 0
        result[inside] += a[inside] * np.log((b[inside] + r[inside]) / np.abs(a[inside]))
    return result


def twice(x, y):
    """G with G_xxyy = 1/r: corners of two cells, for the Galerkin mean."""
    x, y = np.abs(x), np.abs(y)
    r = np.hypot(x, y)
    result = -(r**3) / 6
    inside = (x > 0) & (y > 0)
    x, y, r = x[inside], y[inside], r[inside]
    result[inside] += 0.5 * x**2 * y * np.log((y + r) / x) + 0.5 * y**2 * x * np.log((x + r) / y)
    return result


def cell(x, y, corners, anti, nodes, weights):
    """Means of 1/r over a cell (or two): by the antiderivative at the corners, far away by quadrature."""
    near = (x < FAR) & (y < FAR)
    result = np.zeros(x.shape)
    result[near] = sum(ca * cb * anti(x[near] + a, y[near] + b) for a, ca in corners for b, cb in corners)
    result[~near] = sum(
        wa * wb / np.hypot(x[~near] + a, y[~near] + b) for a, wa in zip(nodes, weights) for b, wb in zip(nodes, weights)
    )
    return result / np.pi


def kernel(kind, n1, n2, spacing):
    """Deflections for a unit force, times E* delta, at every offset of the grid."""
    x, y = np.meshgrid(np.arange(n1) * float(spacing), np.arange(n2) * float(spacing), indexing="ij")
    r = np.hypot(x, y)
    if kind in ("eq9", "punch"):
        result = 2 / np.pi * np.arcsin(np.minimum(1, 0.5 / np.where(r == 0, 0.5, r)))
        result[r == 0] = 2 / np.pi if kind == "eq9" else 1
        return result
    if kind == "disc":
        return disc(r)
    nodes, weights = np.polynomial.legendre.leggauss(11)
    if kind == "love":
        return cell(x, y, ((0.5, 1), (-0.5, -1)), once, nodes / 2, weights / 2)
    half = (nodes + 1) / 2
    hat = weights / 2 * (1 - half)
    return cell(x, y, ((-1, 1), (0, -2), (1, 1)), twice, np.r_[-half, half], np.r_[hat, hat])


def matvec(p, kind, delta, modulus, spacing):
    n1, n2 = p.shape
    table = kernel(kind, n1, n2, spacing) / (modulus * delta)
    if n1 * n2 <= 4096:  # without the round-off of transforms
        rows, columns = (q.ravel() for q in np.meshgrid(np.arange(n1), np.arange(n2), indexing="ij"))
        result = np.zeros(n1 * n2)
        for q in np.flatnonzero(p.ravel() > 0):
            result += table[abs(rows - rows[q]), abs(columns - columns[q])] * p.ravel()[q]
        return result.reshape(n1, n2)
    i, j = (np.minimum(np.arange(2 * n), 2 * n - np.arange(2 * n)) for n in (n1, n2))
    periodic = np.zeros((2 * n1, 2 * n2))
    periodic[np.ix_(i < n1, j < n2)] = table[np.ix_(i[i < n1], j[j < n2])]
    spectrum = np.fft.rfft2(p, (2 * n1, 2 * n2)) * np.fft.rfft2(periodic)
    return np.fft.irfft2(spectrum, (2 * n1, 2 * n2))[:n1, :n2]


def residuals(u, p, *model):
    w = matvec(np.maximum(p, 0), *model) - u
    largest_p, largest_u = max(p.max(), 0) or 1.0, u.max() if u.max() > 1e-300 else 1.0
    contact = p > 0
    if not contact.any():
        contact_gap = compl = 0.0
    else:
        contact_gap = np.abs(w[contact]).max() / largest_u
        compl = np.minimum(p / max(p.max(), 1e-300), np.abs(w) / max(u.max(), 1e-300))[contact].max()
    return {
        "neg_p": float(max(0, -p.min()) / largest_p),
        "neg_w": float(max(0, -w.min()) / largest_u),
        "w_contact": float(contact_gap),
        "compl": float(compl),
        "load": float(p.sum()),
        "contacts": int(contact.sum()),
    }


def main(jobs_file, results_file):
    with open(jobs_file) as file:
        jobs = json.load(file)
    results = []
    for job in jobs:
        shape = (job["n1"], job["n2"])
        u, p = np.array(job["u"]).reshape(shape), np.array(job["p"]).reshape(shape)
        results.append(residuals(u, p, job["kernel"], job["delta"], job["Es"], job["spacing"]))
    with open(results_file, "w") as file:
        json.dump(results, file)


if __name__ == "__main__":
    main(*sys.argv[1:])
