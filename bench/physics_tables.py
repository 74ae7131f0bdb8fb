"""Tables and pictures of docs/physics.md, from physics.json."""
import math
import os

from charts import OPEN_MARKERS, STYLES, Panels, style
from samples import groups, solved
from store import load
from tables import provenance, table

PERSSON, BUSH = math.sqrt(8 / math.pi), math.sqrt(2 * math.pi)
PRESSURE = 'set xlabel "mean pressure / (E* rms slope)" offset 0,0.4\n'
LINEAR = 'unset logscale\nset format "%g"\nset xtics autofreq\nset ytics autofreq\n'
GREY = 'lines lw 2 lc rgb "#888888"'


def hollow(number):
    return f'points ps 1.3 lw 1.4 {STYLES[number].split(" dt ")[0]} pt {OPEN_MARKERS[number]}'


def curve(document, key):
    return [(row['pressure'], row[key]) for row in document['curve'] if row.get(key) is not None]


def area_picture(document, file):
    drawing = Panels(800, 430, 2, 1, 90)
    raw, corrected = curve(document, 'area'), curve(document, 'corrected_area')
    bush = f'(x < {1 / BUSH!r} ? {BUSH!r}*x : 1/0)'
    drawing.panel(0, 0, 'contact area', 'set format "%g"\nset xrange [0.003:3]\nset yrange [0.005:2]\n' + PRESSURE +
                  'set ylabel "contact area / nominal area" offset 1,0',
                  [f'erf(sqrt(2)*x) with {GREY} dt 1', f'{bush} with {GREY} dt (8,5)',
                   f'{drawing.block(raw)} with {hollow(1)}', f'{drawing.block(corrected)} with {style(2)}'])
    spread = [(row['pressure'], *(row['corrected_ratio'][key] for key in ('mean', 'lowest', 'highest'))) for row in document['curve']]
    bars = drawing.block(spread)
    look = style(2).replace('linespoints', '')
    drawing.panel(1, 0, 'area per pressure', LINEAR + 'set logscale x\nset xrange [0.003:3]\nset yrange [0:3]\n' + PRESSURE +
                  'set ylabel "A E* slope / F" offset 1,0',
                  [f'erf(sqrt(2)*x)/x with {GREY} dt 1', f'{BUSH!r} with {GREY} dt (8,5)',
                   f'{drawing.block([(p, a / p) for p, a in raw])} with {hollow(1)}',
                   f'{bars} with linespoints {look}', f'{bars} using 1:2:3:4 with yerrorbars {look}'])
    drawing.draw(file, [('cells in contact', hollow(1)), ('corrected; bars: all surfaces', style(2)), ('Persson, erf(√2 p)', GREY + ' dt 1'),
                        ('Bush, Gibson, Thomas, √(2π) p', GREY + ' dt (8,5)')], 2)


def gap_picture(document, file):
    drawing = Panels(800, 400, 2, 1, 60)
    fits = document['fits']
    gaps = [(row['mean_gap'], row['pressure']) for row in document['curve']]
    u0 = fits['decay']['mean']
    inside = [(u, p) for u, p in gaps if fits['from'] <= p <= fits['to']]
    beta = math.exp(sum(math.log(p) + u / u0 for u, p in inside) / len(inside))
    drawing.panel(0, 0, 'pressure against mean gap', LINEAR + 'set logscale y\nset xrange [0:*]\nset yrange [0.002:3]\n'
                  'set xlabel "mean gap / rms height" offset 0,0.4\nset ylabel "mean pressure / (E* rms slope)" offset 1,0',
                  [f'{beta!r}*exp(-x/{u0!r}) with {GREY} dt 1', f'{drawing.block(gaps)} with {style(2)}'])
    stiffness = curve(document, 'stiffness')
    drawing.panel(1, 0, 'contact stiffness', 'set logscale xy\nset format "%g"\nset xrange [0.003:3]\nset yrange [*:*]\n' + PRESSURE +
                  'set ylabel "K rms height / (E* rms slope A0)" offset 1.5,0',
                  [f'x/{fits["stiffness_decay"]["mean"]!r} with {GREY} dt (8,5)', f'{drawing.block(stiffness)} with {style(1)}'])
    drawing.draw(file, [('mean gap', style(2)), ('exponential fit', GREY + ' dt 1'), ('stiffness of the last step', style(1)),
                        ('proportional to the load', GREY + ' dt (8,5)')], 2)


