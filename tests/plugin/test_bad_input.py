# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever is wrong ends in one clear sentence and exit code 1, and leaves no file."""
import os

import numpy as np
import pytest

from conftest import make_survey, write_ply


@pytest.fixture
def good(tmp_path, room):
    points, codes = room
    return write_ply(tmp_path / "good.ply", points, Classification=codes)


def assert_refused(run, tmp_path, *words):
    """Exit code 1, the last thing said is one sentence of ours with these words, and no IFC file is there."""
    assert run.rc == 1
    sentences = [line for line in run.ours if all(word.lower() in line.lower() for word in words)]
    assert len(sentences) == 1, "expected one sentence with %s" % (words,)
    assert sentences[0] == run.ours[-1]
    assert not list(tmp_path.rglob("*.ifc*"))


def test_no_cloud(cloudcompare, tmp_path):
    assert_refused(cloudcompare("-S2B"), tmp_path, "no point cloud", "-O")


def test_empty_cloud(cloudcompare, tmp_path, good):
    # All points are filtered out: whether CloudCompare or we say it, nothing is written and the run fails.
    run = cloudcompare("-O", good, "-AUTO_SAVE", "OFF", "-SET_ACTIVE_SF", 0, "-FILTER_SF", 100, 200, "-S2B")
    assert run.rc == 1
    assert not list(tmp_path.rglob("*.ifc*"))


def test_file_without_points(cloudcompare, tmp_path):
    run = cloudcompare("-O", write_ply(tmp_path / "empty.ply", np.zeros((0, 3))), "-S2B")
    assert run.rc == 1
    assert not list(tmp_path.rglob("*.ifc*"))


def test_coordinates_that_are_not_numbers(cloudcompare, tmp_path, room):
    # CloudCompare's readers of text and PLY replace such coordinates, its own format keeps them: a mark is put there and overwritten.
    points, codes = room
    mark = np.float32(1234.5)
    points[77, 1] = mark
    write_ply(tmp_path / "scan.ply", points, Classification=codes)
    assert cloudcompare("-NO_TIMESTAMP", "-C_EXPORT_FMT", "BIN", "-O", "scan.ply", "-SAVE_CLOUDS", "FILE", "nan.bin").rc == 0
    data = (tmp_path / "nan.bin").read_bytes()
    assert data.count(mark.tobytes()) >= 1
    (tmp_path / "nan.bin").write_bytes(data.replace(mark.tobytes(), np.float32(np.nan).tobytes()))
    assert_refused(cloudcompare("-O", "nan.bin", "-S2B"), tmp_path, "point 78", "not a number")


