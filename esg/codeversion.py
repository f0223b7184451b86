"""The version of a stage's code: what a cached result depends on besides its input.

A hash of the sources a stage can reach, plus the versions of the numerical libraries under it. An
edit of the layout stage thus invalidates layouts and everything after them, and no draft.
"""

from __future__ import annotations

from functools import cache
import hashlib
from importlib import metadata
from pathlib import Path

_ROOT = Path(__file__).parent
COMMON = (
    "graph",
    "engines/joints.py",
    "engines/program.py",
    "lexicon",
    "units.py",
    "thresholds.py",
    "untyped.py",
    "outcomes.py",
    "fidelity.py",
    "strangers",
    "__init__.py",
)
_SIMULATION = ("engines", "dynamics")
_PROOF = ("compile", *_SIMULATION, "assets", "metrics", "layout/problem/hints.py")

SOURCES: dict[str, tuple[str, ...]] = {
    "draft": ("draft",),
    "resolve": ("assets",),
    "cast": (
        "dynamics/__init__.py",
        "dynamics/story",
        "dynamics/choreography",
        "dynamics/casting",
        "engines/scene.py",
        "layout/problem",
        "assets",
        "metrics/liquids.py",
        "metrics/models.py",
        "metrics/plausibility",
    ),
    "layout": ("layout", "assets"),
    "optimize": (
        *_SIMULATION,
        "machine/kept.py",
        "machine/recent.py",
        "layout",
        "assets",
        "metrics/__init__.py",
        "metrics/geometry.py",
        "metrics/liquids.py",
        "metrics/models.py",
        "metrics/plausibility",
        "metrics/replay.py",
    ),
    "compile": _PROOF,
    "replay": ("machine", *_PROOF),
    "judge": (
        "metrics",
        "engines",
        "filming",
        "dynamics",
        "draft/document/coverage.py",
        "assets/colors.py",
    ),
    "dress": ("dressing", "engines", "assets"),
    "record": (
        "machine",
        "view",
        "dressing",
        "store",
        "assets",
        "metrics",
        "engines",
        "filming",
        "dynamics",
        "layout/problem/hints.py",
        "compile",
        "scenereading.py",
    ),
}
"""Parts of the package (files or folders below `esg/`) that each stage's result depends on."""

LIBRARIES: dict[str, tuple[str, ...]] = {
    "draft": ("spacy",),
    "resolve": ("trimesh", "onnxruntime"),
    "cast": ("trimesh", "onnxruntime"),
    "layout": ("warp-lang",),
    "optimize": ("newton", "warp-lang"),
    "compile": ("usd-core",),
    "replay": ("sapien", "newton", "rapier3d"),
    "judge": (),
    "dress": (),
    "record": ("newton", "mcap", "usd-core"),
}


@cache
def code_version(stage: str) -> str:
    """Hex digest of everything but input and configuration that determines a stage's result.

    Args:
        stage: A key of `SOURCES`.
    """
    digest = hashlib.sha256()
    for part in sorted({*COMMON, *SOURCES[stage], "stages.py"}):
        digest.update(f"{part}={_tree_hash(part)};".encode())
    for library in LIBRARIES[stage]:
        digest.update(f"{library}={_version(library)};".encode())
    return digest.hexdigest()[:16]


def sources_hash() -> str:
    """Hex digest of all files of the package."""
    return _tree_hash(".")


@cache
def _tree_hash(part: str) -> str:
    root = _ROOT / part
    files = [root] if root.is_file() else sorted(p for p in root.rglob("*") if p.is_file())
    digest = hashlib.sha256()
    for path in files:
        if "__pycache__" in path.parts or path.suffix == ".pyc":
            continue
        digest.update(path.relative_to(_ROOT).as_posix().encode())
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()


def _version(library: str) -> str:
    try:
        return metadata.version(library)
    except metadata.PackageNotFoundError:
        return "absent"
