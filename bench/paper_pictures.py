"""The pictures of docs/paper.md, from paper.json. What has not been measured is left out."""
import math
import os

from charts import PROPORTIONAL, STYLES as LOOKS, Panels, line
from paper_rows import METHODS, reduced_force, rows
from samples import median_interval, values_of
from store import load

# A colour a family, a dash and a marker a variant.
METHOD_LOOKS = dict(zip(METHODS, [
    'lc rgb "#D55E00" dt 1 pt 9', 'lc rgb "#000000" dt 1 pt 7', 'lc rgb "#000000" dt (4,3) pt 6', 'lc rgb "#CC79A7" dt (8,8) pt 15',
    'lc rgb "#0072B2" dt 1 pt 5', 'lc rgb "#0072B2" dt (4,3) pt 4', 'lc rgb "#E69F00" dt 1 pt 13', 'lc rgb "#009E73" dt (2,3) pt 11',
    'lc rgb "#56B4E9" dt (12,4,2,4) pt 12']))


def with_intervals(drawing, points, look):
    """Curves of (x, median, lower, upper)."""
    name = drawing.block(points)
    bar = look.split(' pt ')[0]
    return [f'{name} using 1:2:3:4 with yerrorbars lw 1 {bar} pt -1', f'{name} using 1:2 with {line(look)}']


def range_and_tics(axis, low, high, log):
    if not log:
        return f'set {axis}range [{low!r}:{high!r}]\nset {axis}tics autofreq\nset format {axis} "%g"\n'
    text = f'set logscale {axis}\nset {axis}range [{low!r}:{high!r}]\n'
    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    if last - first > 3:
        return text + f'set {axis}tics autofreq\nset format {axis} "10^{{%T}}"\n'
    tics = ','.join(f'{digit * 10.0**power:g}' for power in range(first, last + 1) for digit in ((1, 3) if axis == 'x' and last - first > 2 else (1, 2, 5)))
    return text + f'set {axis}tics ({tics})\nset format {axis} "%g"\n'


def axes(x, y, xlabel, ylabel, logx=False, logy=False):
    return ('unset logscale\nunset label\nunset object\n' + range_and_tics('x', *x, logx) + range_and_tics('y', *y, logy) +
            f'set xlabel "{xlabel}" offset 0,0.4\nset ylabel "{ylabel}" offset 1.2,0')


def around(values, log=True, spare=0.06):
    """A range with room around values."""
    values = list(values)
    low, high = min(values), max(values)
    if log:
        return low / 1.5, high * 1.5
    room = spare * ((high - low) or 1)
    return low - room, high + room


def figure_2(document, file):
    row = rows(document, 'figure_2')[0]
    drawing = Panels(800, 720, 1, 3, 45)
    numbers = range(1, len(row['u']) + 1)
    x = (0, len(row['u']) + 1)

    def stems(values, look):
        name = drawing.block(list(zip(numbers, values)))
        return [f'{name} with impulses lw 1 lc rgb "#999999"', f'{name} with points ps 0.8 {look}']

    drawing.panel(0, 0, 'compenetration', axes(x, (0, 1.05), 'element', 'u [length]'), stems(row['u'], LOOKS[0]))
    negative = [(i, value) for i, value in zip(numbers, row['w']) if value < -1e-9]
    drawing.panel(0, 1, 'gap that greedy elimination leaves', axes(x, around(row['w'], log=False), 'element', 'w [length]'),
                  stems(row['w'], LOOKS[0]) + [f'{drawing.block(negative)} with points ps 1.6 lw 2 lc rgb "#D55E00" pt 6'])
    drawing.panel(0, 2, 'force', axes(x, around([0, *row['greedy'], *row['exact']], log=False), 'element', 'p/E* [length²]'),
                  stems(row['greedy'], LOOKS[0]) + [f'{drawing.block(list(zip(numbers, row["exact"])))} with points ps 1.2 lw 1.5 lc rgb "#009E73" pt 4'])
    drawing.draw(file, [('greedy', f'points ps 0.8 {LOOKS[0]}'), ('w < 0: overlap', 'points ps 1.6 lw 2 lc rgb "#D55E00" pt 6'),
                        ('solution (NNLS)', 'points ps 1.2 lw 1.5 lc rgb "#009E73" pt 4')], 3)


