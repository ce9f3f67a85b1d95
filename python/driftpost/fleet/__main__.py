"""``python -m driftpost.fleet``: arguments, exit codes and what is said; no decisions."""

from __future__ import annotations

import argparse
import contextlib
import json
import signal
import sys
from typing import TextIO

from .._errors import DriftpostError


def main(words: list[str] | None = None) -> int:
    """Runs a command: 0 all rows done, 1 some refused (or, for watch, some robots changed), 2 could not run."""
    args = _parser().parse_args(words)
    try:
        return _run(args, sys.stdout)
    except DriftpostError as error:
        help = f"\n  help: {error.help}" if error.help else ""
        print(f"error{error}{help}", file=sys.stderr)
        return 2


def _run(args: argparse.Namespace, out: TextIO) -> int:
    try:
        from . import COMPENSATE, DIAGNOSE, run, watch
        from ._page import cause
    except ImportError as error:
        raise DriftpostError(f"{error.name} is not installed", "fleet::no-ray", "pip install 'driftpost[fleet]'") from None
    how = {"ray": not args.serial, "workers": args.workers, "address": args.address, "rows_a_task": args.rows_a_task}
    ranked = None
    # Ray tells of dead workers on standard output, which belongs to results.
    with contextlib.redirect_stdout(sys.stderr):
        if args.command == "watch":
            summary, ranked = watch(args.input, args.output, days=args.days, **how)
        else:
            summary = run({"compensate": COMPENSATE, "diagnose": DIAGNOSE}[args.command], args.input, args.output, **how)
    told = sys.stderr if args.json == "-" else out
    if ranked is not None:
        for row in ranked.compared[:10]:
            if row["changed"]:
                print(f"{row['robot_serial']}: moved by {row['rms_mm']:.3f} mm rms, {row['ratio'] or 0:.1f} times the noise; {cause(row['causes'])}", file=told)
        print(f"{ranked.n_changed} changed, {ranked.n_same} as they were, {ranked.n_refused} not compared; the page: {args.output}/page.html", file=told)
    print(f"{summary.rows} rows, {summary.skipped} done before, {summary.refused} refused; {summary.wall_s:.1f} s, "
          f"{summary.cpu_s:.1f} s of processor time in {summary.workers} processes", file=sys.stderr)
    if args.json:
        text = json.dumps(vars(summary), indent=1) + "\n"
        if args.json == "-":
            out.write(text)
        else:
            try:
                with open(args.json, "w") as file:
                    file.write(text)
            except OSError as error:
                raise DriftpostError(f"{args.json}: {error.strerror}", "output::unwritable") from None
    return 1 if summary.refused or (ranked and ranked.n_changed) else 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m driftpost.fleet", description="A plant's robots at once, on Ray over Parquet (docs/FLEET.md).")
    commands = parser.add_subparsers(dest="command", required=True)
    for name, said, rows in (("compensate", "corrected programs", "programs, one a row"), ("diagnose", "a diagnosis of each set", "sets of measurements, one a row"),
                             ("watch", "which robots have changed, ranked, with a page", "sets of measurements of several weeks")):
        command = commands.add_parser(name, help=said, description=said)
        command.add_argument("input", metavar="INPUT", help=f"Parquet file or folder: {rows}")
        command.add_argument("output", metavar="OUTPUT", help="folder for the results; what is done there already is not done again")
        command.add_argument("--workers", type=_count, metavar="N", help="cores of the Ray that is started [default: all]")
        command.add_argument("--address", metavar="ADDRESS", help="a Ray that runs already, or auto")
        command.add_argument("--serial", action="store_true", help="without Ray, in this process")
        command.add_argument("--rows-a-task", type=_count, default=16, metavar="N", help="rows that a task does and writes at once [default: 16]")
        command.add_argument("--json", metavar="FILE|-", help="how the run ended, as JSON")
        if name == "watch":
            command.add_argument("--days", type=_days, default=7, metavar="N", help="how long before the last set the one compared was [default: 7]")
    return parser


def _count(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return number


def _days(text: str) -> float:
    number = float(text)
    if not 0 < number < 1e5:
        raise argparse.ArgumentTypeError(f"{text} is no number of days above 0")
    return number


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    sys.exit(main())
