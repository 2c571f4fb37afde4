#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_models.py DIR: small ONNX files for the tests: models that label cells by rules, and files that are no model."""
import pathlib
import sys

import numpy
import onnx
from onnx import TensorProto, helper, numpy_helper

CLASSES = ["floor", "ceiling", "wall", "furniture"]


def tensor(name, values, kind=numpy.float32):
    return numpy_helper.from_array(numpy.asarray(values, dtype=kind), name)


def by_rules(features, classes=CLASSES):
    """Scores of a cell: level and near the floor, level and near the ceiling, upright, something between.

    One linear layer over normal_z, height and depth is enough; what else is listed is given no weight."""
    weights = numpy.zeros((len(features), len(classes)), numpy.float32)
    rows = {"normal_z": [8, 8, -8, 0], "height": [-8, 0, 0, 0], "depth": [0, -8, 0, 0]}
    for name, row in rows.items():
        weights[features.index(name), :4] = row
    return weights, numpy.array([0, 0, 6, 1] + [-20] * (len(classes) - 4), numpy.float32)


def metadata(**changes):
    values = {
        "s2b.contract": "1",
        "s2b.classes": ",".join(CLASSES),
        "s2b.cell_m": "0.03",
        "s2b.features": "normal_z,height,depth",
        "s2b.output": "logits",
    }
    for key, value in changes.items():
        values["s2b." + key] = value
    return {key: value for key, value in values.items() if value is not None}


def write(path, nodes, inputs, weights, pairs, output=None, opset=17, ir=8):
    output = output or helper.make_tensor_value_info("scores", TensorProto.FLOAT, ["n", len(CLASSES)])
    graph = helper.make_graph(nodes, "test", inputs, [output], weights)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", opset)], producer_name="s2b-tests")
    model.ir_version = ir
    helper.set_model_props(model, pairs)
    path.write_bytes(model.SerializeToString(deterministic=True))


def linear(path, pairs, features=None, cell_input="cells", output=None, width=None, kind=TensorProto.FLOAT, **how):
    features = features or ["normal_z", "height", "depth"]
    matrix, bias = by_rules(features)
    cells = helper.make_tensor_value_info(cell_input, kind, ["n", width or len(features)])
    write(path, [helper.make_node("Gemm", [cell_input, "w", "b"], ["scores"])], [cells],
          [tensor("w", matrix), tensor("b", bias)], pairs, output, **how)


def plan_model(path):
    """Takes a plan beside the cells: 3 x 3 mean of the layers, looked up where each cell lies."""
    matrix, bias = by_rules(["normal_z", "height", "depth"])
    layers = 4
    generator = numpy.random.default_rng(1)
    kernel = generator.normal(0, 0.1, (8, layers, 3, 3))
    out = generator.normal(0, 0.1, (4, 8, 3, 3))
    inputs = [
        helper.make_tensor_value_info("cells", TensorProto.FLOAT, ["n", 3]),
        helper.make_tensor_value_info("plan", TensorProto.FLOAT, [1, layers, "h", "w"]),
        helper.make_tensor_value_info("pixel", TensorProto.INT64, ["n"]),
    ]
    nodes = [
        helper.make_node("Conv", ["plan", "k1"], ["c1"], pads=[1, 1, 1, 1]),
        helper.make_node("Relu", ["c1"], ["r1"]),
        helper.make_node("Conv", ["r1", "k2"], ["c2"], pads=[1, 1, 1, 1]),
        helper.make_node("Reshape", ["c2", "flat"], ["f"]),
        helper.make_node("Transpose", ["f"], ["t"], perm=[1, 0]),
        helper.make_node("Gather", ["t", "pixel"], ["g"], axis=0),
        helper.make_node("Gemm", ["cells", "w", "b"], ["s"]),
        helper.make_node("Add", ["s", "g"], ["scores"]),
    ]
    write(path, nodes, inputs,
          [tensor("k1", kernel), tensor("k2", out), tensor("flat", [4, -1], numpy.int64), tensor("w", matrix),
           tensor("b", bias)],
          metadata(plan_pixel_m="0.1", plan_low_m="0", plan_bin_m="1.5", plan_bins="2",
                   plan_channels="cells,upright", plan_multiple="8"))


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    linear(folder / "rules.onnx", metadata())
    linear(folder / "normalised.onnx", metadata(mean="0,0,0", scale="1,1,1"))
    # Probabilities instead of logits, and columns that count together.
    matrix, bias = by_rules(["normal_z", "height", "depth"])
    write(folder / "probabilities.onnx",
          [helper.make_node("Gemm", ["cells", "w", "b"], ["s"]), helper.make_node("Softmax", ["s"], ["scores"], axis=1)],
          [helper.make_tensor_value_info("cells", TensorProto.FLOAT, ["n", 3])],
          [tensor("w", matrix), tensor("b", bias)], metadata(output="probabilities"))
    colours = ["normal_z", "height", "depth", "red", "green", "blue"]
    linear(folder / "needs_colour.onnx", metadata(features=",".join(colours), colour="required"), colours)
    linear(folder / "takes_colour.onnx", metadata(features=",".join(colours), colour="optional"), colours)
    plan_model(folder / "plan.onnx")

    # What is wrong with a model, one thing each.
    linear(folder / "no_metadata.onnx", {})
    linear(folder / "other_version.onnx", metadata(contract="2"))
    linear(folder / "unknown_key.onnx", metadata(cel_m="0.03"))
    linear(folder / "missing_key.onnx", metadata(cell_m=None))
    linear(folder / "unknown_class.onnx", metadata(classes="floor,ceiling,wal,furniture"))
    linear(folder / "unknown_feature.onnx", metadata(features="normal_z,hight,depth"))
    linear(folder / "bad_number.onnx", metadata(cell_m="3 cm"))
    linear(folder / "half_normalised.onnx", metadata(mean="0,0,0"))
    linear(folder / "silent_colour.onnx", metadata(features="normal_z,height,red"))
    linear(folder / "wrong_width.onnx", metadata(features="normal_z,height,depth,flatness"))
    linear(folder / "wrong_input.onnx", metadata(), cell_input="cell")
    write(folder / "wrong_type.onnx",
          [helper.make_node("Cast", ["cells"], ["c"], to=TensorProto.FLOAT),
           helper.make_node("Gemm", ["c", "w", "b"], ["scores"])],
          [helper.make_tensor_value_info("cells", TensorProto.DOUBLE, ["n", 3])],
          [tensor("w", matrix), tensor("b", bias)], metadata())
    linear(folder / "wrong_classes.onnx", metadata(classes="floor,ceiling,wall,column,furniture"))
    write(folder / "no_scores.onnx",
          [helper.make_node("Gemm", ["cells", "w", "b"], ["labels"])],
          [helper.make_tensor_value_info("cells", TensorProto.FLOAT, ["n", 3])],
          [tensor("w", matrix), tensor("b", bias)], metadata(),
          helper.make_tensor_value_info("labels", TensorProto.FLOAT, ["n", len(CLASSES)]))
    linear(folder / "newer_ir.onnx", metadata(), ir=99)
    linear(folder / "newer_opset.onnx", metadata(), opset=999)
    (folder / "text.onnx").write_text("This is no model.\n")
    (folder / "empty.onnx").write_bytes(b"")
    whole = (folder / "rules.onnx").read_bytes()
    (folder / "truncated.onnx").write_bytes(whole[: len(whole) // 2])


if __name__ == "__main__":
    main()