def figure_4(document, file):
    drawing = Panels(800, 480, 2, 1, 110)
    for column, setting in enumerate(('dense', 'fft')):
        found = rows(document, 'figure_4', setting=setting, seed=1)
        curves, everything = [], []
        for row in sorted(found, key=lambda r: METHODS.index(r['method'])):
            points = [(reduced_force(row, step), step['cpu_seconds']) for step in row['steps'] if step['mean_pressure'] > 0]
            everything += points
            curves.append(f'{drawing.block(points)} with {line(METHOD_LOOKS[row["method"]])}')
        side = found[0]['points_a_side']
        words = f'dense products, {found[0]["steps_of_ten"]} steps of 10' if setting == 'dense' else 'FFT products'
        drawing.panel(column, 0, f'{side}² points, {words}',
                      axes(around(x for x, _ in everything), around(y for _, y in everything),
                           'P/(E* A), rms height L/100', 'CPU time of a step [s]', True, True), curves)
    drawing.draw(file, [(name.replace('P&K', 'Polonsky, Keer'), line(METHOD_LOOKS[name])) for name in METHODS], 3)


INNERS = ['cg', 'cholesky', 'gauss-seidel', 'gauss-seidel, matrix stored before']


def inner_seconds(row, inner):
    return row['cpu_seconds'] - row['storing_seconds'] if inner == INNERS[3] else row['cpu_seconds']


def figure_5(document, file):
    found = rows(document, 'figure_5')
    drawing = Panels(800, 440, 2, 1, 80)
    times, shares, every_time, every_share = [], [], [], []
    for number, inner in enumerate(INNERS):
        points, relative = [], []
        for n in values_of(found, 'n'):
            mine = {r['seed']: inner_seconds(r, inner) for r in found if r['n'] == n and r['inner'] == inner.split(',')[0]}
            cg = {r['seed']: r['cpu_seconds'] for r in found if r['n'] == n and r['inner'] == 'cg'}
            both = sorted(mine.keys() & cg.keys())
            if not both:
                continue
            points.append((n, *median_interval([mine[seed] for seed in both])))
            relative.append((n, *median_interval([mine[seed] / cg[seed] for seed in both])))
        if not points:
            continue
        times += with_intervals(drawing, points, LOOKS[number])
        shares += with_intervals(drawing, relative, LOOKS[number])
        every_time += [value for point in points for value in point[1:]]
        every_share += [value for point in relative for value in point[1:]]
    x = around(values_of(found, 'n'))
    drawing.panel(0, 0, 'greedy elimination', axes(x, around(every_time), 'candidates n', 'CPU time [s]', True, True), times)
    drawing.panel(1, 0, 'relative to conjugate gradients', axes(x, around(every_share), 'candidates n', 'ratio of CPU times', True, True), shares)
    names = ['conjugate gradients', 'Cholesky', 'Gauss-Seidel', 'Gauss-Seidel, storing not counted']
    drawing.draw(file, [(name, line(look)) for name, look in zip(names, LOOKS)], 2)


def figure_6(document, file):
    found = rows(document, 'figure_6')
    steps = sorted({r['projections'] for r in found})
    drawing = Panels(800, 460, 2, 1, 100)
    curves, everything = [], []
    for number, count in enumerate(steps):
        for row in [r for r in found if r['projections'] == count and r['pivoting'] == 'single' and r['seed'] == 1]:
            points = [(step['candidates'], step['cpu_seconds']) for step in row['steps'] if step['contacts'] > 0]
            everything += points
            curves.append(f'{drawing.block(points)} with {line(LOOKS[number])}')
    drawing.panel(0, 0, 'one exchange a solve, as published', axes(around(x for x, _ in everything), around(y for _, y in everything),
                                                                 'candidates n of a step', 'CPU time of a step [s]', True, True), curves)
    totals, every_total = [], []
    for number, pivoting in enumerate(('single', 'block')):
        points = []
        for count in steps:
            seconds = [r['cpu_seconds'] for r in found if r['projections'] == count and r['pivoting'] == pivoting]
            if seconds:
                points.append((count, *median_interval(seconds)))
        every_total += [value for point in points for value in point[1:]]
        totals += with_intervals(drawing, points, LOOKS[4 + number] if number else 'lc rgb "#555555" dt 1 pt 6')
    drawing.panel(1, 0, 'ten steps together', axes((-10, 210), around(every_total), 'projections K before NNLS', 'CPU time [s]', False, True), totals)
    drawing.draw(file, [(f'K = {count}', line(LOOKS[number])) for number, count in enumerate(steps)] +
                 [('one exchange a solve', line('lc rgb "#555555" dt 1 pt 6')), ('blocks', line(LOOKS[5]))], 4)


