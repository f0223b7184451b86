"""The benchmark with kills of nodes: it finds whole families, and clusters bear it."""

from __future__ import annotations

from collections import defaultdict
import json
import os
from pathlib import Path
import subprocess
import sys
import time

import pytest

from benchmarks.cluster import Node, end, look, unfinished
from benchmarks.resume import alive

_FAMILY = """
import subprocess, sys, threading, time
child = "import sys, time; f = open(sys.argv[1]); time.sleep(600)"
middle = "import subprocess, sys; subprocess.run([sys.executable, '-c', *sys.argv[1:]])"
start = lambda: subprocess.run([sys.executable, "-c", middle, child, sys.argv[1]])
threading.Thread(target=start).start()
time.sleep(600)
"""
"""Its grandchild, below a child that a thread started, holds a file open."""


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_who_makes_a_batch_is_found_and_dies_with_the_node(tmp_path: Path) -> None:
    for folder in ("locks", "marks"):
        (tmp_path / folder).mkdir()
    lock = tmp_path / "locks" / "batch-000007"
    lock.touch()
    process = subprocess.Popen([sys.executable, "-c", _FAMILY, str(lock)])
    node, makers = Node("node-1", 1, process), defaultdict[int, set[int]](set)
    deadline = time.monotonic() + 60
    while not node.making and time.monotonic() < deadline:
        look([node], tmp_path, makers)
    assert (node.making, node.most) == ({7}, 1)
    (maker,) = makers[7]
    assert maker != process.pid
    assert unfinished(tmp_path, node.making) == {7}
    end(process)
    assert not alive(maker)
    (tmp_path / "marks" / "batch-000007.json").touch()
    assert unfinished(tmp_path, node.making) == set()


@pytest.mark.slow
@pytest.mark.parametrize(("runner", "package"), [("dask", "prefect_dask"), ("ray", "prefect_ray")])
def test_a_dataset_survives_its_nodes(tmp_path: Path, runner: str, package: str) -> None:
    """Made with a node killed and one evicted, it has the bytes that one machine makes."""
    pytest.importorskip(package)
    told = tmp_path / "told.json"
    call = [
        *(sys.executable, "-m", "benchmarks.cluster", "--runner", runner, "--json", str(told)),
        *("--scenes", "8", "--batch", "2", "--nodes", "2", "--slots", "1", "--kills", "2"),
        *("--shortest", "0.5", "--longest", "2", "--options", "--strategy none --previews none"),
    ]
    root = Path(__file__).parents[2]
    done = subprocess.run(
        call, env={**os.environ, "PYTHONPATH": str(root)}, cwd=tmp_path, timeout=1200, check=False,
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    found = json.loads(told.read_text())
    assert (found["kills"], found["differences"]) == (2, [])
    assert found["made_twice"] == found["lost"] != []
