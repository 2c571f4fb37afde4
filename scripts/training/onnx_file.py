# SPDX-License-Identifier: GPL-3.0-or-later
"""The network as an ONNX file and back. The graph is written node by node, so that the same weights give the same
bytes; batch normalisation is folded into the convolutions."""
import contextlib
import os
import sys

import numpy as np
import torch

from network import AREAS, BINS, CELL_FEATURES, CHANNELS, PER_BIN, Network, conv_layers, linear_layers


@contextlib.contextmanager
def silence():
    """Debian's torch and onnx each register all operators and complain in a thousand lines."""
    sys.stderr.flush()
    kept, null = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(null)


with silence():
    import onnx
    from onnx import TensorProto, helper, numpy_helper

OPSET, IR = 17, 8
BATCH = 8192  # cells: what goes through the perceptron stays in the cache


def folded(layer, norm):
    """Weight and bias of a convolution with its batch normalisation."""
    scale = norm.weight / torch.sqrt(norm.running_var + norm.eps)
    return layer.weight * scale[:, None, None, None], norm.bias - norm.running_mean * scale


class Graph:
    def __init__(self):
        self.nodes, self.initializers = [], []

    def constant(self, name, value):
        self.initializers.append(numpy_helper.from_array(np.ascontiguousarray(value), name))
        return name

    def add(self, kind, inputs, output, **attributes):
        self.nodes.append(helper.make_node(kind, inputs, [output], name=output, **attributes))
        return output

    def conv(self, name, x, weight, bias, stride=1, relu=True):
        kernel = weight.shape[2]
        y = self.add("Conv", [x, self.constant(name + ".weight", weight.detach().numpy()),
                              self.constant(name + ".bias", bias.detach().numpy())], name + ".conv",
                     kernel_shape=[kernel, kernel], strides=[stride, stride], pads=[kernel // 2] * 4)
        return self.add("Relu", [y], name) if relu else y

    def block(self, name, x, layers):
        weight, bias = folded(layers[0], layers[1])
        return self.conv(name, x, weight, bias, layers[0].stride[0])


def body(own, bins, size, ints, floats, linear):
    """The perceptron on the cells of batch number `i`; the last batch is filled up."""
    g = Graph()
    start = g.add("Mul", [g.add("Reshape", ["i", ints["one"]], "number"), "batch"], "from")
    end = g.add("Add", [start, "batch"], "to")
    cells, pixel, height = (g.add("Slice", [name, start, end, ints["zero"]], f"batch_{name}")
                            for name in ("cells", "pixel", "bin"))
    # Row of a cell's bin: bin * height * width + pixel.
    index = g.add("Add", [g.add("Mul", [height, size], "bin_from"), pixel], "bin_pixel")
    of_bin = g.add("Gather", [bins, index], "of_bin", axis=0)
    heights = g.add("Slice", [cells, ints["zero"], ints["two"], ints["axis"]], "heights")
    others = g.add("Slice", [cells, ints["two"], ints["features"], ints["axis"]], "others")
    heights = g.add("Clip", [heights, floats["low"], floats["most"]], "heights_limited")
    others = g.add("Clip", [others, floats["low"], floats["high"]], "others_limited")
    known = g.add("Concat", [of_bin, heights, others], "known", axis=1)
    h = g.add("Gemm", [known, "head0.rest", g.add("Gather", [own, pixel], "own", axis=0)], "head0.product", transB=1)
    for i in range(1, len(linear)):
        h = g.add("Relu", [h], f"head{i - 1}")
        h = g.add("Gemm", [h, f"head{i}.weight", f"head{i}.bias"], f"head{i}.product", transB=1)
    missing = g.add("Sub", ["batch", g.add("Shape", [h], "rows_done", start=0, end=1)], "missing")
    pads = g.add("Concat", [ints["zero"], ints["zero"], missing, ints["zero"]], "pads", axis=0)
    g.add("Pad", [h, pads], "batch_scores")
    g.add("Identity", ["go_on"], "goes_on")
    return helper.make_graph(
        g.nodes, "batch",
        [helper.make_tensor_value_info("i", TensorProto.INT64, []),
         helper.make_tensor_value_info("go_on", TensorProto.BOOL, [1])],
        [helper.make_tensor_value_info("goes_on", TensorProto.BOOL, [1]),
         helper.make_tensor_value_info("batch_scores", TensorProto.FLOAT, [BATCH, linear[-1].out_features])])


def build(network):
    g = Graph()
    ints = {name: g.constant(name, np.array(value, np.int64)) for name, value in
            {"zero": [0], "one": [1], "split": [AREAS], "end": [CHANNELS], "axis": [1], "two": [2], "features": [CELL_FEATURES],
             "spatial": [4], "wide": [network.widths[0], -1], "by_bin": [BINS, PER_BIN, -1],
             "rows": [-1, PER_BIN]}.items()}
    floats = {name: g.constant(name, np.float32(value)) for name, value in
              {"none": 0.0, "most": 4.0, "low": -2.0, "high": 2.0}.items()}
    areas = g.add("Slice", ["plan", ints["zero"], ints["split"], ints["axis"]], "areas")
    shares = g.add("Slice", ["plan", ints["split"], ints["end"], ints["axis"]], "shares")
    areas = g.add("Clip", [areas, floats["none"], floats["most"]], "limited")
    x = g.add("Concat", [g.add("Sqrt", [areas], "root"), shares], "column", axis=1)
    x = g.block("first", g.block("stem", x, network.stem), network.first)
    levels = [x]
    for i, down in enumerate(network.down):
        x = g.block(f"down{i}b", g.block(f"down{i}a", x, down[0]), down[1])
        levels.append(x)
    scales = g.constant("double", np.array([1, 1, 2, 2], np.float32))
    for i, ((narrow, smooth), skip) in enumerate(zip(network.up, levels[-2::-1])):
        y = g.block(f"up{i}a", x, narrow)
        y = g.add("Resize", [y, "", scales], f"up{i}r", mode="nearest", coordinate_transformation_mode="asymmetric",
                  nearest_mode="floor")
        x = g.block(f"up{i}b", g.add("Add", [y, skip], f"up{i}s"), smooth)
    pixels = g.add("Transpose", [g.add("Reshape", [x, ints["wide"]], "pixels")], "pixel_rows", perm=[1, 0])
    bins = g.conv("bins", x, network.bins.weight, network.bins.bias, relu=False)
    bins = g.add("Transpose", [g.add("Reshape", [bins, ints["by_bin"]], "bins3")], "bins_last", perm=[0, 2, 1])
    bins = g.add("Reshape", [bins, ints["rows"]], "bin_rows")
    sides = g.add("Slice", [g.add("Shape", ["plan"], "shape"), ints["two"], ints["spatial"], ints["zero"]], "sides")
    size = g.add("ReduceProd", [sides], "size", keepdims=1)
    # What the first layer makes of the pixel's vector is the same for all cells of the pixel.
    linear = linear_layers(network)
    wide = network.widths[0]
    first, rest = linear[0].weight[:, :wide], linear[0].weight[:, wide:]
    own = g.add("Gemm", [pixels, g.constant("head0.own", first.detach().numpy()),
                         g.constant("head0.bias", linear[0].bias.detach().numpy())], "own_rows", transB=1)
    g.constant("head0.rest", rest.detach().numpy())
    for i, layer in enumerate(linear[1:], 1):
        g.constant(f"head{i}.weight", layer.weight.detach().numpy())
        g.constant(f"head{i}.bias", layer.bias.detach().numpy())
    count = g.add("Shape", ["cells"], "count", start=0, end=1)
    batches = g.add("Div", [g.add("Add", [count, g.constant("batch_less_one", np.array([BATCH - 1], np.int64))],
                                  "count_up"), g.constant("batch", np.array([BATCH], np.int64))], "batches")
    trips = g.add("Squeeze", [batches], "trips")
    # Cells go through the perceptron in batches that stay in the processor's cache.
    every = g.add("Loop", [trips, g.constant("always", np.array([True]))], "batches_of_scores",
                  body=body(own, bins, size, ints, floats, linear))
    every = g.add("Reshape", [every, g.constant("score_rows", np.array([-1, linear[-1].out_features], np.int64))],
                  "padded_scores")
    g.add("Slice", [every, ints["zero"], count, ints["zero"]], "scores")

    def value(name, kind, shape):
        return helper.make_tensor_value_info(name, kind, shape)
    graph = helper.make_graph(
        g.nodes, "scan-to-bim segmentation",
        [value("plan", TensorProto.FLOAT, [1, CHANNELS, "height", "width"]),
         value("cells", TensorProto.FLOAT, ["n", CELL_FEATURES]), value("pixel", TensorProto.INT64, ["n"]),
         value("bin", TensorProto.INT64, ["n"])],
        [value("scores", TensorProto.FLOAT, ["n", linear[-1].out_features])], g.initializers)
    return helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=IR,
                             producer_name="scan-to-bim")


def write(network, path, metadata):
    model = build(network.eval())
    for key, text in metadata.items():
        model.metadata_props.append(onnx.StringStringEntryProto(key=key, value=text))
    onnx.checker.check_model(model, full_check=True)
    with open(path, "wb") as file:
        file.write(model.SerializeToString(deterministic=True))


def read(path):
    """The network of a file that write() made, ready to go on training. Normalisation stays folded."""
    model = onnx.load(path)
    values = {i.name: torch.from_numpy(numpy_helper.to_array(i).copy()) for i in model.graph.initializer}
    widths = [values["stem.bias"].numel()]
    while f"down{len(widths) - 1}a.bias" in values:
        widths.append(values[f"down{len(widths) - 1}a.bias"].numel())
    network = Network(widths, values["head0.bias"].numel())
    values["head0.weight"] = torch.cat([values["head0.own"], values["head0.rest"]], 1)
    with torch.no_grad():
        for name, (layer, norm) in conv_layers(network).items():
            layer.weight.copy_(values[name + ".weight"])
            norm.running_mean.zero_()
            norm.running_var.fill_(1.0 - norm.eps)
            norm.weight.fill_(1.0)
            norm.bias.copy_(values[name + ".bias"])
        network.bins.weight.copy_(values["bins.weight"])
        network.bins.bias.copy_(values["bins.bias"])
        for i, layer in enumerate(linear_layers(network)):
            layer.weight.copy_(values[f"head{i}.weight"])
            layer.bias.copy_(values[f"head{i}.bias"])
    return network.eval()
