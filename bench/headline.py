"""The chart of README.md: time against error at one contact with free and one with periodic edges, as SVG for light and dark pages."""
import math

LEVEL = 1e-4  # at which the times are compared
CASES = {'rough-512-free-load-10': 'free edges', 'wavy-512-periodic-load-10': 'periodic edges'}
SIDE, TOP, HIGH, GAP, LEFT = 300, 58, 200, 24, 66
TIMES, ERRORS = (2e-2, 3e1), (1e-11, 1e-3)
# Code: name, light colour, dark colour, marker; (seconds, error, anchor) of its name at free and periodic edges.
CODES = {'ours': ('roughcontact', '#0072B2', '#56B4E9', 'circle', [(4.9e-2, 6e-6, 'start'), (4e-2, 6e-6, 'start')]),
         'baseline': ('textbook Polonsky-Keer', '#B35900', '#E69F00', 'square', [(1.55, 2.2e-10, 'end'), None]),
         'aspher-fft': ('ASPHER', '#00785A', '#40C9A0', 'triangle', [(1.65, 7e-7, 'start'), None]),
         'aspher-periodic': ('ASPHER', '#00785A', '#40C9A0', 'triangle', [None, (0.2, 5.5e-7, 'start')]),
         'contactmechanics': ('ContactMechanics', '#A0307A', '#E08AC0', 'diamond', [(25, 3.5e-11, 'end'), (0.42, 2.5e-10, 'start')]),
         'tamaas-free': ('Tamaas', '#555555', '#BBBBBB', 'cross', [(10.3, 1.5e-5, 'end'), None]),
         'tamaas': ('Tamaas', '#555555', '#BBBBBB', 'cross', [None, (1.6, 3e-5, 'end')])}
STYLE = '''text{font:12px "DejaVu Sans",Verdana,sans-serif;fill:#222}.t{font-weight:bold}.s{font-size:10.5px}.g{stroke:#ddd}.f{stroke:#777;fill:none}
.e{stroke:#222;stroke-dasharray:5 3}'''
DARK = 'text{fill:#ddd}.g{stroke:#444}.f{stroke:#999}.e{stroke:#ddd}'
MARKERS = {'circle': '<circle cx="{x}" cy="{y}" r="4"/>', 'square': '<path d="M{x},{y}m-3.5,-3.5h7v7h-7z"/>',
           'triangle': '<path d="M{x},{y}m0,-4.5l4.2,7.5h-8.4z"/>', 'diamond': '<path d="M{x},{y}m0,-5l4.5,5l-4.5,5l-4.5,-5z"/>',
           'cross': '<path d="M{x},{y}m-3.5,-3.5l7,7m0,-7l-7,7" stroke-width="2"/>'}
WIDTH, HEIGHT = LEFT + 2 * SIDE + GAP + 8, TOP + HIGH + 76


def part(value, ends):
    return math.log(value / ends[0]) / math.log(ends[1] / ends[0])


class Panel:
    """One contact. runs: of each code (seconds, error), from loose to tight."""

    def __init__(self, number, title, runs):
        self.number, self.left, self.title, self.runs = number, LEFT + number * (SIDE + GAP), title, runs

    def across(self, seconds):
        return self.left + SIDE * part(seconds, TIMES)

    @staticmethod
    def down(error):
        return TOP + HIGH * (1 - part(error, ERRORS))

    def frame(self):
        bottom, right = TOP + HIGH, self.left + SIDE
        parts = [text(self.left + SIDE / 2, TOP - 8, self.title, 'middle', ' class="t"')]
        for seconds in (0.1, 1, 10):
            parts += [f'<path class="g" d="M{self.across(seconds):.1f},{TOP}V{bottom}"/>', text(self.across(seconds), bottom + 16, f'{seconds:g} s', 'middle')]
        for exponent in (-4, -6, -8, -10):
            y = self.down(10 ** exponent)
            parts.append(f'<path class="{"e" if exponent == -4 else "g"}" d="M{self.left},{y:.1f}H{right}"/>')
            parts += [text(self.left - 5, y + 4, f'1e{exponent}', 'end')] if self.number == 0 else []
        return [*parts, f'<rect class="f" x="{self.left}" y="{TOP}" width="{SIDE}" height="{HIGH}"/>']

    def ratio(self, code):
        """Time to LEVEL over ours."""
        first = {name: min(seconds for seconds, error in runs if error <= LEVEL) for name, runs in self.runs.items()}
        return first[code] / first['ours']

    def curve(self, code):
        name, _, _, marker, places = CODES[code]
        look = f'c{list(CODES).index(code)}'
        shown = [(self.across(seconds), self.down(error)) for seconds, error in self.runs[code]]
        path = 'L'.join(f'{x:.1f},{y:.1f}' for x, y in shown)
        marks = ''.join(MARKERS[marker].format(x=f'{x:.1f}', y=f'{y:.1f}') for x, y in shown)
        ours, (seconds, error, anchor) = code == 'ours', places[self.number]
        words = name if ours else f'{name} {float(format(self.ratio(code), ".2g")):g} \u00d7'
        return [f'<g class="{look}"><path d="M{path}" style="fill:none" stroke-width="{2.5 if ours else 1.5}"/>{marks}</g>',
                text(self.across(seconds), self.down(error), words, anchor, f' class="n{look}{" t" if ours else ""}"')]


def text(x, y, words, anchor='start', more=''):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{words}</text>'


def draw(file, panels, below):
    """panels: {case of CASES: {code: [(seconds, error), ...]}}; below: lines with processor, threads, date and judge."""
    light, dark = ([f'.c{i}{{stroke:{code[side]};fill:{code[side]}}}.nc{i}{{fill:{code[side]}}}' for i, code in enumerate(CODES.values())] for side in (1, 2))
    parts = [text(8, 16, 'Time to an error, 512² points, 10 % in contact, at a given load'),
             text(8, 32, 'numbers: the time that a code takes to 1e-4, in multiples of ours', more=' class="s"'),
             f'<text transform="translate(16,{TOP + HIGH / 2}) rotate(-90)" text-anchor="middle">largest error of a contact condition</text>',
             text(LEFT + SIDE + GAP / 2, TOP + HIGH + 34, 'set-up and solve', 'middle'), *(text(8, HEIGHT - 22 + 15 * k, line, more=' class="s"') for k, line in enumerate(below))]
    for number, (case, title) in enumerate(CASES.items()):
        panel = Panel(number, title, panels[case])
        parts += panel.frame()
        for code in CODES:
            parts += panel.curve(code) if code in panel.runs and CODES[code][4][number] else []
    style = f'<style>{STYLE}{"".join(light)}@media(prefers-color-scheme:dark){{{DARK}{"".join(dark)}}}</style>'
    with open(file, 'w', encoding='utf-8') as svg:
        svg.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" role="img">\n'
                  f'<title>Time against error of roughcontact, a textbook Polonsky-Keer and other codes</title>\n{style}\n' + '\n'.join(parts) + '\n</svg>\n')
