#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of an IFC model over the points it was made from: cut open from above, and a plan of every storey.

    scripts/env python3 scripts/draw_model.py MODEL.ifc POINTS.ply PICTURE.png

On the left half of the view the points are seen, on the right half the model. POINTS is a binary PLY as CloudCompare
writes it. The renderer is a depth buffer in numpy: every fragment above the cut is left out, and where the first thing
seen is then the inside of a solid, the solid was cut and is filled.
"""
import sys

import ifcopenshell
import ifcopenshell.geom
import ifcopenshell.util.placement
import matplotlib
import numpy as np
from scipy.ndimage import gaussian_filter

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

PAPER = np.array([0.985, 0.98, 0.97])
INK = np.array([0.16, 0.18, 0.22])
COLORS = {"IfcWall": (0.93, 0.90, 0.85), "IfcDoor": (0.80, 0.50, 0.27), "IfcWindow": (0.52, 0.73, 0.86),
          "IfcColumn": (0.78, 0.42, 0.38), "IfcSlab": (0.90, 0.905, 0.91)}
CUT = {"IfcWall": (0.25, 0.30, 0.38), "IfcColumn": (0.45, 0.20, 0.18)}
CUT_ABOVE_FLOOR_M = 1.35  # through doors and windows


def read_model(path):
    """Triangles (n, 3, 3) in world coordinates, their class, and the storeys' (name, elevation) from below."""
    model = ifcopenshell.open(path)
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    triangles, classes = [], []
    for name in COLORS:
        for product in model.by_type(name):
            if product.Representation is None or getattr(product, "PredefinedType", None) == "ROOF":
                continue
            shape = ifcopenshell.geom.create_shape(settings, product)  # owns the buffers
            vertices = np.array(shape.geometry.verts).reshape(-1, 3)
            faces = np.array(shape.geometry.faces).reshape(-1, 3)
            triangles.append(vertices[faces])
            classes += [name] * len(faces)
    storeys = []
    for storey in model.by_type("IfcBuildingStorey"):
        placement = ifcopenshell.util.placement.get_local_placement(storey.ObjectPlacement)
        storeys.append((storey.Name, placement[2, 3]))
    if not triangles:
        sys.exit("draw_model: %s has no walls to draw" % path)
    return np.concatenate(triangles), np.array(classes), sorted(storeys, key=lambda s: s[1])


def read_rows(path):
    """The vertices of a binary PLY, a structured array with its properties' names."""
    kinds = {"float": "<f4", "float32": "<f4", "double": "<f8", "uchar": "u1", "uint8": "u1", "ushort": "<u2", "int": "<i4", "short": "<i2"}
    with open(path, "rb") as file:
        columns, count = [], 0
        while (line := file.readline().decode().split()) != ["end_header"]:
            if line[:2] == ["element", "vertex"]:
                count = int(line[2])
            elif line[0] == "property":
                columns.append((line[2], kinds[line[1]]))
        return np.fromfile(file, dtype=columns, count=count)


def read_ply(path):
    """Points (n, 3) and colours (n, 3) in [0, 1]; grey without colours."""
    rows = read_rows(path)
    points = np.stack([rows[a].astype(float) for a in "xyz"], 1)
    if "red" in rows.dtype.names:
        colors = np.stack([rows[c] for c in ("red", "green", "blue")], 1) / 255.0
    else:
        colors = np.full((len(points), 3), 0.55)
    return points, colors


def main_direction(triangles, classes):
    """Yaw of the longest walls [rad]: the picture is squared up with the building."""
    t = triangles[classes == "IfcWall"]
    edges = (t[:, 1] - t[:, 0])[:, :2]
    angle = np.arctan2(edges[:, 1], edges[:, 0])
    weight = np.hypot(*edges.T)
    return np.angle(np.sum(weight * np.exp(4j * angle))) / 4