def shown(document):
    """Rows with distributions, by pressure."""
    rows = [row for row in solved(document['rows']) if row['n'] == document['surface']['points'] and 'patch_octaves' in row]
    return sorted(groups(rows, 'pressure').items())


def patch_density(document, rows):
    """(area, patches per area and nominal area), in squares of the shortest wave, by octaves of cells."""
    wave = document['surface']['points'] / document['surface']['cut_off']
    points = []
    for k in range(max(len(row['patch_octaves']) for row in rows)):
        count = sum(row['patch_octaves'][k] for row in rows if k < len(row['patch_octaves'])) / len(rows)
        # Sizes 2^k .. 2^(k+1) - 1: their number and their geometric mean.
        sizes, middle = 2**k, math.sqrt(2**k * max(2**(k + 1) - 1, 1))
        if count > 0:
            points.append((middle / wave**2, count / sizes * wave**2 / document['surface']['cut_off']**2))
    return points


def persson_density(pressure):
    # The variance of the pressure in full contact is a quarter of (E* slope)^2.
    return (f'sqrt(2/pi)*(exp(-2*(x-{pressure!r})**2)-exp(-2*(x+{pressure!r})**2))')


def pressure_density(rows):
    width = rows[0]['histogram']['width']
    values = [row['histogram']['density'] for row in rows]
    return [((k + 0.5) * width, sum(value[k] for value in values) / len(values)) for k in range(len(values[0]))]


