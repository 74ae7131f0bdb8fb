"""The pictures of docs/development/paper.md, from paper.json. What has not been measured is left out."""
import math
import os

from charts import FILTERS, PROPORTIONAL, STYLES as LOOKS, Panels, axes, line, ticks
from paper_tables import METHODS, measured
from samples import chosen, median_interval, values_of
from json_tables import load

# A colour a family, a dash and a marker a variant.
METHOD_LOOKS = dict(zip(METHODS, map(line, [
    'lc rgb "#D55E00" dt 1 pt 9', 'lc rgb "#000000" dt 1 pt 7', 'lc rgb "#000000" dt (4,3) pt 6', 'lc rgb "#CC79A7" dt (8,8) pt 15',
    'lc rgb "#0072B2" dt 1 pt 5', 'lc rgb "#0072B2" dt (4,3) pt 4', 'lc rgb "#E69F00" dt 1 pt 13', 'lc rgb "#009E73" dt (2,3) pt 11',
    'lc rgb "#56B4E9" dt (12,4,2,4) pt 12'])))


def scale(axis, low, high, log):
    """Tics of a range, at round numbers within few decades, at powers of ten within more."""
    if not log:
        return f'set {axis}tics autofreq\nset format {axis} "%g"\n'
    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    if last - first > 3:
        return f'set logscale {axis}\nset {axis}tics autofreq\nset format {axis} "10^{{%T}}"\n'
    digits = (1, 3) if axis == 'x' and last - first > 2 else (1, 2, 5)
    tics = ','.join(f'{digit * 10.0**power:g}' for power in range(first, last + 1) for digit in digits)
    return f'set logscale {axis}\nset {axis}tics ({tics})\nset format {axis} "%g"\n'


def frame(x, y, xlabel, ylabel, log='', more=''):
    """log: the axes with logarithmic scales."""
    return axes(xlabel, ylabel, x, y, 'unset logscale\n' + scale('x', *x, 'x' in log) + scale('y', *y, 'y' in log) + more)


def around(values, log=True, spare=0.06):
    """A range with room around values."""
    values = list(values)
    low, high = min(values), max(values)
    room = spare * ((high - low) or 1)
    return (low / 1.5, high * 1.5) if log else (low - room, high + room)


def with_intervals(drawing, points, look):
    """Curves of (x, median, lower, upper)."""
    return [drawing.curve(points, f'yerrorbars lw 1 {look.split(" pt ")[0]} pt -1', 'using 1:2:3:4'),
            drawing.curve(points, line(look), 'using 1:2')]


def every(series):
    """All medians and ends of intervals of some curves."""
    return [value for points in series for point in points for value in point[1:]]


def figure_2(found, file):
    row, drawing, stems = found[0], Panels(800, 675, 1, 3), f'points ps 0.8 {LOOKS[0]}'
    overlap, solution = 'points ps 1.6 lw 2 lc rgb "#D55E00" pt 6', 'points ps 1.2 lw 1.5 lc rgb "#009E73" pt 4'
    places = range(1, len(row['u']) + 1)
    panels = [('compenetration', 'u', (0, 1.05), 'u [length]', []),
              ('gap that greedy elimination leaves', 'w', around(row['w'], log=False), 'w [length]',
               [([(i, value) for i, value in zip(places, row['w']) if value < -1e-9], overlap)]),
              ('force', 'greedy', around([0, *row['greedy'], *row['exact']], log=False), 'p/E* [length²]',
               [(list(zip(places, row['exact'])), solution)])]
    for number, (title, key, y, label, more) in enumerate(panels):
        points = list(zip(places, row[key]))
        drawing.panel(0, number, title, frame((0, len(places) + 1), y, 'element', label),
                      [drawing.curve(*each) for each in ((points, 'impulses lw 1 lc rgb "#999999"'), (points, stems), *more)])
    drawing.draw(file, [('greedy', stems), ('w < 0: overlap', overlap), ('solution (NNLS)', solution)], 3)


def figure_4(rows, file):
    """Forces as if the rms height were a hundredth of the side L: they are proportional to heights."""
    drawing = Panels(800, 370, 2, 1)
    for column, setting in enumerate(('dense', 'fft')):
        found = sorted(chosen(rows, setting=setting, seed=1), key=lambda r: METHODS.index(r['method']))
        series = [[(pressure * 0.01 / row['rms_height'], cpu) for pressure, cpu in zip(row['steps']['mean_pressure'], row['steps']['cpu_seconds'])
                   if pressure > 0] for row in found]
        x, y = (around(values) for values in zip(*sum(series, [])))
        words = f'dense products, {found[0]["steps_of_ten"]} steps of 10' if setting == 'dense' else 'FFT products'
        drawing.panel(column, 0, f'{found[0]["points_a_side"]}² points, {words}',
                      frame(x, y, 'P/(E* A), rms height L/100', 'CPU time of a step [s]', 'xy'),
                      [drawing.curve(points, METHOD_LOOKS[row['method']]) for row, points in zip(found, series)])
    drawing.draw(file, [(name.replace('P&K', 'Polonsky, Keer'), look) for name, look in METHOD_LOOKS.items()], 3)


