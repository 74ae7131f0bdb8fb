"""device_tables.py LINES PASSES OUTPUT COMMIT DEVICE [DOCUMENT]: what bench/device.sh measured, as one file of JSON and as the tables of
docs/device.md, between their marks."""
import json
import pathlib
import sys
import time

BEGIN, END = '<!-- begin measured -->', '<!-- end measured -->'


def solves_table(solves):
    """Each solve on the device, beside the same on two threads of the host."""
    text = ['| grid | control | tol | status | products | first solve [s] | next solves [s] | two threads [s] | times faster |',
            '|---|---|---|---|---|---|---|---|---|']
    for row in solves:
        if row['backend'] == 'fft':
            continue
        beside = [other['seconds'] for other in solves if other['backend'] == 'fft'
                  and all(other[key] == row[key] for key in ('n', 'control', 'tol'))]
        host, faster = (f'{beside[0]:.3g}', f"{beside[0] / row['seconds']:.3g}") if beside else ('not measured', '')
        text.append(f"| {row['n']}² | {row['control']} | {row['tol']:g} | {row['status']} | {row['products']} | {row['first_seconds']:.3g} | "
                    f"{row['seconds']:.3g} | {host} | {faster} |")
    return text


def batches_table(batches):
    text = ['| contacts of 64² | solver, backend, threads | certified | first batch [s] | solves a second (goal: 100000) |', '|---|---|---|---|---|']
    return text + [f"| {row['batch']} | {row['solver']}, {row['backend']}, {row['threads']} | {row['certified']} | {row['first_seconds']:.3g} | {row['solves_per_second']:.4g} |"
                   for row in batches]


def passes_table(passes):
    if not passes:
        return []
    rate = {row['pass']: row['bytes'] / row['seconds'] for row in passes['passes']}
    text = [f"| pass over {passes['n']}² cells | seconds | bytes a second | share of a copy's |", '|---|---|---|---|']
    return text + [f"| {row['pass']} | {row['seconds']:.3g} | {rate[row['pass']]:.3g} | {rate[row['pass']] / rate['copy']:.2f} |"
                   for row in passes['passes']]


def row_of(line):
    """A line of JSON; a line that is cut off or has nan becomes a row of failures."""
    try:
        return json.loads(line)
    except ValueError:
        return {'failed': line}


def main():
    lines, passes, output, commit, device, *document = sys.argv[1:]
    rows = [row_of(line) for line in pathlib.Path(lines).read_text().splitlines()]
    try:
        measured = json.loads(pathlib.Path(passes).read_text())
    except ValueError:  # it failed half-way, which a line says
        measured = {}
    result = {'benchmark': 'device', 'date': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime()), 'commit': commit, 'device': device,
              'solves': [row for row in rows if 'control' in row], 'batches': [row for row in rows if 'batch' in row],
              'missing': [row for row in rows if 'failed' in row or 'left_out' in row], **measured}
    pathlib.Path(output).write_text(json.dumps(result, indent=1) + '\n')
    text = [f'Measured by `bench/device.sh` on {device}, commit {commit}; transfers and the certificate are included, set-up is in the '
            'first solve.', '', *solves_table(result['solves']), '', *batches_table(result['batches']), '', *passes_table(measured), '',
            *(f"Not measured: {row.get('failed') or row['left_out']}." for row in result['missing'])]
    if document:
        page = pathlib.Path(document[0])
        before, rest = page.read_text().split(BEGIN)
        page.write_text(f'{before}{BEGIN}\n' + '\n'.join(text).rstrip() + f'\n{END}{rest.split(END)[1]}')
    print('\n'.join(text))


main()
