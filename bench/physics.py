"""Area, mean gap, stiffness, patches and pressures of rough surfaces against load, elastic and with a hardness, beside the theories of rough
contact: the rows, tables and pictures of docs/development/physics.md."""
import math
import os
import sys
from statistics import fmean, linear_regression

import numpy as np
import roughcontact as rc

from case import Failure
from charts import DASHED, GREY, LINEAR, Panels, axes, colour, hollow, style
from contact import OK, status_of
from options import ALL_THREADS, listed, question, ranged, side
from samples import groups, solved
from json_tables import load
from store import Store
from surfaces import self_affine_gap
from tables import provenance, records, show, table

RMS_SLOPE = 0.1
BINS, HIGHEST = 50, 2  # of the histograms, whose end is HIGHEST E* rms slope
# Mean pressures over E* times the rms slope of the surface.
PRESSURES = (0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.3, 0.5, 0.75, 1, 1.5)
SHOWN = (0.01, 0.04, 0.16)  # those with distributions of patches and pressures
MESH_PRESSURES, MESH_SEEDS = (0.02, 0.16), 2  # on all grids, the first surfaces
HARDNESSES, SHARES = (0.25, 1, 2), (0.02, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99)  # over E* times the rms slope; mean pressures over the hardness
LIGHT = 0.04  # area and load are proportional up to this pressure
FITTED = (0.01, 0.2)  # pressure falls exponentially with the mean gap
PERSSON, BUSH = math.sqrt(8 / math.pi), math.sqrt(2 * math.pi)
PRESSURE, PLAIN = 'mean pressure / (E* rms slope)', 'set format "%g"\n'
FREE, PRESSED = ('*', '*'), (0.003, 3)
CURVE = ('p / (E* slope)={pressure:g}; A/A0 [%]={area:%.2f}; corrected [%]={corrected_area:%.2f}; Persson [%]={persson:%.2f}; '
         'κ, corrected={corrected_ratio[mean]:.2f}; mean gap / rms={mean_gap:.3f}; p / (K rms)={decay:.3f}; patches={patches:.0f}; '
         'largest [% of the contact]={largest_patch:%.0f}')
MESHES = ('p / (E* slope)={pressure:g}; grid={n}²; cells in the shortest wave={cells_a_wave:g}; A/A0 [%]={area:%.3f}; '
          'corrected [%]={corrected_area:%.3f}; error [%]={raw_error:%+.2f}; corrected, error [%]={corrected_error:%+.2f}')
HARD = ('hardness / (E* slope)={hardness:g}; p / hardness={share:g}; A/A0 [%]={area:%.2f}; Persson [%]={persson:%.2f}; over p / hardness={excess:.3f}; '
        'at the hardness [% of the contact]={capped:%.1f}; Persson [%]={persson_capped:%.1f}; indentation / rms={indentation:.3f}; products={products:.0f}')


def persson_capped(p, hardness):
    """(area, area at the hardness): what reaches neither end, and the upper one, of a walk from p between 0 and the hardness with the variance of
    the pressures in full contact (Persson, Physical Review Letters 87 (2001) 116101)."""
    terms = [(k, 4 / (math.pi * k) * math.exp(-(math.pi * k / hardness)**2 / 8) * math.sin(math.pi * k * p / hardness)) for k in range(1, 200)]
    capped = p / hardness + sum((-1)**k * term / 2 for k, term in terms)
    return capped + sum(term for k, term in terms if k % 2), capped


