"""The chart of README.md: time against error at one contact, as SVG for light and dark pages."""
import math

WIDTH, HEIGHT = 400, 300
LEFT, RIGHT, TOP, BOTTOM = 52, 392, 46, 252
TIMES, ERRORS = (2e-3, 3e1), (1e-9, 1.0)
# Code: name, light colour, dark colour, marker, where the name stands (seconds, error, anchor).
OURS, STANDARD = 'haar-cg, fft', 'polonsky-keer, fft'
CODES = {OURS: ('roughcontact', '#0072B2', '#56B4E9', 'circle', (3e-2, 0.15, 'end')),
         STANDARD: ('our Polonsky-Keer', '#B35900', '#E69F00', 'square', (6e-2, 1.1e-2, 'start')),
         'aspher-fft': ('ASPHER', '#00785A', '#40C9A0', 'triangle', (2.7e-1, 1.1e-3, 'start')),
         'contactmechanics': ('ContactMechanics', '#A0307A', '#E08AC0', 'diamond', (28, 2.2e-4, 'end')),
         'tamaas-free': ('Tamaas', '#555555', '#BBBBBB', 'cross', (2.3, 2e-8, 'start'))}
STYLE = '''text{font:12px "DejaVu Sans",Verdana,sans-serif;fill:#222}.t{font-weight:bold}.g{stroke:#ddd}.f{stroke:#777;fill:none}
.a{stroke:#222;fill:none;stroke-width:1.5}.h{fill:#222}.e{stroke:#222;stroke-dasharray:5 3}'''
DARK = 'text{fill:#ddd}.g{stroke:#444}.f{stroke:#999}.a,.e{stroke:#ddd}.h{fill:#ddd}'
MARKERS = {'circle': '<circle cx="{x}" cy="{y}" r="4"/>', 'square': '<path d="M{x},{y}m-3.5,-3.5h7v7h-7z"/>',
           'triangle': '<path d="M{x},{y}m0,-4.5l4.2,7.5h-8.4z"/>', 'diamond': '<path d="M{x},{y}m0,-5l4.5,5l-4.5,5l-4.5,-5z"/>',
           'cross': '<path d="M{x},{y}m-3.5,-3.5l7,7m0,-7l-7,7" stroke-width="2"/>'}


def across(seconds):
    return LEFT + (RIGHT - LEFT) * math.log(seconds / TIMES[0]) / math.log(TIMES[1] / TIMES[0])


def down(error):
    return TOP + (BOTTOM - TOP) * math.log(ERRORS[1] / error) / math.log(ERRORS[1] / ERRORS[0])


def text(x, y, words, anchor='start', more=''):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{words}</text>'


def frame(grid_error):
    """Axes, the arrow and the line of the grid's own error."""
    parts = [text(LEFT - 44, 15, 'Error of the pressures against seconds: one rough'), text(LEFT - 44, 31, 'contact, 256² points, 10 % touch, one core')]
    for exponent in range(-2, 2):
        x = across(10 ** exponent)
        parts += [f'<path class="g" d="M{x:.1f},{TOP}V{BOTTOM}"/>', text(x, BOTTOM + 16, f'{10 ** exponent:g} s', 'middle')]
    for exponent, words in ((0, '1'), (-3, '0.001'), (-6, '1e-6'), (-9, '1e-9')):
        y = down(10 ** exponent)
        parts += [f'<path class="g" d="M{LEFT},{y:.1f}H{RIGHT}"/>', text(LEFT - 5, y + 4, words, 'end')]
    y = down(grid_error)
    parts += [f'<path class="e" d="M{LEFT},{y:.1f}H{RIGHT}"/>', text(RIGHT - 4, y - 5, "the grid's own error", 'end'),
              f'<rect class="f" x="{LEFT}" y="{TOP}" width="{RIGHT - LEFT}" height="{BOTTOM - TOP}"/>',
              f'<path class="a" d="M{LEFT + 36},{BOTTOM - 36}L{LEFT + 12},{BOTTOM - 12}"/>',
              f'<path class="h" d="M{LEFT + 7},{BOTTOM - 7}l3,-11l8,8z"/>', text(LEFT + 6, BOTTOM - 42, 'better')]
    return parts


def curve(place, points):
    """One code: (seconds, error), from loose to tight, down to the least error that is shown."""
    name, _, _, marker, (seconds, error, anchor) = CODES[place]
    look = f'c{list(CODES).index(place)}'
    shown = [(across(time), down(error)) for time, error in points if ERRORS[0] <= error <= ERRORS[1]]
    path = 'L'.join(f'{x:.1f},{y:.1f}' for x, y in shown)
    marks = ''.join(MARKERS[marker].format(x=f'{x:.1f}', y=f'{y:.1f}') for x, y in shown)
    bold = ' t' if place == OURS else ''
    return [f'<g class="{look}"><path d="M{path}" style="fill:none" stroke-width="{2.5 if bold else 1.5}"/>{marks}</g>',
            text(across(seconds), down(error), name, anchor, f' class="n{look}{bold}"')]


def draw(file, points, grid_error):
    """points: by code, those of CODES."""
    light, dark = ([f'.c{i}{{stroke:{code[side]};fill:{code[side]}}}.nc{i}{{fill:{code[side]}}}' for i, code in enumerate(CODES.values())] for side in (1, 2))
    parts = frame(grid_error) + [part for code in CODES if points.get(code) for part in curve(code, points[code])]
    parts.append(text((LEFT + RIGHT) / 2, BOTTOM + 34, 'set-up and solve', 'middle'))
    style = f'<style>{STYLE}{"".join(light)}@media(prefers-color-scheme:dark){{{DARK}{"".join(dark)}}}</style>'
    with open(file, 'w', encoding='utf-8') as svg:
        svg.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" role="img">\n'
                  f'<title>Time against error of roughcontact, our Polonsky-Keer and other codes</title>\n{style}\n' + '\n'.join(parts) + '\n</svg>\n')
