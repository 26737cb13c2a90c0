#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Makes the networks that the tests load: their outputs are known tensors of each format, whatever the image.

    tests/network/make_models.py FOLDER

FOLDER is tests/network/models, whose files are checked in. Needs numpy and onnx (Debian: python3-onnx). The tensors
are those of known_tensors.hpp.
"""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/network"))

import numpy as np
import onnx
from expand_constants import expand
from onnx import TensorProto, helper, numpy_helper

OPSET, IR = 12, 7


def save(folder, name, inputs, nodes, outputs, weights, change=None):
    graph = helper.make_graph(nodes, name, inputs, outputs, weights)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)], producer_name="dot")
    model.ir_version = IR
    if change:
        change(model)
    onnx.checker.check_model(model)
    onnx.save(model, os.path.join(folder, name + ".onnx"))


def floats(name, shape):
    return helper.make_tensor_value_info(name, TensorProto.FLOAT, shape)


def known(folder, name, input_shape, outputs):
    """Each output is a convolution of the image's mean with weights of 0, so that its bias is left."""
    nodes, weights = [], []
    image = "images"
    if len(input_shape) == 3:
        weights.append(numpy_helper.from_array(np.array([1, *input_shape], np.int64), "batch"))
        nodes.append(helper.make_node("Reshape", [image, "batch"], ["batched"]))
        image = "batched"
    nodes.append(helper.make_node("GlobalAveragePool", [image], ["mean"]))
    for output, values in outputs.items():
        values = np.asarray(values, np.float32)
        weights += [
            numpy_helper.from_array(np.zeros((values.size, 3, 1, 1), np.float32), output + "_weights"),
            numpy_helper.from_array(values.reshape(-1), output + "_bias"),
            numpy_helper.from_array(np.array(values.shape, np.int64), output + "_shape"),
        ]
        nodes += [
            helper.make_node("Conv", ["mean", output + "_weights", output + "_bias"], [output + "_flat"], kernel_shape=[1, 1]),
            helper.make_node("Reshape", [output + "_flat", output + "_shape"], [output]),
        ]
    save(folder, name, [floats("images", input_shape)], nodes, [floats(o, np.shape(v)) for o, v in outputs.items()], weights)


def single(folder, name, operator, input_shape, output_shape):
    save(folder, name, [floats("images", input_shape)], [helper.make_node(operator, ["images"], ["out"])],
         [floats("out", output_shape)], [])


def attention(folder):
    """Half the product of two activations, as in the attention of YOLO11."""
    half = numpy_helper.from_array(np.array(0.5, np.float32), "half")
    save(folder, "attention", [floats("images", (1, 3, 4, 4))],
         [helper.make_node("MatMul", ["images", "images"], ["product"]), helper.make_node("Mul", ["product", "half"], ["out"])],
         [floats("out", (1, 3, 4, 4))], [half])


def boxes_head(folder):
    """The end of the head of YOLOv8 and YOLO11 over four places: the distribution of each of the four distances becomes
    its mean; distances from the anchors become boxes, times the strides. As exported, and for OpenCV 4.6."""
    n = 4
    anchors = np.array([[[0.5, 1.5, 0.5, 1.5], [0.5, 0.5, 1.5, 1.5]]], np.float32)
    constants = {
        "split": np.array([1, 4, 3, n]), "joined": np.array([1, 4, n]), "bins": np.arange(3, dtype=np.float32).reshape(1, 3, 1, 1),
        "zero": np.array([0]), "two": np.array([2]), "four": np.array([4]), "axis": np.array([1]), "anchors": anchors,
        "half": np.array(2, np.float32), "strides": np.array([[8, 8, 16, 16]], np.float32)}
    node = helper.make_node
    nodes = [
        node("Reshape", ["images", "split"], ["r"]), node("Transpose", ["r"], ["t"], perm=[0, 3, 1, 2]),
        node("Softmax", ["t"], ["s"], axis=3), node("Transpose", ["s"], ["p"], perm=[0, 3, 2, 1]),
        node("Conv", ["p", "bins"], ["c"], kernel_shape=[1, 1]), node("Reshape", ["c", "joined"], ["distances"]),
        node("Slice", ["distances", "zero", "two", "axis"], ["before"]), node("Slice", ["distances", "two", "four", "axis"], ["after"]),
        node("Sub", ["anchors", "before"], ["first"]), node("Add", ["anchors", "after"], ["last"]),
        node("Add", ["first", "last"], ["sum"]), node("Div", ["sum", "half"], ["centre"]), node("Sub", ["last", "first"], ["size"]),
        node("Concat", ["centre", "size"], ["boxes"], axis=1), node("Mul", ["boxes", "strides"], ["out"])]
    for name, change in (("boxes_head", None), ("boxes_head_expanded", expand)):
        save(folder, name, [floats("images", (1, 12, 2, 2))], nodes, [floats("out", (1, 4, n))],
             [numpy_helper.from_array(v, k) for k, v in constants.items()], change)