class Picture:
    """A depth buffer seen along a direction; `axes` has right, up and towards the viewer as rows."""

    def __init__(self, axes, lower, upper, pixels_per_m):
        self.axes, self.scale = axes, pixels_per_m
        corners = np.array([[x, y, z] for x in (lower[0], upper[0]) for y in (lower[1], upper[1]) for z in (lower[2], upper[2])]) @ axes.T
        self.origin = corners[:, :2].min(axis=0) - 0.6
        size = np.ceil((corners[:, :2].max(axis=0) + 0.6 - self.origin) * pixels_per_m).astype(int)
        self.width, self.height = size
        self.color = np.tile(PAPER, (self.height, self.width, 1))
        self.depth = np.full((self.height, self.width), -1e9)
        self.edge = np.zeros((self.height, self.width), int)

    def project(self, points):
        p = points @ self.axes.T
        return np.concatenate([(p[..., :2] - self.origin) * self.scale, p[..., 2:]], -1)

    def draw_triangles(self, triangles, classes, cut, keep=None):
        """cut: height above which nothing is drawn. keep: function of world points (n, 3) to bool."""
        light = np.array([0.35, -0.55, 0.76])
        for corners, kind in zip(triangles, classes):
            if corners[:, 2].min() >= cut:
                continue
            normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
            length = np.linalg.norm(normal)
            if length < 1e-9:
                continue
            normal /= length
            is_back = normal @ self.axes[2] < 0
            p = self.project(corners)
            x0, y0 = np.maximum(np.floor(p[:, :2].min(axis=0)).astype(int), 0)
            x1, y1 = np.minimum(np.ceil(p[:, :2].max(axis=0)).astype(int) + 1, (self.width, self.height))
            if x0 >= x1 or y0 >= y1:
                continue
            x, y = np.meshgrid(np.arange(x0, x1) + 0.5, np.arange(y0, y1) + 0.5)
            (ax, ay, _), (bx, by, _), (cx, cy, _) = p
            area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
            if abs(area) < 1e-9:
                continue
            u = ((bx - x) * (cy - y) - (cx - x) * (by - y)) / area
            v = ((cx - x) * (ay - y) - (ax - x) * (cy - y)) / area
            w = 1 - u - v
            world_z = u * corners[0, 2] + v * corners[1, 2] + w * corners[2, 2]
            depth = u * p[0, 2] + v * p[1, 2] + w * p[2, 2]
            inside = (u >= 0) & (v >= 0) & (w >= 0) & (world_z < cut) & (depth > self.depth[y0:y1, x0:x1])
            if keep is not None and inside.any():
                world = u[..., None] * corners[0] + v[..., None] * corners[1] + w[..., None] * corners[2]
                inside &= keep(world)
            if is_back and kind in CUT:
                color = np.array(CUT[kind])
            else:
                color = np.array(COLORS[kind]) * (0.72 + 0.28 * abs(normal @ light))
            self.color[y0:y1, x0:x1][inside] = np.clip(color, 0, 1)
            self.depth[y0:y1, x0:x1][inside] = depth[inside]
            facing = int(np.argmax(np.abs(normal)) * 2 + (normal[np.argmax(np.abs(normal))] > 0))
            self.edge[y0:y1, x0:x1][inside] = 100 if is_back and kind in CUT else 1 + facing + 10 * list(COLORS).index(kind)

    def draw_points(self, points, colors, size=1):
        p = self.project(points)
        order = np.argsort(p[:, 2], kind="stable")  # far ones first
        p, colors = p[order], colors[order]
        for dx in range(size):
            for dy in range(size):
                x, y = p[:, 0].astype(int) + dx, p[:, 1].astype(int) + dy
                ok = (x >= 0) & (y >= 0) & (x < self.width) & (y < self.height)
                ok[ok] &= p[ok, 2] > self.depth[y[ok], x[ok]] - 0.05
                self.color[y[ok], x[ok]] = colors[ok]
                self.depth[y[ok], x[ok]] = np.maximum(self.depth[y[ok], x[ok]], p[ok, 2])

    def finish(self):
        """Soft shadows where something near hides something far, and ink on the edges."""
        drawn = self.depth > -1e8
        depth = np.where(drawn, self.depth, self.depth[drawn].min() if drawn.any() else 0)
        shade = np.zeros_like(depth)
        for radius_m in (0.15, 0.6):
            behind = np.maximum(gaussian_filter(depth, radius_m * self.scale) - depth, 0)
            shade += 0.5 * np.minimum(behind / (1.5 * radius_m), 1)
        picture = self.color * (1 - 0.45 * (shade * drawn)[..., None])
        lines = np.zeros_like(drawn)
        for axis in (0, 1):
            change = (np.diff(self.edge, axis=axis) != 0) & (np.minimum(*[np.take(self.edge, i, axis) for i in (range(1, self.edge.shape[axis]), range(self.edge.shape[axis] - 1))]) >= 0)
            index = [slice(None)] * 2
            index[axis] = slice(0, -1)
            lines[tuple(index)] |= change
        picture[lines] = 0.45 * picture[lines] + 0.55 * INK
        height, width = picture.shape[0] // 2 * 2, picture.shape[1] // 2 * 2  # drawn twice as large
        picture = picture[:height, :width].reshape(height // 2, 2, width // 2, 2, 3).mean(axis=(1, 3))
        return np.clip(picture[::-1], 0, 1)


def rotation(yaw):
    c, s = np.cos(yaw), np.sin(yaw)
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


def view_axes(azimuth_deg, elevation_deg):
    a, e = np.radians([azimuth_deg, elevation_deg])
    towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.cross([0, 0, 1], towards)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards])