class Pressed:
    """One surface on one grid, pressed by growing loads. E*, the side and with it the nominal area are 1."""

    def __init__(self, request, n, seed, stiffness, hardness):
        self.gap = self_affine_gap(n, seed, request.hurst, request.roll_off, request.cut_off, RMS_SLOPE)
        options = {'tol': request.tol, 'threads': request.threads, 'stiffness': int(stiffness)}
        system = rc.HalfSpace((n, n), pitch=1 / n, modulus=1, boundary='periodic', hardness=hardness * RMS_SLOPE or None)
        self.contact = rc.Contact(system, options=options)
        self.mean, self.rms_height = self.gap.mean(), self.gap.std()

    def at(self, pressure, distributions):
        result = self.contact.solve(load=pressure * RMS_SLOPE, undeformed_gap=self.gap, borrow=True, check=False)
        area, cells = result.measure_area(), result.find_patches().cells
        row = {'status': status_of(result), 'products': result.products, 'area': area.area, 'corrected_area': area.corrected_area,
               'mean_gap': (self.mean - result.approach) / self.rms_height}
        if math.isfinite(result.stiffness):  # over E* times slope and nominal area, as the pressure is
            row['stiffness'] = result.stiffness * self.rms_height / RMS_SLOPE
        row.update(patches=len(cells), largest_patch=cells.max() / cells.sum() if len(cells) else 0)
        if result.capped:
            row.update(capped=result.capped / result.contacts, indentation=float(self.contact.indentation().mean()) / self.rms_height)
        if distributions:
            row['patch_octaves'] = np.bincount(np.frexp(cells.astype(float))[1] - 1)  # patches of 2^k .. 2^(k+1) - 1 cells
            found = result.histogram(BINS, HIGHEST * RMS_SLOPE)
            # Density over all points, per pressure over E* rms slope.
            row['histogram'] = {'width': HIGHEST / BINS, 'above': found.above, 'density': found.density * area.area * RMS_SLOPE}
        return row


def spread(values):
    return {'mean': fmean(values), 'lowest': min(values), 'highest': max(values)}


class Summary:
    """The summary of certified rows."""

    def __init__(self, rows, capped, request):
        self.request, self.capped = request, [row for row in capped if row['status'] == OK]
        self.rows = {(row['n'], row['seed'], row['pressure']): row for row in rows if row['status'] == OK}

    def at(self, pressure, n=None):
        keys = [(n or self.request.points, seed, pressure) for seed in self.request.seeds]
        return [self.rows[key] for key in keys if key in self.rows]

    def curve(self):
        for pressure in PRESSURES:
            found = self.at(pressure)
            if not found:
                continue
            entry = {'pressure': pressure, 'persson': math.erf(math.sqrt(2) * pressure)}
            for key in ('area', 'corrected_area', 'mean_gap', 'stiffness', 'patches', 'largest_patch'):
                if all(key in row for row in found):
                    entry[key] = fmean(row[key] for row in found)
            entry['corrected_ratio'] = spread([row['corrected_area'] / pressure for row in found])
            if 'stiffness' in entry:
                entry['decay'] = pressure / entry['stiffness']
            yield entry

    def fits(self):
        found = {'kappa': [], 'corrected_kappa': [], 'decay': [], 'stiffness_decay': []}
        for seed in self.request.seeds:
            rows = [row for pressure in PRESSURES for row in self.at(pressure) if row['seed'] == seed]
            light = [row for row in rows if row['pressure'] <= LIGHT]
            middle = [row for row in rows if FITTED[0] <= row['pressure'] <= FITTED[1]]
            for name, key in (('kappa', 'area'), ('corrected_kappa', 'corrected_area')):  # least squares through the origin
                if light:
                    found[name].append(sum(row['pressure'] * row[key] for row in light) / sum(row['pressure']**2 for row in light))
            if len(middle) > 1:  # length, over the rms height, in which the pressure falls by e
                found['decay'].append(-1 / linear_regression(*zip(*[(row['mean_gap'], math.log(row['pressure'])) for row in middle])).slope)
            stiff = [row['pressure'] / row['stiffness'] for row in middle if 'stiffness' in row]  # the same: K = p / u0
            if stiff:
                found['stiffness_decay'].append(fmean(stiff))
        if not all(found.values()):
            return {}
        return {'from': FITTED[0], 'to': FITTED[1], **{name: spread(values) for name, values in found.items()}}

    def hard(self):
        for hardness, share in ((hardness, share) for hardness in HARDNESSES for share in SHARES):
            found = [row for row in self.capped if (row['hardness'], row['pressure']) == (hardness, hardness * share)]
            area, capped = persson_capped(hardness * share, hardness)
            means = {key: fmean(row.get(key, 0) for row in found) for key in ('area', 'capped', 'indentation', 'products') if found}
            if found:
                yield {'hardness': hardness, 'share': share, 'persson': area, 'persson_capped': capped / area, 'excess': means['area'] / share, **means}

    def meshes(self):
        """Errors against the raw area, which is off in proportion to the cell size, for cells of no size by the two finest grids."""
        sizes = sorted(self.request.sizes)
        for pressure in MESH_PRESSURES if len(sizes) > 1 else ():
            for n in sizes:
                sets = [[self.rows.get((m, seed, pressure)) for m in (n, sizes[-1], sizes[-2])] for seed in self.request.seeds]
                sets = [rows for rows in sets if all(rows)]
                if not sets:
                    continue
                a, b = 1 / sizes[-1], 1 / sizes[-2]
                limits = [(b * last['area'] - a * before['area']) / (b - a) for _, last, before in sets]
                areas, corrected = ([rows[0][key] for rows in sets] for key in ('area', 'corrected_area'))
                yield {'pressure': pressure, 'n': n, 'cells_a_wave': n / self.request.cut_off, 'area': fmean(areas),
                       'corrected_area': fmean(corrected), 'raw_error': fmean(area / limit - 1 for area, limit in zip(areas, limits)),
                       'corrected_error': fmean(area / limit - 1 for area, limit in zip(corrected, limits))}


