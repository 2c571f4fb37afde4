# SPDX-License-Identifier: GPL-3.0-or-later
"""-VALIDATE and -REPORT: a reconstruction, or any IFC file, against a ground truth and the points."""
import csv
import io
import json
import shutil
import struct
import xml.etree.ElementTree as ElementTree
import zipfile
from html.parser import HTMLParser

import numpy as np
import pytest

from conftest import make_survey, write_ply

FILES = ["elements.csv", "issues.bcf", "report.html", "report.json"]


@pytest.fixture(scope="module")
def truth(survey):
    return survey.parent / "truth.ifc"


@pytest.fixture(scope="module")
def model(survey, tmp_path_factory, request):
    """The survey reconstructed once, for what only compares."""
    return tmp_path_factory.mktemp("model") / "model.ifc"


@pytest.fixture
def written_model(cloudcompare, survey, model):
    if not model.exists():
        assert cloudcompare("-O", survey, "-S2B", "-IFC", model).rc == 0
    return model


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def read_report(folder):
    assert names(folder) == FILES
    return json.loads((folder / "report.json").read_text(encoding="utf-8"))


def assert_refused(run, tmp_path, *words):
    """Exit code 1, one sentence of ours with these words comes last, and neither a model nor a report is left."""
    assert run.rc == 1
    sentences = [line for line in run.ours if all(word.lower() in line.lower() for word in words)]
    assert len(sentences) == 1, "expected one sentence with %s" % (words,)
    assert sentences[0] == run.ours[-1]
    assert not list(tmp_path.rglob("*_report*")) and not list(tmp_path.rglob("report.*")) and not list(tmp_path.rglob("scan.ifc*"))


class Page(HTMLParser):
    """What a page shows and asks for."""

    def __init__(self, text):
        super().__init__()
        self.text, self.links, self.rows = "", [], 0
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.links += [value for name, value in attributes if name in ("src", "href", "xlink:href")]
        self.rows += any(name == "id" and value.startswith("e") for name, value in attributes) and tag == "tr"

    def handle_data(self, data):
        self.text += data


def test_a_reconstruction_is_measured_as_it_was_written(cloudcompare, survey, truth, tmp_path, output):
    scan = shutil.copy(survey, tmp_path / "scan.laz")
    run = cloudcompare("-O", scan, "-S2B", "-VALIDATE", truth)
    assert run.rc == 0
    folder = tmp_path / "scan_report"
    report = read_report(folder)
    shutil.copytree(folder, output / "report")

    walls = report["classes"]["wall"]
    assert walls["at50"]["f1"] >= 0.9  # two rooms seen from inside and outside: every wall is there
    assert walls["iou"] >= 0.85
    # Both faces are seen: the survey's noise is 3 mm, its points are 3 cm apart.
    assert walls["thicknessError_m"] < 0.005
    assert report["cloudToResult"]["wallMeanAbsolute_m"] < 0.010
    assert report["storeys"][0]["error_m"] < 0.01
    assert report["files"]["result"]["name"] == "scan.ifc" and report["files"]["cloud"]["points"] > 100000
    assert report["parameters"]["seed"] == "1"
    assert any(line.startswith("walls:") and "F1" in line for line in run.ours)
    assert any("judged elements are within LOA30" in line for line in run.ours)