def main(model_path, points_path, picture_path):
    triangles, classes, storeys = read_model(model_path)
    points, colors = read_ply(points_path)
    centre = triangles.reshape(-1, 3).mean(axis=0)
    turn = rotation(main_direction(triangles, classes))
    triangles, points = (triangles - centre) @ turn.T, (points - centre) @ turn.T
    floors = [elevation - centre[2] for _, elevation in storeys]
    lower, upper = triangles.reshape(-1, 3).min(axis=0), triangles.reshape(-1, 3).max(axis=0)
    if upper[1] - lower[1] > upper[0] - lower[0]:  # the long side lies along the picture
        quarter = rotation(np.pi / 2)
        triangles, points = triangles @ quarter.T, points @ quarter.T
        lower, upper = triangles.reshape(-1, 3).min(axis=0), triangles.reshape(-1, 3).max(axis=0)
    near = ((points[:, :2] > lower[:2] - 0.3) & (points[:, :2] < upper[:2] + 0.3)).all(axis=1) & (points[:, 2] > lower[2] - 0.2)
    points, colors = points[near], colors[near]

    cut = floors[-1] + CUT_ABOVE_FLOOR_M
    split = 0.55 * lower[0] + 0.45 * upper[0]
    scale = 2400 / (np.hypot(*(upper - lower)[:2]) + 1)
    view = Picture(view_axes(-62, 40), lower, [upper[0], upper[1], cut], scale)
    view.draw_triangles(triangles, classes, cut, keep=lambda p: p[..., 0] > split)
    # Towards the seam the points thin out over the model.
    share = np.clip((split + 0.12 * (upper[0] - lower[0]) - points[:, 0]) / (0.12 * (upper[0] - lower[0])), 0, 1)
    shown = (points[:, 2] < cut) & (np.random.default_rng(1).random(len(points)) < share)
    view.draw_points(points[shown], colors[shown], size=4)

    rows = min(len(storeys), 3)
    figure = plt.figure(figsize=(16, 9), facecolor=PAPER)
    grid = figure.add_gridspec(rows, 2, width_ratios=[2.1, 1], left=0.02, right=0.98, top=0.90, bottom=0.03, wspace=0.03, hspace=0.12)
    axes = figure.add_subplot(grid[:, 0])
    axes.imshow(view.finish(), interpolation="lanczos")
    axes.axis("off")
    top = np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1]])
    for row in range(rows):
        storey = len(storeys) - 1 - row
        floor = floors[storey]
        plan = Picture(top, lower, upper, 1700 / (upper[0] - lower[0] + 1))
        above = triangles[:, :, 2].max(axis=1) > floor - 0.05
        plan.draw_triangles(triangles[above], classes[above], floor + CUT_ABOVE_FLOOR_M)
        slice_ = points[np.abs(points[:, 2] - floor - CUT_ABOVE_FLOOR_M) < 0.06]
        plan.depth[:] = -1e9  # the points of the slice lie on top, to be compared with the walls
        plan.draw_points(slice_, np.tile([0.92, 0.35, 0.20], (len(slice_), 1)), size=2)
        image = plan.finish()
        axes = figure.add_subplot(grid[row, 1])
        axes.imshow(image, interpolation="lanczos")
        axes.axis("off")
        axes.set_title("%s, %+.2f m" % (storeys[storey][0], round(storeys[storey][1], 2) + 0.0), fontsize=11, color=INK, loc="left", pad=2)
    counts = {name: 0 for name in ("IfcWall", "IfcDoor", "IfcWindow", "IfcColumn", "IfcSlab", "IfcSpace")}
    model = ifcopenshell.open(model_path)
    for name in counts:
        counts[name] = len(model.by_type(name))
    text = ", ".join("%d %s%s" % (n, name[3:].lower(), "" if n == 1 else "s") for name, n in counts.items() if n)
    figure.text(0.03, 0.945, "From the scan to the model", fontsize=22, color=INK, weight="bold")
    figure.text(0.03, 0.912, "%d storey%s: %s" % (len(storeys), "" if len(storeys) == 1 else "s", text), fontsize=12, color=INK)
    figure.savefig(picture_path, dpi=110, facecolor=PAPER)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
