"""The pictures of docs/speed-accuracy.md, from pareto.json."""
import os

from charts import Panels, decades, style
from speed_accuracy_rows import FAST, MEASURED, TITLES, cases, front, grid_error, grids, lines, title_of
from samples import total_seconds
from store import load

FLOOR = 1e-14  # errors against a solution of tolerance 1e-13 say nothing below
BAND = '#D9D9D9'
FRONT = 'lines lw 7 lc rgb "#C4C4C4" dt 1'
LOOKS = {  # methods that are drawn: colour, dash and marker each tell them apart
    FAST: 'lc rgb "#000000" dt 1 pt 7',
    'haar-cg, fft, double': 'lc rgb "#000000" dt (4,3) pt 6',
    'haar-cg, fft, single': 'lc rgb "#D55E00" dt 1 pt 9',
    'haar-cg, split': 'lc rgb "#0072B2" dt (12,4) pt 5',
    'polonsky-keer, fft': 'lc rgb "#E69F00" dt (12,4,2,4) pt 13',
    'polonsky-keer, fft, single': 'lc rgb "#E69F00" dt (2,3) pt 12',
    'nnls, fft': 'lc rgb "#009E73" dt (2,3) pt 11',
    'nnls, dense': 'lc rgb "#CC79A7" dt (8,8) pt 15',
    'gp, fft': 'lc rgb "#56B4E9" dt (8,3) pt 4',
    'admm, fft': 'lc rgb "#777777" dt (2,3) pt 10',
    'cmr, fft': 'lc rgb "#777777" dt (8,3) pt 14',
    'greedy, fft': 'lc rgb "#777777" dt 1 pt 8',
}
FEW = [FAST, 'haar-cg, fft, single', 'haar-cg, split', 'polonsky-keer, fft', 'nnls, fft', 'nnls, dense', 'gp, fft']
PEERS = {'aspher-fft': ('ASPHER, fft', 'pt 2'), 'aspher-h2': ('ASPHER, h2', 'pt 1'), 'tamaas-free': ('Tamaas', 'pt 3'),
         'contactmechanics': ('ContactMechanics', 'pt 8')}
AXES = {'load_error': 'load', 'pressure_error': 'pressure', 'true_load_error': 'load', 'true_pressure_error': 'pressure'}


def look(name):
    return f'linespoints lw 1.6 ps 0.9 {LOOKS[name]}'


def peer_look(code):
    return f'points lw 1.8 ps 1.2 lc rgb "#AA0000" {PEERS[code][1]}'


def peer_points(document, case, key):
    """Other codes hold the load: its error says nothing about them."""
    if key != 'pressure_error':
        return {}
    found = {}
    for row in document.get('peers', []):
        if row['code'] in PEERS and 'error' not in row and all(row[name] == case[name] for name in ('scene', 'contact', 'n')):
            found.setdefault(row['code'], []).append((total_seconds(row), row[key]))
    return found


def clipped(points):
    return [(time, max(error, FLOOR)) for time, error in points]


def errors_panel(drawing, document, place, case, key, names):
    """Time against the error of the solver, above the band of errors that the grid makes anyway."""
    known = lines(document, case)
    drawn = {name: [(total_seconds(point), point[key]) for point in known[name]] for name in names if name in known}
    peers = peer_points(document, case, key)
    best = front(clipped((total_seconds(point), point[key]) for points in known.values() for point in points))
    curves = [f'{drawing.block(best)} with {FRONT}']
    curves += [f'{drawing.block(clipped(points))} with {look(name)}' for name, points in drawn.items()]
    curves += [f'{drawing.block(clipped(points))} with {peer_look(code)}' for code, points in peers.items()]
    lowest, highest = decades([time for points in [*drawn.values(), *peers.values()] for time, _ in points])
    grid = grid_error(document, case, key) or 0
    settings = (f'set xrange [{lowest}:{highest}]\nset yrange [{FLOOR}:1]\nset ytics 1e-14,100,1\n'
                'set xlabel "set-up and solve [s]" offset 0,0.4\nset ylabel "relative error" offset 1.2,0\n'
                f'set object 1 rectangle from graph 0,0 to graph 1,first {max(grid, FLOOR)!r} '
                f'fc rgb "{BAND}" fs solid 0.6 noborder behind')
    drawing.panel(*place, f'{title_of(case)}: {AXES[key]}', settings, curves)
    return drawn.keys(), peers.keys()


def entries(methods, peers):
    found = [(name, look(name)) for name in LOOKS if name in methods]
    found += [(title, peer_look(code)) for code, (title, _) in PEERS.items() if code in peers]
    return found + [('Pareto front of all methods', FRONT), ("below the grid's own error", f'lines lw 12 lc rgb "{BAND}"')]


