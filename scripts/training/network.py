# SPDX-License-Identifier: GPL-3.0-or-later
"""The network: a column of height bins per plan pixel is embedded, a small U-Net looks at the plan round it, and a
per-cell perceptron reads the pixel's vector, the vector of the cell's own bin and the cell's own features."""
import torch
from torch import nn

CLASSES = ["unassigned", "floor", "ceiling", "wall", "column", "door", "window", "beam", "stair", "roof", "furniture"]
BINS = 24
PLAN_CHANNELS = ["facing_x", "facing_y", "level", "rest", "facing_x_place", "facing_y_place"]
AREAS = 4 * BINS          # layers of the plan that are areas; the rest are places within the pixel
CHANNELS = len(PLAN_CHANNELS) * BINS
CELL_FEATURES = 19
ALIGN = 8                 # the plan's sides must be multiples of it
PER_BIN = 6


def conv(inputs, outputs, kernel=3, stride=1):
    return nn.Sequential(nn.Conv2d(inputs, outputs, kernel, stride, kernel // 2, bias=False),
                         nn.BatchNorm2d(outputs), nn.ReLU())


class Network(nn.Module):
    def __init__(self, widths=(32, 48, 64, 64), hidden=48, context=True):
        super().__init__()
        self.widths, self.hidden, self.context = tuple(widths), hidden, context
        self.stem = conv(CHANNELS, widths[0], 1)
        self.first = conv(widths[0], widths[0])
        self.down = nn.ModuleList(nn.Sequential(conv(a, b, 3, 2), conv(b, b)) for a, b in zip(widths, widths[1:]))
        self.up = nn.ModuleList()
        for below, here in zip(widths[:0:-1], widths[-2::-1]):
            self.up.append(nn.ModuleList([conv(below, here, 1), conv(here, here)]))
        self.bins = nn.Conv2d(widths[0], BINS * PER_BIN, 1)
        inputs = widths[0] + PER_BIN + CELL_FEATURES if context else CELL_FEATURES
        self.head = nn.Sequential(nn.Linear(inputs, hidden), nn.ReLU(), nn.Linear(hidden, hidden), nn.ReLU(),
                                  nn.Linear(hidden, len(CLASSES)))

    def maps(self, plan):
        """Pixel vectors [B, widths[0], H, W] and bin vectors [B, BINS * PER_BIN, H, W]."""
        areas = plan[:, :AREAS].clamp(0.0, 4.0).sqrt()
        x = self.first(self.stem(torch.cat([areas, plan[:, AREAS:]], 1)))
        levels = [x]
        for down in self.down:
            x = down(x)
            levels.append(x)
        for (narrow, smooth), skip in zip(self.up, levels[-2::-1]):
            x = smooth(nn.functional.interpolate(narrow(x), scale_factor=2.0, mode="nearest") + skip)
        return x, self.bins(x)

    def forward(self, plan, cells, places):
        """places [N, 4]: index in the batch, x, y, bin. Scores before the softmax."""
        known = torch.cat([cells[:, :2].clamp(-2.0, 4.0), cells[:, 2:].clamp(-2.0, 2.0)], 1)
        if not self.context:
            return self.head(known)
        pixels, bins = self.maps(plan)
        batch, x, y, z = places.unbind(1)
        b, _, h, w = bins.shape
        # Rows of flat tables: their gradient is a plain sum.
        pixel = (batch * h + y) * w + x
        own = pixels.permute(0, 2, 3, 1).reshape(-1, pixels.shape[1]).index_select(0, pixel)
        table = bins.view(b, BINS, PER_BIN, h, w).permute(0, 1, 3, 4, 2).reshape(-1, PER_BIN)
        of_bin = table.index_select(0, ((batch * BINS + z) * h + y) * w + x)
        return self.head(torch.cat([own, of_bin, known], 1))


def conv_layers(network):
    """{name in the file: (convolution, its batch normalisation)}."""
    layers = {"stem": network.stem, "first": network.first}
    for i, down in enumerate(network.down):
        layers[f"down{i}a"], layers[f"down{i}b"] = down[0], down[1]
    for i, (narrow, smooth) in enumerate(network.up):
        layers[f"up{i}a"], layers[f"up{i}b"] = narrow, smooth
    return {name: (block[0], block[1]) for name, block in layers.items()}


def linear_layers(network):
    return [layer for layer in network.head if isinstance(layer, nn.Linear)]