def rows(folder):
    """Rows that are extended to four dimensions and to two. As exported, and for OpenCV 4.6."""
    constants = {"ones": np.array([[1, 10]], np.float32), "flat": np.array([3, 4]), "factors": np.array([[1, 2, 3, 4]], np.float32)}
    nodes = [
        helper.make_node("Add", ["images", "ones"], ["sum"]), helper.make_node("Reshape", ["sum", "flat"], ["table"]),
        helper.make_node("Mul", ["table", "factors"], ["out"])]
    for name, change in (("rows", None), ("rows_expanded", expand)):
        save(folder, name, [floats("images", (1, 3, 2, 2))], nodes, [floats("out", (3, 4))],
             [numpy_helper.from_array(v, k) for k, v in constants.items()], change)


def yolo_v5_head(folder):
    """The end of YOLOv5 for two anchors on 2x2 places, with one class and one coefficient: 1x14x2x2 to 1x8x7."""
    grid = np.zeros((1, 2, 2, 2, 2), np.float32)
    grid[..., 0], grid[..., 1] = [0, 1], [[0], [1]]
    constants = {
        "apart": np.array([1, 2, 7, 2, 2]), "rows": np.array([1, 8, 7]), "two": np.array(2, np.float32), "grid": grid,
        "stride": np.array(8, np.float32), "anchors": np.array([4, 6, 10, 12], np.float32).reshape(1, 2, 1, 1, 2) * np.ones((1, 1, 2, 2, 1), np.float32)}
    node = helper.make_node
    nodes = [
        node("Reshape", ["images", "apart"], ["r"]), node("Transpose", ["r"], ["t"], perm=[0, 1, 3, 4, 2]),
        node("Split", ["t"], ["a", "b", "c", "coefficients"], axis=4, split=[2, 2, 2, 1]),
        node("Sigmoid", ["a"], ["a1"]), node("Mul", ["a1", "two"], ["a2"]), node("Add", ["a2", "grid"], ["a3"]),
        node("Mul", ["a3", "stride"], ["places"]), node("Sigmoid", ["b"], ["b1"]), node("Mul", ["b1", "two"], ["b2"]),
        node("Pow", ["b2", "two"], ["b3"]), node("Mul", ["b3", "anchors"], ["sizes"]), node("Sigmoid", ["c"], ["scores"]),
        node("Concat", ["places", "sizes", "scores", "coefficients"], ["all"], axis=4), node("Reshape", ["all", "rows"], ["out"])]
    save(folder, "yolo_v5_head", [floats("images", (1, 14, 2, 2))], nodes, [floats("out", (1, 8, 7))],
         [numpy_helper.from_array(v, k) for k, v in constants.items()])


def main(folder):
    # x, y, width, height | car, person, tree | two coefficients
    boxes = [[6, 8, 8, 8], [7, 8, 8, 8], [11, 8, 10, 4], [6, 8, 8, 8], [8, 8, 4, 4], [3, 6, 4, 4]]
    scores = [[.875, 0, 0], [.625, .5, 0], [0, .75, 0], [.25, .6875, 0], [0, 0, .9375], [.125, 0, 0]]
    coefficients = [[1, 0], [1, 0], [0, 1], [-1, 0], [1, 1], [1, 0]]
    left = np.repeat([[1, 1, -1, -1]], 4, 0)
    prototypes = np.stack([left, left.T])[None]
    v8 = np.concatenate([boxes, scores, coefficients], 1).T[None]
    # The same scores as products; the last one has a class that is sure of itself.
    objectness = [[1], [1], [.75], [1], [1], [.125]]
    parts = [[.875, 0, 0], [.625, .5, 0], [0, 1, 0], [.25, .6875, 0], [0, 0, .9375], [1, 0, 0]]
    v5 = np.concatenate([boxes, objectness, parts, coefficients], 1)[None]
    known(folder, "yolo_v8", (1, 3, 16, 16), {"output0": v8, "output1": prototypes})
    known(folder, "yolo_v5", (1, 3, 16, 16), {"output0": v5, "output1": prototypes})

    boxes = [[0, 0, 4, 4], [3, 1, 8, 3], [0, 0, 8, 4], [0, 0, 8, 4]]
    masks = np.zeros((4, 1, 4, 8))
    masks[0, 0, :, :3] = .75
    masks[0, 0, 0, 0] = .5
    masks[1, 0, 1:3, 2:6] = 1
    masks[2:] = 1
    known(folder, "torchvision", (1, 3, 4, 8),
          {"boxes": boxes, "labels": [3, 1, 10, 3], "scores": [.75, .875, .9375, .25], "masks": masks})
    small = [[[[1, 0], [0, 0]]], [[[1, 1], [1, 1]]]]
    known(folder, "detectron2", (3, 4, 8),
          {"pred_boxes": [[0, 0, 4, 4], [4, 0, 8, 4]], "pred_classes": [2, 0], "pred_masks": small,
           "scores": [.75, .875], "image_size": [4, 8]})
    known(folder, "ids", (1, 3, 4, 8), {"ids": [[[[0, 1, 300, 0], [2, 1, 0, 0]]]]})
    known(folder, "no_ids", (1, 3, 4, 8), {"ids": [[[[0, 1, .5, 0], [2, 1, 0, 0]]]]})

    attention(folder)
    boxes_head(folder)
    rows(folder)
    yolo_v5_head(folder)
    single(folder, "unsupported", "Det", (1, 3, 4, 4), (1, 3))
    single(folder, "grey_input", "Relu", (1, 1, 4, 8), (1, 1, 4, 8))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
