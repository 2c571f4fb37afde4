# SPDX-License-Identifier: GPL-3.0-or-later
"""CloudCompare's window under a virtual display: what a user sees and does."""
import json
import os
import re
import subprocess
import sys

import ifcopenshell
import ifcopenshell.util.element
import ifcopenshell.util.placement
import numpy as np
import pytest

from conftest import make_survey, write_ply


def test_reconstruct_look_correct_export(window, to_bin, survey, output):
    said = window("reconstruct", to_bin(survey))
    walls = int(said.split("walls ")[-1].split()[0])
    assert len(ifcopenshell.open(str(output / "dialog.ifc")).by_type("IfcWall")) == walls + 1
    assert len(ifcopenshell.open(str(output / "without_one_wall.ifc")).by_type("IfcWall")) == walls
    check = subprocess.run([sys.executable, "-m", "ifcopenshell.validate", "--rules", str(output / "without_one_wall.ifc")], capture_output=True)
    assert check.returncode == 0, check.stdout


def test_cancelling_and_quitting_leave_nothing(window, to_bin, tmp_path):
    # Large enough that the last moment of cancelling still lies within the run.
    scan = to_bin(make_survey(tmp_path / "large.laz", "--storeys", 2, "--rooms", 2, "--step-deg", 0.2, "--voxel", 0.01))
    window("cancel", scan)
    window("quit", scan)


def test_unknown_codes_are_shown(window, to_bin, tmp_path, room):
    points, codes = room
    codes[:100] = 77
    window("labels", to_bin(write_ply(tmp_path / "codes.ply", points, Classification=codes)))


def test_a_build_without_a_model_does_not_offer_its_labels(window, to_bin, tmp_path, room):
    points, _ = room
    window("without_model", to_bin(write_ply(tmp_path / "bare.ply", points)), CC_PLUGIN_PATH=os.environ["S2B_TEST_PLUGINS_WITHOUT_MODEL"])


def test_segment_adds_class_and_confidence(window, to_bin, survey, tmp_path):
    bad = tmp_path / "bad.onnx"
    bad.write_text("this is no model")
    window("segment", to_bin(survey), S2B_DRIVER_MODEL=os.environ["S2B_TEST_MODELS"] + "/rules.onnx", S2B_DRIVER_BAD_MODEL=str(bad))


def test_validate_shows_verdicts_and_deviations(window, to_bin, survey, tmp_path, output):
    bad = tmp_path / "bad.ifc"
    bad.write_text("this is no IFC file")
    window("validate", to_bin(survey), S2B_DRIVER_TRUTH=str(survey.parent / "truth.ifc"), S2B_DRIVER_BAD_TRUTH=str(bad))
    report = json.loads((output / "window_report" / "report.json").read_text())
    assert report["classes"]["wall"]["at50"]["f1"] >= 0.9
    assert report["files"]["result"]["name"].endswith(".ifc")
    assert "/" not in report["files"]["truth"]["name"]


def number(said, key):
    """What a line of its own says: "walls 12"."""
    return int(re.findall(rf"^{key} (\d+)$", said, re.MULTILINE)[-1])


def walls_of(path):
    """The walls of a file by their ids: name, start and end of the axis in the plan, thickness."""
    model = ifcopenshell.open(str(path))
    walls = {}
    for wall in model.by_type("IfcWall"):
        placement = ifcopenshell.util.placement.get_local_placement(wall.ObjectPlacement)
        axis = next(r for r in wall.Representation.Representations if r.RepresentationIdentifier == "Axis").Items[0]
        ends = [placement @ [*point[:2], 0, 1] for point in (axis.Points[0].Coordinates, axis.Points[-1].Coordinates)]
        quantities = ifcopenshell.util.element.get_psets(wall)["Qto_WallBaseQuantities"]
        walls[int(wall.Tag)] = (wall.Name, ends[0][:2], ends[1][:2], quantities["Width"])
    return walls


def valid(path):
    return subprocess.run([sys.executable, "-m", "ifcopenshell.validate", "--rules", str(path)], capture_output=True).returncode == 0


