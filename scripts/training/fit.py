# SPDX-License-Identifier: GPL-3.0-or-later
"""Trains the network on crops, with a checkpoint a minute; the same seed and data give the same network."""
import pathlib
import time

import numpy as np
import torch

import data
from network import CLASSES, Network


def class_weights(storeys):
    counts = np.zeros(len(CLASSES))
    for storey in storeys:
        counts += np.bincount(np.asarray(storey.labels), minlength=len(CLASSES))[:len(CLASSES)]
    share = counts / counts.sum()
    weights = 1.0 / np.sqrt(np.maximum(share, 1e-3))
    weights[0] *= 0.5  # mixed pixels and ground: what they are called matters least
    return torch.tensor(weights / (weights * share).sum(), dtype=torch.float32)


def fit(storeys, steps, seed, checkpoint, network=None, batch_size=4, size=64, cells=6000, rate=3e-3, minutes=None,
        freeze_norms=False, harder=False, say=print):
    """Returns the trained network. `network`: one to go on with (fine-tuning). Stops early after `minutes`."""
    torch.manual_seed(seed)
    rng = np.random.default_rng(seed)
    weights = class_weights(storeys)
    if network is None:
        network = Network()
    else:
        shift_scores(network, torch.log(weights))
    optimizer = torch.optim.AdamW(network.parameters(), rate, weight_decay=1e-2)
    criterion = torch.nn.CrossEntropyLoss(weights)
    checkpoint = pathlib.Path(checkpoint)
    start = saved = time.monotonic()
    network.train()
    if freeze_norms:
        for module in network.modules():
            if isinstance(module, torch.nn.BatchNorm2d):
                module.eval()
    shown = []
    for step in range(steps):
        progress = step / steps
        if minutes:
            progress = max(progress, (time.monotonic() - start) / 60.0 / minutes)
            if progress >= 1.0:
                break
        for group in optimizer.param_groups:  # warm up, then down to nothing along a cosine
            group["lr"] = rate * min(1.0, (step + 1) / 50.0) * 0.5 * (1.0 + np.cos(np.pi * progress))
        raster, features, places, labels = data.batch(storeys, batch_size, size, cells, rng, harder)
        optimizer.zero_grad()
        scores = network(raster, features, places)
        loss = criterion(scores, labels)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimizer.step()
        shown.append((loss.item(), (scores.argmax(1) == labels).float().mean().item()))
        if step % 25 == 24:
            mean = np.mean(shown, axis=0)
            say(f"step {step + 1}: loss {mean[0]:.3f}, {100 * mean[1]:.1f} % right, "
                f"{time.monotonic() - start:.0f} s", flush=True)
            shown = []
        if time.monotonic() - saved > 60.0:
            save(network, checkpoint)
            saved = time.monotonic()
    # Rare classes were given more weight while learning; the scores are to say what is likeliest.
    shift_scores(network, -torch.log(weights))
    save(network, checkpoint)
    return network.eval()


def shift_scores(network, by):
    with torch.no_grad():
        network.head[-1].bias += by


def mean(first, second, share):
    """The second network, its weights mixed with this share of the first's: such means hold on other data better."""
    with torch.no_grad():
        for a, b in zip(first.state_dict().values(), second.state_dict().values()):
            if b.is_floating_point():
                b.lerp_(a, share)
    return second


def save(network, path):
    partial = path.with_suffix(".partial")
    torch.save({"state": network.state_dict(), "widths": network.widths, "hidden": network.hidden,
                "context": network.context}, partial)
    partial.replace(path)


def load(path):
    saved = torch.load(path, weights_only=True)
    network = Network(saved["widths"], saved["hidden"], saved["context"])
    network.load_state_dict(saved["state"])
    return network.eval()
