"""Starting is quick because next to nothing is imported: counted, since seconds depend on the load."""

from __future__ import annotations

import os
from pathlib import Path
import subprocess
import sys

import pytest

ROOT = Path(__file__).parents[2]
HEAVY = {
    "PIL", "av", "duckdb", "fastapi", "newton", "numpy", "onnxruntime", "pandas", "prefect", "pxr",
    "pyarrow", "pydantic", "rapier3d", "sapien", "scipy", "shapely", "spacy", "sqlalchemy",
    "starlette", "torch", "trimesh", "uvicorn", "warp", "yaml",
}  # fmt: skip
COUNT = """
import sys
before = set(sys.modules)
{work}
own = sorted(set(sys.modules) - before)
print(len(own), *(m for m in own if m.partition(".")[0] in {heavy!r}))
"""
HELP = """
sys.argv = ["esg", "--help"]
from esg.cli import main
try:
    main()
except SystemExit:
    pass
"""


@pytest.mark.parametrize(("work", "most"), [("import esg", 8), (HELP, 300)], ids=["import", "help"])
def test_starting_imports_next_to_nothing(work: str, most: int) -> None:
    done = subprocess.run(
        [sys.executable, "-c", COUNT.format(work=work, heavy=HEAVY)], capture_output=True,
        text=True, env={**os.environ, "PYTHONPATH": str(ROOT)}, timeout=120, check=True,
    )  # fmt: skip
    count, *heavy = done.stdout.splitlines()[-1].split()
    assert heavy == []
    assert int(count) <= most