def distribution_picture(document, file):
    drawing = Panels(800, 450, 2, 1, 90)
    hurst = document['surface']['hurst']
    patches, pressures, entries = [], [], []
    for number, ((pressure,), rows) in enumerate(shown(document)):
        points = patch_density(document, rows)
        if number == 1:
            x, y = points[len(points) // 2]
            slope = 2 - hurst / 2
            patches.append(f'{3 * y!r}*(x/{x!r})**(-{slope!r}) with {GREY} dt (8,5)')
        patches.append(f'{drawing.block(points)} with {style(number)}')
        pressures += [f'{drawing.block(pressure_density(rows))} with {hollow(number)}',
                      f'{persson_density(pressure)} with lines lw 1.4 {STYLES[number].split(" dt ")[0]} dt 1']
        entries.append((f'p = {pressure:g} E* slope', style(number)))
    drawing.panel(0, 0, 'patch sizes', 'set format "10^{%T}"\nset xrange [*:*]\nset yrange [*:*]\n'
                  'set xlabel "area of a patch / λ_s²" offset 0,0.4\nset ylabel "patches per area / (A0 / λ_s⁴)" offset 1.2,0', patches)
    drawing.panel(1, 0, 'pressures (hollow), Persson (lines)', LINEAR + 'set xrange [0:2]\nset yrange [0:*]\n'
                  'set xlabel "pressure / (E* rms slope)" offset 0,0.4\nset ylabel "density over all points" offset 1,0', pressures)
    drawing.draw(file, entries + [(f'area^{{-(2-H/2)}}, H = {hurst:g}', GREY + ' dt (8,5)')], 2)


def mesh_picture(document, file):
    drawing = Panels(800, 420, 2, 1, 80)
    areas, errors, entries = [], [], []
    for number, ((pressure,), rows) in enumerate(groups(document['meshes'], 'pressure').items()):
        limit = rows[-1]['area'] / (1 + rows[-1]['raw_error'])
        number += 1
        for key, error, look in (('area', 'raw_error', hollow(number)), ('corrected_area', 'corrected_error', style(number))):
            areas.append(f'{drawing.block([(1 / row["cells_a_wave"], row[key] / limit) for row in rows])} with {look}')
            errors.append(f'{drawing.block([(row["cells_a_wave"], 100 * max(abs(row[error]), 1e-6)) for row in rows])} with {look}')
        entries += [(f'cells, p = {pressure:g} E* slope', hollow(number)), (f'corrected, p = {pressure:g} E* slope', style(number))]
    drawing.panel(0, 0, 'area against cell size', LINEAR + 'set xrange [0:*]\nset yrange [*:*]\n'
                  'set xlabel "cell size / shortest wave" offset 0,0.4\nset ylabel "area / area for cells of no size" offset 1,0',
                  [f'1 with {GREY} dt 1'] + areas)
    drawing.panel(1, 0, 'error of the area', 'set logscale xy\nset format "%g"\nset xrange [3:90]\nset yrange [*:*]\n'
                  'set xtics (4,8,16,32,64)\nset xlabel "cells in the shortest wave" offset 0,0.4\nset ylabel "error [%]" offset 1,0',
                  errors)
    drawing.draw(file, entries, 2)


PICTURES = {'area': area_picture, 'gap': gap_picture, 'patches': distribution_picture, 'mesh': mesh_picture}


def spread_of(fit, digits):
    return f'{fit["mean"]:.{digits}f} ({fit["lowest"]:.{digits}f} to {fit["highest"]:.{digits}f})'


def fit_table(document):
    fits = document['fits']
    rows = [['κ, cells in contact', spread_of(fits['kappa'], 2)], ['κ, corrected area', spread_of(fits['corrected_kappa'], 2)],
            ['κ, Persson: √(8/π)', f'{PERSSON:.2f}'], ['κ, Bush, Gibson & Thomas: √(2π)', f'{BUSH:.2f}'],
            ['u0 / rms height, by the mean gap', spread_of(fits['decay'], 3)],
            ['u0 / rms height, by the stiffness', spread_of(fits['stiffness_decay'], 3)]]
    return table(['', 'mean (lowest to highest surface)'], rows)


def curve_table(document):
    rows = [[f'{row["pressure"]:g}', f'{100 * row["area"]:.2f}', f'{100 * row["corrected_area"]:.2f}', f'{100 * row["persson"]:.2f}',
             f'{row["corrected_ratio"]["mean"]:.2f}', f'{row["mean_gap"]:.3f}', f'{row["decay"]:.3f}' if 'decay' in row else '',
             f'{row["patches"]:.0f}', f'{100 * row["largest_patch"]:.0f}'] for row in document['curve']]
    return table(['p / (E* slope)', 'A/A0 [%]', 'corrected [%]', 'Persson [%]', 'κ, corrected', 'mean gap / rms', 'p / (K rms)', 'patches',
                  'largest [% of the contact]'], rows)


def mesh_table(document):
    rows = [[f'{row["pressure"]:g}', f'{row["n"]}²', f'{row["cells_a_wave"]:g}',
             *(f'{100 * row[key]:.3f}' for key in ('area', 'corrected_area')),
             *(f'{100 * row[key]:+.2f}' for key in ('raw_error', 'corrected_error'))] for row in document['meshes']]
    return table(['p / (E* slope)', 'grid', 'cells in the shortest wave', 'A/A0 [%]', 'corrected [%]', 'error [%]', 'corrected, error [%]'],
                 rows)


def sections(results):
    document = load(results, 'physics')
    return {'fits': fit_table(document), 'curve': curve_table(document), 'meshes': mesh_table(document), 'provenance': provenance(document)}


def pictures(results, images):
    document = load(results, 'physics')
    for name, draw in PICTURES.items():
        draw(document, os.path.join(images, f'physics-{name}.png'))
