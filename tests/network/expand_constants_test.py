#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What expand_constants.py does with models that do not tell their shapes, and which constants it leaves alone.

    tests/network/expand_constants_test.py FOLDER

FOLDER is that of the script. Needs numpy and onnx (Debian: python3-onnx).
"""
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

script = os.path.join(sys.argv.pop(1), "expand_constants.py")


def product(image_shape, constant, out_shape):
    """The image times the constant, by a node that is called `scaling`."""
    graph = helper.make_graph(
        [helper.make_node("Mul", ["images", "factors"], ["out"], name="scaling")], "product",
        [helper.make_tensor_value_info("images", TensorProto.FLOAT, image_shape)],
        [helper.make_tensor_value_info("out", TensorProto.FLOAT, out_shape)],
        [numpy_helper.from_array(np.asarray(constant, np.float32), "factors")])
    return helper.make_model(graph, opset_imports=[helper.make_opsetid("", 12)])


class Expand(unittest.TestCase):

    def run_script(self, model):
        """The script's end, and the shape of the constant that the product then has."""
        with tempfile.TemporaryDirectory() as folder:
            before, after = os.path.join(folder, "before.onnx"), os.path.join(folder, "after.onnx")
            onnx.save(model, before)
            done = subprocess.run([sys.executable, "-B", script, before, after], capture_output=True, text=True, check=False)
            if done.returncode != 0:
                self.assertFalse(os.path.exists(after))
                return done, None
            graph = onnx.load(after).graph
            constants = {c.name: numpy_helper.to_array(c) for c in graph.initializer}
            return done, constants[graph.node[0].input[1]]

    def test_a_shape_that_is_not_fixed_is_an_error_that_names_the_node(self):
        for image, out in ((("n", 4, 3), ("n", 4, 3)), ((1, "m", 3), (1, "m", 3)), (("n", 3), ("n", 3))):
            done, _ = self.run_script(product(image, [[1, 2, 3]], out))
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"^\S+before.onnx: Mul 'scaling' has no fixed shape: export with a fixed size\n$")

    def test_one_number_needs_no_shape(self):
        done, constant = self.run_script(product((1, 4, "n"), [[2]], (1, 4, "n")))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(constant.shape, (1, 1))

    def test_constants_get_the_shape_that_opencv_takes(self):
        for image, constant, expected in (((1, 4, 3), (1, 3), (1, 4, 3)), ((1, 2, 4, 3), (1, 3), (1, 2, 4, 3)),
                                          ((1, 2, 4, 3), (3,), (1, 2, 4, 3)), ((4, 3), (1, 3), (3,)), ((1, 3), (1, 3), (3,)),
                                          ((4, 3), (3,), (3,)), ((4, 3), (4, 3), (4, 3)), ((3,), (3,), (3,))):
            values = np.arange(np.prod(constant), dtype=np.float32).reshape(constant)
            done, got = self.run_script(product(image, values, image))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(got.shape, expected)
            np.testing.assert_array_equal(np.broadcast_to(got, image), np.broadcast_to(values, image))


if __name__ == "__main__":
    unittest.main()
