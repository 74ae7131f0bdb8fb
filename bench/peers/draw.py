#!/usr/bin/env python3
"""draw.py RESULTS IMAGES: draws peers-size.png, peers-contact.png and peers-memory.png into the folder IMAGES from peers.json in the
folder RESULTS, with gnuplot."""
import os
import sys

from store import best, growth, total

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from charts import Panels, decades  # noqa: E402
from results import load  # noqa: E402

# A colour a code, a dash and a marker a variant.
STYLES = {'ours': 'lc rgb "#000000" dt 1 pt 7', 'ours-float': 'lc rgb "#000000" dt 2 pt 6', 'baseline': 'lc rgb "#777777" dt 1 pt 5',
          'aspher-fft': 'lc rgb "#D55E00" dt 1 pt 9', 'aspher-h2': 'lc rgb "#D55E00" dt (8,4) pt 11',
          'aspher-fft-float': 'lc rgb "#E69F00" dt 1 pt 8', 'aspher-h2-float': 'lc rgb "#E69F00" dt (8,4) pt 10',
          'aspher-periodic': 'lc rgb "#D55E00" dt (2,3) pt 9', 'tamaas': 'lc rgb "#0072B2" dt 1 pt 13',
          'tamaas-free': 'lc rgb "#0072B2" dt (8,4) pt 12', 'contactmechanics': 'lc rgb "#009E73" dt 1 pt 15',
          'nnls': 'lc rgb "#CC79A7" dt 1 pt 4', 'osqp': 'lc rgb "#56B4E9" dt 1 pt 6'}
SHOWN = (1e-4, 1e-8)


def look(name):
    return f'linespoints lw {2.4 if name == "ours" else 1.6} ps 1.1 {STYLES[name]}'


def series(document, name, chosen, x, y):
    """Points (x(case), y(group)) of a code over the cases that `chosen` takes, without those that it did not reach."""
    points = []
    for group in document['groups']:
        case = document['cases'][group['case']]
        if group['code'] == name and chosen(case) and (value := y(group)) is not None:
            points.append((x(case), value))
    return sorted(points)


def time_to(level):
    def value(group):
        run = best(group, level)
        return total(run) if run else None
    return value


def memory_per_point(document):
    def value(group):
        n = document['cases'][group['case']]['n']
        run = next((run for level in reversed(SHOWN) if (run := best(group, level))), None)
        return growth(run) / n**2 if run and growth(run) > 0 else None
    return value


def side_tics(sides):
    return 'set xtics (' + ', '.join(f'"{n}²" {n}' for n in sides) + ')'


def draw(document, file, panels):
    """panels: (title, chosen, x of a case, y of a group, axes, y label), two in a row."""
    filled = []
    for title, chosen, x, y, axes, label in panels:
        curves = {name: points for name in document['codes'] if (points := series(document, name, chosen, x, y))}
        if curves:
            filled.append((title, curves, axes, label))
    if not filled:
        return
    rows = (len(filled) + 1) // 2
    names = [name for name in document['codes'] if any(name in curves for _, curves, _, _ in filled)]
    legend = 20 + 22 * ((len(names) + 1) // 2)
    drawing = Panels(800, legend + 320 * rows, 2, rows, legend)
    for number, (title, curves, axes, label) in enumerate(filled):
        xs = [x for points in curves.values() for x, _ in points]
        low, high = decades([y for points in curves.values() for _, y in points])
        settings = (f'set xrange [{min(xs) / 1.5}:{max(xs) * 1.5}]\nset yrange [{low}:{high}]\n{axes(sorted(set(xs)))}\n'
                    f'set ylabel "{label}" offset 1.2,0')
        drawing.panel(number % 2, number // 2, title, settings,
                      [f'{drawing.block(points)} with {look(name)}' for name, points in curves.items()])
    drawing.draw(file, [(document['codes'][name]['title'], look(name)) for name in names], 2)


def is_family(boundary, control, percent=None, n=None):
    return lambda case: ((case['boundary'], case['control']) == (boundary, control) and percent in (None, case['percent']) and
                         n in (None, case['n']))


def widest(document, boundary):
    """The grid with the most contact areas, the larger of equal ones."""
    counts = {}
    for case in document['cases'].values():
        if is_family(boundary, 'load')(case):
            counts[case['n']] = counts.get(case['n'], 0) + 1
    return max(counts, key=lambda n: (counts[n], n), default=None)


def main():
    results, images = sys.argv[1:]
    document = load(results, 'peers')
    os.makedirs(images, exist_ok=True)
    side = (lambda case: case['n']), (lambda xs: side_tics(xs) + '\nset xlabel "points" offset 0,0.4')
    share = ((lambda case: case['percent']),
             (lambda xs: 'set xtics (' + ', '.join(f'"{x:g}" {x}' for x in xs) + ')\nset xlabel "contact [%]" offset 0,0.4'))
    boundaries = 'free', 'periodic'
    draw(document, os.path.join(images, 'peers-size.png'),
         [(f'{boundary}, 10 % contact, certified {level:.0e}', is_family(boundary, 'load', 10), side[0], time_to(level), side[1],
           'set-up and solve [s]') for boundary in boundaries for level in SHOWN])
    contact = []
    for boundary in boundaries:
        n = widest(document, boundary)
        contact += [(f'{boundary}, {n}², certified {level:.0e}', is_family(boundary, 'load', n=n), share[0], time_to(level), share[1],
                     'set-up and solve [s]') for level in SHOWN]
    draw(document, os.path.join(images, 'peers-contact.png'), contact)
    draw(document, os.path.join(images, 'peers-memory.png'),
         [(f'{boundary}, 10 % contact', is_family(boundary, 'load', 10), side[0], memory_per_point(document), side[1],
           'peak memory [bytes/point]') for boundary in boundaries])


if __name__ == '__main__':
    main()
