"""Numbers that others published beside those of the library: the rows, tables and pictures of docs/development/published.md."""
import itertools
import math
import os
import re
import subprocess
import sys
from statistics import fmean, linear_regression, stdev

import numpy as np

import published_creep as creeps
import published_forms as forms
import published_leak as leaks
import published_rough as rough
import published_slip as slips
from charts import DASHED, GREY, LINEAR, PROPORTIONAL, STYLES, Panels, axes, hollow, style
from json_tables import load
from options import ALL_THREADS, listed, question, ranged, side
from samples import groups, slope
from store import Store
from tables import missing, provenance, records, show

INPUTS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'integrations', 'mirco', 'inputs')
CRITICAL = 0.415  # Wang & Müser, arXiv 2010.13470
BANDS = ((0.8, 2), (0.8, 8), (0.8, 32), (0.3, 8), (0.3, 32))  # exponent, and longest over shortest wave
LONGEST = 4  # waves a side in these
# Areas by Green's function molecular dynamics over E* times the rms slope, with their scatter: file Area_GFMD_Zhou.mat of
# github.com/xylcsi/PerssonModelFudgeFactor. H = 0.8, longest over shortest wave 100; the rms slope is that of the spectrum in Fig_2_program.m.
GFMD_SLOPE, GFMD_BAND = 0.27666, 100
GFMD = ((0.001, 0.008272, 0.000102), (0.005, 0.039935, 0.000293), (0.015, 0.114685, 0.000555), (0.04, 0.284595, 0.000697),
        (0.086, 0.540296, 0.000569), (0.147, 0.771872, 0.000317), (0.24, 0.940583, 0.000264))
# Density of pressures of the challenge without adhesion, 250 kPa: Wang & Müser, Tribology Letters 65(3) (2017), Figure 2, as digitised in
# Wang_Muser_Fig2_data.txt of the same repository. The area is the integral over all its points, whose mean pressure is 3 % above the load.
DENSITY = ((0.0127, 0.00492), (0.0605, 0.01335), (0.1172, 0.02054), (0.2256, 0.02708), (0.3135, 0.02854), (0.418, 0.02712), (0.5273, 0.024),
           (0.6719, 0.01832), (0.79, 0.01382), (0.9277, 0.00918), (1.0459, 0.00634), (1.1855, 0.00402))
DENSITY_AREA = 0.0208
FORMS = ('contact={title}; source={source}; known={quantity}; coarsest grid={coarse}²; error={coarse_error:err}; '
         'finest grid={fine}²; error={fine_error:err}; order={order:.1f}')
WAVES = 'share of the closing load={share:g}; ={quantity}; asymptote={theirs:.5f}; ours={ours:.5f}; difference [%]={difference:%+.2f}'
SPHERES = ('roughness={roughness:.3f}; pressure in the middle, model={model_middle:.3f}; ours={middle:.3f} ± {middle_scatter:.3f}; '
           'distance of the load, model={model_distance:.3f}; ours={distance:.3f} ± {distance_scatter:.3f}')
CROSSING = ('H={hurst:g}; grid={n}²; surfaces={surfaces}; area where the gap closes={mean:.3f} ± {deviation:.3f}; scatter={scatter:.3f}; '
            'cells counted={raw:.3f}; p / (E* slope)={pressure:.3f}')
BREADTH = ('H={hurst:g}; longest / shortest wave={band}; Nayak={nayak:.1f}; {columns}; κ={kappa:.3f} ± {scatter:.3f}; misfit [%]={misfit:%.1f}; '
           'mean gap / rms at 0.1={gap:.3f}; u0 / rms height={decay:.3f}')
ATLAS = ('p / (E* slope)={pressure:.4f}; published={theirs:.4f} ± {scatter:.4f}; cells counted={area:.4f}; corrected={corrected:.4f}; '
         'scatter={spread:.4f}; Persson={persson:.4f}; Wang & Müser={fudge:.4f}')
