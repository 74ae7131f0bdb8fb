#!/usr/bin/env python3
"""Names that clash where all files of a target are compiled as one batch: two of them define the name in an unnamed namespace, or
as a static function, in the same namespaces."""
import collections
import pathlib
import re
import subprocess
import sys

# Beginnings of the names of a target's files; the longest one counts.
TARGETS = ('src/', 'formats/', 'surface/', 'mpi/', 'backends/cholmod/', 'backends/common/', 'backends/dense/', 'backends/fft/',
           'backends/split/')
COMMENT, TEXT, DIRECTIVE = r'//[^\n]*|/\*.*?\*/', r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', r'^[ \t]*#(?:\\\n|[^\n])*'
TOKEN = re.compile(rf'{COMMENT}|{TEXT}|{DIRECTIVE}|[\w:~]+|\S', re.S | re.M)
NO_NAMES = {'operator', 'noexcept', 'decltype', 'alignas', 'requires', 'static_assert', 'const'}


def hidden_names(text):
    """(namespaces, name, arguments) of what a file hides from others: in unnamed namespaces, or static."""
    scopes, statement, round_brackets = [], [], 0
    for token in TOKEN.findall(text):
        if token[0] in '#"\'' or token.startswith(('//', '/*')):
            continue
        round_brackets += (token == '(') - (token == ')')
        inside = all(kind == 'namespace' for kind, _ in scopes)
        if token == '{' or (token in ';=' and round_brackets == 0):
            if inside and statement and statement[0] != 'using' and 'namespace' not in statement:
                hidden = ('namespace', '') in scopes or statement[0] == 'static'
                if hidden and (found := defined(statement)) and (token != ';' or not found[1]):
                    yield tuple(name for _, name in scopes if name), *found
        if token == '{':
            space = 'namespace' in statement and statement[0] in ('namespace', 'inline')
            scopes.append(('namespace', statement[-1] if statement[-1] != 'namespace' else '') if space else ('block', ''))
        elif token == '}' and scopes:
            scopes.pop()
        if token in '{}' or (token == ';' and round_brackets == 0):
            statement, round_brackets = [], 0
        elif token == '=' and inside and round_brackets == 0:
            statement = ['=']  # what follows is a value
        else:
            statement.append(token)


def defined(words):
    """The name that this begins to define, and the arguments of a function, which may be overloaded; None: it defines none."""
    if words[0] == '=':
        return None
    if 'template' in words:  # behind its arguments
        depth = 0
        for i, word in enumerate(words):
            depth += (word == '<') - (word == '>')
            if word == '>' and depth == 0:
                words = words[i + 1:]
                break
    for kind in ('struct', 'class', 'enum', 'union'):
        if kind in words and '(' not in words:
            rest = [word for word in words[words.index(kind) + 1:] if word not in ('class', 'final')]
            return (rest[0], '') if rest and rest[0][0].isalpha() else None
    if '(' in words:
        i = words.index('(')
        name = words[i - 1] if i > 1 else ''
        if not re.fullmatch(r'[A-Za-z_]\w*', name) or name in NO_NAMES:
            return None
        return name, ' '.join(word for word in words[i:] if not re.fullmatch(r'\w+', word) or word[0].islower())
    words = [word for word in words if re.fullmatch(r'[A-Za-z_][\w:]*', word)]
    return (words[-1], '') if len(words) > 1 and re.fullmatch(r'\w+', words[-1]) else None


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else '.').resolve()
    files = subprocess.run(['git', '-C', root, 'ls-files', '*.cpp'], capture_output=True, text=True, check=True).stdout.split()
    places = collections.defaultdict(set)
    for file in files:
        if target := max((each for each in TARGETS if file.startswith(each)), key=len, default=''):
            for spaces, name, arguments in hidden_names((root / file).read_text()):
                places[target, spaces, name, arguments].add(file)
    clashes = [(key, sorted(found)) for key, found in sorted(places.items()) if len(found) > 1]
    for (_, spaces, name, _), found in clashes:
        print(f'{"::".join(spaces)}::{name} is defined in {", ".join(found)}, which one batch may hold')
    print(f'{len(places)} hidden names, {len(clashes)} of them in two files of a target')
    return 1 if clashes or not places else 0


sys.exit(main())
