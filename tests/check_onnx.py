#!/usr/bin/env python3
"""Saved policies against the checker of ONNX, and their values against ours: check_onnx.py ONNX_SAMPLE

Debian's python3-onnx belongs to Debian's Python, which need not be the first one on the path.
"""
import os
import subprocess
import sys
import tempfile

try:
    import numpy
    import onnx
    import onnx.checker
    import onnx.numpy_helper
except ImportError:
    if sys.executable == "/usr/bin/python3" or not os.path.exists("/usr/bin/python3"):
        sys.exit("no module onnx: install python3-onnx")
    os.execv("/usr/bin/python3", ["/usr/bin/python3", "-B", *sys.argv])


def evaluate(model, x):
    """The graph's output, node by node."""
    values = {t.name: onnx.numpy_helper.to_array(t) for t in model.graph.initializer}
    values[model.graph.input[0].name] = x
    for node in model.graph.node:
        inputs = [values[name] for name in node.input]
        if node.op_type == "Gemm":
            assert [(a.name, a.i) for a in node.attribute] == [("transB", 1)], node
            values[node.output[0]] = inputs[0] @ inputs[1].T + inputs[2]
        elif node.op_type == "Relu":
            values[node.output[0]] = numpy.maximum(inputs[0], 0)
        else:
            raise AssertionError(f"an operator that nobody wrote: {node.op_type}")
    return values[model.graph.output[0].name]


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        path, table = os.path.join(folder, "policy.onnx"), os.path.join(folder, "values.csv")
        subprocess.run([program, path, table], check=True)
        model = onnx.load(path)
        onnx.checker.check_model(model, full_check=True)
        assert model.ir_version == 8 and model.opset_import[0].version == 13
        assert [p.name for p in model.graph.input] == ["observation"]
        assert [p.name for p in model.graph.output] == ["values"]
        assert {p.key: p.value for p in model.metadata_props} == {"kernels": "portable"}
        rows = numpy.loadtxt(table, delimiter=",", dtype=numpy.float32)
        error = numpy.abs(evaluate(model, rows[:, :3]) - rows[:, 3:]).max()
        assert rows.shape == (200, 6) and error <= 1e-5, error
        # The checker must be one that can say no.
        del model.graph.initializer[0]
        try:
            onnx.checker.check_model(model, full_check=True)
        except onnx.checker.ValidationError:
            return
        raise AssertionError("the checker accepts a model without its weights")


if __name__ == "__main__":
    main(sys.argv[1])
