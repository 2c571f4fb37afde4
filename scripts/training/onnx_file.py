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


def build(network):
    g = Graph()
    ints = {name: g.constant(name, np.array(value, np.int64)) for name, value in
            {"zero": [0], "split": [AREAS], "end": [CHANNELS], "axis": [1], "two": [2], "features": [CELL_FEATURES],
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
    own = g.add("Gather", [pixels, "pixel"], "own", axis=0)
    bins = g.conv("bins", x, network.bins.weight, network.bins.bias, relu=False)
    bins = g.add("Transpose", [g.add("Reshape", [bins, ints["by_bin"]], "bins3")], "bins_last", perm=[0, 2, 1])
    bins = g.add("Reshape", [bins, ints["rows"]], "bin_rows")
    # Row of a cell's bin: bin * height * width + pixel.
    sides = g.add("Slice", [g.add("Shape", ["plan"], "shape"), ints["two"], ints["spatial"], ints["zero"]], "sides")
    size = g.add("ReduceProd", [sides], "size", keepdims=1)
    index = g.add("Add", [g.add("Mul", ["bin", size], "bin_from"), "pixel"], "bin_pixel")
    of_bin = g.add("Gather", [bins, index], "of_bin", axis=0)
    heights = g.add("Slice", ["cells", ints["zero"], ints["two"], ints["axis"]], "heights")
    others = g.add("Slice", ["cells", ints["two"], ints["features"], ints["axis"]], "others")
    heights = g.add("Clip", [heights, floats["low"], floats["most"]], "heights_limited")
    others = g.add("Clip", [others, floats["low"], floats["high"]], "others_limited")
    h = g.add("Concat", [own, of_bin, heights, others], "known", axis=1)
    linear = linear_layers(network)
    for i, layer in enumerate(linear):
        last = i + 1 == len(linear)
        h = g.add("Gemm", [h, g.constant(f"head{i}.weight", layer.weight.detach().numpy()),
                           g.constant(f"head{i}.bias", layer.bias.detach().numpy())],
                  "scores" if last else f"head{i}.product", transB=1)
        if not last:
            h = g.add("Relu", [h], f"head{i}")
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
