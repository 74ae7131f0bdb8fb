"""Options of the sub-commands: what each takes, and what it takes by default and with --quick."""
import argparse
import os
from dataclasses import dataclass, field
from typing import Callable

THREADS = os.cpu_count() or 1


def ranged(kind, low, high):
    def parse(text):
        value = kind(text)
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(f'{text} is not in {low:g} .. {high:g}')
        return value
    return parse


def one_of(*names):
    def parse(text):
        if text not in names:
            raise argparse.ArgumentTypeError(f'{text} is none of {", ".join(names)}')
        return text
    return parse


def listed(kind):
    return lambda text: [kind(word) for word in text.split(',')]


def folder(text):
    if not os.path.isdir(text):
        raise argparse.ArgumentTypeError(f'{text} is no folder')
    return text


threads = ranged(int, 1, 1024)
side = ranged(int, 16, 16384)
percent = ranged(float, 0.001, 95)
CONTROLS = one_of('displacement', 'load')


@dataclass(frozen=True)
class Question:
    """options: name: (type, default, text); bool: a flag. quick: defaults in the place of those, and the text of --quick.
    names: what may be named without an option."""
    name: str
    text: str
    run: Callable
    options: dict
    quick: dict = field(default_factory=dict)
    quick_text: str = ''
    names: tuple = ()

    def add_to(self, commands):
        parser = commands.add_parser(self.name, help=self.text, description=self.text)
        for name, (kind, default, text) in self.options.items():
            flag = '--' + name.replace('_', '-')
            if kind is bool:
                parser.add_argument(flag, action='store_true', default=argparse.SUPPRESS, help=text)
            else:
                shown = ','.join(map(str, default)) if isinstance(default, (list, tuple)) else default
                parser.add_argument(flag, type=kind, default=argparse.SUPPRESS, help=f'{text} ({shown})' if shown != '' else text)
        if self.quick_text:
            parser.add_argument('--quick', action='store_true', default=argparse.SUPPRESS, help=self.quick_text)
        if self.names:
            parser.add_argument('names', nargs='*', metavar='NAME', choices=[*self.names, []], help=', '.join(self.names) + '; all')
        parser.add_argument('--json', default='', help='results, in JSON')
        parser.set_defaults(question=self)

    def answer(self, given):
        values = {name: default for name, (_, default, _) in self.options.items()}
        values.update(quick=False, **(self.quick if 'quick' in given else {}))
        self.run(argparse.Namespace(**{**values, **vars(given)}))
