"""roughcontact-bench: time, memory and accuracy of the library, through its public interface alone."""
import importlib
import signal
import subprocess
import sys

import roughcontact

from case import Failure
from options import PARSER

for name in ('scaling', 'passes', 'products', 'small', 'overhead', 'speed_accuracy', 'goals', 'histories', 'failures', 'paper', 'physics',
             'published', 'peers', 'mapped', 'leak', 'ranks', 'documents'):
    importlib.import_module(name)  # each adds its sub-commands

if __name__ == '__main__':
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # the package then calls the library on this thread: no hand-over counts as time
    try:
        given = PARSER.parse_args()
        given.answer(given)
    except (Failure, roughcontact.RoughContactError, subprocess.CalledProcessError, OSError) as error:
        sys.exit(f'roughcontact-bench: {error}')