def solve(request, store, n, seed, pressures, hardness=0):
    """With a hardness in growing steps, each on the surface that those before have indented."""
    pressed, kind = None, 'capped' if hardness else 'rows'
    for pressure in pressures:
        key = {'n': n, 'seed': seed, 'pressure': pressure, **({'hardness': hardness} if hardness else {})}
        name = f'{n}^2, surface {seed}, p/(E* slope) = {pressure:g}' + (f', hardness {hardness:g}' if hardness else '')
        if store.measured(kind, key):
            print(f'{name}: measured before', file=sys.stderr)
            continue
        pressed = pressed or Pressed(request, n, seed, n == request.points and not hardness, hardness)
        row = store.put(kind, key, pressed.at(pressure, n == request.points and not hardness and pressure in SHOWN))
        print(f'{name}: {row["area"]:.4f} in contact, {row["products"]} products', file=sys.stderr)


def run(request):
    """Solves that the file has from the same library are not repeated."""
    for n in [*request.sizes, request.points]:
        if 2 * request.cut_off >= n:
            raise Failure(f'a wave of 1/{request.cut_off:g} of the side needs more than two cells, a grid of {n}^2 has fewer')
    store = Store(request.json, 'physics', request.threads)
    surface = {key: getattr(request, key) for key in ('hurst', 'roll_off', 'cut_off', 'tol', 'points')}
    if store.document.setdefault('surface', surface) != surface:
        raise Failure(f'{request.json} is of other surfaces')
    for seed in request.seeds:
        solve(request, store, request.points, seed, PRESSURES)
    for n in request.sizes:
        for seed in request.seeds[:MESH_SEEDS]:
            solve(request, store, n, seed, MESH_PRESSURES)
    for seed in request.seeds[:MESH_SEEDS]:
        for hardness in HARDNESSES:
            solve(request, store, request.points, seed, [share * hardness for share in SHARES], hardness)
    found = Summary(store.rows('rows'), store.rows('capped', n=request.points), request)
    curve, fits, meshes, hard = list(found.curve()), found.fits(), list(found.meshes()), list(found.hard())
    store.save(curve=curve, fits=fits, meshes=meshes, hard=hard)
    print(f'Periodic self-affine surfaces on {request.points}^2 points, mean of the surfaces')
    show(CURVE, curve)
    print(fit_table({'fits': fits}) if fits else '')
    print('The same surfaces on several grids; errors against the raw areas of the two finest, extrapolated')
    show(MESHES, meshes)
    print('With a hardness, in growing steps')
    show(HARD, hard)


def curve(document, key):
    return [(row['pressure'], row[key]) for row in document['curve'] if row.get(key) is not None]


