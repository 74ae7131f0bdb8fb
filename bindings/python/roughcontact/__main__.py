"""python -m roughcontact: the command `roughcontact`, and `report`, see `roughcontact.report`."""

import sys

from ._command import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
