"""The page of a watch: which robots have changed, the most changed first. One HTML file without scripts or addresses."""

from __future__ import annotations

from html import escape

import pyarrow as pa

MOST_ROWS = 1000
STYLE = """
:root{color-scheme:light dark}body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:80rem;padding:0 1rem}
h1{font-size:1.5rem}h2{font-size:1.15rem;margin-top:2rem}table{border-collapse:collapse;width:100%}
th,td{text-align:left;padding:.3rem .6rem;border-bottom:1px solid #8884;vertical-align:top}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}
.figures{display:flex;flex-wrap:wrap;gap:2rem;padding:0;list-style:none}.figures b{display:block;font-size:1.6rem}
meter{width:7rem}.wide{overflow-x:auto}.is-changed{font-weight:600}
@media print{body{margin:0;max-width:none}}
"""


class Ranked:
    """The rows of a watch, those that changed most by their noise first; of the rest as many as a page holds."""

    COLUMNS = ["robot_serial", "status", "code", "message", "changed", "verdict", "rms_mm", "noise_rms_mm", "ratio", "worst_mm",
               "tool_moved_mm", "base_moved_mm", "causes", "before_set", "after_set", "sensor_changed", "model_changed"]

    def __init__(self):
        self.n_changed = self.n_same = self.n_refused = 0
        self.compared: list[dict] = []
        self.refused: list[dict] = []

    def add(self, table: pa.Table) -> None:
        """Takes rows of results in; holds no more of them than are shown."""
        for row in table.select(self.COLUMNS).to_pylist():
            if row["status"] != "done":
                self.n_refused += 1
                self.refused.append(row)
            else:
                self.n_changed += row["changed"]
                self.n_same += not row["changed"]
                self.compared.append(row)
        self.compared.sort(key=lambda row: (not row["changed"], -(row["ratio"] or 0), row["robot_serial"]))
        del self.compared[MOST_ROWS:]
        del self.refused[MOST_ROWS:]


def page(ranked: Ranked, days: float) -> str:
    """The page as HTML. All that comes from tables is escaped."""
    figures = [(ranked.n_changed, "changed"), (ranked.n_same, "as they were"), (ranked.n_refused, "not compared")]
    most = max((row["ratio"] or 0 for row in ranked.compared), default=0)
    parts = ["<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content='width=device-width'>"
             f"<title>Robots that changed</title><style>{STYLE}</style></head><body>\n<h1>Which robots have changed</h1>",
             f"<p>Each robot's last measurement beside the one nearest to {days:g} days before, base and tool refitted.</p>",
             "<ul class=figures>" + "".join(f"<li><b>{n}</b>{what}</li>" for n, what in figures) + "</ul>"]
    heads = [("", "n"), ("robot", ""), ("", ""), ("moved, mm rms", "n"), ("noise, mm rms", "n"), ("times the noise", "n"), ("", ""),
             ("worst, mm", "n"), ("tool, mm", "n"), ("base, mm", "n"), ("cause", ""), ("sets", ""), ("note", "")]
    rows = [_compared(number, row, most) for number, row in enumerate(ranked.compared, 1)]
    parts.append("<h2>Compared</h2>" + _table(heads, rows, ranked.n_changed + ranked.n_same))
    rows = [[(escape(row["robot_serial"]), ""), (escape(row["code"] or ""), ""), (escape(row["message"] or ""), "")] for row in ranked.refused]
    if rows:
        parts.append("<h2>Not compared</h2>" + _table([("robot", ""), ("code", ""), ("why", "")], rows, ranked.n_refused))
    return "\n".join(parts) + "\n</body></html>\n"


def cause(found: list[dict]) -> str:
    """The causes as a line: those of one slot are alternatives."""
    slots: dict = {}
    for one in found:
        joint = "" if one["joint"] is None else f" of joint {one['joint']}"
        slots.setdefault(one["slot"], []).append(f"{one['effect']}{joint} ({one['posterior'] or 0:.0%})")
    return "; ".join(" or ".join(alternatives) for alternatives in slots.values())


def _compared(number: int, row: dict, most: float) -> list[tuple[str, str]]:
    notes = [text for text, holds in (("another sensor", row["sensor_changed"]), ("another model", row["model_changed"])) if holds]
    ratio = row["ratio"] or 0
    meter = f"<meter min=0 max={most:.6g} value={ratio:.6g} aria-hidden=true></meter>" if most else ""
    return [(str(number), "n"), (escape(row["robot_serial"]), "is-changed" if row["changed"] else ""), ("changed" if row["changed"] else "", ""),
            *((_mm(row[name]), "n") for name in ("rms_mm", "noise_rms_mm")), (f"{ratio:.1f}", "n"), (meter, ""),
            *((_mm(row[name]), "n") for name in ("worst_mm", "tool_moved_mm", "base_moved_mm")),
            (escape(cause(row["causes"] or [])) or escape(row["verdict"] or ""), ""),
            (escape(f"{row['before_set']} to {row['after_set']}"), ""), (", ".join(notes), "")]


def _mm(value: float | None) -> str:
    return "" if value is None else f"{value:.3f}"


def _table(heads: list[tuple[str, str]], rows: list[list[tuple[str, str]]], n: int) -> str:
    def cell(tag: str, text: str, kind: str) -> str:
        return f"<{tag} class={kind}>{text}</{tag}>" if kind else f"<{tag}>{text}</{tag}>"

    more = f"<p>{n - len(rows)} more stand in the table alone.</p>" if n > len(rows) else ""
    lines = ["<tr>" + "".join(cell("td", text, kind) for text, kind in row) + "</tr>" for row in rows]
    head = "".join(cell("th", text, kind) for text, kind in heads)
    return f"<div class=wide><table><thead><tr>{head}</tr></thead><tbody>\n" + "\n".join(lines) + f"\n</tbody></table></div>{more}"