def area_picture(document, file):
    drawing = Panels(800, 340, 2, 1)
    raw, corrected = curve(document, 'area'), curve(document, 'corrected_area')
    drawing.panel(0, 0, 'contact area', axes(PRESSURE, 'contact area / nominal area', PRESSED, (0.005, 2), PLAIN),
                  [f'erf(sqrt(2)*x) with {GREY}', f'(x < {1 / BUSH!r} ? {BUSH!r}*x : 1/0) with {DASHED}', drawing.curve(raw, hollow(1)),
                   drawing.curve(corrected, style(2))])
    spread = [(row['pressure'], *(row['corrected_ratio'][key] for key in ('mean', 'lowest', 'highest'))) for row in document['curve']]
    drawing.panel(1, 0, 'area per pressure', axes(PRESSURE, 'A E* slope / F', PRESSED, (0, 3), LINEAR + 'set logscale x'),
                  [f'erf(sqrt(2)*x)/x with {GREY}', f'{BUSH!r} with {DASHED}', drawing.curve([(p, a / p) for p, a in raw], hollow(1)),
                   *drawing.bars(spread, style(2))])
    drawing.draw(file, [('cells in contact', hollow(1)), ('corrected; bars: all surfaces', style(2)), ('Persson, erf(√2 p)', GREY),
                        ('Bush, Gibson, Thomas, √(2π) p', DASHED)], 2)


def gap_picture(document, file):
    drawing, fits = Panels(800, 340, 2, 1), document['fits']
    gaps = [(row['mean_gap'], row['pressure']) for row in document['curve']]
    u0 = fits['decay']['mean']
    inside = [(u, p) for u, p in gaps if fits['from'] <= p <= fits['to']]
    beta = math.exp(sum(math.log(p) + u / u0 for u, p in inside) / len(inside))
    drawing.panel(0, 0, 'pressure against mean gap', axes('mean gap / rms height', PRESSURE, (0, '*'), (0.002, 3), LINEAR + 'set logscale y'),
                  [f'{beta!r}*exp(-x/{u0!r}) with {GREY}', drawing.curve(gaps, style(2))])
    drawing.panel(1, 0, 'contact stiffness', axes(PRESSURE, 'K rms height / (E* rms slope A0)', PRESSED, FREE, 'set logscale xy\n' + PLAIN),
                  [f'x/{fits["stiffness_decay"]["mean"]!r} with {DASHED}', drawing.curve(curve(document, 'stiffness'), style(1))])
    drawing.draw(file, [('mean gap', style(2)), ('exponential fit', GREY), ('stiffness of the last step', style(1)),
                        ('proportional to the load', DASHED)], 2)


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


