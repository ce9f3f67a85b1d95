#!/usr/bin/env python3
"""How time and memory of `compensate` grow with the number of moves: `benches/moves.py [PICTURE.svg]`.

A milling path in reach of an IRB 140, each target 0.3 mm further and none twice, a thousand to a million moves in modules of 5,000 as RoboDK
writes them, in form `ramp` on one thread; a table on standard output, and a picture with both axes logarithmic. DRIFTPOST is the program, by
default target/release/driftpost; MOVES_A_MODULE another number of moves.
"""

import math
import os
import pathlib
import sys
import tempfile

MOVES = [1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000]
A_MODULE = int(os.environ.get("MOVES_A_MODULE", "5000"))
DRIFTPOST = os.environ.get("DRIFTPOST", "target/release/driftpost")
# Of what ru_maxrss counts in.
MEGABYTES = 1 / 1024**2 if sys.platform == "darwin" else 1 / 1024
WIDTH, HEIGHT, LEFT, BELOW, MARGIN = 640, 360, 64, 48, 40


def write_program(folder, moves):
    """The modules, and one that calls them in turn."""
    rest = "[0.50000000, 0.00000000, 0.86602540, 0.00000000],[0,0,0,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]"
    starts = range(0, moves, A_MODULE)
    for page, start in enumerate(starts):
        with (folder / f"Mill{page}.mod").open("w") as out:
            out.write(f"MODULE MOD_Mill{page}\n    PROC Mill{page}()\n        ConfJ \\Off;\n        ConfL \\Off;\n")
            for i in range(start, min(start + A_MODULE, moves)):
                x = 520 + 25 * math.cos(0.0027 * i) * (1 + math.sin(0.0001 * i))
                y, z = 150 + 120 * math.sin(0.0025 * i), 430 + 20 * math.sin(0.0004 * i)
                out.write(f"        MoveL [[{x:.3f}, {y:.3f}, {z:.3f}],{rest}],rdkSpeed,z1,tMill;\n")
            out.write("    ENDPROC\nENDMODULE\n")
    calls = "".join(f"        Mill{page};\n" for page in range(len(starts)))
    first = "        MoveAbsJ [[10,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tMill;\n"
    tool = "    PERS tooldata tMill:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n"
    speed = "    VAR speeddata rdkSpeed:=[100,500,5000,1000];\n"
    (folder / "MillMain.mod").write_text(
        f"MODULE MOD_MillMain\n{tool}{speed}    PROC main()\n{first}{calls}    ENDPROC\nENDMODULE\n"
    )


def measure(folder, moves):
    """Processor time (s) and the most memory (MB) of one compensation."""
    program = folder / str(moves)
    program.mkdir()
    write_program(program, moves)
    command = [DRIFTPOST, "compensate", str(program), "-o", str(folder / f"{moves}_tc"), "--form", "ramp", "--diff", "none", "--quiet"]
    pid = os.spawnve(os.P_NOWAIT, DRIFTPOST, command, {**os.environ, "RAYON_NUM_THREADS": "1"})
    _, status, used = os.wait4(pid, 0)
    if status != 0:
        sys.exit(f"{' '.join(command)} ended with {status}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss * MEGABYTES


def line(points, color):
    at = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    dots = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5"/>' for x, y in points)
    return f'<g fill="{color}"><polyline points="{at}" fill="none" stroke="{color}" stroke-width="2"/>{dots}</g>'


def picture(rows):
    """Both axes in powers of ten; the dashed line is a tenfold time for ten times the moves."""
    low, high, floor, top = 3, 6, -2, 3

    def at(moves, value):
        x = LEFT + (math.log10(moves) - low) / (high - low) * (WIDTH - LEFT - MARGIN)
        y = HEIGHT - BELOW - (math.log10(value) - floor) / (top - floor) * (HEIGHT - BELOW - MARGIN)
        return x, y

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">']
    parts.append(f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>')
    for power in range(floor, top + 1):
        (x, y), (end, _) = at(10**low, 10.0**power), at(10**high, 10.0**power)
        parts.append(f'<path d="M{x:.1f} {y:.1f}H{end:.1f}" stroke="#ddd"/><text x="{x - 8:.1f}" y="{y + 4:.1f}" text-anchor="end">{10.0**power:g}</text>')
    for power in range(low, high + 1):
        x, y = at(10**power, 10.0**floor)
        parts.append(f'<text x="{x:.1f}" y="{y + 18:.1f}" text-anchor="middle">{10**power:,}</text>')
    seconds, memory = [at(n, s) for n, s, _ in rows], [at(n, m) for n, _, m in rows]
    n, s, m = rows[-1]
    (x0, y0), (x1, y1) = at(10**low, s * 10**low / n), at(n, s)
    parts.append(f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" stroke="#888" stroke-dasharray="4 4"/>')
    parts += [line(seconds, "#0b62a8"), line(memory, "#b5541c")]
    parts.append(f'<text x="{WIDTH / 2}" y="{HEIGHT - 8}" text-anchor="middle">moves</text>')
    parts.append(f'<text x="{seconds[2][0] + 8:.1f}" y="{seconds[2][1] + 18:.1f}" fill="#0b62a8">processor time, s</text>')
    parts.append(f'<text x="{memory[2][0] - 8:.1f}" y="{memory[2][1] - 12:.1f}" fill="#b5541c" text-anchor="end">memory, MB</text>')
    return "\n".join(parts) + "\n</svg>\n"


def main():
    rows = []
    print(f"{'moves':>10} {'time, s':>9} {'us a move':>10} {'memory, MB':>11}")
    with tempfile.TemporaryDirectory() as name:
        for moves in MOVES:
            seconds, memory = measure(pathlib.Path(name), moves)
            rows.append((moves, seconds, memory))
            print(f"{moves:>10,} {seconds:>9.2f} {1e6 * seconds / moves:>10.1f} {memory:>11.0f}", flush=True)
    if sys.argv[1:]:
        pathlib.Path(sys.argv[1]).write_text(picture(rows))


if __name__ == "__main__":
    main()
