"""The sub-commands: what each asks, and what it takes, by default and with --quick."""
import argparse
import os

THREADS = os.cpu_count() or 1
PARSER = argparse.ArgumentParser(prog='roughcontact-bench', description='Benchmarks of the roughcontact library')
COMMANDS = PARSER.add_subparsers(required=True, metavar='COMMAND')


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
    return lambda text: [kind(word) for word in text.split(',') if word]


def folder(text):
    if not os.path.isdir(text):
        raise argparse.ArgumentTypeError(f'{text} is no folder')
    return text


threads = ranged(int, 1, 1024)
side = ranged(int, 16, 16384)
percent = ranged(float, 0.001, 95)
CONTROLS = one_of('approach', 'load')
ALL_THREADS = {'threads': (threads, THREADS, 'threads')}


def question(name, text, run, options, quick=(), quick_text='', names=()):
    """A sub-command. options: name: (type, default, text); bool: a flag. quick: defaults in the place of those, and the text of --quick.
    names: what may be named without an option."""
    parser = COMMANDS.add_parser(name, help=text, description=text)
    for option, (kind, default, words) in options.items():
        shown = ','.join(map(str, default)) if isinstance(default, (list, tuple)) else '' if kind is bool else default
        parser.add_argument('--' + option.replace('_', '-'), default=argparse.SUPPRESS, help=words if shown == '' else f'{words} ({shown})',
                            **({'action': 'store_true'} if kind is bool else {'type': kind}))
    if quick_text:
        parser.add_argument('--quick', action='store_true', default=argparse.SUPPRESS, help=quick_text)
    if names:
        parser.add_argument('names', nargs='*', metavar='NAME', choices=[*names, []], help=', '.join(names) + '; all')
    parser.add_argument('--json', default='', help='results, in JSON')

    def answer(given):
        values = {option: default for option, (_, default, _) in options.items()}
        run(argparse.Namespace(**{**values, 'quick': False, **dict(quick if 'quick' in given else ()), **vars(given)}))
    parser.set_defaults(answer=answer)
