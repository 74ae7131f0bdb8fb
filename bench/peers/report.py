#!/usr/bin/env python3
"""report.py RESULTS DOCUMENT: writes the tables of peers.json in the folder RESULTS between the markers of DOCUMENT. Also the lines that
a run prints."""
import os
import sys

from certificate import LEVELS
from store import best, growth, total

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))

BUSY = 0.2  # cores that others took: such a time is marked


def seconds(value):
    return f'{value:.2g}' if value < 10 else f'{value:.0f}'


def time_cell(group, level):
    run = best(group, level)
    if run is None:
        if 'limit' in group['stopped']:
            return f'> {group["limit"]:g}'
        return 'not measured' if group['stopped'] else 'not reached'
    return seconds(total(run)) + ('*' if (run.get('other_cores') or 0) > BUSY else '')


def lines(store, key):
    """One line a code: times to the levels, then the parts of the tightest level met."""
    groups = {group['code']: group for group in store['groups'] if group['case'] == key}
    ours = groups.get('ours')
    found = []
    for name in store['codes']:
        if name not in groups:
            continue
        group = groups[name]
        line = [store['codes'][name]['title']] + [time_cell(group, level) for level in LEVELS]
        tightest = next(((level, run) for level in reversed(LEVELS) if (run := best(group, level))), None)
        if tightest:
            level, run = tightest
            mine = best(ours, level) if ours else None
            line += [f'{level:.0e}', seconds(run['setup_seconds']), seconds(run['solve_seconds']), str(run.get('products', '')),
                     f'{growth(run) / 2**20:.0f}', f'{run["peak_bytes"] / 2**20:.0f}',
                     f'{total(run) / total(mine):.2f}' if mine else '', f'{run["residual"]:.0e}']
        else:
            line += [''] * 8
        found.append(line + [group['stopped']])
    return found


TITLES = ['code', '1e-4 [s]', '1e-6 [s]', '1e-8 [s]', 'level', 'set-up [s]', 'solve [s]', 'products', 'memory [MiB]', 'peak [MiB]',
          'times ours', 'residual', 'remark']


def print_case(store, key):
    document = store.document
    case = document['cases'][key]
    print(f'\n{case["title"]}: contact {100 * case["area"]:.3g} %, target {case["target"]:.6g}')
    rows = [TITLES] + lines(document, key)
    widths = [max(len(row[i]) for row in rows) for i in range(len(TITLES))]
    for row in rows:
        print('  '.join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip(), flush=True)


def codes_table(document, table):
    rows = []
    for name, code in document['codes'].items():
        hertz = [f'{boundary} {100 * document["calibration"][key]["deviation"]:+.2f} %' for boundary in ('free', 'periodic')
                 if 'deviation' in document['calibration'].get(key := f'{name}, {boundary}', {})]
        rows.append([code['title'], code['version'] or '', ', '.join(hertz), code.get('not_run', '')])
    return table(['code', 'version', 'largest Hertz pressure off by', 'not run'], rows)


def cases_tables(document, table):
    parts = []
    for key, case in document['cases'].items():
        rows = lines(document, key)
        if rows:
            parts.append(f'**{case["title"]}**, contact {100 * case["area"]:.3g} % (surface by {case["maker"]})\n\n' +
                         table(TITLES, rows))
    return '\n\n'.join(parts)


def provenance(document):
    known = document['provenance']
    left = document.get('left_out') or []
    text = (f'{known["cpu"]}, {known["threads"]} threads a code; roughcontact {known["version"]} ({known["commit"]}), library '
            f'{known["library"]}; Python {known["python"]}, NumPy {known["numpy"]}; {known["date"][:10]}; load average at the start '
            f'{known["load_average_at_start"]:.1f}.')
    return text + (f' Not run, because the budget was spent: {"; ".join(left)}.' if left else '')


def main():
    from results import load
    from tables import fill, table
    results, file = sys.argv[1:]
    document = load(results, 'peers')
    fill(file, {'provenance': provenance(document), 'codes': codes_table(document, table), 'cases': cases_tables(document, table)})


if __name__ == '__main__':
    main()
