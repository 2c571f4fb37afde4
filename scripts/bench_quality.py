#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/bench quality [DIR]: reconstructs every survey in every mode, prints one table, and writes a page of plans.

A survey is a folder with scan.laz and gt.json (as scripts/survey --truth writes it). Without DIR the simulator makes
some of different buildings. docs/bench.md explains the columns.
"""
import argparse
import hashlib
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import bench_page

MODES = ("given", "degraded", "geometry", "segmented")
SHIPPED_MODEL = Path(__file__).resolve().parent.parent / "core/segmentation/model.onnx"
CLASSES = ("wall", "door", "window", "column", "slab")

# What differs from survey to survey is what makes reconstruction hard. Options of scripts/survey.
SIMULATED = {
    "office": "--seed 7 --storeys 2 --rooms 3 --yaw-deg 23 --step-deg 0.2 --voxel 0.02",
    "oblique": "--seed 11 --storeys 1 --rooms 3 --yaw-deg -28 --facade-angle-deg 12 --step-deg 0.2 --voxel 0.02 --outside",
    "suspended": "--seed 5 --storeys 2 --rooms 2 --suspended-ceilings --stairs --step-deg 0.2 --voxel 0.02 --noise-mm 4",
    "georeferenced": "--seed 3 --storeys 1 --rooms 3 --yaw-deg 40 --origin 500100 5600300 120 --step-deg 0.2 --voxel 0.025",
    "curved": "--seed 13 --storeys 1 --rooms 3 --curved-facade --open-doors 0.8 --removed-doors 0.2 --step-deg 0.2 --voxel 0.03",
}


def fail(text):
    sys.exit(f"scripts/bench: {text}")


def simulator_version(root):
    """Changes with the simulator's sources: surveys that an older one made are made again."""
    digest = hashlib.sha256()
    for path in sorted((root / "tests" / "simulator").iterdir()):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def simulated_surveys(options, names):
    root = Path(__file__).resolve().parent.parent
    version = simulator_version(root)
    folders = []
    for name in names:
        key = hashlib.sha256((SIMULATED[name] + version).encode()).hexdigest()[:12]
        folder = options.data / "quality" / name
        mark = folder / "made_by"
        if not (mark.exists() and mark.read_text() == key):
            folder.mkdir(parents=True, exist_ok=True)
            mark.unlink(missing_ok=True)
            print(f"scripts/bench: scanning {name}", file=sys.stderr)
            run([options.build / "tests/simulator/s2b_survey", folder / "scan.laz", "--truth", folder / "gt.json",
                 *SIMULATED[name].split()])
            mark.write_text(key)
        folders.append(folder)
    return folders


def found_surveys(folder):
    if not folder.is_dir():
        fail(f"{folder} is not a folder")
    folders = sorted(f for f in [folder, *folder.iterdir()] if (f / "scan.laz").exists() and (f / "gt.json").exists())
    if not folders:
        fail(f"{folder} has no folder with scan.laz and gt.json")
    return folders