def figure_5(found, file):
    drawing, panels = Panels(800, 360, 2, 1), {'greedy elimination': [], 'relative to conjugate gradients': []}
    bare = [{**row, 'inner': 'stored before', 'cpu_seconds': row['cpu_seconds'] - row['storing_seconds']}
            for row in chosen(found, inner='gauss-seidel')]
    for inner in ('cg', 'cholesky', 'gauss-seidel', 'stored before'):
        times, shares = [], []
        for n in values_of(found, 'n'):
            mine, cg = ({r['seed']: r['cpu_seconds'] for r in chosen(found + bare, n=n, inner=name)} for name in (inner, 'cg'))
            both = sorted(mine.keys() & cg.keys())
            if both:
                times.append((n, *median_interval([mine[seed] for seed in both])))
                shares.append((n, *median_interval([mine[seed] / cg[seed] for seed in both])))
        for series, points in zip(panels.values(), (times, shares)):
            series.append(points)
    x = around(values_of(found, 'n'))
    for column, ((title, series), label) in enumerate(zip(panels.items(), ('CPU time [s]', 'ratio of CPU times'))):
        curves = [curve for points, look in zip(series, LOOKS) if points for curve in with_intervals(drawing, points, look)]
        drawing.panel(column, 0, title, frame(x, around(every(series)), 'candidates n', label, 'xy'), curves)
    names = ['conjugate gradients', 'Cholesky', 'Gauss-Seidel', 'Gauss-Seidel, storing not counted']
    drawing.draw(file, [(name, line(look)) for name, look in zip(names, LOOKS)], 2)


def figure_6(found, file):
    drawing, steps = Panels(800, 360, 2, 1), values_of(found, 'projections')
    series = [(line(LOOKS[number]), [(candidates, cpu) for candidates, cpu, contacts in zip(*map(row['steps'].get, ('candidates', 'cpu_seconds', 'contacts')))
                                     if contacts > 0])
              for number, count in enumerate(steps) for row in chosen(found, projections=count, pivoting='single', seed=1)]
    x, y = (around(values) for values in zip(*sum((points for _, points in series), [])))
    drawing.panel(0, 0, 'one exchange a solve, as published', frame(x, y, 'candidates n of a step', 'CPU time of a step [s]', 'xy'),
                  [drawing.curve(points, look) for look, points in series])
    looks = {'single': 'lc rgb "#555555" dt 1 pt 6', 'block': LOOKS[5]}
    totals = {look: [(count, *median_interval([r['cpu_seconds'] for r in same])) for count in steps
                     if (same := chosen(found, projections=count, pivoting=pivoting))] for pivoting, look in looks.items()}
    drawing.panel(1, 0, 'ten steps together', frame((-10, 210), around(every(totals.values())), 'projections K before NNLS', 'CPU time [s]', 'y'),
                  [curve for look, points in totals.items() for curve in with_intervals(drawing, points, look)])
    drawing.draw(file, [(f'K = {count}', line(LOOKS[number])) for number, count in enumerate(steps)] +
                 [('one exchange a solve', line(looks['single'])), ('blocks', line(looks['block']))], 4)


def percent_of(row):
    return 100 * abs(row['load_error'])


def share(key):
    return lambda row: row[key] / row['whole_cpu_seconds']


def figure_8(found, file):
    exponents, drawing = values_of(found, 'hurst'), Panels(800, 690, 2, 2)

    def series(rows, value):
        return [(h, *median_interval([value(r) for r in same])) for h in exponents if (same := chosen(rows, hurst=h))]

    def panel(column, row, title, label, lines, log=''):
        everything = [value for value in every(points for points, _ in lines) if value > 0]
        low, high = around(everything + ([2] if log else [1]), log=bool(log))
        curves = [curve for points, look in lines for curve in with_intervals(drawing, points, look)]
        drawing.panel(column, row, title, frame((exponents[0] - 0.05, exponents[-1] + 0.05), (max(low, 1e-3), high) if log else (0, high),
                                                'Hurst exponent H', label, log), curves + ([f'2 with lines {PROPORTIONAL}'] if log else []))

    fft, love, dense = chosen(found, backend='fft', kernel='eq9'), chosen(found, kernel='love'), chosen(found, backend='dense')
    for column, (title, label, value, log) in enumerate((('load lost, as published', '|error| of the load [%]', percent_of, 'y'),
                                                         ('candidates that are kept', 'n_p / n', lambda r: r['kept'], ''))):
        panel(column, 0, title, label, [(series(fft, value), LOOKS[0]), (series(love, value), LOOKS[1]),
                                        (series(fft, lambda r: value(r['diagonal'])), LOOKS[2])], log)
    for column, (of, title) in enumerate(((dense, 'dense products, NNLS'), (fft, 'FFT products, conjugate gradients'))):
        panel(column, 1, 'time: ' + title, 'CPU time / that of the whole', [(series(of, share('cpu_seconds')), LOOKS[0]),
               (series(of, lambda r: r['diagonal']['cpu_seconds'] / r['whole_cpu_seconds']), LOOKS[2]),
               (series(of, share('certified_cpu_seconds')), LOOKS[4])])
    drawing.draw(file, [('Algorithm 6, radius h δ, eq9', line(LOOKS[0])), ('the same, love', line(LOOKS[1])),
                        ('radius h √2 δ, eq9', line(LOOKS[2])), ('certified, eq9', line(LOOKS[4])), ('2 %', f'lines {PROPORTIONAL}')], 3)


