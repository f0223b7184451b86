"""What resolving common things must not load: mesh libraries and the embedding model take seconds."""

from __future__ import annotations

import json
import subprocess
import sys

HEAVY = ("trimesh", "scipy", "networkx", "onnxruntime")
SCRIPT = """
import json, sys
from esg.draft import draft
from esg.assets.stage import resolve
resolve(draft(sys.argv[1]), seed=0)
print(json.dumps([name for name in sys.argv[2:] if name in sys.modules]))
"""


def test_cars_and_synonyms_are_resolved_without_meshes_or_a_model() -> None:
    prompt = "A car hits a trashbin on the sidewalk and pushes it into a lamp post."
    run = subprocess.run(
        [sys.executable, "-c", SCRIPT, prompt, *HEAVY], capture_output=True, text=True, check=True
    )
    assert json.loads(run.stdout) == []