def test_all_files_tell_of_the_same_elements(cloudcompare, survey, truth, written_model, tmp_path):
    assert cloudcompare("-O", survey, "-S2B", "-STAGES", "none", "-IFC", written_model, "-VALIDATE", truth, "-REPORT", "r").rc == 0
    report = read_report(tmp_path / "r")
    elements = report["elements"]
    assert len(elements) > 8
    assert [e["number"] for e in elements] == list(range(1, len(elements) + 1))

    text = (tmp_path / "r" / "elements.csv").read_bytes().decode("utf-8")
    assert text.count("\r\n") == len(elements) + 1
    rows = list(csv.DictReader(io.StringIO(text, newline="")))
    for row, element in zip(rows, elements, strict=True):
        assert row["class"] == element["class"] and row["verdict"] == element["verdict"]
        assert row["result_guid"] == (element["result"]["guid"] if element["result"] else "")

    page = Page((tmp_path / "r" / "report.html").read_text(encoding="utf-8"))
    assert page.rows == len(elements)
    for element in elements:
        assert (element["result"] or element["truth"])["guid"] in page.text
    assert page.links and all(link.startswith("data:image/png;base64,") for link in page.links)  # nothing from outside

    issues = [e for e in elements if e["verdict"] == "out of tolerance"]
    with zipfile.ZipFile(tmp_path / "r" / "issues.bcf") as bcf:
        assert bcf.testzip() is None
        assert ElementTree.fromstring(bcf.read("bcf.version")).get("VersionId") == "2.1"
        topics = sorted({name.split("/")[0] for name in bcf.namelist()} - {"bcf.version"})
        assert len(topics) == len(issues)
        selected = set()
        for topic in topics:
            markup = ElementTree.fromstring(bcf.read(topic + "/markup.bcf"))
            assert markup.find("Topic").get("Guid") == topic
            view = ElementTree.fromstring(bcf.read(topic + "/viewpoint.bcfv"))
            assert markup.find("Viewpoints").get("Guid") == view.get("Guid")
            selected |= {c.get("IfcGuid") for c in view.iter("Component")}
            picture = bcf.read(topic + "/snapshot.png")
            assert picture[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", picture[16:24]) == (800, 600)
        for issue in issues:
            assert (issue["result"] or issue["truth"])["guid"] in selected


def test_two_files_without_a_cloud(cloudcompare, truth, written_model, tmp_path):
    run = cloudcompare("-S2B", "-VALIDATE", truth, "-IFC", written_model, "-STAGES", "none", "-REPORT", tmp_path / "r")
    assert run.rc == 0
    report = read_report(tmp_path / "r")
    assert report["classes"]["wall"]["at50"]["f1"] >= 0.9
    assert report["cloudToResult"] is None and report["files"]["cloud"] is None


def test_a_file_against_itself_is_perfect(cloudcompare, truth, tmp_path):
    before = truth.read_bytes()
    assert cloudcompare("-S2B", "-VALIDATE", truth, "-IFC", truth, "-STAGES", "none", "-REPORT", tmp_path / "r").rc == 0
    report = read_report(tmp_path / "r")
    for name in ("wall", "door"):
        assert report["classes"][name]["at50"] == {"precision": 1.0, "recall": 1.0, "f1": 1.0}
        assert report["classes"][name]["iou"] == pytest.approx(1.0, abs=1e-6)
    assert report["summary"]["verdicts"]["out of tolerance"] == 0
    assert truth.read_bytes() == before


def test_the_report_is_beside_the_model_by_default(cloudcompare, truth, written_model):
    assert cloudcompare("-S2B", "-VALIDATE", truth, "-IFC", written_model, "-STAGES", "none").rc == 0
    assert names(written_model.parent / "model_report") == FILES


def test_a_model_against_the_points_alone(cloudcompare, survey, truth, tmp_path):
    assert cloudcompare("-O", survey, "-S2B", "-STAGES", "none", "-IFC", truth, "-REPORT", "r").rc == 0
    report = read_report(tmp_path / "r")
    assert report["files"]["truth"] is None and report["classes"] == {}
    assert report["cloudToResult"]["wallMeanAbsolute_m"] < 0.010  # the scanner's noise, and what its labels mix up
    assert {e["verdict"] for e in report["elements"]} >= {"within tolerance"}


def test_same_bytes_for_every_number_of_threads(cloudcompare, survey, truth, written_model, tmp_path):
    for folder, threads in (("a", 1), ("b", 2)):
        assert cloudcompare("-O", survey, "-S2B", "-STAGES", "none", "-IFC", written_model, "-VALIDATE", truth, "-REPORT", folder, "-THREADS", threads).rc == 0
    for name in FILES:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes(), name


def test_deviations_are_saved_on_a_copy_of_the_cloud(cloudcompare, tmp_path, survey, truth):
    run = cloudcompare("-NO_TIMESTAMP", "-C_EXPORT_FMT", "PLY", "-O", survey, "-S2B", "-STAGES", "none", "-IFC", truth, "-REPORT", "r",
                       "-SAVE_CLOUDS", "FILE", "scan.ply deviation.ply")
    assert run.rc == 0
    assert b"deviation" not in (tmp_path / "scan.ply").read_bytes()[:1000]
    data = (tmp_path / "deviation.ply").read_bytes()
    header, body = data.split(b"end_header\n", 1)
    kinds = {"float": "<f4", "double": "<f8", "uchar": "u1"}
    columns = [line.split()[1:] for line in header.decode().splitlines() if line.startswith("property")]
    count = int(next(line.split()[2] for line in header.decode().splitlines() if line.startswith("element vertex")))
    points = np.frombuffer(body, dtype=[(name, kinds[kind]) for kind, name in columns], count=count)
    deviation = points["scalar_S2B_deviation"]
    near = deviation[np.isfinite(deviation)]
    assert len(near) > 0.5 * count
    assert np.abs(near).max() <= 0.2 and np.median(np.abs(near)) < 0.01


def test_tolerance_and_limits_are_parameters(cloudcompare, truth, written_model, tmp_path):
    common = ["-S2B", "-VALIDATE", truth, "-IFC", written_model, "-STAGES", "none", "-REPORT"]
    assert cloudcompare(*common, "strict", "-SET", "validation.tolerance=50").rc == 0
    assert cloudcompare(*common, "loose", "-SET", "validation.tolerance=10", "-SET", "validation.loa10=0.9").rc == 0
    strict, loose = read_report(tmp_path / "strict"), read_report(tmp_path / "loose")
    assert strict["summary"]["toleranceLimit_m"] == 0.001 and loose["summary"]["toleranceLimit_m"] == 0.9
    assert strict["summary"]["verdicts"]["out of tolerance"] > loose["summary"]["verdicts"]["out of tolerance"]


def test_a_storey_can_be_chosen(cloudcompare, truth, written_model, tmp_path):
    common = ["-S2B", "-VALIDATE", truth, "-IFC", written_model, "-STAGES", "none", "-REPORT", "r"]
    report_of = lambda: read_report(tmp_path / "r")
    assert cloudcompare(*common).rc == 0
    storey = report_of()["storeys"][0]["truth"]
    assert cloudcompare(*common, "-STOREYS", storey).rc == 0
    assert report_of()["classes"]["wall"]["truthCount"] > 0
    run = cloudcompare("-S2B", "-VALIDATE", truth, "-IFC", written_model, "-STAGES", "none", "-REPORT", "other", "-STOREYS", "Attic")
    assert_refused(run, tmp_path / "other", "Attic", storey)


# What is wrong is said in one sentence before anything is written.


@pytest.fixture
def scan(tmp_path, room):
    points, codes = room
    return write_ply(tmp_path / "scan.ply", points, Classification=codes)


def test_truth_that_does_not_exist(cloudcompare, scan, tmp_path):
    assert_refused(cloudcompare("-O", scan, "-S2B", "-VALIDATE", "no.ifc"), tmp_path, "-VALIDATE", "no.ifc", "does not exist")


@pytest.mark.parametrize("content", [b"", b"this is no IFC file\n", b"\x89PNG\r\n\x1a\n\x00\x01\x02", b"{\"walls\": 3}", b"[1, 2"])
def test_truth_that_is_something_else(cloudcompare, scan, tmp_path, content):
    (tmp_path / "bad.ifc").write_bytes(content)
    assert_refused(cloudcompare("-O", scan, "-S2B", "-VALIDATE", "bad.ifc"), tmp_path, "bad.ifc")


def test_truth_that_is_truncated(cloudcompare, scan, truth, tmp_path):
    whole = truth.read_bytes()
    (tmp_path / "cut.ifc").write_bytes(whole[: len(whole) // 2])
    assert_refused(cloudcompare("-O", scan, "-S2B", "-VALIDATE", "cut.ifc"), tmp_path, "cut.ifc")


def test_truth_without_geometry(cloudcompare, scan, truth, tmp_path):
    header = truth.read_bytes().split(b"DATA;")[0]
    (tmp_path / "empty.ifc").write_bytes(header + b"DATA;\nENDSEC;\nEND-ISO-10303-21;\n")
    assert_refused(cloudcompare("-O", scan, "-S2B", "-VALIDATE", "empty.ifc"), tmp_path, "empty.ifc")


def test_truth_of_another_place(cloudcompare, scan, tmp_path):
    make_survey(tmp_path / "far.laz", "--layout", "one-room", "--storeys", 1, "--step-deg", 2, "--origin", 500000, 5400000, 300, "--truth-ifc", tmp_path / "far.ifc")
    run = cloudcompare("-O", scan, "-S2B", "-VALIDATE", "far.ifc")
    assert_refused(run, tmp_path, "far.ifc", "km")


@pytest.mark.parametrize("prefix", [b".MILLI.", b".KILO."])
def test_truth_in_a_unit_that_is_wrong_by_1000(cloudcompare, scan, truth, tmp_path, prefix):
    content = truth.read_bytes()
    metre = b".LENGTHUNIT.,$,.METRE."
    assert content.count(metre) == 1
    (tmp_path / "unit.ifc").write_bytes(content.replace(metre, b".LENGTHUNIT.," + prefix + b",.METRE."))
    assert_refused(cloudcompare("-O", scan, "-S2B", "-VALIDATE", "unit.ifc"), tmp_path, "unit.ifc", "unit")


def test_folder_that_is_a_file(cloudcompare, scan, truth, tmp_path):
    (tmp_path / "taken").write_text("precious")
    assert cloudcompare("-O", scan, "-S2B", "-VALIDATE", truth, "-REPORT", "taken").rc == 1
    assert (tmp_path / "taken").read_text() == "precious"
    assert not (tmp_path / "scan.ifc").exists()


def test_folder_that_can_not_be_written(cloudcompare, scan, truth, tmp_path):
    # Root may write anywhere, but nobody can make a file below /proc.
    assert_refused(cloudcompare("-O", scan, "-S2B", "-VALIDATE", truth, "-REPORT", "/proc/report"), tmp_path, "-REPORT", "/proc/report")


def test_nothing_to_compare(cloudcompare, truth, tmp_path):
    assert_refused(cloudcompare("-S2B", "-STAGES", "none"), tmp_path, "-IFC", "-VALIDATE")
    assert_refused(cloudcompare("-S2B", "-STAGES", "none", "-VALIDATE", truth), tmp_path, "-IFC", "-O FILE")


def test_model_to_compare_that_does_not_exist(cloudcompare, truth, tmp_path):
    assert_refused(cloudcompare("-S2B", "-STAGES", "none", "-VALIDATE", truth, "-IFC", "no.ifc"), tmp_path, "-IFC", "no.ifc", "does not exist")


@pytest.mark.parametrize("setting", ["validation.tolerance=35", "validation.tolerence=30", "validation.loa10=0.001", "validation.minimumMatch=2"])
def test_parameters_that_can_not_be(cloudcompare, scan, truth, tmp_path, setting):
    assert_refused(cloudcompare("-O", scan, "-S2B", "-VALIDATE", truth, "-SET", setting), tmp_path, "validation.")


def test_storeys_without_a_truth(cloudcompare, scan, tmp_path):
    assert_refused(cloudcompare("-O", scan, "-S2B", "-STOREYS", "Level 0"), tmp_path, "-STOREYS", "-VALIDATE")
