# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/bench quality on a tiny simulated building: the table's values are sane, and what is wrong is shown."""
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
BUILD = Path(os.environ["S2B_TEST_BUILD"])


def bench(*arguments):
    return subprocess.run([sys.executable, ROOT / "scripts/bench_quality.py", "--build", BUILD, "--data", BUILD / "bench-data",
                           *map(str, arguments)], capture_output=True, text=True, timeout=300)


def table(text):
    """(survey, mode) -> {"wall IoU": 0.98, ...}"""
    lines = text.splitlines()
    titles = lines[1].replace("thk mm", "thk").replace("err mm", "err").replace("time s", "time").replace("peak MB", "peak").split()
    names, group, groups = [], -1, ("wall", "door", "window", "column", "slab")
    for title in titles[2:]:
        group += title == "IoU"
        names.append(f"{groups[group]} {title}" if title in ("IoU", "F1", "both", "thk") else title)
    rows = {}
    for line in lines[2:]:
        cells = line.split()
        if len(cells) == len(titles):
            rows[cells[0], cells[1]] = {n: None if c == "-" else float(c) for n, c in zip(names, cells[2:])}
    return rows


@pytest.fixture(scope="module")
def surveys(tmp_path_factory):
    folder = tmp_path_factory.mktemp("surveys") / "tiny"
    folder.mkdir()
    subprocess.run([BUILD / "tests/simulator/s2b_survey", folder / "scan.laz", "--truth", folder / "gt.json", "--layout", "two-rooms", "--outside",
                    "--storeys", "1", "--step-deg", "0.4", "--voxel", "0.03", "--seed", "3"], check=True, capture_output=True)
    return folder.parent


def test_all_modes_of_a_survey_are_scored_and_drawn(surveys, tmp_path):
    modes = ("given", "degraded", "geometry", "segmented")
    done = bench(surveys, "--out", tmp_path, "--modes", ",".join(modes), "--model", BUILD / "test_models" / "rules.onnx")
    assert done.returncode == 0, done.stderr
    rows = table(done.stdout)
    assert list(rows) == [(survey, m) for survey in ("tiny", "mean") for m in modes]
    given = rows["tiny", "given"]
    # Two rooms with right labels: well within what the reconstruction's own tests ask for (all walls, 5 mm).
    assert 0.8 < given["wall IoU"] <= 1.0
    assert given["wall F1"] > 0.8
    assert given["wall thk"] < 10
    assert given["missed"] == 0 and given["extra"] == 0
    assert given["err"] < 20
    assert 0 < given["time"] < 120
    assert 10 < given["peak"] < 4000
    # One linear layer that looks at height and normal: it tells floors and ceilings, and takes cupboards for walls.
    segmented = rows["tiny", "segmented"]
    assert segmented["flo"] > 0.7 and segmented["cei"] > 0.7 and segmented["wal"] > 0.4
    # It knows no doors; what is found of them, the walls show.
    assert segmented["doo"] < 0.1 and 0.2 < segmented["mIoU"] < 0.9
    assert given["mIoU"] is None
    for mode in ("degraded", "geometry"):
        assert 0.3 < rows["tiny", mode]["wall IoU"] <= 1.0
    assert rows["mean", "given"]["wall IoU"] == given["wall IoU"], "the mean of one survey is that survey"
    page = (tmp_path / "quality.html").read_text()
    assert page.count("<figure>") == 4
    assert page.count('aria-label="Plan of') == 4
    for mode in modes:
        assert (tmp_path / f"tiny-{mode}.ifc").stat().st_size > 1000


def test_a_wall_of_the_truth_that_is_not_there_is_a_miss(surveys, tmp_path):
    folder = tmp_path / "surveys" / "more"
    folder.mkdir(parents=True)
    shutil.copy(surveys / "tiny" / "scan.laz", folder)
    truth = json.loads((surveys / "tiny" / "gt.json").read_text())
    wall = next(e for e in truth["elements"] if e["type"].startswith("IfcWall") and e["points"] > 1000)
    ghost = json.loads(json.dumps(wall))
    ghost["GlobalId"] = "0000000000000000000000"
    ghost["obb"]["center"][0] += 20.0
    ghost["axis"] = [[p[0] + 20.0, *p[1:]] for p in ghost["axis"]]
    ghost["footprint"] = [[[p[0] + 20.0, *p[1:]] for p in ring] for ring in ghost["footprint"]]
    truth["elements"].append(ghost)
    (folder / "gt.json").write_text(json.dumps(truth))
    done = bench(folder.parent, "--modes", "given", "--out", tmp_path / "more")
    assert done.returncode == 0, done.stderr
    without = bench(surveys, "--modes", "given", "--out", tmp_path / "without")
    walls = sum(1 for e in truth["elements"] if e["type"].startswith("IfcWall"))
    more, less = table(done.stdout)["more", "given"]["wall IoU"], table(without.stdout)["tiny", "given"]["wall IoU"]
    # One more of the truth that nothing stands for: the mean sinks by that share (two digits are printed).
    assert more == pytest.approx(less * (walls - 1) / walls, abs=0.02)
    page = (tmp_path / "more" / "quality.html").read_text()
    assert "missed: 1 wall<" in page and "0000000000000000000000" in page
    assert "missed: 1 wall<" not in (tmp_path / "without" / "quality.html").read_text()


@pytest.mark.parametrize("arguments, sentence", [
    (["--modes", "labels"], "there is no mode labels, use given, degraded, geometry"),
    (["--surveys", "castle"], "there is no survey castle"),
])
def test_what_it_does_not_know_ends_in_one_sentence(arguments, sentence, tmp_path):
    done = bench("--out", tmp_path, *arguments)
    assert done.returncode != 0 and sentence in done.stderr
    assert "Traceback" not in done.stderr


def test_a_folder_without_surveys_ends_in_one_sentence(tmp_path):
    done = bench(tmp_path, "--out", tmp_path)
    assert done.returncode != 0 and "has no folder with scan.laz and gt.json" in done.stderr
