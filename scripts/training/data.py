# SPDX-License-Identifier: GPL-3.0-or-later
"""Storeys as s2b_features writes them: crops for training, whole storeys for evaluation."""
import pathlib

import numpy as np
import torch

from contract import BIN_M, FEATURES, PLAN_LOW_M
from network import ALIGN, AREAS, BINS, CHANNELS, PLAN_CHANNELS


class Storey:
    def __init__(self, prefix):
        def read(name):
            return np.load(f"{prefix}{name}.npy", mmap_mode="r")
        self.width, self.height = (int(v) for v in read("shape"))
        self.at, self.channel, self.value = read("raster_at"), read("raster_channel"), read("raster_value")
        self.raster_rows, self.cell_rows = read("raster_rows"), read("cell_rows")
        self.cells, self.places = read("cells"), read("places")
        self.labels, self.counts = read("labels"), read("counts")

    def raster(self, x0, y0, width, height):
        """The raster of a window [channels, height, width]; what lies outside the storey is empty."""
        first, last = self.rows(self.raster_rows, y0, height)
        y, x = np.divmod(self.at[first:last].astype(np.int64), self.width)
        x, y = x - x0, y - y0
        inside = (x >= 0) & (x < width)
        result = np.zeros((CHANNELS, height, width), np.float32)
        result[self.channel[first:last][inside], y[inside], x[inside]] = self.value[first:last][inside]
        return result

    def inside(self, x0, y0, width, height):
        """Which cells lie in a window."""
        first, last = self.rows(self.cell_rows, y0, height)
        x = self.places[first:last, 0].astype(np.int64) - x0
        return first + np.flatnonzero((x >= 0) & (x < width))

    def rows(self, starts, y0, height):
        return int(starts[np.clip(y0, 0, self.height)]), int(starts[np.clip(y0 + height, 0, self.height)])

    def whole(self):
        """Everything, padded to the network's alignment."""
        width, height = -self.width % ALIGN + self.width, -self.height % ALIGN + self.height
        places = np.zeros((len(self.places), 4), np.int64)
        places[:, 1:] = self.places
        return self.raster(0, 0, width, height)[None], np.asarray(self.cells, np.float32), places


def load(folder):
    """Storeys of every survey in a folder: {survey: [Storey]}."""
    surveys = {}
    for shape in sorted(pathlib.Path(folder).glob("*/*_shape.npy")):
        surveys.setdefault(shape.parent.name, []).append(Storey(str(shape)[:-len("shape.npy")]))
    if not surveys:
        raise SystemExit(f"scripts/train: there are no features in {folder}")
    return surveys


def feature(*names):
    return [list(FEATURES).index(name) for name in names]


SCALES = np.array([scale for _, scale in FEATURES.values()], np.float32)
HEIGHT, NORMAL_Z, RUN_DOWN, BOTTOM = feature("height", "normal_z", "plane_run_down", "plane_bottom")
RUNS = feature("plane_run_up", "plane_run_down")
STRENGTHS = feature("plane_strength", "plane_own", "plane_upper_strength")


