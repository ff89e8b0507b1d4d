# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figures of docs/degeneracy.md are made of: tables, plots with their numbers beside them, histograms of a
sweep, means and exponents."""

import csv
import math
from pathlib import Path

HERE = Path(__file__).resolve().parent
figures = []  # for example-plots


def table(name, rows):
    with open(HERE / (name + ".csv"), "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows({k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()} for row in rows)


def figure(name, title, x, y, series):
    """series: (name, xs, ys), or (name, xs, ys, errors of ys); the same numbers go to a CSV file."""
    series = [(one[0], *(list(map(float, part)) for part in one[1:])) for one in series if len(one[1])]
    bars = any(len(one) > 3 for one in series)
    table(name,
          [{"curve": one[0], x["label"]: a, y["label"]: b,
            **({"error": one[3][i] if len(one) > 3 else ""} if bars else {})}
           for one in series for i, (a, b) in enumerate(zip(one[1], one[2]))])
    figures.append({"file": name + ".svg", "title": title, "x": x, "y": y,
                    "series": [{"name": one[0], "x": one[1], "y": one[2], "error": one[3] if len(one) > 3 else []}
                               for one in series]})


def axis(label, log=False, **more):
    return {"label": label, "log": log, **more}


def edges(scales, name):
    s = scales[name]
    lo, hi = (math.log10(s["lower"]), math.log10(s["upper"])) if s["scale"] == "log10" else (s["lower"], s["upper"])
    e = [lo + (hi - lo) * i / s["bins"] for i in range(s["bins"] + 1)]
    return [10 ** v for v in e] if s["scale"] == "log10" else e


def bins(scales, histogram, name):
    all = [0] * scales[name]["bins"]
    all[histogram["first"]:histogram["first"] + len(histogram["in"])] = histogram["in"]
    return all


def mean(values):
    """And its standard error."""
    m = sum(values) / len(values)
    return m, math.sqrt(sum((v - m) ** 2 for v in values) / max(1, len(values) - 1) / len(values))


def exponent(xs, ys):
    """Of the power of x that is nearest to y, by least squares of logarithms."""
    lx, ly = [math.log(x) for x in xs], [math.log(y) for y in ys]
    mx, my = sum(lx) / len(lx), sum(ly) / len(ly)
    return sum((a - mx) * (b - my) for a, b in zip(lx, ly)) / sum((a - mx) ** 2 for a in lx)


def label(p):
    return p.get("kind") or Path(p["file"]).stem


def cumulative(scales, p, name):
    h = p["histograms"][name]
    e, below = edges(scales, name), h["below"]
    b = bins(scales, h, name)
    total, xs, ys = below + h["above"] + sum(b), [], []
    for i in range(len(b) + 1):
        if i:
            below += b[i - 1]
        if below:
            xs.append(e[i])
            ys.append(100 * below / total)
        if below == total and e[i] >= 10:  # all curves end at one side
            break
    return xs, ys
