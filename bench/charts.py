#!/usr/bin/env python3
"""charts.py RESULTS IMAGES [NAME...]: draws scaling.png and failures.png, or those named, into the folder IMAGES from the JSON files
in the folder RESULTS, with gnuplot."""
import os
import subprocess
import sys

from results import groups, load, scaling_rows, total_seconds

# Colour, dash and marker each tell the lines apart; the colours differ in lightness and for the colour-blind (Okabe & Ito).
STYLES = ['lc rgb "#000000" dt 1 pt 7', 'lc rgb "#D55E00" dt (12,4) pt 9', 'lc rgb "#0072B2" dt (4,3) pt 5',
          'lc rgb "#E69F00" dt (12,4,2,4) pt 13', 'lc rgb "#009E73" dt (2,3) pt 11', 'lc rgb "#CC79A7" dt (8,8) pt 15']
OPEN_MARKERS = [6, 8, 4, 12, 10, 14]  # the same shapes, hollow
PROPORTIONAL = 'lw 1.2 lc rgb "#888888" dt (2,4)'
TARGET = 'lines lw 1 lc rgb "#AA0000" dt 1'

HEAD = '''set terminal pngcairo size {width},{height} font "DejaVu Sans,11" linewidth 1.2
set output "{file}"
set encoding utf8
set multiplot
set logscale xy
set format "10^{{%T}}"
set grid lc rgb "#E6E6E6" lt 1
set border lc rgb "#555555"
set tics scale 0.6
set key off
'''


def style(number):
    return f'linespoints lw 1.6 ps 0.9 {STYLES[number % len(STYLES)]}'


class Panels:
    """Panels on a grid above one legend, in pixels."""

    def __init__(self, width, height, columns, rows, legend):
        self.size = width, height
        self.columns, self.rows, self.legend = columns, rows, legend
        self.script, self.blocks = [], 0

    def block(self, points):
        name = f'$data{self.blocks}'
        self.blocks += 1
        lines = ''.join(f'{x!r} {y!r}\n' for x, y in points)
        self.script.append(f'{name} << EOD\n{lines}EOD\n')
        return name

    def panel(self, column, row, title, settings, curves):
        width, height = self.size
        w, h = width / self.columns, (height - self.legend) / self.rows
        left, right = column * w + 68, (column + 1) * w - 18
        top, bottom = height - row * h - 30, height - (row + 1) * h + 50
        self.script.append(f'set lmargin at screen {left / width}\nset rmargin at screen {right / width}\n'
                           f'set tmargin at screen {top / height}\nset bmargin at screen {bottom / height}\n'
                           f'set title "{title}" offset 0,-0.6\n{settings}\nplot {", ".join(curves)}\n')

    def draw(self, file, entries, columns):
        width, height = self.size
        self.script.append(f'''reset
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen {self.legend / height}
set bmargin at screen 0
unset border
unset tics
set xrange [0:1]
set yrange [0:1]
set key at screen 0.5,{(self.legend - 6) / height} center top horizontal maxcols {columns} samplen 4 spacing 1.3 Left reverse
plot {", ".join(f'NaN with {look} title "{name}"' for name, look in entries)}
unset multiplot
''')
        script = HEAD.format(width=width, height=height, file=file) + ''.join(self.script)
        subprocess.run(['gnuplot', '-d'], input=script.encode(), check=True)


def decades(values):
    """The range of powers of ten around positive values."""
    exponents = [float(f'{value:e}'.split('e')[1]) for value in values if value > 0]
    return 10 ** min(exponents), 10 ** (max(exponents) + 1)


