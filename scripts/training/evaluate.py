# SPDX-License-Identifier: GPL-3.0-or-later
"""Intersection over union per class and survey, by points."""
import numpy as np
import torch

from network import CLASSES

MEASURED = ["floor", "ceiling", "wall", "column", "door", "window"]


def confusion(network, storeys):
    """[truth][predicted], points."""
    n = len(CLASSES)
    total = np.zeros((n, n), np.int64)
    with torch.no_grad():
        for storey in storeys:
            raster, cells, places = (torch.from_numpy(a) for a in storey.whole())
            predicted = network(raster, cells, places).argmax(1).numpy()
            key = np.asarray(storey.labels, np.int64) * n + predicted
            total += np.bincount(key, np.asarray(storey.counts), n * n).astype(np.int64).reshape(n, n)
    return total


def ious(matrix):
    """{class: IoU}, classes that the truth does not have left out."""
    hit = np.diag(matrix)
    union = matrix.sum(0) + matrix.sum(1) - hit
    return {name: hit[i] / union[i] for i, name in enumerate(CLASSES) if matrix[i].sum() > 0}


def table(matrices):
    """One line a survey, then all points together, and the mean of the surveys that have the class."""
    names = MEASURED + ["beam", "stair", "roof", "furniture"]
    rows = {survey: ious(m) for survey, m in matrices.items()}
    rows["all points"] = ious(sum(matrices.values()))
    rows["mean of surveys"] = {k: np.mean([ious(m)[k] for m in matrices.values() if k in ious(m)])
                               for k in names if any(k in ious(m) for m in matrices.values())}
    lines = [f"{'survey':16}" + "".join(f"{n:>10}" for n in names) + f"{'mean of 6':>11}"]
    for survey, row in rows.items():
        six = [row[n] for n in MEASURED if n in row]
        lines.append(f"{survey:16}" + "".join(f"{row[n]:10.3f}" if n in row else " " * 9 + "-" for n in names) +
                     f"{np.mean(six):11.3f}")
    return "\n".join(lines)


def confusion_text(matrix):
    """Per class: how its points are spread over the predicted ones [%]."""
    lines = [f"{'truth':12}" + "".join(f"{n[:8]:>9}" for n in CLASSES)]
    for i, name in enumerate(CLASSES):
        if matrix[i].sum() > 0:
            lines.append(f"{name:12}" + "".join(f"{100.0 * v / matrix[i].sum():9.1f}" for v in matrix[i]))
    return "\n".join(lines)
