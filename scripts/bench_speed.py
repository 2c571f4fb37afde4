#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/bench speed: time, points per second and memory of the stages and of the whole -S2B step in CloudCompare.

The clouds are the same building with different numbers of points; they are made once. docs/bench.md explains the
columns and the limits that are compared with.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

WHOLE = "Whole pipeline"
# What the project asks of itself: docs/bench.md.
LIMIT_BYTES_PER_POINT = 24.0
LIMIT_BYTES = 300.0e6
LIMITS_S = {12.0: 4.0, 30.0: 10.0}  # millions of points: seconds of the -S2B step on two idle cores


def fail(text):
    sys.exit(f"scripts/bench: {text}")


def stages(options, files):
    """Google Benchmark's rows by (stage, size)."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "speed.json"
        command = [options.build / "tests/bench/s2b_speed", *files, f"--repetitions={options.repetitions}",
                   f"--threads={options.threads}", f"--benchmark_out={out}", "--benchmark_out_format=json"]
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
        if done.returncode != 0:
            fail(f"s2b_speed ended with {done.returncode}: {done.stderr.strip()[-500:]}")
        result = json.loads(out.read_text())
    if options.json:
        options.json.write_text(json.dumps(result, indent=1))
    rows = {}
    for row in result["benchmarks"]:
        stage, size = row["name"].split("/")[:2]
        rows[stage, size] = {"seconds": row["real_time"] / 1e3, "cpu_s": row["cpu_s"], "points": row["points"],
                             "extra_b": row.get("extra_b")}
    return rows


def print_stages(rows, sizes):
    print("Stages (s: wall clock; cpu: seconds of all cores; ns: nanoseconds of wall clock a point)")
    print(" " * 18 + "".join(f"{size:>30}" for size in sizes))
    print(f"{'stage':18}" + "".join(f"{'s':>10}{'cpu':>10}{'ns':>10}" for _ in sizes))
    for stage in dict.fromkeys(stage for stage, _ in rows):
        line = f"{stage:18}"
        for size in sizes:
            row = rows.get((stage, size))
            line += f"{'-':>10}{'-':>10}{'-':>10}" if row is None else (
                f"{row['seconds']:10.3f}{row['cpu_s']:10.3f}{1e9 * row['seconds'] / row['points']:10.0f}")
        print(line)
    line = f"{'million points/s':18}"
    for size in sizes:
        row = rows[WHOLE, size]
        line += f"{row['points'] / row['seconds'] / 1e6:10.1f}{row['points'] / row['cpu_s'] / 1e6:10.1f}{'':10}"
    print(line)
    line = f"{'bytes/point':18}"
    for size in sizes:
        row = rows[WHOLE, size]
        line += f"{row['extra_b'] / row['points']:10.1f}{'':20}"
    print(line + "   above the loaded cloud")


def cloudcompare(options, arguments):
    """Runs it; its output, and the seconds of all cores that it took."""
    here = Path(__file__).resolve().parent
    command = [here / "cloudcompare", "-SILENT", "-NO_TIMESTAMP", "-AUTO_SAVE", "OFF", *arguments]
    with tempfile.TemporaryFile("w+") as out:
        process = subprocess.Popen([str(c) for c in command], stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                   env={**os.environ, "S2B_BUILD_DIR": str(options.build)})
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        printed = out.read()
    if process.returncode != 0:
        fail(f"CloudCompare ended with {process.returncode}: {printed.strip()[-800:]}")
    return printed, usage.ru_utime + usage.ru_stime


def number(pattern, printed):
    found = re.search(pattern, printed)
    if not found:
        fail(f"CloudCompare's output has no \"{pattern}\"")
    return [float(g) for g in found.groups()]


def step(options, file):
    """The best of some runs of the whole step: what disturbs a run only makes it slower."""
    load = ["-O", "-GLOBAL_SHIFT", "AUTO", file]
    threads = ["-THREADS", str(options.threads)] if options.threads else []
    best = None
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.repetitions):
            _, load_cpu_s = cloudcompare(options, load)
            printed, cpu_s = cloudcompare(options, [*load, "-S2B", "-IFC", Path(folder) / "model.ifc", *threads])
            row = {"points": number(r"with (\d+) points", printed)[0],
                   "load_s": number(r"\[LOAD\] finished in ([\d.]+) s", printed)[0],
                   "seconds": number(r"\[S2B\] ([\d.]+) s, peak memory", printed)[0],
                   "load_cpu_s": load_cpu_s, "cpu_s": cpu_s - load_cpu_s}
            peak_gb, before_gb = number(r"peak memory ([\d.]+) GB \(([\d.]+) GB before\)", printed)
            row["extra_b"] = 1e9 * (peak_gb - before_gb)
            row["cloud_b"] = 1e9 * before_gb
            best = best or row
            for key in ("load_s", "seconds", "load_cpu_s", "cpu_s", "extra_b"):
                best[key] = min(best[key], row[key])
    return best


def print_steps(rows):
    print("\nWhole -S2B step in CloudCompare (seconds; cpu: of all cores; the file's opening beside it)")
    print(f"{'':8}{'open':>8}{'-S2B':>8}{'open cpu':>10}{'-S2B cpu':>10}{'ns/point':>10}{'loaded GB':>11}{'extra MB':>10}{'B/point':>9}"
          f"{'allowed MB':>12}")
    for size, r in rows.items():
        allowed = LIMIT_BYTES_PER_POINT * r["points"] + LIMIT_BYTES
        print(f"{size:8}{r['load_s']:8.2f}{r['seconds']:8.2f}{r['load_cpu_s']:10.2f}{r['cpu_s']:10.2f}"
              f"{1e9 * r['seconds'] / r['points']:10.0f}{r['cloud_b'] / 1e9:11.2f}{r['extra_b'] / 1e6:10.0f}"
              f"{r['extra_b'] / r['points']:9.1f}{allowed / 1e6:12.0f}")
    remarks = []
    for size, r in rows.items():
        millions = r["points"] / 1e6
        for at, limit_s in LIMITS_S.items():
            if abs(millions - at) < 0.05 * at and r["seconds"] > limit_s:
                remarks.append(f"{size}: -S2B took more than {limit_s:.0f} s")
        if r["extra_b"] > LIMIT_BYTES_PER_POINT * r["points"] + LIMIT_BYTES:
            remarks.append(f"{size}: more memory than allowed")
        if millions > 2.5 and r["seconds"] > r["load_s"]:
            remarks.append(f"{size}: -S2B took longer than opening the file")
    print("\n".join(remarks) if remarks else "all within the limits")


def main():
    parser = argparse.ArgumentParser(prog="scripts/bench speed", description=__doc__.split("\n\n")[0])
    parser.add_argument("--points", default="1,10,30", help="millions of points (default: 1,10,30)")
    parser.add_argument("--from", dest="source", type=Path, help="draw the clouds from this LAZ file, not a simulated building's")
    parser.add_argument("--repetitions", type=int, default=3, help="runs of each (default: 3)")
    parser.add_argument("--threads", type=int, default=0, help="0 = all (default)")
    parser.add_argument("--only", choices=["stages", "step"], help="one half of it")
    parser.add_argument("--json", type=Path, help="Google Benchmark's own output")
    parser.add_argument("--build", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--data", type=Path, required=True, help=argparse.SUPPRESS)
    options = parser.parse_args()
    options.build = options.build.resolve()
    try:
        millions = [float(m) for m in options.points.split(",")]
    except ValueError:
        fail(f"--points {options.points} is not a list of millions")
    folder = options.data.resolve() / "speed" / (options.source.stem if options.source else "simulated")
    command = [options.build / "tests/bench/s2b_make_clouds", folder, "--points", options.points]
    if options.source:
        command += ["--from", options.source]
    if subprocess.run([str(c) for c in command]).returncode != 0:
        fail("the clouds could not be made")
    sizes = [f"{m:g}M" for m in millions]
    files = [folder / f"{size}.laz" for size in sizes]
    load = os.getloadavg()[0]
    print(f"{os.cpu_count()} cores, load {load:.1f} before"
          + (": others use this machine, see the cpu columns" if load > 0.5 else ""), flush=True)
    if options.only != "step":
        print_stages(stages(options, files), sizes)
        sys.stdout.flush()
    if options.only != "stages":
        print_steps({size: step(options, file) for size, file in zip(sizes, files)})


if __name__ == "__main__":
    main()
