"""`documents PAGE --quick` on nothing measured before: every answer is certified, the page is filled, pictures are drawn, and a second
call measures nothing anew. The second argument names the page: performance, paper, pareto (speed-accuracy), physics, published. What the
numbers must be is tested where the library's answers are."""
import os
import sys

from program import BUILD, check_pictures, counts, load, remade, run

from paper_tables import SECTIONS
from samples import median_interval
from speed_accuracy_tables import enough, front, time_to

PAGES = {  # (stems of its JSON, options, sections besides that of the provenance, pictures)
    'performance': ('scaling mapped', [], {'scaling', 'batch', 'mapped'}, []),
    'paper': ('paper', [], {'claims', *SECTIONS}, [f'paper-figure-{number}' for number in (2, 4, 5, 6, 8, 9, 10)]),
    'pareto': ('pareto', ['--threads', '1'], {'picks', 'methods', 'tolerances', 'grids', 'goals'}, ['speed-accuracy', 'speed-accuracy-grids']),
    'physics': ('physics', ['--threads', '1'], {'fits', 'curve', 'meshes'}, [f'physics-{name}' for name in ('area', 'gap', 'patches', 'mesh', 'hardness')]),
    'published': ('published', ['--threads', '1'], {'summary', 'forms', 'crossing', 'gfmd', 'challenge'},
                  [f'published-{name}' for name in ('forms', 'crossing', 'area', 'challenge', 'slip')]),
}
GOOD = {'RC_OK', 'RC_WITHIN_GOAL', 'OK'}
MAY_FAIL = {'greedy CG', 'figure_2'}  # what a page shows to fail: its method, or its table


def statuses(node, inside=''):
    """(status, the row that has it) of all rows of a document."""
    if isinstance(node, dict):
        if 'status' in node and not MAY_FAIL & {inside, node.get('method'), node.get('table')}:
            yield node['status'], node
        for name, value in node.items():
            yield from statuses(value, name)
    elif isinstance(node, list):
        for value in node:
            yield from statuses(value, inside)


def check_helpers():
    """Order statistics: 20 values leave five out at either end; the front of times and errors."""
    assert median_interval(range(1, 21)) == (10.5, 6, 15) and median_interval([1, 2, 4]) == (2, 1, 4)
    assert front([(3, 1e-3), (1, 1e-1), (2, 1e-1), (4, 1e-2), (5, 1e-9)]) == [(1, 1e-1), (3, 1e-3), (5, 1e-9)]
    points = [{'tol': 1e-2, 'a': 1e-5, 'b': 1e-1, 'seconds': 2}, {'tol': 1e-4, 'a': 1e-5, 'b': 1e-4, 'seconds': 3},
              {'tol': 1e-6, 'a': 1e-9, 'b': 1e-6, 'seconds': 4}]
    assert enough(points, {'a': 1e-4, 'b': 1e-3}) == 1e-4 and enough(points, {'a': 1e-4, 'b': 1e-9}) is None
    assert time_to(points, 1e-4, 'b') == 3 and time_to(points, 1e-8, 'b') is None


def main():
    page = {'pareto': 'speed-accuracy'}.get(sys.argv[2], sys.argv[2])
    stem, options, sections, pictures = PAGES[sys.argv[2]]
    folder = os.path.join(BUILD, f'{page}-quick')
    check_helpers()
    first, filled = remade(page, *options)
    assert 'measured before' not in first if not counted(first) else counts(first)[1:] == [0, 0], first
    assert set(filled) >= sections | ({'provenance'} if stem != 'scaling mapped' else set()), filled.keys()
    for name in sections:
        assert filled[name].strip() and not any(word in filled[name] for word in ('ot measured yet', 'nan', 'None')), (name, filled[name])
    check_pictures(folder, *pictures)
    for each in stem.split():
        found = list(statuses(load(folder, each)))
        assert found and all(status in GOOD for status, _ in found), next((row for status, row in found if status not in GOOD), 'no rows')
    again = run('documents', page, '--quick', *options)
    assert counts(again)[0] == 0 if counted(again) else 'measured before' in again, again


def counted(output):
    return ' of them failed; ' in output


main()
