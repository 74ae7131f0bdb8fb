"""Tables: of records, for a terminal, and for documents between the markers that name them."""
import re
import sys


def cell(row, key, form):
    value = row.get(key)
    if value is None:
        return ''
    return value if isinstance(value, str) else str(value) if isinstance(value, int) and not form else f'{value:{form or "g"}}'


def aligned(rows):
    """Text of rows of cells, columns of one width."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    return '\n'.join('  '.join(text.rjust(width) for text, width in zip(row, widths)) for row in rows)


def show(columns, rows):
    """Prints records. columns: "title=key:format; ..."; the title alone where it is the key."""
    titles, keys, forms = zip(*(re.fullmatch('(?:(.*)=)?([^:=]*)(?::(.*))?', each).groups() for each in columns.split('; ')))
    lines = [[title or key for title, key in zip(titles, keys)]]
    for row in rows:
        lines.append([cell(row, key, form) for key, form in zip(keys, forms)])
        lines[-1][-1] += row.get('error', '')
    print(aligned(lines), flush=True)


def table(titles, rows):
    lines = ['| ' + ' | '.join(titles) + ' |', '|' + '---|' * len(titles)]
    return '\n'.join(lines + ['| ' + ' | '.join(row) + ' |' for row in rows])


def show_table(text):
    """Prints the table of a document."""
    print(aligned([line[2:-2].split(' | ') for line in text.splitlines() if line.startswith('| ')]), flush=True)


def seconds(value):
    return f'{value:.2g}' if value < 10 else f'{value:.0f}'


def error(value):
    return '0' if value == 0 else f'{value:.0e}'


def missing(command):
    return f'Not measured yet: `{command}`.'


def provenance(document):
    known = document['provenance']
    threads = f'{known["threads"]} thread{"s" if known["threads"] > 1 else ""}'
    return (f'{known["cpu"]}, {threads}; {known["compiler"]}, {known["flags"]}; {known["fftw"]}; roughcontact {known["version"]} '
            f'({known["commit"]}); {known["date"][:10]}; load average at the start {known["load_average_at_start"]:.1f}.')


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
