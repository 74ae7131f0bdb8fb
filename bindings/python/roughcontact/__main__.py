"""python -m roughcontact report FILE ...: see `roughcontact.report`."""

import sys

from .report.command import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
