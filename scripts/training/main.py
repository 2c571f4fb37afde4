# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/train: surveys -> features -> network -> measures -> ONNX file."""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import torch

import contract
import data
import evaluate
import fit

SHIPPED = pathlib.Path(__file__).resolve().parents[2] / "core" / "segmentation" / "model.onnx"
QUICK = {"surveys": 4, "steps": 120, "held_out": 1}
FULL = {"surveys": 120, "steps": 6000, "held_out": 8}


def run(command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"scripts/train: {pathlib.Path(command[0]).name} failed: {done.stderr.strip()}")
    return done.stdout


def features_of(build, cloud, out):
    """The network's inputs of a cloud, made once."""
    if (out / "0_shape.npy").exists():
        return
    partial = out.with_name(out.name + ".partial")
    shutil.rmtree(partial, ignore_errors=True)
    out.parent.mkdir(parents=True, exist_ok=True)
    wanted = out.parent / "contract.txt"
    wanted.write_text("".join(f"{key}={text}\n" for key, text in contract.metadata().items()))
    run([build / "tests/bench/s2b_features", cloud, partial, "--contract", wanted, "--threads", 1])
    partial.rename(out)


def make_survey(build, folder, seed, extra):
    out = folder / f"{seed:06d}"
    if (out / "0_shape.npy").exists():
        return
    cloud = folder / f"{seed:06d}.laz"
    run([build / "tests/simulator/s2b_survey", cloud, "--variety", "--seed", seed, "--threads", 1, *extra])
    features_of(build, cloud, out)
    cloud.unlink()


def make_surveys(build, folder, first_seed, count, jobs, extra=()):
    folder.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(jobs) as pool:
        for i, _ in enumerate(pool.map(lambda s: make_survey(build, folder, s, extra),
                                       range(first_seed, first_seed + count))):
            print(f"survey {i + 1} of {count}", flush=True)


def features_of_clouds(build, folder, out):
    """Features of every labelled cloud in a folder: NAME.laz, or NAME/scan.laz; or those that `surveys` made."""
    clouds = {p.stem: p for p in sorted(folder.glob("*.la[sz]"))}
    clouds.update({p.parent.name: p for p in sorted(folder.glob("*/scan.la[sz]"))})
    if not clouds and any(folder.glob("*/0_shape.npy")):
        return data.load(folder)
    if not clouds:
        raise SystemExit(f"scripts/train: there is no .laz file in {folder}")
    out.mkdir(parents=True, exist_ok=True)
    for name, path in clouds.items():
        features_of(build, path, out / name)
    return {name: storeys for name, storeys in data.load(out).items() if name in clouds}


def all_storeys(surveys):
    return [storey for storeys in surveys.values() for storey in storeys]


def measure(network, surveys):
    matrices = {name: evaluate.confusion(network, storeys) for name, storeys in surveys.items()}
    return evaluate.table(matrices) + "\n\n" + evaluate.confusion_text(sum(matrices.values()))


def read_network(path):
    if path.suffix == ".onnx":
        import onnx_file
        return onnx_file.read(path)
    return fit.load(path)


def export(network, path, note):
    import onnx_file
    onnx_file.write(network, path, contract.metadata(note))
    print(f"written to {path}")


QUICK_FIT = {"size": 48, "cells": 2000, "batch_size": 2}


