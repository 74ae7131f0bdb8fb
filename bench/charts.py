"""Charts by gnuplot: panels of curves above one legend."""
import math
import os
import subprocess

# Colour, dash and marker each tell the lines apart; the colours differ in lightness and for the colour-blind (Okabe & Ito).
STYLES = ['lc rgb "#000000" dt 1 pt 7', 'lc rgb "#D55E00" dt (12,4) pt 9', 'lc rgb "#0072B2" dt (4,3) pt 5',
          'lc rgb "#E69F00" dt (12,4,2,4) pt 13', 'lc rgb "#009E73" dt (2,3) pt 11', 'lc rgb "#CC79A7" dt (8,8) pt 15']
FILTERS = {'subsample': 'pt 9 lc rgb "#D55E00"', 'mean': 'pt 5 lc rgb "#0072B2"', 'max': 'pt 13 lc rgb "#E69F00"'}  # of cascades
OPEN_MARKERS = [6, 8, 4, 12, 10, 14]  # the same shapes, hollow
PROPORTIONAL = 'lw 1.2 lc rgb "#888888" dt (2,4)'
GREY, DASHED = ('lines lw 2 lc rgb "#888888" dt ' + dash for dash in ('1', '(8,5)'))  # of theories
LINEAR = 'unset logscale\nset format "%g"\nset xtics autofreq\nset ytics autofreq\n'

HEAD = '''set terminal pngcairo size {width},{height} font "DejaVu Sans,11" linewidth 1.2
height = {height}.
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
LEGEND = '''reset
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen {top}
set bmargin at screen 0
unset border
unset tics
set xrange [0:1]
set yrange [0:1]
set key at screen 0.5,{below} center top horizontal maxcols {columns} samplen 4 spacing 1.3 Left reverse
plot {entries}
unset multiplot
'''


def line(look):
    return f'linespoints lw 1.6 ps 0.9 {look}'


def style(number):
    return line(STYLES[number % len(STYLES)])


def colour(number):
    return STYLES[number].split(' dt ')[0]


def hollow(number):
    return f'points ps 1.3 lw 1.4 {colour(number)} pt {OPEN_MARKERS[number]}'


def axes(xlabel, ylabel, x, y, more=''):
    """Ranges and labels of a panel, after other settings."""
    return (f'{more}\nset xrange [{x[0]}:{x[1]}]\nset yrange [{y[0]}:{y[1]}]\nset xlabel "{xlabel}" offset 0,0.4\n'
            f'set label 1 "{ylabel}" at screen left, graph 0.5 center rotate')  # gnuplot's own ylabel may lie on wide tick labels


def ticks(axis, places):
    """A line of gnuplot with ticks from pairs (text, place)."""
    return f'set {axis}tics (' + ', '.join(f'"{text}" {place}' for text, place in places) + ')'


class Panels:
    """Panels on a grid above one legend, in pixels; the height is without the legend."""

    def __init__(self, width, height, columns, rows):
        self.size = width, height
        self.columns, self.rows = columns, rows
        self.script, self.blocks = [], 0

    def curve(self, points, look, using=''):
        """Rows of numbers with a look."""
        name = f'$data{self.blocks}'
        self.blocks += 1
        self.script.append(f'{name} << EOD\n' + ''.join(' '.join(map(repr, map(float, row))) + '\n' for row in points) + 'EOD\n')
        return f'{name} {using} with {look}'

    def bars(self, points, look):
        """A curve of (x, y, lower, upper) and its intervals."""
        return [self.curve(points, look), self.curve(points, look.replace('linespoints', 'yerrorbars'), 'using 1:2:3:4')]

    def panel(self, column, row, title, settings, curves, margin=68):
        """margin: for the labels on the left."""
        width, height = self.size
        w, h = width / self.columns, height / self.rows
        left, right = column * w, (column + 1) * w - 18
        self.script.append(f'left = {(left + 11) / width}\nset lmargin at screen {(left + margin) / width}\nset rmargin at screen {right / width}\n'
                           f'set tmargin at screen 1-{row * h + 30}/height\nset bmargin at screen 1-{(row + 1) * h - 50}/height\n'
                           f'set title "{title}" offset 0,-0.6\n{settings}\nplot {", ".join(curves)}\n')

    def draw(self, file, entries, columns):
        width, height = self.size
        columns = min(columns, max(1, int(0.95 * width / (60 + 9 * max(len(name) for name, _ in entries)))))  # gnuplot's widths
        legend = 16 + 23 * math.ceil(len(entries) / columns)
        height += legend
        self.script.append(LEGEND.format(top=legend / height, below=(legend - 6) / height, columns=columns,
                                         entries=', '.join(f'NaN with {look} title "{name}"' for name, look in entries)))
        os.makedirs(os.path.dirname(file), exist_ok=True)
        script = HEAD.format(width=width, height=height, file=file) + ''.join(self.script)
        subprocess.run(['gnuplot', '-d'], input=script.encode(), check=True)


def decades(values):
    """The range of powers of ten around positive values."""
    exponents = [float(f'{value:e}'.split('e')[1]) for value in values if value > 0]
    return 10 ** min(exponents), 10 ** (max(exponents) + 1)
