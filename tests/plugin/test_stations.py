# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the scanner stood: what the points leave open is right with it."""
import ifcopenshell
import ifcopenshell.util.placement
import numpy as np
import pytest

from conftest import SMALL, make_survey, write_ply

SIZE = np.array([6.0, 5.0, 2.6])
STATION = np.array([2.6, 2.2, 1.5])
HIDDEN_M = 0.9  # of floor and ceiling along the walls: which side of a wall is the room's can't be seen there


def scan_of_hall(columns=900, rows=360):
    """A panorama of a hall from one station, relative to it; (0, 0, 0) for no return, as PTX has it."""
    azimuth = np.linspace(-np.pi, np.pi, columns, endpoint=False)
    elevation = np.linspace(-np.radians(70), np.radians(85), rows)
    a, e = np.meshgrid(azimuth, elevation, indexing="ij")
    ray = np.stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)], -1).reshape(-1, 3)
    with np.errstate(divide="ignore"):
        to_planes = np.where(ray > 0, (SIZE - STATION) / ray, np.where(ray < 0, -STATION / ray, np.inf))
    hit = ray * to_planes.min(axis=1)[:, None]
    place = hit + STATION
    level = (to_planes.argmin(axis=1) == 2)
    edge = np.minimum(place[:, :2], SIZE[:2] - place[:, :2]).min(axis=1)
    hit[level & (edge < HIDDEN_M)] = 0
    return hit, columns, rows


def write_ptx(path, hit, columns, rows, shift=(0, 0, 0)):
    x, y, z = (STATION + shift).tolist()
    head = "%d\n%d\n%r %r %r\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n%r %r %r 1\n" % (columns, rows, x, y, z, x, y, z)
    path.write_text(head + "".join("%.4f %.4f %.4f 0.5\n" % tuple(p) for p in hit))
    return path


def wall_count(path):
    return len(ifcopenshell.open(str(path)).by_type("IfcWall"))


def axes_are_outside(path):
    """Whether every wall's middle lies outside of what the scanner saw: its body is behind the face."""
    middles = []
    for wall in ifcopenshell.open(str(path)).by_type("IfcWall"):
        placement = ifcopenshell.util.placement.get_local_placement(wall.ObjectPlacement)
        axis = next(r for r in wall.Representation.Representations if r.RepresentationIdentifier == "Axis").Items[0]
        points = np.array(axis.Points.CoordList if axis.is_a("IfcIndexedPolyCurve") else [p.Coordinates for p in axis.Points])
        middle = np.append(points[:, :2].mean(axis=0), (0.0, 1.0))
        middles.append((placement @ middle)[:2])
    return all((m < 0).any() or (m > SIZE[:2]).any() for m in middles)


def test_sensor_of_a_ptx_file_says_where_the_walls_bodies_are(cloudcompare, tmp_path):
    hit, columns, rows = scan_of_hall()
    write_ptx(tmp_path / "hall.ptx", hit, columns, rows)
    run = cloudcompare("-O", "hall.ptx", "-S2B", "-IFC", "with.ifc")
    assert run.rc == 0
    assert any("1 station of the scanner, every point is its" in line for line in run.ours)
    assert wall_count(tmp_path / "with.ifc") == 4
    assert axes_are_outside(tmp_path / "with.ifc")

    # The same points alone don't say it.
    write_ply(tmp_path / "hall.ply", hit[(hit != 0).any(axis=1)] + STATION)
    run = cloudcompare("-O", "hall.ply", "-S2B", "-IFC", "without.ifc")
    assert run.rc == 0
    assert wall_count(tmp_path / "without.ifc") < 4


def labelled_hall():
    hit, _, _ = scan_of_hall()
    points = hit[(hit != 0).any(axis=1)] + STATION
    codes = np.full(len(points), 3)
    codes[points[:, 2] < 1e-4] = 1
    codes[points[:, 2] > SIZE[2] - 1e-4] = 2
    return points, codes


@pytest.mark.parametrize("text", ["id,x,y,z\n9,%r,%r,%r\n4,50,0,0\n", '{"stations": [{"id": 9, "x": %r, "y": %r, "z": %r}]}'])
def test_stations_file_by_source_id(cloudcompare, tmp_path, text):
    points, codes = labelled_hall()
    write_ply(tmp_path / "hall.ply", points, Classification=codes, Point_Source_ID=np.full(len(points), 9))
    (tmp_path / "stations.txt").write_text(text % tuple(STATION.tolist()))
    run = cloudcompare("-O", "hall.ply", "-S2B", "-STATIONS", "stations.txt")
    assert run.rc == 0
    assert any("100.0 % of the points name theirs" in line for line in run.ours)
    assert wall_count(tmp_path / "hall.ifc") == 4
    assert axes_are_outside(tmp_path / "hall.ifc")


def test_stations_file_without_ids_of_points(cloudcompare, tmp_path):
    points, codes = labelled_hall()
    write_ply(tmp_path / "hall.ply", points, Classification=codes)
    (tmp_path / "stations.txt").write_text("%r %r %r\n3 40 1.5\n" % tuple(STATION.tolist()))
    run = cloudcompare("-O", "hall.ply", "-S2B", "-STATIONS", "stations.txt")
    assert run.rc == 0
    assert any("follows from what they can see" in line for line in run.ours)
    assert wall_count(tmp_path / "hall.ifc") == 4


def test_truth_of_a_georeferenced_survey_is_a_stations_file(cloudcompare, tmp_path):
    make_survey(tmp_path / "world.laz", *SMALL, "--origin", 32500100, 5600300, 120, "--truth", tmp_path / "truth.json")
    run = cloudcompare("-O", "-GLOBAL_SHIFT", "AUTO", "world.laz", "-S2B", "-STATIONS", "truth.json")
    assert run.rc == 0
    assert any("100.0 % of the points name theirs" in line for line in run.ours)


@pytest.mark.parametrize("text, said", [("1 2 3\n4 5\n", "line 2"), ("9 5000 0 0\n", "same coordinates"), ("8 1 1 1\n", "same ids")])
def test_stations_that_cannot_be_used_end_the_run(cloudcompare, tmp_path, text, said):
    points, codes = labelled_hall()
    write_ply(tmp_path / "hall.ply", points, Classification=codes, Point_Source_ID=np.full(len(points), 9))
    (tmp_path / "stations.txt").write_text(text)
    run = cloudcompare("-O", "hall.ply", "-S2B", "-STATIONS", "stations.txt")
    assert run.rc == 1
    assert said in run.text and "stations.txt" in run.text
    assert not (tmp_path / "hall.ifc").exists()
