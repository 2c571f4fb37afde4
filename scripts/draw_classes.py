#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of what a model said of a cloud's points, and of the walls that came of it.

    scripts/env python3 scripts/draw_classes.py MODEL.ifc POINTS.ply PICTURE.png

POINTS is a binary PLY with the field "S2B class" (-S2B -SEGMENT ... -SAVE_CLOUDS). On the left the lowest storey's points
from the south-west and above, without its ceiling, in the colours of their classes; on the right a slice through the
points 1 to 1.6 m above the floor, and the model's walls, doors, windows and columns.
"""
import sys

import ifcopenshell
import ifcopenshell.geom
import ifcopenshell.util.placement
import matplotlib
import numpy as np

from draw_model import read_rows

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

NAMES = ["unassigned", "floor", "ceiling", "wall", "column", "door", "window", "beam", "stair", "roof", "furniture"]
COLORS = ["#c4c4c4", "#b8a37a", "#e3dcc8", "#6f9fd8", "#8e5bb5", "#e07b39", "#4cc9d6", "#c0587e", "#f2c94c", "#a0522d", "#6aa84f"]
FILL = {"IfcWall": "#24303f", "IfcDoor": "#e07b39", "IfcWindow": "#4cc9d6", "IfcColumn": "#8e5bb5"}


def read_points(path):
    """Points (n, 3) and their classes (n)."""
    rows = read_rows(path)
    names = [n for n in rows.dtype.names if n.replace("_", " ").endswith("S2B class")]
    if not names:
        sys.exit(f"draw_classes: {path} has no field S2B class")
    return np.stack([rows[a].astype(float) for a in "xyz"], 1), rows[names[0]].astype(int)


def outlines(path):
    """(class, triangles in plan (n, 3, 2)) of the elements, the lowest storey's floor, and the yaw of the walls."""
    model = ifcopenshell.open(path)
    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    found, yaw = [], 0.0
    storeys = [ifcopenshell.util.placement.get_local_placement(s.ObjectPlacement)[2, 3] for s in model.by_type("IfcBuildingStorey")]
    if not storeys:
        sys.exit(f"draw_classes: {path} has no storey")
    for name in FILL:
        for product in model.by_type(name):
            shape = ifcopenshell.geom.create_shape(settings, product)  # owns the buffers
            vertices = np.array(shape.geometry.verts).reshape(-1, 3)
            if vertices[:, 2].min() > min(storeys) + 1.6:
                continue
            found.append((name, vertices[np.array(shape.geometry.faces).reshape(-1, 3)][:, :, :2]))
    for wall in model.by_type("IfcWall"):
        axis = ifcopenshell.util.placement.get_local_placement(wall.ObjectPlacement)
        yaw = np.arctan2(axis[1, 0], axis[0, 0])
        break
    return found, min(storeys), yaw


def main(model, cloud, picture):
    points, classes = read_points(cloud)
    elements, floor, yaw = outlines(model)
    turn = np.array([[np.cos(yaw), np.sin(yaw)], [-np.sin(yaw), np.cos(yaw)]])
    middle = points[:, :2].mean(axis=0)
    points[:, :2] = (points[:, :2] - middle) @ turn.T
    corners = (np.concatenate([t.reshape(-1, 2) for name, t in elements]) - middle) @ turn.T
    low, high = corners.min(axis=0) - 1.0, corners.max(axis=0) + 1.0  # what was seen far outside is not of interest
    inside = ((points[:, :2] > low) & (points[:, :2] < high)).all(axis=1)
    points, classes = points[inside], classes[inside]
    z = points[:, 2] - floor
    figure, (left, right) = plt.subplots(1, 2, figsize=(13, 5.6), dpi=110, facecolor="white")

    # From above and the side: a cabinet projection, drawn from the far end to the near one.
    shown = (classes != 2) & (classes != 9) & (z < 2.6) & (z > -0.3)
    order = np.argsort(-points[shown, 1] + 0.01 * z[shown])
    flat = np.stack([points[shown, 0] + 0.25 * points[shown, 1], 0.55 * points[shown, 1] + 0.8 * z[shown]], 1)[order]
    left.scatter(flat[:, 0], flat[:, 1], s=2.0, c=np.array(COLORS)[classes[shown]][order], linewidths=0)
    present = [k for k in range(len(NAMES)) if (classes[shown] == k).sum() > 0.002 * shown.sum()]
    left.legend(handles=[plt.Line2D([], [], marker="o", ls="", color=COLORS[k], label=NAMES[k]) for k in present], loc="upper center",
                bbox_to_anchor=(0.5, -0.02), ncol=min(6, len(present)), frameon=False, fontsize=9)
    left.set_title("Classes of the points, ceiling left out", fontsize=10)

    for name, triangles in elements:
        flat = (triangles - middle) @ turn.T
        for t in flat:
            right.fill(t[:, 0], t[:, 1], color=FILL[name], alpha=1.0, lw=0.4, zorder=2 if name == "IfcWall" else 3)
    cut = (z > 1.0) & (z < 1.6)
    right.scatter(points[cut, 0], points[cut, 1], s=1.5, c="#d1495b", linewidths=0, zorder=4)
    right.set_title("Points 1.0 to 1.6 m above the floor, and the model", fontsize=10)
    for axes in (left, right):
        axes.set_aspect("equal")
        axes.axis("off")
    figure.tight_layout()
    figure.savefig(picture)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
