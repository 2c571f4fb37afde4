# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/train --quick proves the chain: surveys, training, measures, export, fine-tuning on one's own clouds."""
import os
import pathlib
import re
import subprocess

import numpy as np
import pytest

REPO = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("S2B_TEST_BUILD", REPO / "build" / "release"))


def train(*arguments, fails=False):
    done = subprocess.run([REPO / "scripts" / "train", "--threads", "1", *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, "S2B_BUILD_DIR": str(BUILD)})
    assert (done.returncode != 0) == fails, done.stdout + done.stderr
    return done.stderr if fails else done.stdout


def iou(text, row, column):
    names = re.search(r"^survey +floor .*$", text, re.M).group().split()
    values = re.search(rf"^{row} .*$", text, re.M).group()[16:].split()
    return float(values[names.index(column) - 1])


@pytest.fixture(scope="module")
def trained(tmp_path_factory):
    folder = tmp_path_factory.mktemp("trained")
    return folder, train("all", folder, "--quick")


def test_learns_the_large_surfaces_in_a_minute(trained):
    _, text = trained
    # Guessing one class for everything is below 0.4 in each.
    assert iou(text, "all points", "floor") > 0.6
    assert iou(text, "all points", "wall") > 0.45


def test_the_model_says_what_it_needs_and_runs(trained):
    folder, _ = trained
    onnxruntime = pytest.importorskip("onnxruntime")
    session = onnxruntime.InferenceSession(str(folder / "model.onnx"))
    said = session.get_modelmeta().custom_metadata_map
    assert said["s2b.contract"] == "1"
    layers = len(said["s2b.plan_channels"].split(",")) * int(said["s2b.plan_bins"])
    features = len(said["s2b.features"].split(","))
    plan = np.zeros((1, layers, 16, 24), np.float32)
    scores = session.run(None, {"plan": plan, "cells": np.zeros((5, features), np.float32),
                                "pixel": np.array([0, 1, 23, 24, 383]), "bin": np.array([0, 1, 2, 3, 4])})[0]
    assert scores.shape == (5, len(said["s2b.classes"].split(",")))
    assert np.isfinite(scores).all()
    assert (folder / "model.onnx").stat().st_size < 8e6


def test_fine_tuning_on_own_clouds_makes_them_right(trained, tmp_path):
    folder, _ = trained
    own = tmp_path / "own"
    own.mkdir()
    subprocess.run([BUILD / "tests/simulator/s2b_survey", own / "office.laz", "--layout", "two-rooms", "--storeys", "1",
                    "--step-deg", "0.8", "--voxel", "0.05", "--seed", "77"], check=True, capture_output=True)
    before = train("evaluate", own, "--model", folder / "model.onnx", "--features", tmp_path / "features")
    after = train("fine-tune", own, tmp_path / "own.onnx", "--model", folder / "model.onnx", "--steps", 15,
                  "--features", tmp_path / "features")
    assert iou(after, "office", "wall") > iou(before, "office", "wall")
    again = train("evaluate", own, "--model", tmp_path / "own.onnx", "--features", tmp_path / "features")
    assert iou(again, "office", "wall") == pytest.approx(iou(after, "office", "wall"), abs=0.002)


def test_fine_tuning_on_surveys_keeps_as_much_of_the_first_model_as_asked_for(trained, tmp_path):
    folder, _ = trained
    first = folder / "model.onnx"
    texts = {}
    for keep in (0, 1):
        train("fine-tune", folder / "train", tmp_path / f"{keep}.onnx", "--model", first, "--steps", 3, "--keep", keep)
        texts[keep] = train("evaluate", folder / "held-out", "--model", tmp_path / f"{keep}.onnx")
    before = train("evaluate", folder / "held-out", "--model", first)
    assert texts[1] == before
    assert texts[0] != before


def test_a_folder_without_clouds_is_named(tmp_path):
    assert f"there is no .laz file in {tmp_path}" in train("evaluate", tmp_path, fails=True)