def test_single_stages_use_what_is_there(window, to_bin, survey, output):
    said = window("stages", to_bin(survey))
    model = ifcopenshell.open(str(output / "stages.ifc"))
    assert len(model.by_type("IfcWall")) == number(said, "walls")
    assert len(model.by_type("IfcDoor")) == number(said, "doors")
    assert model.by_type("IfcBuildingStorey")[0].Elevation == pytest.approx(0.1, abs=0.02)
    assert model.by_type("IfcColumn") and model.by_type("IfcSlab") and valid(output / "stages.ifc")


def test_corrections_are_exported_saved_and_reopened(window, to_bin, survey, output):
    said = window("edit", to_bin(survey))
    inner, added = number(said, "moved"), number(said, "added")
    before, moved, edited = (walls_of(output / (name + ".ifc")) for name in ("unmoved", "moved", "edited"))

    # CloudCompare's turn and scale are the wall's,
    turned = walls_of(output / "turned.ifc")[inner]
    directions = [(end - start) / np.linalg.norm(end - start) for _, start, end, _ in (before[inner], turned)]
    assert np.arccos(directions[0] @ directions[1]) == pytest.approx(0.1, abs=0.002)
    heights = [ifcopenshell.util.element.get_psets(next(w for w in ifcopenshell.open(str(output / name)).by_type("IfcWall") if w.Tag == str(inner)))
               ["Qto_WallBaseQuantities"]["Height"] for name in ("unmoved.ifc", "scaled.ifc")]
    assert heights[1] == pytest.approx(heights[0] / 2, abs=0.002)
    # and so is its move; those that meet it still do.
    for end in (1, 2):
        assert np.linalg.norm(moved[inner][end] - before[inner][end]) == pytest.approx(0.3, abs=0.002)
    joints = [len(ifcopenshell.open(str(output / name)).by_type("IfcRelConnectsPathElements")) for name in ("unmoved.ifc", "moved.ifc")]
    assert joints[0] == joints[1] > 0
    placed = ifcopenshell.util.element.get_psets(next(w for w in ifcopenshell.open(str(output / "moved.ifc")).by_type("IfcWall") if w.Tag == str(inner)))
    assert placed["S2B_Evidence"]["PlacementProvenance"] == "Corrected"

    assert set(edited) == set(before) | {added}
    assert edited[inner][0] == "Partition"
    assert edited[added][3] == pytest.approx(0.12, abs=0.002)
    tags = {e.Tag for e in ifcopenshell.open(str(output / "edited.ifc")).by_type("IfcWindow")}
    assert str(number(said, "deleted")) not in tags and tags
    assert valid(output / "edited.ifc")

    # All of it survives a file, and goes on from there.
    window("edited", output / "edited.bin")
    assert (output / "reopened.ifc").read_text().split("DATA;")[1].count("\n") == (output / "edited.ifc").read_text().split("DATA;")[1].count("\n")
    reopened, back = walls_of(output / "reopened.ifc"), walls_of(output / "moved_back.ifc")
    for wall, values in edited.items():
        assert reopened[wall][0] == values[0]
        assert np.allclose(reopened[wall][1], values[1], atol=1e-6) and np.allclose(reopened[wall][2], values[2], atol=1e-6)
    assert np.allclose(back[inner][1], before[inner][1], atol=0.002)
    assert set(back) == set(edited)


def test_a_picked_level_gets_walls(window, cloudcompare, tmp_path, output):
    # Without what is above the upper storey's walls, its floor is what a click from above meets.
    scan = make_survey(tmp_path / "house.laz", "--layout", "two-rooms", "--storeys", 2, "--step-deg", 0.25, "--voxel", 0.03, "--outside",
                       "--without", "trees,furniture,curved-walls")
    run = cloudcompare("-NO_TIMESTAMP", "-C_EXPORT_FMT", "BIN", "-O", scan, "-CROP", "-100:-100:-100:100:100:5.0", "-SAVE_CLOUDS", "FILE", tmp_path / "scan.bin")
    assert run.rc == 0
    said = window("add_level", tmp_path / "scan.bin")
    model = ifcopenshell.open(str(output / "added_level.ifc"))
    walls = {storey.Name: sum(e.is_a("IfcWall") for r in storey.ContainsElements for e in r.RelatedElements) for storey in model.by_type("IfcBuildingStorey")}
    assert walls == {"Level 0": number(said, "lower"), "Level 1": number(said, "upper")}
    assert valid(output / "added_level.ifc")