def run(command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        fail(f"{Path(str(command[0])).name} ended with {done.returncode}: {(done.stderr or done.stdout).strip()[-500:]}")
    return done


def measure(options, folder, mode):
    name = f"{folder.resolve().name}-{mode}"
    out = options.out / f"{name}.json"
    command = [options.build / "tests/bench/s2b_quality", folder / "scan.laz", folder / "gt.json", "--mode", mode,
               "--ifc", options.out / f"{name}.ifc", "--json", out]
    if options.stations:
        command += ["--stations", folder / "gt.json"]
    if mode == "segmented" and options.model:
        command += ["--model", options.model]
    for assignment in options.set:
        command += ["--set", assignment]
    run(command)
    return {"survey": folder.resolve().name, "mode": mode, **json.loads(out.read_text())}


# Columns: title, unit, value of a row (None where the survey has nothing to say), digits, whether more is better.
def of(element, value, scale=1.0):
    return lambda row: None if row[element][value] is None else scale * row[element][value]


def of_labels(name):
    return lambda row: row.get("labels", {}).get(name)


def columns(with_labels=False):
    out = []
    if with_labels:
        out += [("labels", title, of_labels(name), 2) for name, title in
                (("mean", "mIoU"), ("floor", "flo"), ("ceiling", "cei"), ("wall", "wal"), ("column", "col"), ("door", "doo"), ("window", "win"))]
        out += [("labels", "sec", of_labels("seconds"), 1), ("labels", "M/s", of_labels("millions_per_second"), 2)]
    for name in CLASSES:
        out += [(name, "IoU", of(name, "iou"), 2), (name, "F1", of(name, "f1"), 2)]
        if name == "wall":
            out += [(name, "both", of(name, "both_sides_iou"), 2), (name, "thk mm", of(name, "thickness_m", 1000.0), 1)]
    out += [("storeys", "err mm", of("storeys", "error_m", 1000.0), 1),
            ("storeys", "missed", lambda r: r["storeys"]["missed"], 0),
            ("storeys", "extra", lambda r: r["storeys"]["extra"], 0),
            ("", "time s", lambda r: r["seconds"], 1),
            ("", "peak MB", lambda r: r["peak_b"] / 1e6, 0)]
    return out


def mean_row(rows, mode):
    """The mean over the surveys that have a value, of a class those whose truth has it; of the counts of storeys, the
    sum."""
    row = {"survey": "mean", "mode": mode, "cells": []}
    for group, title, value, _ in columns(any("labels" in r for r in rows)):
        asked = [r for r in rows if r["mode"] == mode and (group not in CLASSES or r[group]["truth"] > 0)]
        known = [v for v in (value(r) for r in asked) if v is not None]
        total = sum(known)
        row["cells"].append(None if not known else total if title in ("missed", "extra") else total / len(known))
    return row


def table(rows, modes):
    """Header of two lines, one line a survey and mode, and the means: lists of texts."""
    kinds = columns(any("labels" in row for row in rows))
    lines = []
    for row in rows:
        cells = row["cells"] if "cells" in row else [c[2](row) for c in kinds]
        lines.append([row["survey"], row["mode"]] +
                     ["-" if v is None else f"{v:.{c[3]}f}" for v, c in zip(cells, kinds)])
    groups = ["", ""] + [c[0] for c in kinds]
    titles = ["survey", "mode"] + [c[1] for c in kinds]
    return groups, titles, lines


def print_table(groups, titles, lines, means_from):
    widths = [max(len(line[i]) for line in [titles, *lines]) for i in range(len(titles))]
    head = ""
    i = 0
    while i < len(groups):
        last = i
        while last + 1 < len(groups) and groups[last + 1] == groups[i]:
            last += 1
        head += groups[i].ljust(sum(widths[i:last + 1]) + 2 * (last - i) + 2)[:sum(widths[i:last + 1]) + 2 * (last - i) + 2]
        i = last + 1
    print(head.rstrip())

    def line(cells):
        return "  ".join(c.ljust(w) if i < 2 else c.rjust(w) for i, (c, w) in enumerate(zip(cells, widths))).rstrip()
    print(line(titles))
    for i, cells in enumerate(lines):
        if i == means_from:
            print("-" * (sum(widths) + 2 * (len(widths) - 1)))
        print(line(cells))


def main():
    parser = argparse.ArgumentParser(prog="scripts/bench quality", description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", metavar="DIR", nargs="?", type=Path,
                        help="folder of surveys, each a folder with scan.laz and gt.json; without it the simulator's")
    parser.add_argument("--modes", help="given, degraded, geometry, segmented (default: all; the last one where there is a model)")
    parser.add_argument("--model", type=Path, metavar="FILE.onnx", help="of the mode segmented (default: the shipped one)")
    parser.add_argument("--surveys", help="only these, by name, comma separated")
    parser.add_argument("--out", type=Path, help="where models, scores and the page go (default: build/bench)")
    parser.add_argument("--stations", action="store_true",
                        help="tell the reconstruction where the scanner stood (gt.json) and which points it saw from there")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="a parameter of the reconstruction")
    parser.add_argument("--jobs", type=int, default=1,
                        help="surveys at a time; times are only comparable with 1 (default)")
    parser.add_argument("--build", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--data", type=Path, required=True, help=argparse.SUPPRESS)
    options = parser.parse_args()
    has_model = options.model or SHIPPED_MODEL.exists()
    modes = options.modes.split(",") if options.modes else [m for m in MODES if m != "segmented" or has_model]
    for mode in modes:
        if mode not in MODES:
            fail(f"there is no mode {mode}, use {', '.join(MODES)}")
    options.out = (options.out or options.data.parent / "bench").resolve()
    options.out.mkdir(parents=True, exist_ok=True)
    chosen = options.surveys.split(",") if options.surveys else None
    if options.folder:
        folders = [f for f in found_surveys(options.folder) if not chosen or f.resolve().name in chosen]
        if not folders:
            fail(f"{options.folder} has no survey called {options.surveys}")
    else:
        for name in chosen or []:
            if name not in SIMULATED:
                fail(f"there is no survey {name}, the simulator makes {', '.join(SIMULATED)}")
        folders = simulated_surveys(options, chosen or list(SIMULATED))

    tasks = [(folder, mode) for folder in folders for mode in modes]
    rows = []
    with ThreadPoolExecutor(max(1, options.jobs)) as pool:
        for row in pool.map(lambda t: measure(options, *t), tasks):
            rows.append(row)
            if sys.stderr.isatty():
                print(f"\r\033[Kscripts/bench: {len(rows)} of {len(tasks)}", end="", file=sys.stderr, flush=True)
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr)
    rows.sort(key=lambda r: (modes.index(r["mode"]), r["survey"]))
    means = [mean_row(rows, mode) for mode in modes]
    groups, titles, lines = table(rows + means, modes)
    print_table(groups, titles, lines, len(rows))
    page = options.out / "quality.html"
    bench_page.write(page, rows, modes, (groups, titles, lines, len(rows)))
    print(f"\n{os.path.relpath(page)}: plans with misses and false positives")


if __name__ == "__main__":
    main()
