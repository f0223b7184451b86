"""Kernels whose source is read late are the kernels that warp would have made."""

from __future__ import annotations

from pathlib import Path
import subprocess
import sys
from textwrap import dedent

KERNELS = """
from typing import Any

import warp as wp

SIZE = wp.constant(3)

@wp.func
def called(x: float) -> float:
    return x * float(SIZE)

@wp.func
def never_called(x: float) -> float:
    return x

@wp.kernel
def kernel(a: wp.array(dtype=float)):
    i = wp.tid()
    a[i] = called(a[i]) + float(wp.static(SIZE + 1))

@wp.kernel
def generic(a: wp.array(dtype=Any)):
    i = wp.tid()
    a[i] = a[i] + a[i]
"""
ASK = """
import contextlib, sys
from esg.engines.newton import quiet_warp, unread
wp = quiet_warp()
with unread() if sys.argv[1] == "unread" else contextlib.nullcontext():
    import some_kernels as k
read = [f.key for f in (k.called, k.never_called, k.kernel) if "source" in vars(f.adj)]
module = wp.get_module("some_kernels")
print(module.get_module_hash().hex(), "source" in vars(k.never_called.adj), read)
a = wp.array([1.0, 2.0], dtype=float, device="cpu")
wp.launch(k.kernel, dim=2, inputs=[a], device="cpu")
wp.launch(k.generic, dim=2, inputs=[a], device="cpu")
print(a.numpy().tolist(), module.get_module_hash().hex())
"""


def test_late_kernels_are_the_same(tmp_path: Path) -> None:
    (tmp_path / "some_kernels.py").write_text(KERNELS)
    told = {}
    for how in ("unread", "as usual"):
        command = [sys.executable, "-c", dedent(ASK), how]
        done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, check=False)
        assert done.returncode == 0, done.stderr
        told[how] = done.stdout.splitlines()
    late, usual = (lines[0].split(" ", 2) for lines in told.values())
    assert late[0] == usual[0]
    assert told["unread"][1] == told["as usual"][1]
    assert told["unread"][1].startswith("[14.0, 20.0]")
    assert usual[2].count(",") == 2
    assert "called" not in late[2]
    assert late[2].strip() == "['kernel']"  # what is static is evaluated where it is declared
