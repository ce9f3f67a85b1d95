"""The `driftpost` command line."""

import signal
import sys

from . import _driftpost


def main() -> int:
    # Python would only look at Ctrl-C after the program has ended.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _driftpost.main(["driftpost", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
