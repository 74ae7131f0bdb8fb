"""What a solve on ranks takes: a model whose coefficients are fitted to measured and simulated solves.

A solve of N x N points on P ranks makes K products with the given grid. Each transposes the spectra of the rows twice: of N rows the waves
of the doubled length, complex, of s bytes a number; of N + 1 waves two are real, and sent as one. The solve takes

    seconds = a K N^2 log2(N) / P  +  i K N^2 log2(N) / P  +  t K (N / 32)^2  +  r  +  m (l messages)  +  b (bytes / w)

with a, i, r, m, b fitted: a is work on the rank's own rows; i, of more than one rank, how long they wait for the slowest of them; r what
depends on neither, as the coarsest grid; l the network's latency and w its bandwidth. t is work on the levels of the trees that every
rank has whole, one value for each piece of 32 x 32 points; it is too little to be fitted, and was found by a profile. Messages of a rank
that wait for each other: (P - 1) / 16 in each transposition, which has so many under way at a time and of which large grids need several
each way; log2(P) in each gather. Bytes of a rank: what it sends in transpositions and what it receives in gathers of sums, levels and
coarse grids. Memory: bytes a point, what a rank has whole, and of each rank what depends on nothing."""
import math

import numpy as np

ROUND, MESSAGE, MOST_ROUNDS = 2**23, 2**19, 16  # bytes of a rank's spectra that a transposition carries at most, those of a message, and the largest number of transpositions each way
WINDOW = 16  # ranks with which a transposition exchanges at a time; mpi/exchange.c
PIECE = 32  # rows of which a rank has at least so many or none
COARSEST = 256  # points a side of the grid that every rank solves alike
WHOLE_BYTES = 32  # for each value of the first level that every rank has whole: two trees from there up, and what is gathered
WHOLE_SECONDS = 9.7e-9  # t: of 64 ranks at 4096^2, what the loops over trees take more of the processor than those of one rank
TERMS = 'work on rows', 'waits for the slowest', 'what depends on neither grid nor ranks', 'latencies', 'transfers', 'levels that every rank has whole'
LARGE = [(n, ranks) for n in (65536, 262144) for ranks in (1024, 4096, 16384)]


def waves(n):
    """Complex numbers of a row's spectrum that are sent, free boundaries."""
    return n


def transposed(n, ranks, size):
    """Bytes that all ranks send to others in a product whose numbers have `size` bytes."""
    return 2 * n * (2 * waves(n) * size) * (1 - 1 / ranks)


def counted_transposed(n, ranks, products):
    """All that transpositions of a solve without coarser grids send, products in double precision; the eigenvalues are real, and sent once."""
    return products * transposed(n, ranks, 8) + 8 * n * waves(n) * (1 - 1 / ranks)


def rounds(n, ranks, size):
    """Parts in which a product's spectra are transposed, so that a rank needs no second copy of them."""
    return min(max(int(2 * n * waves(n) * size / ranks / min(ROUND, MESSAGE * ranks)), 1), MOST_ROUNDS)


def with_rows(n, ranks):
    """Ranks that have rows, on grids of 1024 rows and more."""
    return min(ranks, max(n // PIECE, 1))


def terms(row, network):
    """Of a solve with its counters, in units of the fitted coefficients, and the seconds of the last; as in TERMS."""
    width, latency = network
    ranks = row['ranks']
    alone = ranks == 1
    messages = row['transpositions'] * math.ceil((ranks - 1) / row.get('window', 1)) + (row['reductions'] + row['gathers']) * math.ceil(math.log2(ranks) if ranks > 1 else 0)
    received = row['transposed'] / ranks + (row['reduced'] + row['gathered']) * (1 - 1 / ranks)
    points = row['products'] * row['n']**2
    work = points * math.log2(row['n']) / with_rows(row['n'], ranks)
    return [work, 0.0 if alone else work, 1.0, 0.0 if alone else latency * messages, received / width], WHOLE_SECONDS * points / PIECE**2


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
    """The counters of a solve on another grid and other ranks, from those of the largest simulated one: as many products with the given grid,
    calls for as many more coarser grids as there are. Sums are gathered by pieces of rows, levels of the trees by pieces of 32 x 32."""
    size = last['transposed'] / last['products'] / transposed(last['n'], last['ranks'], 1)
    more, side = math.log2(n / COARSEST) / math.log2(last['n'] / COARSEST), n / last['n']
    parts = rounds(n, ranks, size) / rounds(last['n'], last['ranks'], size)
    return {'n': n, 'ranks': ranks, 'window': WINDOW, 'products': last['products'], 'reductions': more * last['reductions'], 'gathers': more * last['gathers'],
            'transpositions': more * parts * last['transpositions'], 'transposed': last['products'] * transposed(n, ranks, size),
            'reduced': last['reduced'] * side, 'gathered': last['gathered'] * side**2}


def computed(model, last, networks):
    rows = []
    for n, ranks in LARGE:
        some = with_rows(n, ranks)
        for name, network in networks.items():
            units, levels = terms(scaled(last, n, some), network)
            found = np.append(np.asarray(units) * model['coefficients'], levels)
            seconds = float(found.sum())
            worst = TERMS[int(np.argmax(found))]
            whole = WHOLE_BYTES * (n / PIECE)**2
            rows.append({'kind': 'computed', 'n': n, 'ranks': ranks, 'with_rows': some, 'network': name, 'seconds': seconds,
                         'communication': float(found[3] + found[4]) / seconds, 'limit': worst,
                         'gigabytes_a_rank': (model['bytes_a_point'] * n * n / some + whole + model['bytes_a_rank']) / 1e9})
    return rows


def fitted(document, networks):
    """The model and what it says; {} where too little was measured or simulated."""
    simulated = [row for row in document.get('simulated', []) if row.get('status') == 'RC_OK']
    measured = [row for row in document.get('measured', []) if row.get('status') == 'RC_OK']
    spread = [row for row in simulated if row['ranks'] > 1]
    if len(spread) < 3 or not any(row['way'] == 'ranks' for row in measured):
        return {}
    units, levels = zip(*(terms(row, networks[row['network']]) for row in simulated))
    coefficients = positive_fit(units, [row['seconds'] - of_levels for row, of_levels in zip(simulated, levels)])
    model = {'coefficients': coefficients.tolist()}
    model['bytes_a_point'], model['bytes_a_rank'] = memory_of(measured)
    model['errors'] = [float((np.dot(of, coefficients) + of_levels) / row['seconds'] - 1) for row, of, of_levels in zip(simulated, units, levels)]
    last = max(spread, key=lambda row: (row['n'], row['ranks']))
    model['rows'] = computed(model, last, networks)
    return model