def parse():
    parser = argparse.ArgumentParser(prog="scripts/train", description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--threads", type=int, default=os.cpu_count(), help="of the training; the model depends on it "
                        "in the last digits only")
    steps = parser.add_subparsers(dest="step", required=True)

    def add(name, text):
        step = steps.add_parser(name, help=text, description=text)
        step.add_argument("--seed", type=int, default=1)
        return step

    step = add("all", "make surveys, train, measure on held-out ones, export")
    step.add_argument("out", type=pathlib.Path, help="folder for everything; a run that was stopped goes on")
    step.add_argument("--quick", action="store_true", help="a few small surveys and steps: proves the chain")
    step.add_argument("--surveys", type=int)
    step.add_argument("--steps", type=int)
    step.add_argument("--minutes", type=float, help="end the training after that")

    step = add("surveys", "make the training surveys alone")
    step.add_argument("out", type=pathlib.Path)
    step.add_argument("--count", type=int, default=FULL["surveys"])
    step.add_argument("--jobs", type=int, default=1)

    step = add("compare", "the network of a finished run against boosted trees and a perceptron without context")
    step.add_argument("out", type=pathlib.Path, help="folder of that run")
    step.add_argument("--features", type=pathlib.Path, help="features to compare on [the held-out surveys]")
    step.add_argument("--steps", type=int, default=1500, help="of the perceptron")

    step = add("evaluate", "IoU per class of a model on labelled clouds, or on features made before")
    step.add_argument("data", type=pathlib.Path, help="folder with NAME.laz or NAME/scan.laz (classes of s2b)")
    step.add_argument("--model", type=pathlib.Path, default=SHIPPED)
    step.add_argument("--features", type=pathlib.Path, help="where to keep the features [a folder in /tmp]")

    step = add("fine-tune", "go on training a model on one's own labelled clouds")
    step.add_argument("data", type=pathlib.Path, help="folder with NAME.laz or NAME/scan.laz (classes of s2b)")
    step.add_argument("out", type=pathlib.Path, help="the new model, .onnx")
    step.add_argument("--model", type=pathlib.Path, default=SHIPPED)
    step.add_argument("--features", type=pathlib.Path, help="where to keep the features [a folder in /tmp]")
    step.add_argument("--steps", type=int, default=400)
    step.add_argument("--rate", type=float, default=3e-4, help="of learning, at its highest")
    step.add_argument("--keep", type=float, default=0.0, help="share of the first model's weights in the new one's, 0 to 1")
    step.add_argument("--harder", action="store_true", help="hide and thin parts of the squares, as `all` does: for real clouds "
                      "unlike those trained on")
    return parser.parse_args()


def train_all(o):
    size = QUICK if o.quick else FULL
    count, steps = o.surveys or size["surveys"], o.steps or size["steps"]
    first = 1000 * o.seed
    small = ["--layout", "two-rooms", "--storeys", "1", "--step-deg", "0.8", "--voxel", "0.05"] if o.quick else []
    make_surveys(o.build, o.out / "train", first, count, 1 if o.quick else o.threads, small)
    make_surveys(o.build, o.out / "held-out", first + 100000, size["held_out"], o.threads, small)
    storeys = all_storeys(data.load(o.out / "train"))
    network = fit.fit(storeys, steps, o.seed, o.out / "checkpoint.pt", minutes=o.minutes, harder=not o.quick,
                      **(QUICK_FIT if o.quick else {}))
    text = measure(network, data.load(o.out / "held-out"))
    print(text)
    (o.out / "held-out.txt").write_text(text + "\n")
    export(network, o.out / "model.onnx", f"seed {o.seed}, {count} surveys, {steps} steps")


def main():
    o = parse()
    torch.set_num_threads(o.threads)
    if o.step == "all":
        train_all(o)
    elif o.step == "surveys":
        make_surveys(o.build, o.out, 1000 * o.seed, o.count, o.jobs)
    elif o.step == "compare":
        import compare
        tables = compare.compare(fit.load(o.out / "checkpoint.pt"), all_storeys(data.load(o.out / "train")),
                                 data.load(o.features or o.out / "held-out"), o.steps, o.seed, o.out)
        print("\n\n".join(f"{name}\n{table}" for name, table in tables.items()))
    else:
        features = o.features or pathlib.Path(f"/tmp/s2b-features-{os.getpid()}")
        try:
            surveys = features_of_clouds(o.build, o.data, features)
            network = read_network(o.model)
            if o.step == "fine-tune":
                network = fit.fit(all_storeys(surveys), o.steps, o.seed, o.out.with_suffix(".pt"), network, rate=o.rate,
                                  freeze_norms=True, harder=o.harder)
                network = fit.mean(read_network(o.model), network, o.keep)
                export(network, o.out, f"fine-tuned from {o.model.name}, seed {o.seed}, {o.steps} steps, "
                       f"{o.keep:g} of its weights kept")
            print(measure(network, surveys))
        finally:
            if not o.features:
                shutil.rmtree(features, ignore_errors=True)


if __name__ == "__main__":
    sys.path.insert(0, str(pathlib.Path(__file__).parent))
    main()
