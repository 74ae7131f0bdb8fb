"""The pages of the documentation, and the fenced blocks in them."""

import pathlib
import re
from dataclasses import dataclass

SOURCE = pathlib.Path(__file__).resolve().parents[3]


@dataclass
class Block:
    """A fenced block: the language behind its fence, its lines, where it begins, and the comment and the file name before it."""

    language: str
    text: str
    line: int
    comment: str
    name: str


def pages():
    """README.md, what lies beside it, docs and the README of every folder, without what is built."""
    found = [*SOURCE.glob('*.md'), *SOURCE.glob('[!.]*/**/*.md')]
    return sorted(page for page in found if not page.relative_to(SOURCE).parts[0].startswith('build'))


def blocks(text):
    """A comment `<!-- ... -->` on the line before a fence belongs to the block; so does `NAME`: in the line that ends before it."""
    found = []
    for match in re.finditer(r'^(?:(?:[^\n]*`([\w.-]+)`:\n\n)?|<!-- ([^\n]*) -->\n)```([\w-]*)\n(.*?)^```$', text, re.M | re.S):
        name, comment, language, body = match.groups()
        found.append(Block(language, body, text.count('\n', 0, match.start(4)), comment or '', name or ''))
    return found


def without_blocks(text):
    """The text, with the lines of fenced blocks left blank, so that line numbers stay."""
    return re.sub(r'^```.*?^```$', lambda match: '\n' * match[0].count('\n'), text, flags=re.M | re.S)
