#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Trains cars.onnx: a network of 2486 weights that knows the five cars of the sample by their colours.

    examples/data/network/train.py examples/data/mini examples/data/network/cars.onnx

It stands in for a real network in the demo and the tests, and is of no use for anything but the sample: it was trained
on the same 24 frames, with their true instances. Needs numpy, onnx and OpenCV (Debian: python3-onnx, python3-opencv);
takes some minutes. The result depends on the last digits of the machine's arithmetic.

    image 1x3x188x620 -> means of 4x4 pixels -> 12 features of 3x3 -> their means over 3, 7, 15 and 25
                      -> 32 features -> 6 classes (background, five cars) -> their means over 3 -> the largest: 1x1x47x155
"""
import sys

import cv2
import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

CELL, GREY, FEATURES, HIDDEN, CLASSES = 4, 0.45, 12, 32, 6
WINDOWS = (3, 7, 15, 25)
STEPS, BATCH, RATE = 1500, 3, 0.01


def read(folder):
    """Images as means of cells about 0, NxHxWx3; the true instance in the middle of each cell, NxHxW."""
    images, truth = [], []
    for i in range(24):
        image = cv2.imread(f"{folder}/rgb/{i:06d}.png")[:, :, ::-1].astype(np.float32) / 255
        size = (image.shape[1] // CELL, image.shape[0] // CELL)
        images.append(cv2.resize(image, size, interpolation=cv2.INTER_AREA) - GREY)
        truth.append(cv2.imread(f"{folder}/instance/{i:06d}.png", cv2.IMREAD_UNCHANGED)[CELL // 2 :: CELL, CELL // 2 :: CELL])
    return np.stack(images), np.stack(truth)


def neighbourhoods(images):
    n, h, w, _ = images.shape
    padded = np.pad(images, ((0, 0), (1, 1), (1, 1), (0, 0)))
    return np.concatenate([padded[:, i : i + h, j : j + w] for i in range(3) for j in range(3)], -1)


def means(maps, window):
    return np.stack([cv2.boxFilter(np.ascontiguousarray(m), -1, (window, window), borderType=cv2.BORDER_CONSTANT) for m in maps])


def forward(weights, patches):
    w1, b1, w2, b2, w3, b3 = weights
    n, h, w, _ = patches.shape
    first = patches.reshape(-1, 27) @ w1 + b1
    maps = np.maximum(first, 0).reshape(n, h, w, FEATURES)
    wide = np.concatenate([maps] + [means(maps, k) for k in WINDOWS], -1).reshape(n * h * w, -1)
    second = wide @ w2 + b2
    return first, wide, second, np.maximum(second, 0) @ w3 + b3


def backward(weights, patches, truth, class_weights):
    n, h, w, _ = patches.shape
    first, wide, second, scores = forward(weights, patches)
    shares = np.exp(scores - scores.max(1, keepdims=True))
    shares /= shares.sum(1, keepdims=True)
    weight = class_weights[truth]
    d_scores = (shares - np.eye(CLASSES, dtype=np.float32)[truth]) * (weight / weight.sum())[:, None]
    d_second = (d_scores @ weights[4].T) * (second > 0)
    d_wide = (d_second @ weights[2].T).reshape(n, h, w, -1)
    d_first = d_wide[..., :FEATURES].copy()
    for i, k in enumerate(WINDOWS, 1):
        d_first += means(d_wide[..., FEATURES * i : FEATURES * (i + 1)], k)
    d_first = d_first.reshape(-1, FEATURES) * (first > 0)
    return [patches.reshape(-1, 27).T @ d_first, d_first.sum(0), wide.T @ d_second, d_second.sum(0),
            np.maximum(second, 0).T @ d_scores, d_scores.sum(0)]


def train(images, truth):
    """Adam on the cross entropy; a class counts by its pixels to the power of 0.6."""
    rng = np.random.default_rng(0)
    wide = FEATURES * (1 + len(WINDOWS))
    weights = [rng.normal(size=(27, FEATURES)).astype(np.float32) * 0.5, np.full(FEATURES, 0.1, np.float32),
               rng.normal(size=(wide, HIDDEN)).astype(np.float32) * 2 * np.sqrt(2 / wide), np.zeros(HIDDEN, np.float32),
               rng.normal(size=(HIDDEN, CLASSES)).astype(np.float32) * 0.2, np.zeros(CLASSES, np.float32)]
    class_weights = (1 / np.bincount(truth.reshape(-1), minlength=CLASSES) ** 0.4).astype(np.float32)
    patches = neighbourhoods(images)
    mean = [np.zeros_like(w) for w in weights]
    square = [np.zeros_like(w) for w in weights]
    for step in range(1, STEPS + 1):
        batch = rng.choice(len(images), BATCH, replace=False)
        rate = RATE * min(1, step / 50) * (1 - (step - 1) / STEPS)
        for i, d in enumerate(backward(weights, patches[batch], truth[batch].reshape(-1), class_weights)):
            mean[i] = 0.9 * mean[i] + 0.1 * d
            square[i] = 0.999 * square[i] + 0.001 * d * d
            weights[i] -= np.float32(rate) * (mean[i] / (1 - 0.9**step)) / (np.sqrt(square[i] / (1 - 0.999**step)) + 1e-8)
        if step % 100 == 0:
            said = np.concatenate([forward(weights, patches[i : i + 4])[-1].argmax(1) for i in range(0, len(patches), 4)])
            true = truth.reshape(-1)
            iou = [((said == c) & (true == c)).sum() / ((said == c) | (true == c)).sum() for c in range(CLASSES)]
            print(step, "IoU", *(f"{v:.2f}" for v in iou), flush=True)
    return weights


def save(path, weights, height, width):
    w1, b1, w2, b2, w3, b3 = weights
    tensors = {"cells_w": np.eye(3, dtype=np.float32)[:, :, None, None] * np.full((1, 1, CELL, CELL), 1 / CELL**2, np.float32),
               "cells_b": np.full(3, -GREY, np.float32), "first_w": w1.reshape(3, 3, 3, FEATURES).transpose(3, 2, 0, 1),
               "first_b": b1, "second_w": w2.T[:, :, None, None], "second_b": b2, "third_w": w3.T[:, :, None, None], "third_b": b3}

    def conv(name, source, kernel, **more):
        return helper.make_node("Conv", [source, name + "_w", name + "_b"], [name], kernel_shape=[kernel, kernel], **more)

    def mean(source, name, window):
        """Zeros around the image count. By a Pad of its own: OpenCV does not read AveragePool's count_include_pad."""
        tensors[name + "_pads"] = np.array([0, 0, window // 2, window // 2] * 2)
        return [helper.make_node("Pad", [source, name + "_pads"], [name + "_padded"]),
                helper.make_node("AveragePool", [name + "_padded"], [name], kernel_shape=[window, window], strides=[1, 1])]

    nodes = [conv("cells", "images", CELL, strides=[CELL, CELL]), conv("first", "cells", 3, pads=[1] * 4),
             helper.make_node("Relu", ["first"], ["features"])]
    for k in WINDOWS:
        nodes += mean("features", f"mean{k}", k)
    nodes += [helper.make_node("Concat", ["features"] + [f"mean{k}" for k in WINDOWS], ["wide"], axis=1),
              conv("second", "wide", 1), helper.make_node("Relu", ["second"], ["hidden"]), conv("third", "hidden", 1),
              *mean("third", "smooth", 3),
              helper.make_node("ArgMax", ["smooth"], ["ids"], axis=1, keepdims=1)]
    graph = helper.make_graph(
        nodes, "cars", [helper.make_tensor_value_info("images", TensorProto.FLOAT, (1, 3, height, width))],
        [helper.make_tensor_value_info("ids", TensorProto.INT64, (1, 1, height // CELL, width // CELL))],
        [numpy_helper.from_array(np.ascontiguousarray(t), name) for name, t in tensors.items()])
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 12)], producer_name="dot")
    model.ir_version = 7
    onnx.checker.check_model(model)
    onnx.save(model, path)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    cells, instances = read(sys.argv[1])
    save(sys.argv[2], train(cells, instances), CELL * cells.shape[1], CELL * cells.shape[2])
