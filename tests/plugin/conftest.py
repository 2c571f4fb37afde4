# SPDX-License-Identifier: GPL-3.0-or-later
"""What the end-to-end tests share: the real CloudCompare in a home of its own, and small surveys."""
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest


# With the sanitizers everything takes longer, CloudCompare itself included.
SLOWDOWN = 5 if os.environ.get("S2B_TEST_PRELOAD") else 1


class Run:
    """One finished run of CloudCompare."""

    def __init__(self, process):
        self.rc = process.returncode
        self.text = process.stdout
        # "[12:34:56] [S2B] text" and, from the command line's own messages, other prefixes
        self.lines = [line.split("] ", 1)[-1] for line in self.text.splitlines()]
        self.ours = [line[len("[S2B] "):] for line in self.lines if line.startswith("[S2B] ")]


@pytest.fixture
def output(request):
    """Artefacts that are kept, models and screenshots: an empty folder for each test, named after it."""
    folder = Path(os.environ["S2B_TEST_OUTPUT"]) / request.node.name.removeprefix("test_")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def environment(home, **more):
    home.mkdir(parents=True, exist_ok=True)
    home.chmod(0o700)  # Qt insists on a private runtime folder
    env = dict(os.environ, HOME=str(home), XDG_RUNTIME_DIR=str(home), XDG_DATA_HOME=str(home / "data"), XDG_CONFIG_HOME=str(home / "config"),
               CC_PLUGIN_PATH=os.environ["S2B_TEST_PLUGINS"], LIBGL_ALWAYS_SOFTWARE="1")
    env.pop("SOURCE_DATE_EPOCH", None)
    if os.environ.get("S2B_TEST_PRELOAD"):
        # CloudCompare keeps what it leaks until it ends, and deletes its frame buffers as another type: neither is ours.
        env.update(LD_PRELOAD=os.environ["S2B_TEST_PRELOAD"], ASAN_OPTIONS="detect_leaks=0:new_delete_type_mismatch=0")
    env.update(more)
    return env


@pytest.fixture
def cloudcompare(tmp_path):
    """Runs CloudCompare headless; the working folder is the test's own."""

    def run(*arguments, **more):
        process = subprocess.run([os.environ["S2B_TEST_CLOUDCOMPARE"], "-SILENT", *map(str, arguments)], cwd=tmp_path,
                                 env=environment(tmp_path / "home", QT_QPA_PLATFORM="offscreen", **more),
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300 * SLOWDOWN)
        print(process.stdout)
        assert "Plugin found: Scan to BIM" in process.stdout
        return Run(process)

    return run


def make_survey(path, *arguments):
    subprocess.run([os.environ["S2B_TEST_SURVEY"], str(path), *map(str, arguments)], check=True, stdin=subprocess.DEVNULL,
                   stdout=subprocess.DEVNULL, timeout=300 * SLOWDOWN)
    return path


# One storey with two rooms, seen from inside and outside: a quarter of a million points are enough to find every wall.
SMALL = ["--layout", "two-rooms", "--storeys", 1, "--step-deg", 0.25, "--voxel", 0.03, "--outside", "--without", "trees,furniture,curved-walls"]


@pytest.fixture(scope="session")
def survey(tmp_path_factory):
    folder = tmp_path_factory.mktemp("survey")
    return make_survey(folder / "small.laz", *SMALL, "--truth-ifc", folder / "truth.ifc")


def write_ply(path, points, dtype="float", **fields):
    """A binary PLY with scalar fields, as CloudCompare writes them."""
    kinds = {"float": "<f4", "double": "<f8"}
    columns = [(axis, kinds[dtype]) for axis in "xyz"] + [("scalar_" + name, "<f4") for name in fields]
    rows = np.zeros(len(points), dtype=columns)
    for i, axis in enumerate("xyz"):
        rows[axis] = np.asarray(points)[:, i]
    for name, values in fields.items():
        rows["scalar_" + name] = values
    header = "ply\nformat binary_little_endian 1.0\nelement vertex %d\n" % len(points)
    header += "".join("property %s %s\n" % (dtype if name in "xyz" else "float", name) for name, _ in columns) + "end_header\n"
    path.write_bytes(header.encode() + rows.tobytes())
    return path


@pytest.fixture
def room():
    """The faces of a room of 5 x 4 x 2.6 m with s2b labels: points and codes. Enough to get past every check of the input."""
    size = np.array([5.0, 4.0, 2.6])
    points, codes = [], []
    for axis in range(3):
        u, v = [np.arange(0, size[i], 0.04) for i in range(3) if i != axis]
        grid = np.stack(np.meshgrid(u, v), -1).reshape(-1, 2)
        for side in (0.0, size[axis]):
            points.append(np.insert(grid, axis, side, axis=1))
            codes.append(np.full(len(grid), (1 if side == 0 else 2) if axis == 2 else 3))
    return np.concatenate(points), np.concatenate(codes)


@pytest.fixture(scope="session")
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
        timeout = SLOWDOWN * (300 + 4 * int(more.get("S2B_DRIVER_CYCLES", 0)))  # the driver's own watchdog is earlier
        process = subprocess.run([os.environ["S2B_TEST_CLOUDCOMPARE"], ":start-plugin:S2B_window_driver", str(path)], cwd=tmp_path, env=env,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=timeout)
        print(process.stdout)
        assert process.returncode == 0, "\n".join(line for line in process.stdout.splitlines() if line.startswith(("FAIL", "ok")))
        return process.stdout

    return run
