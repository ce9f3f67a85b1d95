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


def verdict(texts, motions):
    """What `driftpost simulate` says of a program whose original is the motions; None where all are made and none differs."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        files = []
        for i, text in enumerate(texts):
            files.append(folder / f"program{i}.mod")
            files[-1].write_text(text)
        (folder / "unrolled.mod").write_text(unrolled(motions))
        (folder / "rigid.csv").write_text(RIGID)
        command = [os.environ["DRIFTPOST"], "simulate", *files, "--original", folder / "unrolled.mod", "--robot", "irb140", "--quiet"]
        command += ["--deformation", folder / "rigid.csv", "--growth", "none", "--minutes", "0", "--json", "-"]
        done = subprocess.run([*command, "--tolerance-mm", str(TOLERANCE_MM)], capture_output=True, text=True)
    if not done.stdout:
        return done.stderr
    found = json.loads(done.stdout)["minutes"][0]
    for what in (found["failure"], found["mismatch"]):
        if what:
            return what
    if found["n"] != len(motions):
        return f"{found['n']} motions where {len(motions)} should be"
    off = found["corrected"]
    if done.returncode or off["max_mm"] > TOLERANCE_MM or off["max_deg"] > TOLERANCE_MM:
        return f"off by {off['max_mm']} mm, {off['max_deg']} deg"
    return None


def compared(texts):
    """Verdict on a program, the Python interpreter being right."""
    return verdict(texts, Machine(*texts).started())
