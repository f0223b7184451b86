"""Runs one program of a stranger in a process that has locked itself in, and prints its frames.

python -m benchmarks.rivals.scene_language.child < program.py
"""

from __future__ import annotations

import itertools
import json
from pathlib import Path
import random
import sys
import types
from typing import Any

import numpy as np

from benchmarks.rivals.scene_language import language
from esg.compile.trust.locks import lock

MEMORY_BYTES = 2**30
SECONDS = 20


def frames_of(program: str) -> dict[str, Any]:
    """Frames of a program, each a list of primitives with matrix, colour and calls.

    Args:
        program: Its text.
    """
    helper = types.ModuleType("helper")
    helper.__dict__.update(language.NAMES)
    sys.modules["helper"] = helper
    np.random.seed(0)
    random.seed(0)
    exec(compile(program, "program.py", "exec"), {"__name__": "program", **language.NAMES})
    if language.animations:
        frames = list(itertools.islice(language.animations[0](), language.MOST_FRAMES))
    else:
        # As published: the root is the last function that nobody else calls.
        frames = [list(language.library.values())[-1]["target"]()]
    docs = {name: entry["docstring"] for name, entry in language.library.items()}
    return {"frames": [_plain(frame) for frame in frames], "docs": docs}


def _plain(frame: Any) -> list[dict[str, Any]]:
    return [
        {
            "kind": item["kind"],
            "matrix": np.asarray(item["matrix"], float).tolist(),
            "color": item["color"],
            "stack": [[name, int(number)] for name, number in item["stack"]],
        }
        for item in language.concat_shapes(frame)
    ]


def main() -> None:
    """Reads a program, locks itself in, prints frames or what went wrong as JSON."""
    program = sys.stdin.read()
    answer, stdout = {}, sys.stdout
    sys.stdout = sys.stderr  # what the program prints is no answer
    np.linalg.norm(np.ones(3))
    lock(MEMORY_BYTES, SECONDS, [Path(sys.prefix), Path(sys.base_prefix)])
    try:
        answer = frames_of(program)
    except BaseException as error:  # whatever a program does ends here
        answer = {"error": f"{type(error).__name__}: {str(error)[:300]}"}
    json.dump(answer, stdout)
    stdout.flush()


if __name__ == "__main__":
    main()
