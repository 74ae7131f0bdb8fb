#!/usr/bin/env python3
"""tables.py RESULTS DOCUMENT: writes the tables of the JSON files in the folder RESULTS between the markers of DOCUMENT."""
import re
import sys

from results import load


def table(titles, rows):
    lines = ['| ' + ' | '.join(titles) + ' |', '|' + '---|' * len(titles)]
    return '\n'.join(lines + ['| ' + ' | '.join(row) + ' |' for row in rows])


def seconds(value):
    return f'{value:.2g}' if value < 10 else f'{value:.0f}'


def error(value):
    return '0' if value == 0 else f'{value:.0e}'


def worst_residual(row):
    return max(row[key] for key in row if key.startswith('kkt_'))


def provenance(document):
    known = document['provenance']
    threads = f'{known["threads"]} thread{"s" if known["threads"] > 1 else ""}'
    return (f'{known["cpu"]}, {threads}; {known["compiler"]}, {known["flags"]}; {known["fftw"]}; roughcontact {known["version"]} '
            f'({known["commit"]}); {known["date"][:10]}; load average at the start {known["load_average_at_start"]:.1f}.')


def product_table(document):
    rows = []
    for row in document['products']:
        rows.append([f'{row["n"]}²', str(row['threads'])])
        for of in ('', 'single_') if 'single_ratio' in row else ('',):
            times = [row[of + key] for key in ('estimate_best', 'measure_best', 'padded_estimate_best', 'padded_measure_best')]
            rows[-1] += [f'{1000 * t:.3g}' for t in times] + [f'{times[3] / times[0]:.2f}', error(row[of + 'difference'])]
    names = ['fft [ms]', 'fft, measured plan', 'padded [ms]', 'padded, measured plan', 'ratio', 'difference']
    both = 'single_ratio' in document['products'][0]
    return table(['grid', 'threads'] + names + ([f'single: {name}' for name in names] if both else []), rows)


def fill(file, sections):
    """Replaces what stands between the markers of each section of a document."""
    with open(file, encoding='utf-8') as source:
        text = source.read()
    for name, body in sections.items():
        pattern = re.compile(f'(<!-- begin {name} -->\n).*?(<!-- end {name} -->)', re.DOTALL)
        text, count = pattern.subn(lambda match: match[1] + body + '\n' + match[2], text)
        if count != 1:
            sys.exit(f'{file}: no markers "begin {name}" and "end {name}"')
    with open(file, 'w', encoding='utf-8') as out:
        out.write(text)


def main():
    results, file = sys.argv[1:]
    products = load(results, 'products')
    fill(file, {'provenance': provenance(products), 'products': product_table(products)})


if __name__ == '__main__':
    main()
