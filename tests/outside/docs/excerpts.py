"""Every piece of C and C++ in a document stands in one of the sources, word for word.

Usage: excerpts.py DOCUMENT SOURCE...
"""
import pathlib
import sys

import pages

document, *sources = (pathlib.Path(name).read_text() for name in sys.argv[1:])
pieces = [block.text for block in pages.blocks(document) if block.language in ('c', 'cpp')]
# A blank line may stand for what the document leaves out.
missing = [part for piece in pieces for part in piece.strip().split('\n\n') if not any(part in source for source in sources)]
for part in missing:
    print(f'in no source:\n{part}\n')
sys.exit(1 if missing or not pieces else 0)
