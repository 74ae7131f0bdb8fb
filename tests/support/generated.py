"""A document of which a part is generated: compares that part with what is generated now, or rewrites it."""
import difflib
import os
import pathlib
import sys


def compare(document, mark, generated, source, update):
    """The text after `mark` (all of the document if that is empty) must be `generated`, which comes from `source`."""
    document = pathlib.Path(document)
    text = document.read_text() if document.exists() else ''
    head, found, present = text.partition(mark) if mark else ('', True, text)
    if not found:
        sys.exit(f'{document}: the line that starts the generated part is missing:\n{mark}')
    if mark:
        head, present, generated = head + mark, present.strip('\n') + '\n', generated.strip('\n') + '\n'
        if update:
            head += '\n'
    if update:
        temporary = document.with_name(document.name + '.new')
        temporary.write_text(head + generated)
        os.replace(temporary, document)
    elif present != generated:
        sys.stdout.writelines(difflib.unified_diff(present.splitlines(True), generated.splitlines(True), str(document), source))
        sys.exit(f'{document} and {source} differ; scripts/update-docs.sh BUILD renews it')
