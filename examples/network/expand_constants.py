#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Makes YOLOv8 and YOLO11 exports fit for OpenCV 4.6 (Debian 12, Ubuntu 22.04 has 4.5).

    examples/network/expand_constants.py IN.onnx OUT.onnx

The head of these networks multiplies the boxes, 1x4xN, by the strides, 1xN. OpenCV 4.6 cannot extend a constant of fewer
dimensions to three. This script writes constants that are added, subtracted, multiplied or divided out in full, those
of a result of two dimensions as a list; what the network computes does not change. Needs onnx (Debian: python3-onnx) and
an export with a fixed size.
"""
import sys

import numpy as np
import onnx
from onnx import numpy_helper, shape_inference


def expand(model):
    """Changes the model; returns the names of the constants that were extended.

    Raises ValueError naming the node whose shape the model does not tell."""
    shapes = {}
    inferred = shape_inference.infer_shapes(model).graph
    for value in [*inferred.value_info, *inferred.output]:
        shapes[value.name] = [d.dim_value for d in value.type.tensor_type.shape.dim]
    constants = {c.name: numpy_helper.to_array(c) for c in model.graph.initializer}
    for node in model.graph.node:
        if node.op_type == "Constant" and node.attribute[0].name == "value":
            constants[node.output[0]] = numpy_helper.to_array(node.attribute[0].t)
    names = []
    for node in model.graph.node:
        if node.op_type not in ("Add", "Sub", "Mul", "Div"):
            continue
        for i, name in enumerate(node.input):
            constant = constants.get(name)
            if constant is None or constant.size == 1:
                continue
            shape = shapes.get(node.output[0], [0])
            if 0 in shape:
                raise ValueError(f"{node.op_type} '{node.name or node.output[0]}' has no fixed shape: export with a fixed size")
            # Of two dimensions OpenCV 4.6 extends a list, 1xN as N, but does not take all products with a full one.
            row = len(shape) == 2 and constant.ndim == 2 and constant.shape[0] == 1
            if not row and (len(shape) < 3 or list(constant.shape) == shape):
                continue
            node.input[i] = f"{name}_for_{node.output[0]}"
            full = np.ascontiguousarray(constant.reshape(-1) if row else np.broadcast_to(constant, shape))
            model.graph.initializer.append(numpy_helper.from_array(full, node.input[i]))
            names.append(name)
    return names


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    network = onnx.load(sys.argv[1])
    try:
        extended = expand(network)
    except ValueError as error:
        sys.exit(f"{sys.argv[1]}: {error}")
    onnx.checker.check_model(network)
    onnx.save(network, sys.argv[2])
    print(f"{len(extended)} constants extended:", *extended)