def errors_picture(document, file, panels, names):
    """Panels of (case, error), two in a row."""
    rows = (len(panels) + 1) // 2
    legend = 30 + 22 * ((len(names) + len(PEERS) + 3) // 2)
    drawing = Panels(800, legend + 265 * rows, 2, rows, legend)
    methods, peers = set(), set()
    for i, (case, key) in enumerate(panels):
        drawn, others = errors_panel(drawing, document, (i % 2, i // 2), case, key, names)
        methods |= set(drawn)
        peers |= set(others)
    drawing.draw(file, entries(methods, peers), 2)


def both(found):
    return [(case, key) for case in found for key in ('load_error', 'pressure_error')]


def middle(document, scenes):
    """Of each scene the case next to 10 % in contact."""
    found = []
    for scene in scenes:
        known = cases(document, scene=scene)
        if known:
            found.append(min(known, key=lambda case: abs(case['contact'] - 0.1)))
    return found


def best_known(document, wanted):
    """The cases wanted, and others in the place of those that are not there."""
    known = cases(document)
    found = [case for scene, contact in wanted for case in known if (case['scene'], case['contact']) == (scene, contact)]
    return (found + [case for case in known if case not in found])[:len(wanted)]


def speed_accuracy(document, file):
    chosen = best_known(document, [('hertz', 0.1), ('self-affine', 0.1), ('rmd-0.7', 0.4), ('afm_film', 0.1)])
    errors_picture(document, file, [(case, 'pressure_error') for case in chosen], FEW)


def generated(document, file):
    errors_picture(document, file, both(middle(document, [scene for scene in TITLES if scene not in MEASURED])), list(LOOKS))


def measured(document, file):
    errors_picture(document, file, both(middle(document, MEASURED)), list(LOOKS))


def contacts(document, file):
    chosen = [case for scene in ('self-affine', 'afm_film') for case in cases(document, scene=scene)]
    errors_picture(document, file, [(case, 'pressure_error') for case in chosen], FEW)


def grid_picture(document, file):
    """Error against the truth by tolerance, one line a grid: where a line turns down no more, the grid is the limit."""
    chosen = middle(document, ['hertz', 'self-affine', 'rmd-0.5', 'afm_film'])
    drawing = Panels(800, 60 + 265 * len(chosen), 2, len(chosen), 60)
    names = ['half as many points a side', 'the grid of the other pictures', 'twice as many']
    for row, case in enumerate(chosen):
        for column, key in enumerate(['true_load_error', 'true_pressure_error']):
            curves, times, errors = [], [], []
            for number, ((grid, _), points) in enumerate(sorted(grids(document, case).items())):
                values = [(total_seconds(point), point[key]) for point in points]
                curves.append(f'{drawing.block(clipped(values))} with {style(number)}')
                times += [time for time, _ in values]
                errors += [error for _, error in clipped(values)]
            (lowest, highest), (least, most) = decades(times), decades(errors)
            settings = (f'set xrange [{lowest}:{highest}]\nset yrange [{least}:{most}]\nset ytics autofreq\n'
                        'set xlabel "set-up and solve [s]" offset 0,0.4\nset ylabel "error against the truth" offset 1.2,0')
            drawing.panel(column, row, f'{title_of(case)}: {AXES[key]}', settings, curves)
    drawing.draw(file, [(name, style(number)) for number, name in enumerate(names)], 3)


def kernel_picture(document, file):
    chosen = middle(document, ['hertz', 'self-affine'])
    drawing = Panels(800, 380, 2, 1, 60)
    kernels = ['love', 'galerkin', 'disc', 'punch', 'eq9']
    for column, case in enumerate(chosen):
        known = grids(document, case, usual=False)
        curves, errors = [], []
        for number, kernel in enumerate(kernels):
            points = sorted((grid, max(found[-1]['true_load_error'], FLOOR)) for (grid, name), found in known.items() if name == kernel)
            if points:
                curves.append(f'{drawing.block(points)} with {style(number)}')
                errors += [error for _, error in points]
        sides = sorted({grid for grid, _ in known})
        tics = ', '.join(f'"{side}" {side}' for side in sides)
        least, most = decades(errors)
        drawing.panel(column, 0, f'{TITLES[case["scene"]]}, {100 * case["contact"]:g} %: load',
                      f'set xrange [{sides[0] / 1.3}:{sides[-1] * 1.3}]\nset xtics ({tics})\nset yrange [{least}:{most}]\n'
                      'set xlabel "points a side" offset 0,0.4\nset ylabel "error against the truth" offset 1.2,0', curves)
    drawing.draw(file, [(kernel, style(number)) for number, kernel in enumerate(kernels)], 5)


PICTURES = {'speed-accuracy': speed_accuracy, 'pareto-generated': generated, 'pareto-measured': measured, 'pareto-contacts': contacts,
            'pareto-grids': grid_picture, 'pareto-kernels': kernel_picture}


def pictures(results, images):
    document = load(results, 'pareto')
    for name, draw in PICTURES.items() if cases(document) else ():
        if name == 'pareto-measured' and not middle(document, MEASURED):
            print('no measured surface: pareto-measured.png stays as it is')
        else:
            draw(document, os.path.join(images, name + '.png'))
