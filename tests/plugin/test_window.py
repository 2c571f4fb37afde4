# SPDX-License-Identifier: GPL-3.0-or-later
"""CloudCompare's window under a virtual display: what a user sees and does."""
import json
import os
import shutil
import subprocess
import sys

import ifcopenshell
import numpy as np
import pytest

from conftest import environment, make_survey, write_ply


@pytest.fixture(scope="module")
def display():
    """A virtual screen of its own."""
    read, write = os.pipe()
    process = subprocess.Popen([os.environ["S2B_TEST_XVFB"], "-displayfd", str(write), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
                               pass_fds=[write], stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)
    number = os.read(read, 16).decode().strip()
    assert number, "Xvfb did not start"
    yield ":" + number
    process.terminate()
    process.wait()


@pytest.fixture
def to_bin(cloudcompare, tmp_path):
    """CloudCompare's own format opens without a question."""

    def convert(path):
        run = cloudcompare("-NO_TIMESTAMP", "-C_EXPORT_FMT", "BIN", "-O", path, "-SAVE_CLOUDS", "FILE", tmp_path / "scan.bin")
        assert run.rc == 0
        return tmp_path / "scan.bin"

    return convert


@pytest.fixture
def window(display, tmp_path, output):
    """Runs one scenario of the driver plugin in the window."""

    def run(scenario, path, **more):
        env = environment(tmp_path / "home", DISPLAY=display, QT_QPA_PLATFORM="xcb", S2B_DRIVER_SCENARIO=scenario, S2B_DRIVER_OUTPUT=str(output),
                          S2B_PLAIN_DIALOGS="1", **more)
        env["CC_PLUGIN_PATH"] += ":" + os.environ["S2B_TEST_DRIVER"]
        process = subprocess.run([os.environ["S2B_TEST_CLOUDCOMPARE"], ":start-plugin:S2B_window_driver", str(path)], cwd=tmp_path, env=env,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
        print(process.stdout)
        assert process.returncode == 0, "\n".join(line for line in process.stdout.splitlines() if line.startswith(("FAIL", "ok")))
        return process.stdout

    return run


def test_reconstruct_look_correct_export(window, to_bin, survey, output):
    for name in ("dialog.ifc", "without_one_wall.ifc"):
        (output / name).unlink(missing_ok=True)
    said = window("reconstruct", to_bin(survey))
    walls = int(said.split("walls ")[-1].split()[0])
    assert len(ifcopenshell.open(str(output / "dialog.ifc")).by_type("IfcWall")) == walls + 1
    assert len(ifcopenshell.open(str(output / "without_one_wall.ifc")).by_type("IfcWall")) == walls
    check = subprocess.run([sys.executable, "-m", "ifcopenshell.validate", "--rules", str(output / "without_one_wall.ifc")], capture_output=True)
    assert check.returncode == 0, check.stdout


def test_cancel_leaves_nothing(window, to_bin, tmp_path, output):
    (output / "cancelled.ifc").unlink(missing_ok=True)  # of an earlier run that failed
    # Large enough that the last moment of cancelling still lies within the run.
    scan = make_survey(tmp_path / "large.laz", "--storeys", 2, "--rooms", 2, "--step-deg", 0.2, "--voxel", 0.01)
    window("cancel", to_bin(scan))


def test_unknown_codes_are_shown(window, to_bin, tmp_path, room):
    points, codes = room
    codes[:100] = 77
    window("labels", to_bin(write_ply(tmp_path / "codes.ply", points, Classification=codes)))


def test_segment_adds_class_and_confidence(window, to_bin, survey, tmp_path):
    bad = tmp_path / "bad.onnx"
    bad.write_text("this is no model")
    window("segment", to_bin(survey), S2B_DRIVER_MODEL=os.environ["S2B_TEST_MODELS"] + "/rules.onnx", S2B_DRIVER_BAD_MODEL=str(bad))


def test_validate_shows_verdicts_and_deviations(window, to_bin, survey, tmp_path, output):
    shutil.rmtree(output / "window_report", ignore_errors=True)
    bad = tmp_path / "bad.ifc"
    bad.write_text("this is no IFC file")
    window("validate", to_bin(survey), S2B_DRIVER_TRUTH=str(survey.parent / "truth.ifc"), S2B_DRIVER_BAD_TRUTH=str(bad))
    report = json.loads((output / "window_report" / "report.json").read_text())
    assert report["classes"]["wall"]["at50"]["f1"] >= 0.9
    assert report["files"]["result"]["name"].endswith(".ifc")
    assert "/" not in report["files"]["truth"]["name"]
