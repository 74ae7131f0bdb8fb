"""Area, mean gap, stiffness, patches and pressures of rough surfaces against load, beside the theories of rough contact."""
import math
import sys

import numpy as np
import roughcontact as rc

from case import Failure
from contact import OK, record_of, unit_square
from options import THREADS, Question, listed, ranged, side, threads
from physics_tables import curve_table, mesh_table
from samples import line, mean
from store import Store
from surfaces import self_affine_gap
from tables import show_table

RMS_SLOPE = 0.1
BINS, HIGHEST = 50, 2  # of the histograms, whose end is HIGHEST E* rms slope
# Mean pressures over E* times the rms slope of the surface.
PRESSURES = (0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.3, 0.5, 0.75, 1, 1.5)
SHOWN = (0.01, 0.04, 0.16)  # those with distributions of patches and pressures
MESH_PRESSURES, MESH_SEEDS = (0.02, 0.16), 2  # on all grids, the first surfaces
LIGHT = 0.04  # area and load are proportional up to this pressure
FITTED = (0.01, 0.2)  # pressure falls exponentially with the mean gap


class Pressed:
    """One surface on one grid, pressed by growing loads. E*, the side and with it the nominal area are 1."""

    def __init__(self, request, n, seed, stiffness):
        self.gap = self_affine_gap(n, seed, request.hurst, request.roll_off, request.cut_off, RMS_SLOPE)
        options = {'tol': request.tol, 'threads': request.threads, 'stiffness': int(stiffness)}
        self.contact = rc.Contact(unit_square(n, 'periodic'), options=options)
        self.mean, self.rms_height = self.gap.mean(), self.gap.std()

    def at(self, pressure, distributions):
        result = self.contact.solve(load=pressure * RMS_SLOPE, undeformed_gap=self.gap, borrow=True, check=False)
        area, cells = result.area(), result.patches().cells
        row = {**record_of(result), 'area': area.area, 'corrected_area': area.corrected_area, 'perimeter': area.perimeter,
               'mean_gap': (self.mean - result.approach) / self.rms_height}
        if math.isfinite(result.stiffness):  # over E* times slope and nominal area, as the pressure is
            row['stiffness'] = result.stiffness * self.rms_height / RMS_SLOPE
        row.update(patches=len(cells), largest_patch=cells.max() / cells.sum() if len(cells) else 0)
        if distributions:
            row['patch_octaves'] = np.bincount(np.frexp(cells.astype(float))[1] - 1)  # patches of 2^k .. 2^(k+1) - 1 cells
            found = result.histogram(BINS, HIGHEST * RMS_SLOPE)
            # Density over all points, per pressure over E* rms slope.
            row['histogram'] = {'width': HIGHEST / BINS, 'above': found.above, 'density': found.density * area.area * RMS_SLOPE}
        return row


def spread(values):
    return {'mean': mean(values), 'lowest': min(values), 'highest': max(values)}


class Summary:
    """Of certified rows."""

    def __init__(self, rows, request):
        self.request = request
        self.rows = {(row['n'], row['seed'], row['pressure']): row for row in rows if row['status'] == OK}

    def at(self, pressure, n=None):
        keys = [(n or self.request.points, seed, pressure) for seed in self.request.seeds]
        return [self.rows[key] for key in keys if key in self.rows]

    def curve(self):
        for pressure in PRESSURES:
            found = self.at(pressure)
            if not found:
                continue
            entry = {'pressure': pressure, 'surfaces': len(found), 'persson': math.erf(math.sqrt(2) * pressure)}
            for key in ('area', 'corrected_area', 'perimeter', 'mean_gap', 'stiffness', 'patches', 'largest_patch'):
                if all(key in row for row in found):
                    entry[key] = mean(row[key] for row in found)
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
                found['decay'].append(-1 / line([(row['mean_gap'], math.log(row['pressure'])) for row in middle])[0])
            stiff = [row['pressure'] / row['stiffness'] for row in middle if 'stiffness' in row]  # the same: K = p / u0
            if stiff:
                found['stiffness_decay'].append(mean(stiff))
        if not all(found.values()):
            return {}
        return {'light': LIGHT, 'from': FITTED[0], 'to': FITTED[1], **{name: spread(values) for name, values in found.items()}}

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
                yield {'pressure': pressure, 'n': n, 'cells_a_wave': n / self.request.cut_off, 'surfaces': len(sets), 'area': mean(areas),
                       'corrected_area': mean(corrected), 'raw_error': mean(area / limit - 1 for area, limit in zip(areas, limits)),
                       'corrected_error': mean(area / limit - 1 for area, limit in zip(corrected, limits))}