def hide_below(raster, cells, x, y, size, rng):
    """Upright surfaces in a part of the square are hidden up to a height, as by furniture. Which cells are left."""
    first = int(rng.integers(3, 9))  # bins
    height = PLAN_LOW_M + BIN_M * first
    w, h = rng.integers(size // 4, size + 1, 2)
    x0, y0 = rng.integers(0, size - w + 1), rng.integers(0, size - h + 1)
    layers = raster.reshape(-1, BINS, size, size)
    for channel, name in enumerate(PLAN_CHANNELS):
        if name != "level":
            layers[channel, :first, y0:y0 + h, x0:x0 + w] = 0
    above = cells[:, HEIGHT] * SCALES[HEIGHT] - height
    hit = (x >= x0) & (x < x0 + w) & (y >= y0) & (y < y0 + h) & (cells[:, NORMAL_Z] < 0.5)
    run, bottom = cells[:, RUN_DOWN], cells[:, BOTTOM]
    run[hit] = np.minimum(run, np.maximum(above, 0.0) / SCALES[RUN_DOWN])[hit]
    bottom[hit & (run > 0)] = np.maximum(bottom, height / SCALES[BOTTOM])[hit & (run > 0)]
    return ~(hit & (above < 0))


def thin(raster, cells, rng):
    """The square as a scanner with fewer rays would see it: less area, shorter runs without a gap."""
    share = np.float32(np.exp(rng.uniform(np.log(0.12), 0.0)))
    raster[:AREAS] *= share
    cells[:, STRENGTHS] *= share
    cells[:, RUNS] *= np.float32(rng.uniform(0.4, 1.0))


def crop(storey, size, cells_at_most, rng, harder=False):
    """A random square about a cell, turned and mirrored at random; some have a hole, as a partial scan.
    `harder`: some are partly hidden or thin, too."""
    n = len(storey.labels)
    # Rare classes are looked for: a random cell of a random class every second time.
    if rng.random() < 0.5:
        sample = rng.integers(0, n, 4000)
        classes = np.unique(storey.labels[np.sort(sample)])
        wanted = rng.choice(classes)
        matches = sample[storey.labels[sample] == wanted]
        centre = storey.places[rng.choice(matches)]
    else:
        centre = storey.places[rng.integers(0, n)]
    x0 = int(centre[0]) - int(rng.integers(size // 4, size - size // 4))
    y0 = int(centre[1]) - int(rng.integers(size // 4, size - size // 4))
    raster = storey.raster(x0, y0, size, size)
    index = storey.inside(x0, y0, size, size)
    if rng.random() < 0.25:
        hx, hy = rng.integers(0, size, 2)
        hw, hh = rng.integers(8, size // 2, 2)
        raster[:, hy:hy + hh, hx:hx + hw] = 0
        x, y = storey.places[index, 0] - x0, storey.places[index, 1] - y0
        index = index[~((x >= hx) & (x < hx + hw) & (y >= hy) & (y < hy + hh))]
    if len(index) > cells_at_most:
        index = np.sort(rng.choice(index, cells_at_most, replace=False))
    cells = np.asarray(storey.cells[index], np.float32)
    x, y, z = (storey.places[index].astype(np.int64) - [x0, y0, 0]).T
    labels = storey.labels[index].astype(np.int64)
    if harder and rng.random() < 0.2:
        left = hide_below(raster, cells, x, y, size, rng)
        cells, labels, x, y, z = cells[left], labels[left], x[left], y[left], z[left]
    if harder and rng.random() < 0.3:
        thin(raster, cells, rng)
    by_axis = raster.reshape(-1, BINS, size, size)  # a view: facing x, y, level, rest, place x, place y
    if rng.random() < 0.5:  # mirrored in x
        by_axis = by_axis[..., ::-1]
        by_axis[4] *= -1
        x = size - 1 - x
        cells[:, 7] *= -1
    if rng.random() < 0.5:  # mirrored in y
        by_axis = by_axis[..., ::-1, :]
        by_axis[5] *= -1
        y = size - 1 - y
        cells[:, 8] *= -1
    if rng.random() < 0.5:  # x and y exchanged
        by_axis = by_axis.swapaxes(2, 3)[[1, 0, 2, 3, 5, 4]]
        x, y = y, x
        cells[:, [2, 3]] = cells[:, [3, 2]]
        cells[:, [7, 8]] = cells[:, [8, 7]]
    raster = np.ascontiguousarray(by_axis).reshape(CHANNELS, size, size)
    # Surfaces are scanned more or less densely.
    raster[:AREAS] *= np.float32(np.exp(rng.normal(0.0, 0.2)))
    return raster, cells, np.stack([x, y, z], 1), labels


def batch(storeys, count, size, cells_at_most, rng, harder=False):
    rasters, cells, places, labels = [], [], [], []
    while len(rasters) < count:
        r, c, p, l = crop(storeys[rng.integers(0, len(storeys))], size, cells_at_most, rng, harder)
        if len(l) < 200:
            continue
        places.append(np.column_stack([np.full(len(p), len(rasters), np.int64), p]))
        rasters.append(r)
        cells.append(c)
        labels.append(l)
    return tuple(torch.from_numpy(a) for a in (np.stack(rasters), np.concatenate(cells), np.concatenate(places),
                                               np.concatenate(labels)))