def distribution_picture(document, file):
    drawing, hurst = Panels(800, 360, 2, 1), document['surface']['hurst']
    patches, pressures, entries = [], [], []
    shown = [row for row in solved(document['rows']) if row['n'] == document['surface']['points'] and 'patch_octaves' in row]
    for number, ((pressure,), rows) in enumerate(sorted(groups(shown, 'pressure').items())):
        points = patch_density(document, rows)
        if number == 1:
            x, y = points[len(points) // 2]
            patches.append(f'{3 * y!r}*(x/{x!r})**(-{2 - hurst / 2!r}) with {DASHED}')
        patches.append(drawing.curve(points, style(number)))
        # Persson's: the variance of the pressure in full contact is a quarter of (E* slope)^2.
        densities = zip(*(row['histogram']['density'] for row in rows))
        points = [((k + 0.5) * rows[0]['histogram']['width'], sum(values) / len(rows)) for k, values in enumerate(densities)]
        pressures += [drawing.curve(points, hollow(number)),
                      f'sqrt(2/pi)*(exp(-2*(x-{pressure!r})**2)-exp(-2*(x+{pressure!r})**2)) with lines lw 1.4 {colour(number)} dt 1']
        entries.append((f'p = {pressure:g} E* slope', style(number)))
    drawing.panel(0, 0, 'patch sizes',
                  axes('area of a patch / λ_s²', 'patches per area / (A0 / λ_s⁴)', FREE, FREE, 'set format "10^{%T}"'), patches)
    drawing.panel(1, 0, 'pressures (hollow), Persson (lines)',
                  axes('pressure / (E* rms slope)', 'density over all points', (0, 2), (0, '*'), LINEAR), pressures)
    drawing.draw(file, entries + [(f'area^{{-(2-H/2)}}, H = {hurst:g}', DASHED)], 2)


def mesh_picture(document, file):
    drawing = Panels(800, 340, 2, 1)
    areas, errors, entries = [f'1 with {GREY}'], [], []
    for number, ((pressure,), rows) in enumerate(groups(document['meshes'], 'pressure').items(), 1):
        limit = rows[-1]['area'] / (1 + rows[-1]['raw_error'])
        for key, error, look in (('area', 'raw_error', hollow(number)), ('corrected_area', 'corrected_error', style(number))):
            areas.append(drawing.curve([(1 / row['cells_a_wave'], row[key] / limit) for row in rows], look))
            errors.append(drawing.curve([(row['cells_a_wave'], 100 * max(abs(row[error]), 1e-6)) for row in rows], look))
            entries.append((f'{"cells" if key == "area" else "corrected"}, p = {pressure:g} E* slope', look))
    drawing.panel(0, 0, 'area against cell size',
                  axes('cell size / shortest wave', 'area / area at cell size 0', (0, 0.27), FREE, LINEAR), areas)
    drawing.panel(1, 0, 'error of the area', axes('cells in the shortest wave', 'error [%]', (3, 90), FREE,
                                                  'set logscale xy\nset format "%g"\nset xtics (4,8,16,32,64)'), errors)
    drawing.draw(file, entries, 2)


def hardness_picture(document, file):
    drawing, areas, capped = Panels(800, 350, 2, 1), [f'x with {DASHED}'], []
    for number, ((hardness,), rows) in enumerate(groups(document['hard'], 'hardness').items()):
        theory = [(x, *persson_capped(hardness * x, hardness)) for x in np.geomspace(0.01, 0.999, 100).tolist()]
        for panel, key, line in ((areas, 'area', [(x, a) for x, a, _ in theory]), (capped, 'capped', [(x, c / a) for x, a, c in theory])):
            panel += [drawing.curve([(row['share'], row[key]) for row in rows], hollow(number)), drawing.curve(line, f'lines lw 1.4 {colour(number)} dt 1')]
    at = 'mean pressure / hardness'
    drawing.panel(0, 0, 'contact area; lines: Persson', axes(at, 'contact area / nominal area', (0.01, 1), (0.01, 1), PLAIN), areas)
    drawing.panel(1, 0, 'at the hardness; lines: Persson', axes(at, 'part of the contact', (0, 1), (0, 1), LINEAR), capped)
    drawing.draw(file, [*((f'hardness = {value:g} E* slope', hollow(k)) for k, value in enumerate(HARDNESSES)), ('F / hardness', DASHED)], 2)


def fit_table(document):
    def spread_of(key, digits):
        return '{mean:.{0}f} ({lowest:.{0}f} to {highest:.{0}f})'.format(digits, **document['fits'][key])

    return table(['', 'mean (lowest to highest surface)'], [
        ['κ, cells in contact', spread_of('kappa', 2)], ['κ, corrected area', spread_of('corrected_kappa', 2)],
        ['κ, Persson: √(8/π)', f'{PERSSON:.2f}'], ['κ, Bush, Gibson & Thomas: √(2π)', f'{BUSH:.2f}'],
        ['u0 / rms height, by the mean gap', spread_of('decay', 3)], ['u0 / rms height, by the stiffness', spread_of('stiffness_decay', 3)]])


def sections(results):
    document = load(results, 'physics')
    return {'fits': fit_table(document), 'curve': records(CURVE, document['curve']), 'meshes': records(MESHES, document['meshes']),
            'provenance': provenance(document)}


def pictures(results, images):
    document = load(results, 'physics')
    for name, draw in (('area', area_picture), ('gap', gap_picture), ('patches', distribution_picture), ('mesh', mesh_picture),
                       ('hardness', hardness_picture)):
        draw(document, os.path.join(images, f'physics-{name}.png'))


question('physics', 'area, gap, stiffness, patches and pressures of rough surfaces against load', run, {
    'seeds': (listed(int), [1, 2, 3, 4], 'of the surfaces'), 'hurst': (ranged(float, 0.05, 1), 0.8, 'exponent'),
    'roll_off': (ranged(float, 1, 1024), 4.0, 'waves a side below which the spectrum is flat'),
    'cut_off': (ranged(float, 1, 4096), 64.0, 'waves a side above which it is zero'), 'points': (side, 1024, 'points per side, over all loads'),
    'sizes': (listed(side), [256, 512, 1024, 2048, 4096], 'points per side, at two loads'), 'tol': (float, 1e-8, 'certified tolerance'),
    **ALL_THREADS},
    {'seeds': [1, 2], 'roll_off': 2.0, 'cut_off': 16.0, 'points': 128, 'sizes': [64, 128, 256]}, 'two surfaces of 16 waves a side on up to 256^2')
