# SPDX-License-Identifier: GPL-3.0-or-later
"""-SEGMENT: labels from a model, end to end."""
import os
import shutil

import ifcopenshell
import numpy as np
import pytest

from conftest import write_ply


def model(name):
    return os.path.join(os.environ["S2B_TEST_MODELS"], name + ".onnx")


def read_ply(path):
    """Columns of a binary PLY by name."""
    kinds = {"float": "<f4", "double": "<f8", "uchar": "u1", "int": "<i4"}
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    lines = [line.split() for line in head.decode().splitlines()]
    dtype = [(line[2], kinds[line[1]]) for line in lines if line[0] == "property" and line[1] != "list"]
    count = next(int(line[2]) for line in lines if line[:2] == ["element", "vertex"])
    return np.frombuffer(body, dtype=dtype, count=count)


def test_a_bare_cloud_is_labelled_and_reconstructed(cloudcompare, tmp_path, room):
    run = cloudcompare("-O", write_ply(tmp_path / "bare.ply", room[0]), "-S2B", "-SEGMENT", model("rules"))
    assert run.rc == 0
    assert any(line.startswith("segmentation with") and "floor, ceiling, wall, furniture" in line for line in run.ours)
    assert any(line.startswith("labels: ") and "mean confidence" in line for line in run.ours)
    assert not any("geometry alone" in line for line in run.ours)
    assert "already registered" not in run.text and len(run.text.splitlines()) < 200  # onnxruntime keeps quiet
    text = (tmp_path / "bare.ifc").read_text()
    assert len(ifcopenshell.open(str(tmp_path / "bare.ifc")).by_type("IfcWall")) == 4
    assert "rules.onnx" in text and os.environ["S2B_TEST_MODELS"] not in text


def test_class_and_confidence_are_saved_with_the_cloud(cloudcompare, tmp_path, room):
    points, codes = room
    write_ply(tmp_path / "scan.ply", points, Classification=np.full(len(codes), 10))
    run = cloudcompare("-NO_TIMESTAMP", "-C_EXPORT_FMT", "PLY", "-O", "scan.ply", "-S2B", "-SEGMENT", model("rules"), "-STAGES", "none",
                       "-SAVE_CLOUDS", "FILE", tmp_path / "labelled.ply")
    assert run.rc == 0
    assert not list(tmp_path.glob("*.ifc"))
    saved = read_ply(tmp_path / "labelled.ply")
    names = {name.replace("scalar_", "").replace("_", " "): name for name in saved.dtype.names}
    found, confidence = saved[names["S2B class"]], saved[names["S2B confidence"]]
    assert np.array_equal(saved[names["Classification"]], np.full(len(codes), 10))  # what was there stays
    assert (found == codes).mean() > 0.95
    assert confidence.min() > 0.2 and confidence.max() <= 1
    assert confidence[found == codes].mean() > confidence[found != codes].mean()


def test_the_shipped_model_needs_no_file(cloudcompare, tmp_path, survey):
    run = cloudcompare("-O", survey, "-S2B", "-SEGMENT", "-IFC", "shipped.ifc")
    assert run.rc == 0
    assert any(line.startswith("segmentation with the shipped model") for line in run.ours)
    assert ifcopenshell.open(str(tmp_path / "shipped.ifc")).by_type("IfcWall")


def test_the_same_bytes_for_every_number_of_threads(cloudcompare, tmp_path, survey):
    for name, threads in (("a", 1), ("b", 2)):
        assert cloudcompare("-O", survey, "-S2B", "-SEGMENT", model("plan"), "-IFC", name + ".ifc", "-THREADS", threads).rc == 0
    assert (tmp_path / "a.ifc").read_bytes() == (tmp_path / "b.ifc").read_bytes()


@pytest.mark.parametrize("name, says", [("text", "no ONNX model"), ("unknown_class", "nearest known one is wall"), ("newer_ir", "newer ONNX"),
                                        ("no_metadata", "s2b.contract"), ("needs_colour", "the model needs colours")])
def test_a_wrong_model_is_told_in_one_sentence(cloudcompare, tmp_path, room, name, says):
    shutil.copy(model(name), tmp_path / "model.onnx")
    run = cloudcompare("-O", write_ply(tmp_path / "scan.ply", room[0]), "-S2B", "-SEGMENT", "model.onnx")
    assert run.rc == 1
    told = [line for line in run.ours if says in line]
    assert len(told) == 1 and "model.onnx" in told[0]
    assert not list(tmp_path.glob("*.ifc"))


def test_options_that_contradict_each_other(cloudcompare, tmp_path, room):
    write_ply(tmp_path / "scan.ply", room[0], Classification=room[1])
    for option, value in (("-LABELS", ["Classification"]), ("-GEOMETRY_ONLY", [])):
        run = cloudcompare("-O", "scan.ply", "-S2B", "-SEGMENT", model("rules"), option, *value)
        assert run.rc == 1 and "contradict" in run.text
    run = cloudcompare("-O", "scan.ply", "-S2B", "-SEGMENT", "not_there.onnx")
    assert run.rc == 1 and "does not exist" in run.text
