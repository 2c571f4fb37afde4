# SPDX-License-Identifier: GPL-3.0-or-later
"""A survey goes in, a valid and reproducible IFC model comes out."""
import shutil
import subprocess
import sys

import ifcopenshell
import ifcopenshell.geom
import numpy as np
import pytest

from conftest import SMALL, make_survey, write_ply


def assert_valid(path):
    """No finding of the schema's own rules."""
    check = subprocess.run([sys.executable, "-m", "ifcopenshell.validate", "--rules", str(path)], capture_output=True, text=True)
    assert check.returncode == 0, check.stdout + check.stderr


def wall_corners(path):
    """All vertices of all walls in world coordinates [m]."""
    model = ifcopenshell.open(str(path))
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    vertices = []
    for wall in model.by_type("IfcWall"):
        shape = ifcopenshell.geom.create_shape(settings, wall)
        vertices.append(np.array(shape.geometry.verts).reshape(-1, 3))
    return np.concatenate(vertices)


def test_model_is_valid_and_beside_the_cloud(cloudcompare, survey, tmp_path, output):
    scan = shutil.copy(survey, tmp_path / "scan.laz")
    run = cloudcompare("-O", scan, "-S2B")
    assert run.rc == 0
    path = tmp_path / "scan.ifc"
    shutil.copy(path, output / "small.ifc")
    assert_valid(path)
    model = ifcopenshell.open(str(path))
    truth = ifcopenshell.open(str(survey.parent / "truth.ifc"))
    assert model.schema == "IFC4"
    assert len(model.by_type("IfcBuildingStorey")) == len(truth.by_type("IfcBuildingStorey"))
    assert len(model.by_type("IfcWall")) == len(truth.by_type("IfcWall"))
    assert len(model.by_type("IfcDoor")) >= len(truth.by_type("IfcDoor"))  # a plain opening of a door's size may be taken for one
    assert any("walls" in line and "Level 0" in line for line in run.ours)


def test_other_schema(cloudcompare, survey, tmp_path):
    assert cloudcompare("-O", survey, "-S2B", "-SCHEMA", "ifc4x3_add2", "-IFC", "model.ifc").rc == 0
    assert ifcopenshell.open(str(tmp_path / "model.ifc")).schema.startswith("IFC4X3")
    assert_valid(tmp_path / "model.ifc")


def test_same_bytes_for_every_number_of_threads(cloudcompare, survey, tmp_path):
    for name, threads in (("a", 1), ("b", 1), ("c", 2)):
        assert cloudcompare("-O", survey, "-S2B", "-IFC", name + ".ifc", "-THREADS", threads).rc == 0
    first = (tmp_path / "a.ifc").read_bytes()
    assert first == (tmp_path / "b.ifc").read_bytes()
    assert first == (tmp_path / "c.ifc").read_bytes()


@pytest.fixture(scope="module")
def world(tmp_path_factory):
    """A georeferenced survey, world.laz, and its truth.ifc."""
    folder = tmp_path_factory.mktemp("world")
    make_survey(folder / "world.laz", *SMALL, "--origin", 32500100, 5600300, 120, "--truth-ifc", folder / "truth.ifc")
    return folder


def test_georeferenced_survey_keeps_its_place(cloudcompare, tmp_path, world):
    assert cloudcompare("-O", "-GLOBAL_SHIFT", "AUTO", world / "world.laz", "-S2B", "-IFC", "model.ifc").rc == 0
    assert_valid(tmp_path / "model.ifc")
    found, truth = wall_corners(tmp_path / "model.ifc"), wall_corners(world / "truth.ifc")
    # Both faces of every outer wall are seen, so the plan's extent is measured: 2 cm is what the survey's 1 cm points allow.
    assert np.allclose(found.min(axis=0)[:2], truth.min(axis=0)[:2], atol=0.02)
    assert np.allclose(found.max(axis=0)[:2], truth.max(axis=0)[:2], atol=0.02)