def percent_of(row, part=None):
    return 100 * abs((row[part] if part else row)['load_error'])


def figure_8(document, file):
    found = rows(document, 'figure_8')
    exponents = values_of(found, 'hurst')
    drawing = Panels(800, 760, 2, 2, 70)
    x = (exponents[0] - 0.05, exponents[-1] + 0.05)

    def series(chosen, value):
        return [(h, *median_interval([value(r) for r in chosen if r['hurst'] == h])) for h in exponents
                if any(r['hurst'] == h for r in chosen)]

    def panel(column, row, title, label, lines, log):
        curves, everything = [], []
        for points, look in lines:
            curves += with_intervals(drawing, points, look)
            everything += [value for point in points for value in point[1:]]
        if log:
            curves.append(f'2 with lines {PROPORTIONAL}')
        low, high = around([value for value in everything if value > 0] + ([2] if log else [1]), log=log)
        drawing.panel(column, row, title, axes(x, (max(low, 1e-3), high) if log else (0, high), 'Hurst exponent H', label, False, log), curves)

    fft, love = [r for r in found if r['backend'] == 'fft' and r['kernel'] == 'eq9'], [r for r in found if r['kernel'] == 'love']
    dense = [r for r in found if r['backend'] == 'dense']
    panel(0, 0, 'load lost, as published', '|error| of the load [%]',
          [(series(fft, percent_of), LOOKS[0]), (series(love, percent_of), LOOKS[1]),
           (series(fft, lambda r: percent_of(r, 'diagonal')), LOOKS[2])], True)
    panel(1, 0, 'candidates that are kept', 'n_p / n', [(series(fft, lambda r: r['kept']), LOOKS[0]),
                                                       (series(love, lambda r: r['kept']), LOOKS[1]),
                                                       (series(fft, lambda r: r['diagonal']['kept']), LOOKS[2])], False)
    for column, (of, title) in enumerate(((dense, 'dense products, NNLS'), (fft, 'FFT products, conjugate gradients'))):
        panel(column, 1, 'time: ' + title, 'CPU time / that of the whole problem',
              [(series(of, lambda r: r['cpu_seconds'] / r['whole_cpu_seconds']), LOOKS[0]),
               (series(of, lambda r: r['diagonal']['cpu_seconds'] / r['whole_cpu_seconds']), LOOKS[2]),
               (series(of, lambda r: r['certified_cpu_seconds'] / r['whole_cpu_seconds']), LOOKS[4])], False)
    drawing.draw(file, [('Algorithm 6, radius h δ, eq9', line(LOOKS[0])), ('the same, love', line(LOOKS[1])),
                        ('radius h √2 δ, eq9', line(LOOKS[2])), ('certified, eq9', line(LOOKS[4])),
                        ('2 %', f'lines {PROPORTIONAL}')], 3)


def figure_9(document, file):
    found = rows(document, 'figure_9')
    drawing = Panels(800, 430, 2, 1, 80)
    radii = [entry['h'] for entry in found[0]['radii']]
    x = (radii[0] - 0.1, radii[-1] + 0.1)

    def series(backend, value):
        return [(h, *median_interval([value(r['radii'][i], r) for r in found if r['backend'] == backend])) for i, h in enumerate(radii)]

    errors = series('fft', lambda entry, _: percent_of(entry))
    drawing.panel(0, 0, 'load lost', axes(x, around([v for point in errors for v in point[1:] if v > 0] + [0.01, 1]), 'h', '|error| of the load [%]',
                                          False, True), with_intervals(drawing, errors, LOOKS[0]))
    lines = [series('fft', lambda entry, _: entry['kept']), series('dense', lambda entry, row: entry['cpu_seconds'] / row['whole_cpu_seconds']),
             series('fft', lambda entry, row: entry['cpu_seconds'] / row['whole_cpu_seconds']),
             series('dense', lambda entry, row: entry['certified_cpu_seconds'] / row['whole_cpu_seconds'])]
    curves = [curve for points, look in zip(lines, LOOKS[1:]) for curve in with_intervals(drawing, points, look)]
    drawing.panel(1, 0, 'candidates and time', axes(x, (0, 1.05 * max(v for points in lines for point in points for v in point[1:])), 'h', 'ratio'), curves)
    names = ['|error| of the load', 'n_p / n', 'CPU time, dense products', 'CPU time, FFT products', 'certified, dense products']
    drawing.draw(file, [(name, line(look)) for name, look in zip(names, LOOKS)], 3)