def test_unknown_label_field(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-LABELS", "Clasification"), tmp_path, "'Clasification'", "Classification")


def test_unknown_label_codes(cloudcompare, tmp_path, room):
    points, codes = room
    codes[:5] = 77
    run = cloudcompare("-O", write_ply(tmp_path / "codes.ply", points, Classification=codes), "-S2B")
    assert_refused(run, tmp_path, "77 (5 points)", "-LABEL_MAP", "'s2b'")


def test_field_that_holds_no_codes(cloudcompare, tmp_path, room):
    points, _ = room
    run = cloudcompare("-O", write_ply(tmp_path / "height.ply", points, label=points[:, 2] + 0.25), "-S2B")
    assert_refused(run, tmp_path, "class codes", "-GEOMETRY_ONLY")


def test_unknown_label_map(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-LABEL_MAP", "s3diss"), tmp_path, "s3dis")


def test_unknown_parameter_names_the_nearest(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-SET", "walls.maximumThicknes=0.5"), tmp_path, "walls.maximumThickness")


@pytest.mark.parametrize("value", ["-1", "1000", "nan", "thick"])
def test_parameter_out_of_range(cloudcompare, tmp_path, good, value):
    assert_refused(cloudcompare("-O", good, "-S2B", "-SET", "walls.maximumThickness=" + value), tmp_path, "walls.maximumThickness")


def test_unknown_parameter_in_a_file(cloudcompare, tmp_path, good):
    (tmp_path / "parameters.toml").write_text("[walls]\nmaximumThick = 0.5\n")
    assert_refused(cloudcompare("-O", good, "-S2B", "-CONFIG", "parameters.toml"), tmp_path, "parameters.toml", "walls.maximumThick")


def test_unknown_preset(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-PRESET", "castle"), tmp_path, "castle", "residential", "mobile-mapping")


def test_two_presets_of_one_kind(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-PRESET", "office,hall"), tmp_path, "same kind")


@pytest.mark.parametrize("levels", ["2.6", "2.6:0", "3:5.6,0:2.6", "0:high", "0:2.6,"])
def test_levels_that_are_none(cloudcompare, tmp_path, good, levels):
    assert_refused(cloudcompare("-O", good, "-S2B", "-LEVELS", levels), tmp_path, "-LEVELS", "floor:ceiling")


def test_unknown_option_is_found_before_anything_runs(cloudcompare, tmp_path, good):
    run = cloudcompare("-O", good, "-S2B", "-THREADZ", "2")
    assert_refused(run, tmp_path, "-THREADZ", "-THREADS")
    assert len(run.ours) == 1


def test_option_without_its_value(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-IFC"), tmp_path, "-IFC needs a value")


def test_option_given_twice(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-SEED", "1", "-SEED", "2"), tmp_path, "-SEED is given twice")


def test_contradicting_options(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-GEOMETRY_ONLY", "-LABELS", "Classification"), tmp_path, "contradict")


@pytest.mark.parametrize("threads", ["0", "-2", "many"])
def test_threads_that_are_no_number_of_threads(cloudcompare, tmp_path, good, threads):
    assert_refused(cloudcompare("-O", good, "-S2B", "-THREADS", threads), tmp_path, "-THREADS")


def test_unknown_stage(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-STAGES", "walls,dores"), tmp_path, "dores", "doors")


def test_unknown_schema(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-SCHEMA", "IFC2X3"), tmp_path, "IFC2X3", "IFC4X3_ADD2")


def test_output_folder_that_does_not_exist(cloudcompare, tmp_path, good):
    assert_refused(cloudcompare("-O", good, "-S2B", "-IFC", "nowhere/model.ifc"), tmp_path, "nowhere", "does not exist")


def test_output_that_is_a_folder(cloudcompare, tmp_path, good):
    (tmp_path / "model").mkdir()
    assert_refused(cloudcompare("-O", good, "-S2B", "-IFC", "model"), tmp_path, "is a folder")


def test_output_that_can_not_be_written(cloudcompare, tmp_path, good):
    # Root may write anywhere, but nobody can make a file below /proc.
    assert_refused(cloudcompare("-O", good, "-S2B", "-IFC", "/proc/model.ifc"), tmp_path, "/proc/model.ifc")


def test_existing_model_survives_a_failure(cloudcompare, tmp_path, good):
    model = tmp_path / "model.ifc"
    model.write_text("precious")
    assert cloudcompare("-O", good, "-S2B", "-IFC", model, "-SET", "no.such=1").rc == 1
    assert model.read_text() == "precious"


def test_truncated_laz(cloudcompare, tmp_path, survey):
    whole = survey.read_bytes()
    (tmp_path / "cut.laz").write_bytes(whole[: len(whole) // 2])
    assert_refused(cloudcompare("-O", "cut.laz", "-S2B"), tmp_path, "truncated", "cut.laz")


def test_laz_that_ends_in_its_header(cloudcompare, tmp_path, survey):
    (tmp_path / "cut.laz").write_bytes(survey.read_bytes()[:100])
    assert cloudcompare("-O", "cut.laz", "-S2B").rc == 1
    assert not list(tmp_path.rglob("*.ifc*"))


def test_world_coordinates_that_lost_their_precision(cloudcompare, tmp_path):
    scan = make_survey(tmp_path / "world.laz", "--layout", "one-room", "--storeys", 1, "--step-deg", 1, "--origin", 500000, 5400000, 300)
    assert_refused(cloudcompare("-O", scan, "-S2B"), tmp_path, "-GLOBAL_SHIFT AUTO")
