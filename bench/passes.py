"""The passes of haar-cg over all unknowns against what the memory gives: the rate of a = b + c d, the triad, on the same arrays."""
import native
from options import listed, question, ranged
from store import Store
from tables import show

NAMES = ('triad', 'turn', 'inner', 'advance', 'cut', 'keep loads', 'scale', 'add', 'lower', 'grow', 'replace', 'begin', 'choose', 'compenetrate')


def rows_of(points, share, budget):
    seconds, moved = native.time_passes(points, share, budget, len(NAMES))
    rates = moved / seconds
    return [{'points': points, 'contact': share, 'pass': name, 'ns': 1e9 * time / points, 'rate': 1e-9 * rate, 'share': rate / rates[0]}
            for name, time, rate in zip(NAMES, seconds, rates)]


def run(request):
    rows = [row for share in request.shares for row in rows_of(request.points, share / 100, request.budget)]
    Store(request.json, 'passes', 1).save(rows=rows)
    show('contact={contact:.0%}; pass; ns a point={ns:.2f}; GB/s={rate:.1f}; share of the triad={share:.2f}', rows)


question('passes', 'passes over all unknowns against the rate of the memory, one thread', run, {
    'points': (ranged(int, 1000, 1 << 28), 1 << 20, 'unknowns'), 'shares': (listed(ranged(float, 0, 100)), [100, 10], 'percent of them in contact'),
    'budget': (float, 0.3, 'seconds for each pass')}, {'points': 10000, 'budget': 0.001}, '10 000 points')
