# SPDX-License-Identifier: GPL-3.0-or-later
"""What the network says about itself in its file's metadata: docs/segmentation.md. The same text tells s2b_features
what to make."""
from network import ALIGN, BINS, CLASSES, PLAN_CHANNELS

# Name: (mean, scale).
FEATURES = {"height": (0.0, 2.0), "depth": (0.0, 2.0), "normal_x": (0.0, 1.0), "normal_y": (0.0, 1.0),
            "normal_z": (0.0, 1.0), "has_normal": (0.0, 1.0), "flatness": (0.0, 0.03), "pixel_x": (0.0, 1.0),
            "pixel_y": (0.0, 1.0), "bin_z": (0.0, 1.0), "plane_offset": (0.0, 1.0), "plane_strength": (0.0, 0.5),
            "plane_own": (0.0, 0.5), "plane_upper_offset": (0.0, 1.0), "plane_upper_strength": (0.0, 0.5),
            "plane_run_up": (0.0, 2.0), "plane_run_down": (0.0, 2.0), "plane_top": (0.0, 2.0),
            "plane_bottom": (0.0, 2.0)}
CELL_M = 0.03
PLAN_LOW_M = -0.3  # lower edge of the lowest bin above the floor
BIN_M = 0.2


def metadata(note=""):
    pairs = {
        "s2b.contract": "1",
        "s2b.classes": ",".join(CLASSES),
        "s2b.cell_m": f"{CELL_M}",
        "s2b.features": ",".join(FEATURES),
        "s2b.mean": ",".join(f"{m:g}" for m, _ in FEATURES.values()),
        "s2b.scale": ",".join(f"{s:g}" for _, s in FEATURES.values()),
        "s2b.output": "logits",
        "s2b.plan_pixel_m": "0.2",
        "s2b.plan_low_m": f"{PLAN_LOW_M}",
        "s2b.plan_bin_m": f"{BIN_M}",
        "s2b.plan_bins": f"{BINS}",
        "s2b.plan_channels": ",".join(PLAN_CHANNELS),
        "s2b.plan_multiple": f"{ALIGN}",
    }
    if note:
        pairs["training"] = note
    return pairs
