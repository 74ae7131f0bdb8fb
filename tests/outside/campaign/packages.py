"""Imports what a test needs, or ends it as skipped."""

import importlib
import sys


def needed(*names):
    for name in names:
        try:
            importlib.import_module(name)
        except ImportError as absent:
            print(f"skipped: {absent} (for {sys.executable}; from PyPI, or Python 3.11 for tomllib)")
            sys.exit(77)
