"""Tables of records: for a terminal, and in Markdown or as CSV for documents, between the markers that name them."""
import csv
import os
import re
import string
import sys

SCALES = {'%': 100, 'm': 1000}


def seconds(value):
    return f'{value:.2g}' if value < 10 else f'{value:.0f}'


def error(value):
    return '0' if value == 0 else f'{value:.0e}'


class Words(string.Formatter):
    """str.format with more formats: "s" for seconds, "err" for errors, "%" or "m" before others for 100 or 1000 times the value."""

    def format_field(self, value, form):
        if form in ('s', 'err'):
            return (seconds if form == 's' else error)(value)
        return format(SCALES[form[0]] * value, form[1:]) if form[:1] in SCALES else format(value, form)


def cell(row, template):
    """Empty where the record lacks a value."""
    known = {key: value for key, value in row.items() if value is not None}
    try:
        return Words().vformat(template, (), known)
    except KeyError:
        return ''


def cells(columns, rows):
    """Titles and lines of records. columns: "title={key:format} and text; ...", or the key alone where that is the title."""
    pairs = [(title, template or f'{{{title}}}') for title, _, template in (each.partition('=') for each in columns.split('; '))]
    return [[title for title, _ in pairs]] + [[cell(row, template) for _, template in pairs] for row in rows]


def aligned(lines):
    """Text of lines of cells, columns of one width."""
    widths = [max(map(len, column)) for column in zip(*lines)]
    return '\n'.join('  '.join(text.rjust(width) for text, width in zip(line, widths)) for line in lines)


def show(columns, rows):
    """Prints records, each with its error if it has one."""
    lines = cells(columns, rows)
    for line, row in zip(lines[1:], rows):
        line[-1] += row.get('error', '')
    print(aligned(lines), flush=True)


def table(titles, lines):
    return '\n'.join(['| ' + ' | '.join(titles) + ' |', '|' + '---|' * len(titles)] + ['| ' + ' | '.join(line) + ' |' for line in lines])


def records(columns, rows):
    """A document's table of records."""
    titles, *lines = cells(columns, rows)
    return table(titles, lines)


def missing(command):
    return f'Not measured yet: `{command}`.'


def provenance(document):
    known = document['provenance']
    threads = f'{known["threads"]} thread{"s" if known["threads"] > 1 else ""}'
    return (f'{known["cpu"]}, {threads}; {known["compiler"]}, {known["flags"]}; {known["fftw"]}; roughcontact {known["version"]} '
            f'({known["commit"]}); {known["date"][:10]}; load average at the start {known["load_average_at_start"]:.1f}.')


def lines_of(markdown):
    """The cells of a table in Markdown, titles first."""
    titles, _, *lines = markdown.strip().split('\n')
    return [[text.strip().replace('\\|', '|') for text in re.split(r'(?<!\\)\|', line.strip()[1:-1])] for line in (titles, *lines)]


def stored(body, folder, name):
    """The body with a link in place of each table, which is written to this file of the folder, a second one to NAME-2.csv."""
    files = []

    def write(match):
        files.append(name if not files else name.replace('.csv', f'-{len(files) + 1}.csv'))
        place = os.path.join(folder, files[-1])
        os.makedirs(os.path.dirname(place), exist_ok=True)
        with open(place, 'w', encoding='utf-8', newline='') as out:
            csv.writer(out, lineterminator='\n').writerows(lines_of(match[0]))
        return f'[{os.path.basename(files[-1])}]({files[-1]})\n'

    return re.sub(r'(?:^\|.*(?:\n|$))+', write, body, flags=re.MULTILINE).rstrip('\n')


def fill(file, sections):
    """Replaces what stands between the markers of each section of a document. If the first marker ends with "as tables/NAME.csv", the
    section's tables are in that file, and the document has a link to it."""
    with open(file, encoding='utf-8') as source:
        text = source.read()
    for name, body in sections.items():
        pattern = re.compile(f'(<!-- begin {name}(?: as (\\S+))? -->\n).*?(<!-- end {name} -->)', re.DOTALL)

        def filled(match):
            return match[1] + (stored(body, os.path.dirname(file), match[2]) if match[2] else body) + '\n' + match[3]

        text, count = pattern.subn(filled, text)
        if count != 1:
            sys.exit(f'{file}: no markers "begin {name}" and "end {name}"')
    with open(file, 'w', encoding='utf-8') as out:
        out.write(text)