def test_coordinate_system_gives_a_map_conversion(cloudcompare, tmp_path, world):
    run = cloudcompare("-O", "-GLOBAL_SHIFT", "AUTO", world / "world.laz", "-S2B", "-EPSG", 4647, "-IFC", "model.ifc", "-VALIDATE", world / "truth.ifc")
    assert run.rc == 0
    assert_valid(tmp_path / "model.ifc")
    model = ifcopenshell.open(str(tmp_path / "model.ifc"))
    assert [crs.Name for crs in model.by_type("IfcProjectedCRS")] == ["EPSG:4647"]
    conversion = model.by_type("IfcMapConversion")[0]
    assert abs(conversion.Eastings - 32500100) < 100 and abs(conversion.Northings - 5600300) < 100
    # The elements are in coordinates of their own, and the validation finds them where the truth is.
    assert np.abs(wall_corners(tmp_path / "model.ifc")).max() < 100
    assert any(line.startswith("walls:") and "F1" in line for line in run.ours)


@pytest.mark.parametrize("code", ["0", "EPSG:4647", "32632.5"])
def test_coordinate_system_that_is_none(cloudcompare, room, tmp_path, code):
    points, codes = room
    run = cloudcompare("-O", write_ply(tmp_path / "room.ply", points, Classification=codes), "-S2B", "-EPSG", code)
    assert run.rc == 1 and "-EPSG" in run.ours[-1]


def test_two_clouds_are_taken_together(cloudcompare, tmp_path, room):
    points, codes = room
    half = points[:, 0] < 2.5
    write_ply(tmp_path / "all.ply", points, Classification=codes)
    write_ply(tmp_path / "left.ply", points[half], Classification=codes[half])
    write_ply(tmp_path / "right.ply", points[~half], Classification=codes[~half])
    assert cloudcompare("-O", "all.ply", "-S2B", "-IFC", "one.ifc").rc == 0
    run = cloudcompare("-O", "left.ply", "-O", "right.ply", "-S2B", "-IFC", "two.ifc")
    assert run.rc == 0
    assert "2 clouds" in run.text
    counts = [len(ifcopenshell.open(str(tmp_path / name)).by_type("IfcWall")) for name in ("one.ifc", "two.ifc")]
    assert counts[0] == counts[1] == 4


def test_labels_of_another_map_and_field(cloudcompare, tmp_path, room):
    points, codes = room
    s3dis = np.choose(codes, [12, 1, 0, 2])  # s2b floor 1, ceiling 2, wall 3
    write_ply(tmp_path / "s3dis.ply", points, class_id=s3dis)
    run = cloudcompare("-O", "s3dis.ply", "-S2B", "-LABELS", "class_id", "-LABEL_MAP", "s3dis")
    assert run.rc == 0
    assert "wall %s" % format(int((codes == 3).sum()), ",d") in run.text
    assert len(ifcopenshell.open(str(tmp_path / "s3dis.ifc")).by_type("IfcWall")) == 4


def test_without_labels_it_warns_and_takes_those_of_the_shipped_model(cloudcompare, tmp_path, room):
    run = cloudcompare("-O", write_ply(tmp_path / "bare.ply", room[0]), "-S2B")
    assert run.rc == 0
    assert any("no labels" in line and "shipped model" in line for line in run.ours)
    assert any(line.startswith("labels: ") and "mean confidence" in line for line in run.ours)
    assert_valid(tmp_path / "bare.ifc")
    assert len(ifcopenshell.open(str(tmp_path / "bare.ifc")).by_type("IfcWall")) == 4


def test_geometry_only_takes_no_model(cloudcompare, tmp_path, room):
    run = cloudcompare("-O", write_ply(tmp_path / "bare.ply", room[0]), "-S2B", "-GEOMETRY_ONLY")
    assert run.rc == 0
    assert not any("shipped model" in line or line.startswith("labels: ") for line in run.ours)
    assert len(ifcopenshell.open(str(tmp_path / "bare.ifc")).by_type("IfcWall")) == 4


def test_labels_that_name_no_wall_leave_it_to_the_shipped_model(cloudcompare, tmp_path, room):
    points, codes = room
    asprs = np.choose(codes, [1, 2, 6, 6])  # ground and building
    run = cloudcompare("-O", write_ply(tmp_path / "airborne.ply", points, Classification=asprs), "-S2B", "-LABEL_MAP", "asprs")
    assert run.rc == 0
    assert any("names no wall" in line and "shipped model" in line for line in run.ours)