def scaling(results, file):
    document = load(results, 'scaling')
    rows = scaling_rows(document)
    single = scaling_rows(document, tol=1e-4, precision='single')
    areas = [(area,) for area in sorted({r['area_wanted'] for r in rows + single})]
    hollow = 'points ps 1.5 lw 1.4 lc rgb "#555555"'
    drawing = Panels(800, 830, 2, 2, 110)

    def curves(value, of=rows):
        result = []
        families = groups(of, 'area_wanted', 'control')
        for (area, control), found in families.items():
            second = control == 'load' and (area, 'displacement') in families
            points = drawing.block([(r['n'] ** 2, value(r)) for r in found])
            number = areas.index((area,))
            look = f'{hollow} pt {OPEN_MARKERS[number % len(OPEN_MARKERS)]}' if second else style(number)
            result.append(f'{points} with {look}')
        return result

    def target(value):
        return f'{value!r} with {TARGET}'

    sides = sorted({r['n'] for r in rows + single})
    tics = ', '.join(f'"{n}²" {n * n}' for n in sides[-1::-2][::-1])
    settings = f'set xrange [{sides[0] ** 2 / 1.6}:{sides[-1] ** 2 * 1.6}]\nset xtics ({tics})\nset xlabel "points" offset 0,0.4\n'

    def seconds_axis(of):
        lowest, highest = decades([total_seconds(r) for r in of])
        return (settings + f'set format y "10^{{%T}}"\nset yrange [{lowest}:{highest}]\nset ytics autofreq\n'
                'set ylabel "set-up and solve [s]" offset 1.2,0')

    slope = 0.25 * min(total_seconds(r) / r['n'] ** 2 for r in rows if r['n'] == max(r['n'] for r in rows))
    drawing.panel(0, 0, 'time to certified 10^{-8}', seconds_axis(rows),
                  curves(total_seconds) + [f'{slope!r}*x with lines {PROPORTIONAL}'])
    drawing.panel(1, 0, 'products with H', settings + 'set format y "%g"\nset yrange [2:200]\n'
                  'set ytics (2,5,10,20,30,50,100,200)\nset ylabel "products" offset 1,0', curves(lambda r: r['products']) + [target(30)])
    memory = settings + ('set format y "%g"\nset yrange [4:2000]\nset ytics (5,10,20,50,100,200,500,1000,2000)\n'
                         'set ylabel "peak memory [bytes/point]" offset 1,0')
    drawing.panel(0, 1, 'memory beside gap and pressure', memory,
                  curves(lambda r: max(r['bytes_per_point'], 1e-3)) + [target(110)])
    if single:
        drawing.panel(1, 1, 'single precision, time to certified 10^{-4}', seconds_axis(single), curves(total_seconds, single))
    entries = [(f'{100 * area:g} % contact', style(number)) for number, (area,) in enumerate(areas)]
    entries += [('load control (hollow)', hollow + ' pt 6'), ('proportional to points', f'lines {PROPORTIONAL}'), ('target', TARGET)]
    drawing.draw(file, entries, 3)


def failures(results, file):
    data = load(results, 'failures')['data']
    drawing = Panels(800, 530, 2, 1, 150)
    drawing.script.append('unset logscale\nset format "%g"\n')
    kernels = list(groups(data['greedy'], 'kernel'))
    curves = []
    for number, (kernel,) in enumerate(kernels):
        line = [r for r in data['greedy'] if r['kernel'] == kernel and r['spacing'] == 1]
        shift = 1 + 0.05 * (number - 2)  # so that the kernels that never fail do not hide each other
        name = f'$greedy{number}'
        drawing.script.append(f'{name} << EOD\n' + ''.join(
            f'{shift * r["n"]!r} {100 * r["share"]!r} {100 * r["lower"]!r} {100 * r["upper"]!r}\n' for r in line) + 'EOD\n')
        look = style(number).replace('linespoints', '')
        curves += [f'{name} with linespoints {look}', f'{name} using 1:2:3:4 with yerrorbars {look}']
    drawing.panel(0, 0, 'greedy: share of wrong answers, Example 1',
                  'set logscale x\nset xrange [18:560]\nset yrange [-3:100]\nset xtics (25,100,400)\n'
                  'set xlabel "points n" offset 0,0.4\nset ylabel "% of draws" offset 1.5,0', curves)

    surfaces = [name for (name,) in groups(data['cmr'], 'surface')]
    tics = ', '.join(f'"{name}" {i}' for i, name in enumerate(surfaces))

    def largest(surface, kind, key):
        return 100 * max(abs(r[key]) for r in data['cmr'] if r['surface'] == surface and r['filter'] == kind)

    looks = [('subsample', 'plain_error'), ('mean', 'plain_error'), ('max', 'plain_error'), ('max', 'certified_error')]
    styles = ['pt 9 lc rgb "#D55E00"', 'pt 5 lc rgb "#0072B2"', 'pt 13 lc rgb "#E69F00"', 'pt 7 lc rgb "#000000"']
    curves = [drawing.block([(i, max(largest(surface, kind, key), 1e-8)) for i, surface in enumerate(surfaces)]) +
              f' with points ps 1.3 {styles[number]}' for number, (kind, key) in enumerate(looks)]
    drawing.panel(1, 0, 'cascade multi-resolution: error of the load',
                  f'unset logscale x\nset logscale y\nset format y "10^{{%T}}"\nset xrange [-0.6:{len(surfaces) - 0.4}]\nset yrange [1e-8:200]\n'
                  f'set ytics 1e-8,100,100\nset xtics ({tics}) rotate by 25 right font ",8" noenhanced\nset bmargin at screen {(150 + 85) / 530}\n'
                  'unset xlabel\nset ylabel "% of the load" offset 1,0', curves)
    entries = [(f'kernel {kernel}', style(number)) for number, (kernel,) in enumerate(kernels)]
    names = ['as published, sub-sampled', 'as published, mean', 'as published, max', 'certified']
    entries += [(name, f'points ps 1.3 {look}') for name, look in zip(names, styles)]
    drawing.draw(file, entries, 2)


CHARTS = {'scaling': scaling, 'failures': failures}


def main():
    results, images, *names = sys.argv[1:]
    os.makedirs(images, exist_ok=True)
    for name in names or CHARTS:
        CHARTS[name](results, os.path.join(images, name + '.png'))


if __name__ == '__main__':
    main()
