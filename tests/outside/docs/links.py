"""Every relative link and picture of a page leads to a file of the source tree, every anchor to a heading, and every page and picture
of docs is reached from a page. The pages have no more words than CONTRIBUTING.md allows. Needs no network: links to other sites are
not followed.
"""

import collections
import re
import sys
import urllib.parse

from pages import SOURCE, pages, without_blocks


MOST_WORDS = {'users': (('docs', 'docs/how-to'), 42000), 'developers': (('docs/development',), 30000)}


def anchors(text):
    """The anchors of the headings, as a forge makes them."""
    seen, found = collections.Counter(), set()
    for title in re.findall(r'^#+ +(.*?) *$', without_blocks(text), re.M):
        title = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', title)
        slug = re.sub(r'[^\w\- ]', '', title.lower()).replace(' ', '-')
        found.add(f'{slug}-{seen[slug]}' if seen[slug] else slug)
        seen[slug] += 1
    return found


def main():
    texts = {page: page.read_text(encoding='utf-8') for page in pages()}
    wrong, reached, count = [], {SOURCE / 'README.md'}, 0
    for page, text in texts.items():
        prose = re.sub(r'`[^`\n]*`', lambda match: ' ' * len(match[0]), without_blocks(text))
        for match in re.finditer(r'\]\(([^()\s]+)\)', prose):
            target = match[1]
            where = f'{page.relative_to(SOURCE)}:{prose.count(chr(10), 0, match.start()) + 1}: {target}'
            if re.match(r'[a-z]+:', target):
                continue
            count += 1
            path, _, anchor = target.partition('#')
            file = (page.parent / urllib.parse.unquote(path)).resolve() if path else page
            reached.add(file)
            if path.startswith('/') or not file.exists() or SOURCE not in [file, *file.parents]:
                wrong.append(f'{where} is not in the source tree')
            elif file.is_dir():
                wrong.append(f'{where} is a folder: name the file to read')
            elif anchor and anchor not in anchors(texts.get(file, '')):
                wrong.append(f'{where}: no heading has this anchor')
    alone = [
        file
        for pattern in ('*.md', 'images/*', '*/*.md', 'gallery/*', 'development/tables/*')
        for file in (SOURCE / 'docs').glob(pattern)
        if file.is_file() and file not in reached
    ]
    wrong += [f'{file.relative_to(SOURCE)}: no page links to it' for file in alone]
    for reader, (folders, most) in MOST_WORDS.items():
        words = sum(len(text.split()) for page, text in texts.items() if str(page.parent.relative_to(SOURCE)) in folders)
        wrong += [f'the pages for {reader} have {words} words, at most {most} are allowed'] if words > most else []
    print('\n'.join(wrong))
    print(f'{count} links on {len(texts)} pages, {len(wrong)} wrong')
    return 1 if wrong or not count else 0


sys.exit(main())