def test_geometry_only_does_not_look_at_the_labels(cloudcompare, tmp_path, room):
    points, codes = room
    codes[:] = 99  # would be refused
    run = cloudcompare("-O", write_ply(tmp_path / "scan.ply", points, Classification=codes), "-S2B", "-GEOMETRY_ONLY")
    assert run.rc == 0


def test_parameters_are_recorded_and_set_wins_over_config(cloudcompare, tmp_path, room):
    points, codes = room
    write_ply(tmp_path / "scan.ply", points, Classification=codes)
    (tmp_path / "p.toml").write_text("[walls]\ndefaultExternalThickness = 0.41\ndefaultThickness = 0.17\n")
    assert cloudcompare("-O", "scan.ply", "-S2B", "-SET", "walls.defaultThickness=0.19", "-CONFIG", "p.toml").rc == 0
    text = (tmp_path / "scan.ifc").read_text()
    assert "'walls.defaultThickness'" in text and "0.19" in text and "0.41" in text
    assert "0.17" not in text.split("'walls.defaultThickness'")[1][:80]


def test_a_preset_comes_before_config_and_set(cloudcompare, tmp_path, room):
    points, codes = room
    write_ply(tmp_path / "scan.ply", points, Classification=codes)
    (tmp_path / "p.toml").write_text("[walls]\ndefaultExternalThickness = 0.41\n")
    assert cloudcompare("-O", "scan.ply", "-S2B", "-CONFIG", "p.toml", "-PRESET", "office,mobile-mapping").rc == 0
    model = ifcopenshell.open(str(tmp_path / "scan.ifc"))
    values = {p.Name: str(p.NominalValue.wrappedValue) for p in model.by_type("IfcPropertySingleValue") if p.NominalValue}
    assert values["walls.defaultThickness"] == "0.125" and values["walls.planeDistance"] == "0.04"
    assert values["walls.defaultExternalThickness"] == "0.41"


def test_levels_can_be_given(cloudcompare, tmp_path, room):
    points, codes = room
    write_ply(tmp_path / "scan.ply", points - [0, 0, 3.0], Classification=codes)  # a basement
    run = cloudcompare("-O", "scan.ply", "-S2B", "-LEVELS", "-2.95:-0.45")
    assert run.rc == 0
    assert len(ifcopenshell.open(str(tmp_path / "scan.ifc")).by_type("IfcBuildingStorey")) == 1
    assert any("Level 0 at -2.950 m, 2.50 m high" in line for line in run.ours)
    assert_valid(tmp_path / "scan.ifc")


def test_stages_limit_what_is_made(cloudcompare, tmp_path, survey):
    assert cloudcompare("-O", survey, "-S2B", "-STAGES", "walls", "-IFC", "walls.ifc").rc == 0
    model = ifcopenshell.open(str(tmp_path / "walls.ifc"))
    assert model.by_type("IfcWall") and not model.by_type("IfcDoor") and not model.by_type("IfcWindow")


def test_commands_of_cloudcompare_go_on_after_ours(cloudcompare, tmp_path, room):
    points, codes = room
    write_ply(tmp_path / "scan.ply", points, Classification=codes)
    run = cloudcompare("-NO_TIMESTAMP", "-O", "scan.ply", "-S2B", "-M_EXPORT_FMT", "OBJ", "-SAVE_MESHES")
    assert run.rc == 0
    assert "already registered" not in run.text
    meshes = list(tmp_path.glob("scan_Wall*.obj"))
    assert len(meshes) == 4
    assert all(mesh.read_text().count("\nf ") >= 12 for mesh in meshes)


def test_time_stamp_comes_from_the_environment(cloudcompare, tmp_path, room):
    points, codes = room
    write_ply(tmp_path / "scan.ply", points, Classification=codes)
    assert cloudcompare("-O", "scan.ply", "-S2B", SOURCE_DATE_EPOCH="1700000000").rc == 0
    assert "2023-11-14T22:13:20" in (tmp_path / "scan.ifc").read_text()[:1000]
