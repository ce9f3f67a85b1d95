"""Asks driftpost: a program against the motions that it should make."""

import json
import os
import pathlib
import subprocess
import tempfile

from machine import Machine
from unrolled import unrolled

RIGID = "Dx [mm],Dy[mm],Dz[mm],DOx[deg],DOy[deg],DOz[deg]\n" + "0,0,0,0,0,0\n" * 6
TOLERANCE_MM = 0.0002


def simulated(texts, motions, *options, entry="main", minute=0):
    """`driftpost simulate` of a program on a rigid robot, the motions being its original: exit code, what was found at the minute, complaints."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        files = []
        for i, text in enumerate(texts):
            files.append(folder / f"program{i}.mod")
            files[-1].write_text(text, encoding="latin-1")
        (folder / "unrolled.mod").write_text(unrolled(motions, entry))
        (folder / "rigid.csv").write_text(RIGID)
        command = [os.environ["DRIFTPOST"], "simulate", *files, "--original", folder / "unrolled.mod", "--robot", "irb140", "--quiet"]
        command += ["--deformation", folder / "rigid.csv", "--growth", "none", "--minutes", str(minute), "--json", "-"]
        command += ["--entry", entry, "--tolerance-mm", str(TOLERANCE_MM), *options]
        done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, json.loads(done.stdout)["minutes"][0] if done.stdout else None, done.stderr


def verdict(texts, motions, *options, entry="main", minute=0):
    """What driftpost says of a program that should make the motions; None where it makes all and none differs."""
    code, found, complaints = simulated(texts, motions, *options, entry=entry, minute=minute)
    if found is None:
        return complaints
    for what in (found["failure"], found["mismatch"]):
        if what:
            return what
    if found["n"] != len(motions):
        # On some random arcs a joint comes to the end of its range: neither program makes those, and all others.
        made = simulated([unrolled(motions, entry)], motions, *options, entry=entry, minute=minute)[1]["n"]
        if found["n"] != made or "the move is not made" not in complaints:
            return f"{found['n']} motions where {made} of {len(motions)} should be"
    off = found["corrected"]
    # `simulate` fails where the arm does not make a move too, and both programs are short of the same ones here.
    if (code and not found["unreached"]) or off["max_mm"] > TOLERANCE_MM or off["max_deg"] > TOLERANCE_MM:
        return f"off by {off['max_mm']} mm, {off['max_deg']} deg"
    return None


def compared(texts):
    """Verdict on a program, the Python interpreter being right."""
    return verdict(texts, Machine(*texts).started())