def figure_9(found, file):
    drawing, radii = Panels(800, 350, 2, 1), [entry['h'] for entry in found[0]['radii']]
    x = (radii[0] - 0.1, radii[-1] + 0.1)

    def series(backend, value):
        return [(h, *median_interval([value({**r, **r['radii'][i]}) for r in chosen(found, backend=backend)])) for i, h in enumerate(radii)]

    errors = series('fft', percent_of)
    drawing.panel(0, 0, 'load lost', frame(x, around([v for v in every([errors]) if v > 0] + [0.01, 1]), 'h', '|error| of the load [%]', 'y'),
                  with_intervals(drawing, errors, LOOKS[0]))
    lines = [series('fft', lambda r: r['kept']), series('dense', share('cpu_seconds')), series('fft', share('cpu_seconds')),
             series('dense', share('certified_cpu_seconds'))]
    drawing.panel(1, 0, 'candidates and time', frame(x, (0, 1.05 * max(every(lines))), 'h', 'ratio'),
                  [curve for points, look in zip(lines, LOOKS[1:]) for curve in with_intervals(drawing, points, look)])
    names = ['|error| of the load', 'n_p / n', 'CPU time, dense products', 'CPU time, FFT products', 'certified, dense products']
    drawing.draw(file, [(name, line(look)) for name, look in zip(names, LOOKS)], 3)


def figure_10(found, file):
    drawing, fitted = Panels(800, 680, 2, 2), 'lines lw 1 lc rgb "#888888" dt 1'
    profiles, spectra, density, entries = [], [], [], []
    for number, row in enumerate(found):
        rms, count = row['rms_height'], len(row['profile'])
        look = LOOKS[number % len(LOOKS)].rsplit(' pt', 1)[0]
        profiles.append(drawing.curve([(i / count, value / rms - 8 * number) for i, value in enumerate(row['profile'])], f'lines lw 1 {look}'))
        # Lengths in units of the longest wave, densities in those of a flat spectrum of the same variance.
        longest, area = row['q'][0], rms**2 / row['q'][0]**2
        points = [(q / longest, psd / area) for q, psd in zip(row['q'], row['psd']) if psd > 0]
        density += [psd for _, psd in points]
        spectra.append(drawing.curve(points, f'lines lw 1.4 {look}'))
        if row['q_min'] and row['q_max']:
            ends = [(q / longest, row['prefactor'] * q**row['slope'] / area * 4) for q in (row['q_min'], row['q_max'])]
            spectra.append(drawing.curve(ends, fitted))
        entries.append((row['surface'], f'lines lw 1.4 {look}'))
    drawing.panel(0, 0, 'height along the middle row', frame((0, 1), (-8 * len(found) + 2, 6), 'x / L', 'height / rms height, shifted by 8'), profiles)
    drawing.panel(1, 0, 'power spectral density', frame(around([1, 512]), around([max(density) * 1e-10, max(density)]), 'wave number q / lowest q',
                                                        'C q_1² / rms height²', 'xy'), spectra)
    tics = ticks('y', [(row['surface'].replace('generated, ', ''), i) for i, row in enumerate(found)]) + ' noenhanced\nset xtics 1e-4,100'
    for column, part in enumerate((5, 2)):
        curves = []
        for number, (kind, look) in enumerate(FILTERS.items()):
            points = [(max(percent_of(case), 1e-4), i + 0.15 * (number - 1)) for i, row in enumerate(found)
                      for case in chosen(row['cases'], part=part, filter=kind)]
            curves.append(drawing.curve(points, f'points ps 1.4 {look}'))
        drawing.panel(column, 1, f'as published, (max - mean)/{part}',
                      frame((1e-4, 200), (len(found) - 0.4, -0.6), '|error| of the load [%]', '', 'x', tics), curves, 165)
    entries += [('fitted power law, times 4', fitted), *((f'coarse grids by {name}', f'points ps 1.4 {look}') for name, look in FILTERS.items())]
    drawing.draw(file, [(name.replace('_', ' '), look) for name, look in entries], 3)


def pictures(results, images):
    document = load(results, 'paper')
    for number, draw in {2: figure_2, 4: figure_4, 5: figure_5, 6: figure_6, 8: figure_8, 9: figure_9, 10: figure_10}.items():
        rows = measured(document, f'figure_{number}')
        if rows:
            draw(rows, os.path.join(images, f'paper-figure-{number}.png'))