CHALLENGE = ('p / (E* slope)={pressure:g}; p [kPa]={kilopascals:g}; surface={seed}; grid={n}²; A/A0 [%]={area:%.4f}; '
             'proven to be within={lower:%.4f} to {upper:%.4f}; corrected [%]={corrected:%.4f}; mean gap / rms={mean_gap:.4f}')
MIRCO = 'input={file}; theirs={theirs:.6e}; ours={ours:.6e}; difference={difference:+.1e}; tolerance of theirs={tolerance:g}'
SLIP = ("Poisson's ratio={nu:g}; surfaces={surfaces}; shear force, model over vector problem [%]={mean:%+.2f}; largest [%]={most:%.2f}; "
        'field of shears, largest [%]={field:%.0f}')
CREEP = ('steps={steps}; error of the pressures, ours={ours:err}; Tamaas={theirs:err}; time [s], ours={ours_seconds:.2f}; '
         'Tamaas={theirs_seconds:.2f}')
LEAK = ('H={hurst:g}; p / (E* slope)={pressure:g}; surfaces={surfaces}; area={area:.3f}; conductivity over mean gap cubed, ours={ours:.4f}; '
        'proven to within={width:err}; effective medium={medium:.4f}; ours over it={ratio:.2f}')
SUMMARY = 'published result={name}; source={source}; theirs={theirs}; ours={ours}; part={part}; where they differ={why}'


def options(request):
    return {'tol': request.tol, 'threads': request.threads}


def measure(store, table, key, work):
    """A record, unless this library has it."""
    if store.measured(table, key):
        print(f'{table} {key}: measured before', file=sys.stderr)
        return
    store.put(table, key, work())
    print(f'{table} {key}', file=sys.stderr, flush=True)


def measure_forms(request, store):
    for form in forms.FORMS:
        for n in request.form_points:
            measure(store, 'forms', {'title': form.title, 'n': n}, lambda: {'error_of': form.found(n) / form.known - 1})
    for share in forms.LIGHT_SHARES + forms.HEAVY_SHARES:
        measure(store, 'waves', {'share': share}, lambda: forms.crossed_waves(request.form_points[-1], share))
    for rough_slope in forms.ROUGH_SLOPES:
        measure(store, 'spheres', {'slope': rough_slope}, lambda: forms.rough_sphere(512, rough_slope, range(1, request.seeds + 1)))


