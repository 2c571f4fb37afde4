#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/bench validation: time and memory of the distances of 10 million points to a model of 500 elements or more.

The model is a simulated building, the points are drawn on its surfaces. docs/bench.md has the limit and what was measured.
"""
import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

LIMIT_S = 5.0  # 10 million points against 500 elements on two idle cores
LEAST_ELEMENTS = 500


def fail(text):
    sys.exit(f"scripts/bench: {text}")


def run(command, what):
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        fail(f"{what} (exit code {done.returncode})")
    return done.stdout


def main():
    parser = argparse.ArgumentParser(prog="scripts/bench validation", description=__doc__.split("\n\n")[0])
    parser.add_argument("--points", type=float, default=10.0, help="millions of points (default: 10)")
    parser.add_argument("--storeys", type=int, default=6, help="of the building (default: 6)")
    parser.add_argument("--rooms", type=int, default=12, help="of each storey, on each side of its corridor (default: 12)")
    parser.add_argument("--shuffled", action="store_true", help="points in no order, where a scan's come neighbour by neighbour")
    parser.add_argument("--repetitions", type=int, default=3, help="runs of each (default: 3)")
    parser.add_argument("--threads", type=int, default=0, help="0 = all (default)")
    parser.add_argument("--build", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--data", type=Path, required=True, help=argparse.SUPPRESS)
    options = parser.parse_args()
    load = os.getloadavg()[0]
    print(f"{os.cpu_count()} cores, load {load:.1f} before"
          + (": others use this machine, see the cpu column" if load > 0.5 else ""), flush=True)
    result = json.loads(run([options.build.resolve() / "tests/bench/s2b_deviation_speed", "--points", options.points,
                             "--storeys", options.storeys, "--rooms", options.rooms, "--repetitions", options.repetitions,
                             "--threads", options.threads, *(["--shuffled"] if options.shuffled else [])], "the distances could not be measured"))
    print(f"{result['points']} points, {result['elements']} elements of {result['triangles']} triangles")
    print(f"{'':12}{'s':>8}{'cpu s':>8}{'us/point':>10}{'extra MB':>10}{'B/point':>9}{'near':>10}{'mean mm':>9}")
    for kind in ("labels", "no labels"):
        r = result[kind]
        print(f"{kind:12}{r['seconds']:8.2f}{r['cpu_s']:8.2f}{1e6 * r['cpu_s'] / result['points']:10.3f}"
              f"{r['extra_b'] / 1e6:10.0f}{r['extra_b'] / result['points']:9.1f}"
              f"{100 * r['within_range'] / result['points']:9.1f}%{1000 * r['wall_mean_absolute_m']:9.2f}")
    if result["elements"] < LEAST_ELEMENTS:
        fail(f"the model has only {result['elements']} elements")
    worst = max(result[kind]["seconds"] for kind in ("labels", "no labels"))
    if abs(options.points - 10.0) < 0.5:
        print(f"within the limit of {LIMIT_S:.0f} s" if worst <= LIMIT_S else f"took more than {LIMIT_S:.0f} s")


if __name__ == "__main__":
    main()
