"""Runs the notebooks of docs/gallery, with the Python of scripts/docs-venv.sh: each ends without an error and draws one picture, of the
size that the page shows.

Usage: gallery.py [--update] [NAME...]   (ROUGHCONTACT_LIBRARY and PYTHONPATH say which library and package)
--update writes the pictures beside the notebooks.
"""

import base64
import io
import sys
import tempfile

import jupytext
import nbclient
from PIL import Image

import pages

GALLERY = pages.SOURCE / 'docs/gallery'
LARGEST = 100_000  # bytes of a picture that is committed


def drawn(notebook):
    """The pictures of a notebook, run in a scratch folder."""
    book = jupytext.read(notebook, fmt='py:percent')
    with tempfile.TemporaryDirectory() as folder:
        nbclient.NotebookClient(book, timeout=300, kernel_name='python3', resources={'metadata': {'path': folder}}).execute()
    outputs = [output for cell in book.cells for output in cell.get('outputs', [])]
    return [base64.b64decode(output['data']['image/png']) for output in outputs if 'image/png' in output.get('data', {})]


def with_few_colours(picture):
    small = io.BytesIO()
    Image.open(io.BytesIO(picture)).convert('RGB').quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(
        small, 'png', optimize=True
    )
    return small.getvalue()


def trouble(notebook, update):
    """What is wrong with a notebook; empty: nothing."""
    try:
        pictures = drawn(notebook)
    except nbclient.exceptions.CellExecutionError as error:
        return str(error)
    if len(pictures) != 1:
        return f'{len(pictures)} pictures, one is expected'
    shown, picture = notebook.with_suffix('.png'), with_few_colours(pictures[0])
    if update:
        shown.write_bytes(picture)
    if not shown.exists() or shown.stat().st_size > LARGEST:
        return f'{shown.name} is missing or larger than {LARGEST} bytes'
    committed, found = Image.open(shown).size, Image.open(io.BytesIO(picture)).size
    # Tick labels may be wider where other times are measured.
    if max(abs(a - b) for a, b in zip(committed, found)) > 20:
        return f'the picture has {found} pixels, {shown.name} {committed}'
    return ''


def main():
    names = [name for name in sys.argv[1:] if name != '--update']
    notebooks = [GALLERY / f'{name}.py' for name in names] or sorted(GALLERY.glob('*.py'))
    wrong = 0
    for notebook in notebooks:
        why = trouble(notebook, '--update' in sys.argv)
        print(f'{notebook.stem}: {why or "ok"}', flush=True)
        wrong += bool(why)
    print(f'{len(notebooks)} notebooks, {wrong} wrong')
    return 1 if wrong or not notebooks else 0


if __name__ == '__main__':
    sys.exit(main())