def measure_crossing(request, store):
    # The first surfaces on a finer grid as well: what cells that touch in part add.
    for n, surfaces in ((request.points, request.crossing_seeds), (2 * request.points, request.crossing_seeds // 4)):
        for seed, hurst in itertools.product(range(1, surfaces + 1), rough.HURSTS):
            def work():
                pressed = rough.Pressed(n, seed, hurst, request.points // 128, request.points // 16, options(request))
                return rough.last_crossing(pressed, 0.004)
            measure(store, 'crossing', {'hurst': hurst, 'seed': seed, 'n': n}, work)


def press_all(store, table, key, pressures, make):
    """One surface under growing pressures."""
    pressed = None
    for pressure in pressures:
        if not store.measured(table, {**key, 'pressure': pressure}):
            pressed = pressed or make()
        measure(store, table, {**key, 'pressure': pressure}, lambda: pressed.row(pressure))
    return pressed


def measure_breadth(request, store):
    for hurst, band in (each for each in BANDS if 4 * LONGEST * each[1] <= request.points):  # four cells in the shortest wave
        for seed in range(1, request.seeds + 1):
            press_all(store, 'breadth', {'hurst': hurst, 'band': band, 'seed': seed}, rough.AREA_PRESSURES, lambda: rough.Pressed(
                request.points, seed, hurst, LONGEST, LONGEST * band, options(request), LONGEST))


def over_slope(pressure):
    """The pressure over the slope of GFMD, to the digits that results keep."""
    return float(f'{pressure / GFMD_SLOPE:.6g}')


def measure_atlas(request, store):
    longest = max(1, request.atlas_points // (5 * GFMD_BAND))
    for seed in range(1, request.seeds + 1):
        press_all(store, 'gfmd', {'seed': seed}, [over_slope(p) for p, *_ in GFMD], lambda: rough.Pressed(
            request.atlas_points, seed, 0.8, longest, min(GFMD_BAND * longest, request.atlas_points // 3), options(request), longest))


def measure_challenge(request, store):
    for n in request.challenge_points:
        for seed in range(1, (request.challenge_seeds if n <= 4096 else 1) + 1):
            def make():
                return rough.Pressed(n, seed, 0.8, 5, min(1000, int(0.49 * request.challenge_points[0])), options(request))
            pressures = rough.CHALLENGE_PRESSURES if n <= 4096 else rough.CHALLENGE_PRESSURES[2:3]
            pressed = press_all(store, 'challenge', {'n': n, 'seed': seed}, pressures, make)
            if seed == 1:
                measure(store, 'distributions', {'n': n}, lambda: (pressed or make()).distributions(0.01))


def measure_mirco(request, store):
    program = os.path.join(os.environ['RC_BENCH_BUILD'], 'bin', 'press_mirco')
    for file in sorted(name for name in os.listdir(INPUTS) if name.endswith('.yaml')) if os.path.exists(program) else ():
        def work():
            said = subprocess.run([program, os.path.join(INPUTS, file)], check=True, capture_output=True, text=True).stdout
            with open(os.path.join(INPUTS, file), encoding='utf-8') as text:
                tolerance = float(re.search(r'^\s*Tolerance: *(\S+)', text.read(), re.M)[1])
            ours, theirs = (float(re.search(words + r' ([0-9.e+-]+)', said)[1].rstrip(':')) for words in ('mean pressure', 'expects'))
            return {'ours': ours, 'theirs': theirs, 'difference': ours / theirs - 1, 'tolerance': tolerance}
        measure(store, 'mirco', {'file': file}, work)


def measure_slip(request, store):
    for seed in range(1, request.slip_seeds + 1):
        key = {'seed': seed, 'hurst': rough.HURSTS[seed % 2], 'n': request.slip_points}
        measure(store, 'slip', key, lambda: slips.model_errors(request.slip_points, seed, key['hurst'], 0.05))


def measure_creep(request, store):
    if not creeps.available():
        print('creep: Tamaas is not installed (pip install tamaas)', file=sys.stderr)
        return
    n, exact = request.creep_points, None
    for steps in creeps.STEPS:
        key = {'n': n, 'steps': steps}
        if exact is None and not store.measured('creep', key):
            exact = creeps.finest(n)
        measure(store, 'creep', key, lambda: creeps.errors(n, steps, exact))


def measure_leak(request, store):
    if not leaks.available():
        return
    n = request.leak_points
    for seed, hurst in itertools.product(range(1, request.seeds + 1), rough.HURSTS):
        pressed = None
        for pressure in leaks.PRESSURES:
            key = {'hurst': hurst, 'seed': seed, 'n': n, 'pressure': pressure}
            if not store.measured('leak', key):
                pressed = pressed or rough.Pressed(n, seed, hurst, n // 64, n // 16, options(request))
            measure(store, 'leak', key, lambda: leaks.conducted(pressed, pressure))


PARTS = {'forms': measure_forms, 'mirco': measure_mirco, 'crossing': measure_crossing, 'breadth': measure_breadth, 'gfmd': measure_atlas,
         'challenge': measure_challenge, 'slip': measure_slip, 'creep': measure_creep, 'leak': measure_leak}


def run(request):
    """Records that the file has from the same library are not measured again."""
    store = Store(request.json, 'published', request.threads)
    for name in request.names or PARTS:
        PARTS[name](request, store)
    store.save()
    for columns, rows in tables(store.document).values():
        show(columns, rows)


def spread(values):
    return stdev(values) if len(values) > 1 else 0.0


def form_rows(document):
    for form in forms.FORMS:
        rows = [row for row in document.get('forms', []) if row['title'] == form.title]
        if rows:
            errors = [(row['n'], abs(row['error_of'])) for row in rows]
            yield {'title': form.title, 'source': form.source, 'quantity': form.quantity, 'coarse': errors[0][0], 'coarse_error': errors[0][1],
                   'fine': errors[-1][0], 'fine_error': errors[-1][1], 'order': -slope(errors) if len(errors) > 1 else None}


def crossing_rows(document):
    for (hurst, n), rows in groups(document.get('crossing', []), 'hurst', 'n').items():
        values = [row[axis] for row in rows for axis in 'xy']
        yield {'hurst': hurst, 'n': n, 'surfaces': len(rows), 'mean': fmean(values), 'scatter': spread(values),
               # both axes of a surface count as one sample
               'deviation': spread([(row['x'] + row['y']) / 2 for row in rows]) / math.sqrt(len(rows)),
               'raw': fmean(row[axis + '_raw'] for row in rows for axis in 'xy'),
               'pressure': fmean(row[axis + '_pressure'] for row in rows for axis in 'xy')}


def kappa_of(rows):
    """κ of a = erf(√π/2 κ p) by least squares, and the largest misfit in area over the area."""
    def misfits(kappa):
        return [math.erf(math.sqrt(math.pi) / 2 * kappa * row['pressure']) / row['corrected'] - 1 for row in rows]
    kappa = min(np.linspace(1.4, 2.6, 1201).tolist(), key=lambda k: sum(each**2 for each in misfits(k)))
    return kappa, max(map(abs, misfits(kappa)))


def breadth_rows(document):
    for (hurst, band), rows in groups(document.get('breadth', []), 'hurst', 'band').items():
        fits = [kappa_of(each) for each in groups(rows, 'seed').values()]
        row = {'hurst': hurst, 'band': band, 'nayak': rough.nayak(hurst, LONGEST, LONGEST * band, LONGEST),
               'kappa': fmean(k for k, _ in fits), 'scatter': spread([k for k, _ in fits]), 'misfit': max(misfit for _, misfit in fits)}
        for pressure, found in groups(rows, 'pressure').items():
            row[f'at_{pressure[0]:g}'.replace('.', '_')] = fmean(each['corrected'] / each['pressure'] for each in found)
        row['gap'] = fmean(each['mean_gap'] for each in rows if each['pressure'] == 0.1)
        light = [each for each in rows if 0.01 < each['pressure'] < 0.3]
        row['decay'] = -1 / linear_regression([each['mean_gap'] for each in light], [math.log(each['pressure']) for each in light]).slope
        yield row


BREADTH_COLUMNS = '; '.join(f'A E* slope / F at {pressure:g}={{at_{str(pressure).replace(".", "_")}:.3f}}' for pressure in (0.02, 0.1))


def logarithm(rows, key='at_0_02'):
    """(a, b, largest misfit) of key = a - b ln(Nayak), by least squares."""
    x, y = [math.log(row['nayak']) for row in rows], [row[key] for row in rows]
    fit = linear_regression(x, y)
    return fit.intercept, -fit.slope, max(abs(fit.intercept + fit.slope * a - b) for a, b in zip(x, y))


def atlas_rows(document):
    by_pressure = groups(document.get('gfmd', []), 'pressure')
    for p, theirs, scatter in GFMD:
        x = over_slope(p)
        if found := by_pressure.get((x,)):
            yield {'pressure': x, 'theirs': theirs, 'scatter': scatter, 'area': fmean(row['area'] for row in found),
                   'corrected': fmean(row['corrected'] for row in found), 'spread': spread([row['corrected'] for row in found]),
                   'persson': rough.persson(x), 'fudge': rough.persson(x, rough.wang_mueser)}


def challenge_rows(document):
    rows = sorted(document.get('challenge', []), key=lambda row: (row['pressure'], row['seed'], row['n']))
    return [{**row, 'kilopascals': 25000 * row['pressure']} for row in rows]


def extrapolated(document, pressure=0.01):
    """Area extrapolated to cell size 0 by the counted areas of the two finest grids of the first surface; None without two."""
    rows = sorted((row for row in document.get('challenge', []) if row['pressure'] == pressure and row['seed'] == 1), key=lambda row: row['n'])
    if len(rows) < 2:
        return None
    coarse, fine = rows[-2:]
    return (fine['n'] * fine['area'] - coarse['n'] * coarse['area']) / (fine['n'] - coarse['n'])


def slip_rows(document):
    rows = document.get('slip', [])
    for at, nu in enumerate(slips.RATIOS) if rows else ():
        forces = [1 / (1 + force) - 1 for row in rows for force in row['force'][at]]
        yield {'nu': nu, 'surfaces': len(rows), 'mean': fmean(forces), 'most': max(map(abs, forces)),
               'field': max(field for row in rows for field in row['field'][at])}


def leak_rows(document):
    for (hurst, pressure), rows in groups(document.get('leak', []), 'hurst', 'pressure').items():
        mean = {name: fmean(row[name] for row in rows) for name in ('area', 'ours', 'medium')}
        yield {'hurst': hurst, 'pressure': pressure, 'surfaces': len(rows), **mean, 'ratio': mean['ours'] / mean['medium'],
               'width': max(row['width'] for row in rows)}


def tables(document):
    found = {'forms': (FORMS, list(form_rows(document))), 'waves': (WAVES, document.get('waves', [])),
             'spheres': (SPHERES, document.get('spheres', [])), 'crossing': (CROSSING, list(crossing_rows(document))),
             'breadth': (BREADTH.replace('{columns}', BREADTH_COLUMNS), list(breadth_rows(document))), 'gfmd': (ATLAS, list(atlas_rows(document))),
             'challenge': (CHALLENGE, challenge_rows(document)), 'mirco': (MIRCO, document.get('mirco', [])),
             'slip': (SLIP, list(slip_rows(document))), 'creep': (CREEP, document.get('creep', [])), 'leak': (LEAK, list(leak_rows(document)))}
    return {name: (columns, rows) for name, (columns, rows) in found.items() if rows}


def summary(document):
    """One row a published result that is measured."""
    rows, found = {name: rows for name, (_, rows) in tables(document).items()}, []

    def add(part, name, source, theirs, ours, why=''):
        found.append({'name': name, 'source': source, 'theirs': theirs, 'ours': ours, 'part': part, 'why': why})
    for row in rows.get('crossing', ())[:len(rough.HURSTS)]:
        add('crossing', f'area in contact at which the gap stops crossing, H = {row["hurst"]:g}',
            'Wang & Müser 2020, arXiv 2010.13470', f'near {CRITICAL}',
            f'{row["mean"]:.3f} ± {row["deviation"]:.3f}; cells counted: {row["raw"]:.3f}',
            f'by {row["mean"] - CRITICAL:+.3f}, by {row["raw"] - CRITICAL:+.3f} if cells are counted; the source does not say which')
    if len(rows.get('breadth', ())) > 2:
        a, b, off = logarithm(rows['breadth'])
        add('breadth', 'area at a given pressure falls with the logarithm of the Nayak parameter α',
            'Yastrebov, Anciaux & Molinari 2017, arXiv 1704.05650', 'a - b ln α, b > 0', f'{a:.3f} - {b:.3f} ln α, misfit {off:.3f}',
            'their coefficients were not available')
        kappas, off = [row['kappa'] for row in rows['breadth']], max(row['misfit'] for row in rows['breadth'])
        pairs = [[row['kappa'] for row in each] for each in groups(rows['breadth'], 'band').values() if len(each) > 1]
        apart = max(abs(first / second - 1) for first, second in pairs)
        add('breadth', 'a = erf(√π/2 κ p/(E* slope)), nearly the same for all H', 'Prodanov, Dapp & Müser 2014, arXiv 1311.7547', 'form',
            f'κ {min(kappas):.2f} to {max(kappas):.2f}, between two H by {100 * apart:.0f} % at most; misfit up to {100 * off:.0f} %',
            'the form is too low at light loads and too high at p = 0.4; their κ and gap law were not available')
    if 'gfmd' in rows:
        for name in ('area', 'corrected'):
            off = max(abs(row[name] / row['theirs'] - 1) for row in rows['gfmd'])
            add('gfmd', f'areas of surfaces with waves over two decades, {"cells counted" if name == "area" else "corrected"}',
                'Zhou, in PerssonModelFudgeFactor', '7 areas, scatter below 0.001', f'within {100 * off:.1f} %',
                'their grid is not stated' + ('' if name == 'area' else '; they agree with counts'))
    if 'challenge' in rows:
        row, limit = [each for each in rows['challenge'] if each['pressure'] == 0.01][-1], extrapolated(document)
        add('challenge', 'challenge surface without adhesion, 250 kPa: area', 'Wang & Müser 2017, Figure 2, digitised', f'{DENSITY_AREA} ± 3 %',
            f'{row["corrected"]:.4f}' + (f'; extrapolated to cell size 0 {limit:.4f}' if limit else ''), 'another surface of the same spectrum')
    if 'mirco' in rows:
        off = max(abs(row['difference']) for row in rows['mirco'])
        add('mirco', 'mean pressures of six regression inputs', 'MIRCO', 'tolerance 0.01', f'within {100 * off:.2f} %',
            "MIRCO's runs stop at their tolerance")
    if 'slip' in rows:
        exact, *others = rows['slip']
        add('slip', 'shear force of a rough surface in partial slip, from its normal contact alone', 'Ciavarella 1998, Jäger 1998', 'exact at ν = 0',
            f'within {100 * exact["most"]:.0e} % at ν = 0, ' + ', '.join(f'{100 * row["most"]:.1f} % at {row["nu"]:g}' for row in others),
            'the model has one stiffness for all directions; these samples differ by direction')
    if 'creep' in rows:
        coarse, *_, fine = rows['creep']
        add('creep', 'pressures of a rough body that creeps, generalised Maxwell', 'Tamaas 2.9.0, backward Euler',
            f'off by {coarse["theirs"]:.0e} with {coarse["steps"]} steps, by {fine["theirs"]:.0e} with {fine["steps"]}',
            f'off by {coarse["ours"]:.0e} and {fine["ours"]:.0e}, in {fine["ours_seconds"]:.1f} s for {fine["theirs_seconds"]:.1f} s',
            'theirs of first order in the step, ours of second')
    if 'leak' in rows:
        light, *_, heavy = sorted(rows['leak'], key=lambda row: row['area'])
        add('leak', 'flow through the gap between isotropic surfaces, from the distribution of gaps alone', 'effective medium, Bruggeman 1935',
            'closed form', ', '.join(f'{row["ratio"]:.2f} of it at an area of {row["area"]:.2f}' for row in (light, heavy)),
            'the medium conducts up to half of the area, gaps close near 0.4')
    for row in rows.get('forms', ()):
        add('forms', row['title'], row['source'], f'closed form of the {row["quantity"]}', f'error {row["fine_error"]:.0e} on {row["fine"]}²',
            f'cells: order {row["order"]:.1f}' if row['order'] else '')
    return found


PLAIN = 'set logscale xy\nset format "%g"\n'


def forms_picture(document, file):
    drawing, curves, entries = Panels(800, 320, 1, 1), [], []
    for number, form in enumerate(forms.FORMS):
        points = [(row['n'], abs(row['error_of'])) for row in document['forms'] if row['title'] == form.title]
        curves.append(drawing.curve(points, style(number)))
        entries.append((form.title, style(number)))
    curves += [f'{factor}/x**{order} with lines {PROPORTIONAL}' for factor, order in ((0.3, 1), (2, 2))]
    settings = axes('points a side', 'error', (48, 1400), ('*', '*'), PLAIN + 'set format y "10^{%T}"')
    drawing.panel(0, 0, 'relative error', settings, curves)
    drawing.draw(file, [*entries, ('first and second order', f'lines {PROPORTIONAL}')], 2)


def crossing_picture(document, file):
    drawing, curves, entries = Panels(600, 340, 1, 1), [f'{CRITICAL},t with {GREY}'], []
    coarse = [row for row in document['crossing'] if row['n'] == document['crossing'][0]['n']]
    for number, ((hurst,), rows) in enumerate(groups(coarse, 'hurst').items(), 1):
        values = sorted(row[axis] for row in rows for axis in 'xy')
        curves.append(drawing.curve([(value, (k + 0.5) / len(values)) for k, value in enumerate(values)], style(number)))
        entries.append((f'H = {hurst:g}', style(number)))
    drawing.panel(0, 0, 'area at which the gap stops crossing', axes('contact area / nominal area', 'share of surfaces and directions', (0.25, 0.6),
                                                                     (0, 1), LINEAR + 'set parametric\nset trange [0:1]'), curves)
    drawing.draw(file, [*entries, ('Wang, Müser 2020', GREY)], 3)


def area_picture(document, file):
    drawing, rows = Panels(800, 350, 2, 1), list(atlas_rows(document))
    at = np.geomspace(0.003, 1.2, 60).tolist()
    line = 'lines lw 1.6 ' + STYLES[4].rsplit(' pt', 1)[0]
    weights = (lambda area: 1, GREY), (rough.wang_mueser, DASHED)
    curves = [drawing.curve([(p, rough.persson(p, weight) / p) for p in at], look) for weight, look in weights]
    for key, look in (('theirs', hollow(1)), ('area', hollow(2)), ('corrected', style(2))):
        curves.append(drawing.curve([(row['pressure'], row[key] / row['pressure']) for row in rows], look))
    ratio = 'A E* slope / F'
    settings = axes('mean pressure / (E* rms slope)', ratio, (0.003, 1.2), (0.6, 2.6), LINEAR + 'set logscale x')
    drawing.panel(0, 0, 'area per pressure', settings, curves)
    breadth = list(breadth_rows(document))
    curves, entries = [], [('Persson', GREY), ('Wang, Müser 2017', DASHED), ('published areas', hollow(1)), ('ours, cells counted', hollow(2)),
                           ('ours, corrected', style(2))]
    if len(breadth) > 2:
        a, b, _ = logarithm(breadth)
        curves, entries = [f'{a!r}-{b!r}*log(x) with {line}'], [*entries, ('a - b ln α', line)]
    for number, ((hurst,), found) in enumerate(groups(breadth, 'hurst').items()):
        curves.append(drawing.curve([(row['nayak'], row['at_0_02']) for row in found], hollow(3 + 2 * number)))
        entries.append((f'ours, H = {hurst:g}', hollow(3 + 2 * number)))
    settings = axes('Nayak parameter α', ratio, (1, 100), (1.5, 2.6), LINEAR + 'set logscale x')
    drawing.panel(1, 0, 'at p = 0.02 E* slope', settings, curves)
    drawing.draw(file, entries, 3)


def challenge_picture(document, file):
    drawing, found = Panels(800, 640, 2, 2), document['distributions'][-1]
    width, wide = rough.HIGHEST / rough.BINS, rough.WIDEST / rough.GAP_BINS
    settings = axes('pressure / (E* slope)', 'density', (0, rough.HIGHEST), (0, 0.035), LINEAR + 'set ytics 0.01')
    drawing.panel(0, 0, 'pressures at 250 kPa', settings, [
        drawing.curve([((k + 0.5) * width, value) for k, value in enumerate(found['pressures'])], style(2)), drawing.curve(DENSITY, hollow(1))])
    drawing.panel(1, 0, 'open gaps', axes('gap / rms height', 'density', (0, rough.WIDEST), (0, '*'), LINEAR), [
        drawing.curve([((k + 0.5) * wide, value) for k, value in enumerate(found['gaps'])], style(2))])
    wave = found['n'] / 1000  # cells in the shortest
    patches = [(2**k * math.sqrt(2 - 1 / 2**k) / wave**2, count) for k, count in enumerate(found['patch_octaves']) if count]
    wide = PLAIN + 'set format x "10^{%T}"\nset rmargin at screen 0.9775'
    settings = axes('area / (shortest wave)²', 'patches per octave', ('*', '*'), ('*', '*'), wide)
    drawing.panel(0, 1, 'patches', settings, [drawing.curve(patches, style(2))])
    drawing.draw(file, [('ours', style(2)), ('Wang, Müser 2017, Figure 2', hollow(1))], 2)


def slip_picture(document, file):
    drawing, rows = Panels(600, 320, 1, 1), document['slip']
    curves, entries = [], []
    for at, share in enumerate(slips.SHARES):
        points = [(nu, 100 * (1 / (1 + row['force'][number][at]) - 1)) for row in rows for number, nu in enumerate(slips.RATIOS)]
        curves.append(drawing.curve(points, hollow(1 + at)))
        entries.append((f'shear {share:g} of the friction', hollow(1 + at)))
    settings = axes("Poisson's ratio", 'model over vector problem [%]', (-0.03, 0.53), ('*', '*'), LINEAR)
    drawing.panel(0, 0, f'shear force at a given slip, {len(rows)} surfaces', settings, curves)
    drawing.draw(file, entries, 2)


def creep_picture(document, file):
    drawing, rows = Panels(600, 320, 1, 1), document['creep']
    curves = [drawing.curve([(row['steps'], row[name]) for row in rows], style(number)) for number, name in enumerate(('ours', 'theirs'))]
    curves += [f'{factor}/x**{order} with lines {PROPORTIONAL}' for factor, order in ((0.5, 1), (0.2, 2))]
    settings = axes('time steps', 'error', (3, 170), ('*', '*'), PLAIN + 'set format y "10^{%T}"')
    drawing.panel(0, 0, 'error of the pressures after two seconds', settings, curves)
    drawing.draw(file, [('ours', style(0)), ('Tamaas', style(1)), ('first and second order', f'lines {PROPORTIONAL}')], 3)


def sections(results):
    document = load(results, 'published')
    found = tables(document)
    names = 'forms', 'waves', 'spheres', 'crossing', 'breadth', 'gfmd', 'challenge', 'mirco', 'slip', 'creep', 'leak'
    made = {name: records(*found[name]) if name in found else missing(f'roughcontact-bench published {name}') for name in names}
    return {'summary': records(SUMMARY, summary(document)), **made, 'provenance': provenance(document)}


PICTURES = {'forms': ('forms', forms_picture), 'crossing': ('crossing', crossing_picture), 'area': ('gfmd', area_picture),
            'challenge': ('distributions', challenge_picture), 'slip': ('slip', slip_picture), 'creep': ('creep', creep_picture)}


def pictures(results, images):
    document = load(results, 'published')
    for name, (table, draw) in PICTURES.items():
        if document.get(table):
            draw(document, os.path.join(images, f'published-{name}.png'))


question('published', 'published numbers beside those of the library', run, {
    'form_points': (listed(side), [64, 128, 256, 512, 1024], 'points per side, closed forms'),
    'points': (side, 1024, 'points per side, rough surfaces'),
    'atlas_points': (side, 2048, 'points per side, areas of surfaces with waves over two decades'),
    'seeds': (ranged(int, 1, 100), 3, 'surfaces of a kind'), 'crossing_seeds': (ranged(int, 1, 1000), 20, 'surfaces whose gap closes'),
    'challenge_points': (listed(side), [2048, 4096, 8192], 'points per side, challenge'),
    'challenge_seeds': (ranged(int, 1, 100), 2, 'surfaces of the challenge'),
    'slip_points': (side, 128, 'points per side, slip'), 'slip_seeds': (ranged(int, 1, 100), 20, 'surfaces that slip'),
    'creep_points': (side, 128, 'points per side, creep'), 'leak_points': (side, 512, 'points per side, leak'), 'tol': (float, 1e-6, 'certified tolerance'), **ALL_THREADS},
    {'form_points': [64, 128], 'points': 128, 'atlas_points': 512, 'seeds': 2, 'crossing_seeds': 3, 'challenge_points': [256, 512],
     'challenge_seeds': 1, 'slip_points': 32, 'slip_seeds': 2, 'creep_points': 32, 'leak_points': 64},
    'small grids and few surfaces, under a minute', names=tuple(PARTS))