def solve(request, store, settings, n, seed, pressures):
    pressed = None
    for pressure in pressures:
        key = {'n': n, 'seed': seed, 'pressure': pressure, **settings}
        name = f'{n}^2, surface {seed}, p/(E* slope) = {pressure:g}'
        if store.find('rows', {**key, 'library': store.library}):
            print(f'{name}: measured before', file=sys.stderr)
            continue
        pressed = pressed or Pressed(request, n, seed, n == request.points)
        row = store.put('rows', key, pressed.at(pressure, n == request.points and pressure in SHOWN))
        print(f'{name}: {row["area"]:.4f} in contact, {row["solve_seconds"]:.3g} s', file=sys.stderr)


def run(request):
    """Solves that the file has from the same library are not repeated."""
    for n in [*request.sizes, request.points]:
        if 2 * request.cut_off >= n:
            raise Failure(f'a wave of 1/{request.cut_off:g} of the side needs more than two cells, a grid of {n}^2 has fewer')
    store = Store(request.json, 'physics', request.threads)
    settings = {key: getattr(request, key) for key in ('hurst', 'roll_off', 'cut_off', 'tol')}
    for seed in request.seeds:
        solve(request, store, settings, request.points, seed, PRESSURES)
    for n in request.sizes:
        for seed in request.seeds[:MESH_SEEDS]:
            solve(request, store, settings, n, seed, MESH_PRESSURES)
    found = Summary(store.rows('rows', **settings), request)
    curve, fits, meshes = list(found.curve()), found.fits(), list(found.meshes())
    store.document.update(surface={**settings, 'points': request.points}, curve=curve, fits=fits, meshes=meshes)
    store.save()
    print(f'Periodic self-affine surfaces on {request.points}^2 points, mean of the surfaces')
    show_table(curve_table(store.document))
    for name, words in (('kappa', 'kappa, raw'), ('corrected_kappa', 'kappa, corrected'), ('decay', 'u0/rms height by the gap'),
                        ('stiffness_decay', 'u0/rms height by the stiffness')):
        if fits:
            print('{}: {mean:.3f} ({lowest:.3f} to {highest:.3f})'.format(words, **fits[name]))
    print('The same surfaces on several grids; errors against the raw areas of the two finest, extrapolated')
    show_table(mesh_table(store.document))


QUESTION = Question('physics', 'area, gap, stiffness, patches and pressures of rough surfaces against load', run, {
    'seeds': (listed(int), [1, 2, 3, 4], 'of the surfaces'), 'hurst': (ranged(float, 0.05, 1), 0.8, 'exponent'),
    'roll_off': (ranged(float, 1, 1024), 4.0, 'waves a side below which the spectrum is flat'),
    'cut_off': (ranged(float, 1, 4096), 64.0, 'waves a side above which it is zero'),
    'points': (side, 1024, 'points per side, over all loads'),
    'sizes': (listed(side), [256, 512, 1024, 2048, 4096], 'points per side, at two loads'), 'tol': (float, 1e-8, 'certified tolerance'),
    'threads': (threads, THREADS, 'threads')},
    {'seeds': [1, 2], 'roll_off': 2.0, 'cut_off': 16.0, 'points': 128, 'sizes': [64, 128, 256]}, 'two surfaces of 16 waves a side on up to 256^2')
