# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of the build's programs, which return JSON; and the parts common to all tables."""

import json
import platform
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def cpu():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def commit():
    done = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True)
    return done.stdout.strip() or "unknown"


class Bench:
    def __init__(self, build, repeat, quick, keep):
        self.build, self.repeat, self.quick, self.keep = Path(build), repeat, quick, keep

    def program(self, name):
        """The path of a program; None where it is not built."""
        for place in (self.build / "bench" / name, self.build / "bench/contestants" / name, self.build / name,
                      self.build / "python" / name):
            if place.exists():
                return place
        return None

    def call(self, name, *words, **options):
        """Runs a program that appends lines of JSON to a file, and returns these."""
        program = self.program(name)
        if program is None:
            sys.exit(f"bench/run: {name} is not in {self.build}; build the target with -DANNULUS_BUILD_BENCH=ON "
                     "(bench/README.md)")
        with tempfile.TemporaryDirectory() as place:
            file = Path(place) / "run.json"
            command = [program, "--json", file]
            for key, value in options.items():
                command += [f"--{key.replace('_', '-')}"] + ([] if value is True else [value])
            command = [str(w) for w in command + list(words)]
            done = subprocess.run(command, stdout=subprocess.DEVNULL)
            if done.returncode not in (0, 1):
                sys.exit(f"bench/run: {' '.join(command)}: exit {done.returncode}")
            lines = file.read_text().splitlines()
        if self.keep:
            with open(self.keep, "a", encoding="utf-8") as out:
                out.writelines(line + "\n" for line in lines)
        return [json.loads(line) for line in lines]

    def motion(self, repeat=None, **options):
        """The runs of a row with seeds 1, 2 .., as annulus-motions writes them, ordered by ratio."""
        runs = [self.call("annulus-motions", seed=seed, **options)[0] for seed in range(1, (repeat or self.repeat) + 1)]
        return in_order(runs)


def in_order(runs, key="ratio"):
    return sorted(runs, key=lambda r: r["auto"][key])


def middle(runs):
    """The middle run, of an even number the worse of two."""
    return runs[(len(runs) - 1) // 2]


def reached(value, must, more_is_better=True):
    if must is None:
        return ""
    return "yes" if (value >= must if more_is_better else value <= must) else "**no**"


def number(value):
    return "" if value is None else f"{value:g}"


def limits(value, must, aim, more_is_better=True):
    """The columns must, reached, aim."""
    return f"{number(must)} | {reached(value, must, more_is_better)} | {number(aim)}"


def audits(runs, names=("auto", "auto:view", "auto:mesh")):
    return "right" if all(r[name]["audit"] for r in runs for name in names if name in r) else "**WRONG**"


# The first columns are read by tests/tool/test_advise_gain.py.
HEAD = ["| | rebuild / auto | of runs | `Moving_mesh` | with view | must | reached | aim | mesh / view | reached "
        "| auto, ns | rebuild, ns | most expensive step, in rebuilds | rebuilt | audit |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"]
VIEW_MUST = 0.8  # the time of Moving_mesh over that of Moving_delaunay with a request at each step; aim 0.9


def row(name, must, aim, runs):
    """The row of a motion whose steps are all alike: the median of the steps' ratios."""
    one = middle(runs)
    auto = one["auto"]
    spread = f"{runs[0]['auto']['ratio']:.2f} to {runs[-1]['auto']['ratio']:.2f}"
    view = one["auto:view"]["ratio"] / one["auto:mesh"]["ratio"]
    return (f"| {name} | {auto['ratio']:.2f} | {spread} | {one['auto:mesh']['ratio']:.2f} "
            f"| {one['auto:view']['ratio']:.2f} | {limits(auto['ratio'], must, aim)} | {view:.2f} "
            f"| {reached(view, VIEW_MUST)} | {auto['ns']:.0f} | {one['cgal_ns']:.0f} "
            f"| {max(r['auto']['most expensive'] for r in runs):.2f} | {100 * auto['rebuilt']:.0f} % "
            f"| {audits(runs)} |")
