"""The table of docs/benchmarks.md, from products.json."""
from store import load
from tables import error, provenance, table


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


def sections(results):
    products = load(results, 'products')
    return {'provenance': provenance(products), 'products': product_table(products)}