FILTERS = ['subsample', 'mean', 'max']
FILTER_LOOKS = ['pt 9 lc rgb "#D55E00"', 'pt 5 lc rgb "#0072B2"', 'pt 13 lc rgb "#E69F00"']


def figure_10(document, file):
    found = rows(document, 'figure_10')
    legend, height = 160, 910
    drawing = Panels(800, height, 2, 2, legend)
    profiles, spectra, density = [], [], []
    for number, row in enumerate(found):
        rms, count = row['rms_height'], len(row['profile'])
        look = LOOKS[number % len(LOOKS)].rsplit(' pt', 1)[0]
        points = [(i / count, value / rms - 8 * number) for i, value in enumerate(row['profile'])]
        profiles.append(f'{drawing.block(points)} with lines lw 1 {look}')
        # Lengths in units of the longest wave, densities in those of a flat spectrum of the same variance.
        longest, area = row['q'][0], rms**2 / row['q'][0]**2
        points = [(q / longest, psd / area) for q, psd in zip(row['q'], row['psd']) if psd > 0]
        density += [psd for _, psd in points]
        spectra.append(f'{drawing.block(points)} with lines lw 1.4 {look}')
        if row['q_min'] and row['q_max']:
            fit = [(q / longest, row['prefactor'] * q**row['slope'] / area * 4) for q in (row['q_min'], row['q_max'])]
            spectra.append(f'{drawing.block(fit)} with lines lw 1 lc rgb "#888888" dt 1')
    drawing.panel(0, 0, 'height along the middle row', axes((0, 1), (-8 * len(found) + 2, 6), 'x / L', 'height / rms height, shifted by 8'), profiles)
    drawing.panel(1, 0, 'power spectral density', axes(around([1, 512]), around([max(density) * 1e-10, max(density)]), 'wave number q / lowest q',
                                                       'C q_1² / rms height²', True, True), spectra)
    tics = ', '.join(f'"{row["surface"].replace("generated, ", "")}" {i}' for i, row in enumerate(found))
    for column, (part, words) in enumerate(((5, '(max - mean)/5, the paper\'s'), (2, '(max - mean)/2'))):
        curves = []
        for number, kind in enumerate(FILTERS):
            points = [(i + 0.15 * (number - 1), max(percent_of(case), 1e-4)) for i, row in enumerate(found) for case in row['cases']
                      if case['part'] == part and case['filter'] == kind]
            curves.append(f'{drawing.block(points)} with points ps 1.4 {FILTER_LOOKS[number]}')
        settings = axes((-0.6, len(found) - 0.4), (1e-4, 200), '', '|error| of the load [%]', False, True)
        settings += f'\nset xtics ({tics}) rotate by 25 right font ",8" noenhanced\nset bmargin at screen {(legend + 80) / height}\nunset xlabel'
        drawing.panel(column, 1, f'as published, approach {words}', settings, curves)
    entries = [(f'{row["surface"]}', f'lines lw 1.4 {LOOKS[i % len(LOOKS)].rsplit(" pt", 1)[0]}') for i, row in enumerate(found)]
    entries += [('fitted power law, times 4', 'lines lw 1 lc rgb "#888888" dt 1')]
    entries += [(f'coarse grids by {name}', f'points ps 1.4 {look}') for name, look in zip(FILTERS, FILTER_LOOKS)]
    drawing.draw(file, [(name.replace('_', ' '), look) for name, look in entries], 3)


FIGURES = {2: figure_2, 4: figure_4, 5: figure_5, 6: figure_6, 8: figure_8, 9: figure_9, 10: figure_10}


def pictures(results, images):
    document = load(results, 'paper')
    for number, draw in FIGURES.items():
        if rows(document, f'figure_{number}'):
            draw(document, os.path.join(images, f'paper-figure-{number}.png'))
