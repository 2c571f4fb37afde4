# SPDX-License-Identifier: GPL-3.0-or-later
"""The window's tools around a reconstruction: the dialog, lists, views and help. Every one leaves its screenshots."""
import csv
import os

import ifcopenshell
import numpy as np
import pytest

from conftest import SMALL, make_survey, write_ply


def test_dialog_presets_files_levels(window, to_bin, survey):
    window("dialog", to_bin(survey))


def test_findings_lead_to_their_place(window, to_bin, survey):
    window("findings", to_bin(survey))


def test_floor_plan_and_back(window, to_bin, survey):
    window("floor_plan", to_bin(survey))


def test_files_take_a_coordinate_system(window, cloudcompare, tmp_path, output):
    survey = make_survey(tmp_path / "world.laz", *SMALL, "--origin", 32500100, 5600300, 120)
    run = cloudcompare("-NO_TIMESTAMP", "-C_EXPORT_FMT", "BIN", "-O", "-GLOBAL_SHIFT", "AUTO", survey, "-SAVE_CLOUDS", "FILE", tmp_path / "world.bin",
                       "-S2B", "-EPSG", 4647, "-IFC", "command.ifc")
    assert run.rc == 0
    said = window("export", tmp_path / "world.bin")
    conversions = []
    for path in (tmp_path / "command.ifc", output / "projected.ifc", output / "reconstructed.ifc"):
        model = ifcopenshell.open(str(path))
        assert [crs.Name for crs in model.by_type("IfcProjectedCRS")] == ["EPSG:4647"]
        conversion = model.by_type("IfcMapConversion")[0]
        conversions.append([conversion.Eastings, conversion.Northings, conversion.OrthogonalHeight, conversion.XAxisAbscissa, conversion.XAxisOrdinate])
        assert abs(conversion.Eastings - 32500100) < 100
    for conversion in conversions[1:]:
        assert conversion == pytest.approx(conversions[0], rel=1e-12, abs=1e-6)
    for name in ("placed.ifc", "again.ifc", "last.ifc"):
        assert not ifcopenshell.open(str(output / name)).by_type("IfcCoordinateOperation")

    # What is no code is refused in the command's own sentence.
    refused = [line.removeprefix("refused ") for line in said.splitlines() if line.startswith("refused ")]
    assert refused[:3] == refused[3:]
    for code, sentence in zip(("EPSG:4647", "0", "32632.5"), refused[:3], strict=True):
        assert cloudcompare("-O", "-GLOBAL_SHIFT", "AUTO", survey, "-S2B", "-EPSG", code).ours[-1] == sentence and code in sentence


def test_help_is_complete(window, to_bin, tmp_path, room):
    points, codes = room
    window("help", to_bin(write_ply(tmp_path / "room.ply", points, Classification=codes)))


def test_validation_table(window, to_bin, survey, output):
    window("validation_table", to_bin(survey), S2B_DRIVER_TRUTH=str(survey.parent / "truth.ifc"))
    with open(output / "exported_report" / "elements.csv", newline="", encoding="utf-8") as file:
        assert len(list(csv.DictReader(file))) > 8


def test_selections_that_fit_and_that_do_not(window, to_bin, tmp_path, room):
    points, codes = room
    window("selections", to_bin(write_ply(tmp_path / "room.ply", points, Classification=codes)))


@pytest.mark.skipif(bool(os.environ.get("S2B_TEST_PRELOAD")), reason="a sanitizer keeps what was freed")
def test_memory_does_not_grow(window, to_bin, tmp_path, room):
    """S2B_TEST_CYCLES=200 runs all of what is promised; fewer cycles show a leak as well."""
    points, codes = room
    thin = np.arange(0, len(points), 2)
    window("memory", to_bin(write_ply(tmp_path / "room.ply", points[thin], Classification=codes[thin])),
           S2B_DRIVER_CYCLES=os.environ.get("S2B_TEST_CYCLES", "40"))


@pytest.mark.skipif("S2B_TEST_CLOUD" not in os.environ, reason="a measurement: S2B_TEST_CLOUD is the file of a large cloud")
def test_large_cloud_is_measured(window, to_bin):
    window("large", to_bin(os.environ["S2B_TEST_CLOUD"]))
