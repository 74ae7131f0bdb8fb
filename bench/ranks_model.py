"""What a solve on ranks takes: a model whose coefficients are fitted to measured and simulated solves.

A solve of N x N points on P ranks makes K products. Each transposes the spectra of the rows twice: of N rows the N + 1 waves of the doubled
length, complex, of s bytes a number. K products take

    seconds = a N^2 log2(N) / P  +  r  +  m (l messages)  +  b (bytes / w)

with a, r, m, b fitted: a is work on the rank's own rows, r what every rank does alike (the coarsest grids), l the network's latency and w its
bandwidth. Messages of a rank: P - 1 in each transposition, of which large grids need several each way; log2(P) in each gather. Bytes of a rank: what it sends in transpositions and what it
receives in gathers of sums and coarse grids. Memory: bytes a point, and of each rank what does not depend on its rows."""
import math

import numpy as np

ROUND, MOST_ROUNDS = 2**24, 16  # bytes of a rank's spectra that a transposition carries, and the largest number of transpositions each way
PIECE = 32  # rows of which a rank has at least so many or none
LARGE = [(n, ranks) for n in (65536, 262144) for ranks in (1024, 4096, 16384)]


def waves(n):
    """Complex numbers of a row's spectrum, free boundaries."""
    return n + 1


def transposed(n, ranks, size):
    """Bytes that all ranks send to others in a product whose numbers have `size` bytes."""
    return 2 * n * (2 * waves(n) * size) * (1 - 1 / ranks)


def rounds(n, ranks, size):
    """Parts in which a product's spectra are transposed, so that a rank needs no second copy of them."""
    return min(max(int(2 * n * waves(n) * size / ranks / ROUND), 1), MOST_ROUNDS)


def terms(row, network):
    """[work, constant, latencies, transfers], of a solve with its counters, in units of the coefficients."""
    width, latency = network
    ranks = row['ranks']
    alone = ranks == 1
    messages = row['transpositions'] * (ranks - 1) + (row['reductions'] + row['gathers']) * math.ceil(math.log2(ranks) if ranks > 1 else 0)
    received = row['transposed'] / ranks + (row['reduced'] + row['gathered']) * (1 - 1 / ranks)
    return [row['products'] * row['n']**2 * math.log2(row['n']) / ranks, 1.0, 0.0 if alone else latency * messages, received / width]


def positive_fit(rows, right):
    """Least squares with coefficients that are not negative: those that would be are left out, one after the other."""
    rows, right = np.asarray(rows), np.asarray(right)
    weighted, ones = rows / right[:, None], np.ones(len(right))
    used = [k for k in range(rows.shape[1]) if weighted[:, k].any()]
    while used:
        scale = np.abs(weighted[:, used]).max(axis=0)
        found = np.linalg.lstsq(weighted[:, used] / scale, ones, rcond=None)[0] / scale
        if (found >= 0).all():
            break
        used.pop(int(np.argmin(found)))
    answer = np.zeros(rows.shape[1])
    answer[used] = found if used else []
    return answer


def memory_of(measured):
    """(bytes a point, bytes a rank)"""
    rows = [row for row in measured if row['way'] == 'ranks']
    found = positive_fit([[row['n']**2, row['ranks']] for row in rows], [row['peak_bytes'] for row in rows])
    return float(found[0]), float(found[1])


def scaled(last, n, ranks):
    """The counters of a solve on another grid and other ranks, from those of the largest simulated one. Sums are gathered by pieces of
    rows; the coarsest grids, which every rank has, do not grow."""
    size = last['transposed'] / last['products'] / transposed(last['n'], last['ranks'], 1)
    return {'n': n, 'ranks': ranks, 'products': last['products'], 'reductions': last['reductions'], 'gathers': last['gathers'],
            'transpositions': 2 * last['products'] * rounds(n, ranks, size), 'transposed': last['products'] * transposed(n, ranks, size),
            'reduced': last['reduced'] * n / last['n'], 'gathered': last['gathered']}


def computed(model, last, networks):
    rows = []
    for n, ranks in LARGE:
        with_rows = min(ranks, n // PIECE)
        for name, network in networks.items():
            found = np.asarray(terms(scaled(last, n, with_rows), network)) * model['coefficients']
            seconds = float(found.sum())
            worst = ['work on rows', 'what every rank does alike', 'latencies', 'transfers'][int(np.argmax(found))]
            rows.append({'kind': 'computed', 'n': n, 'ranks': ranks, 'with_rows': with_rows, 'network': name, 'seconds': seconds,
                         'communication': float(found[2] + found[3]) / seconds, 'limit': worst,
                         'gigabytes_a_rank': (model['bytes_a_point'] * n * n / with_rows + model['bytes_a_rank']) / 1e9})
    return rows


def fitted(document, networks):
    """The model and what it says; {} where too little was measured or simulated."""
    simulated = [row for row in document.get('simulated', []) if row.get('status') == 'RC_OK']
    measured = [row for row in document.get('measured', []) if row.get('status') == 'RC_OK']
    spread = [row for row in simulated if row['ranks'] > 1]
    if len(spread) < 3 or not any(row['way'] == 'ranks' for row in measured):
        return {}
    coefficients = positive_fit([terms(row, networks[row['network']]) for row in simulated], [row['seconds'] for row in simulated])
    model = {'coefficients': coefficients.tolist()}
    model['bytes_a_point'], model['bytes_a_rank'] = memory_of(measured)
    model['errors'] = [float(np.dot(terms(row, networks[row['network']]), coefficients) / row['seconds'] - 1) for row in simulated]
    last = max(spread, key=lambda row: (row['n'], row['ranks']))
    model['rows'] = computed(model, last, networks)
    return model
