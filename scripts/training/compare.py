# SPDX-License-Identifier: GPL-3.0-or-later
"""What the network is compared with: boosted trees and a perceptron on the cells' own features, without the plan."""
import numpy as np
import torch
from sklearn.ensemble import HistGradientBoostingClassifier

import evaluate
import fit
from network import CLASSES, Network


class Trees:
    """Boosted trees in the network's place."""

    def __init__(self, storeys, seed, cells=300000, rounds=60):
        rng = np.random.default_rng(seed)
        share = cells // len(storeys)
        picked = [np.sort(rng.choice(len(s.labels), min(share, len(s.labels)), replace=False)) for s in storeys]
        features = np.concatenate([s.cells[i] for s, i in zip(storeys, picked)]).astype(np.float32)
        labels = np.concatenate([s.labels[i] for s, i in zip(storeys, picked)])
        weights = fit.class_weights(storeys).numpy()[labels]
        self.trees = HistGradientBoostingClassifier(max_iter=rounds, max_leaf_nodes=31, random_state=seed)
        self.trees.fit(features, labels, weights)

    def __call__(self, plan, cells, places):
        scores = np.full((len(cells), len(CLASSES)), -1e9, np.float32)
        scores[:, self.trees.classes_] = self.trees.predict_proba(cells.numpy())
        return torch.from_numpy(scores)


def compare(network, train, surveys, steps, seed, folder):
    """{name: table} of the trained network and of its rivals, on surveys that none of them has seen."""
    rivals = {"storey network": network, "boosted trees, cell features": Trees(train, seed)}
    rivals["perceptron, cell features"] = fit.fit(train, steps, seed, folder / "perceptron.pt",
                                                  Network(context=False), say=lambda *_, **__: None)
    return {name: evaluate.table({k: evaluate.confusion(r, s) for k, s in surveys.items()})
            for name, r in rivals.items()}
