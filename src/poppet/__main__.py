"""`python -m poppet` is the command line."""

import sys

from poppet.cli.main import run

if __name__ == "__main__":
    sys.exit(run())
