"""Requests that ask a language model for Scene Language programs, in its own published prompts.

`published/` holds what github.com/zzyunzhi/scene-language says to a model at commit 0942b1a (MIT
licence beside it): the header of its language and the animated example. The words around them are
those of its `scripts/run.py` and `scripts/run_utils.py`, with `--cond animate` in `exposed` mode.

    python -m benchmarks.rivals.scene_language.requests --out requests.jsonl
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

from esg.metrics import load_suite

PUBLISHED = Path(__file__).parent / "published"
SAMPLES = 5
"""A scene, as the paper ran every method."""
TEMPERATURE = 0.2
"""The default of its `scripts/run.py`."""

_RULES = """STRICTLY follow these rules:
1. Only use the functions and imported libraries in `helper.py`.
2. You can only write functions. Follow a modular approach and use the `register` decorator to define semantic shapes or shape groups. Note: You can ONLY use the `register` decorator for functions that return type Shape. Any helper functions that you attempt to register will cause an error.
3. Camera coordinate system: +x is right, +y is up, +z is backward. 
4. You must use `library_call` to call registered functions.
5. Use `compute_shape_*` from `helper.py` if possible to compute transformations.
"""  # noqa: E501  # as it was published
_SYSTEM = """\
You are a code completion model and can only write python functions wrapped within ```python```.

You are provided with the following `helper.py` which defines the given functions and definitions:
```python
{header}
```

{rules}

You should be precise and creative.
"""
_USER = '''Here are some examples of how to use `helper.py`:
```python
{example}
```
IMPORTANT: THE FUNCTIONS ABOVE ARE JUST EXAMPLES, YOU CANNOT USE THEM IN YOUR PROGRAM! 

Now, write a similar program for the given task:    
```python
from helper import *

"""
{task}
"""
```
'''  # as it was published


def messages(task: str) -> list[dict[str, str]]:
    """What Scene Language says to a model.

    Args:
        task: Description of the scene.
    """
    header = (PUBLISHED / "header.pyi").read_text("utf-8")
    example = (PUBLISHED / "oracle_0831_animation.py").read_text("utf-8")
    example = example[: example.index('if __name__ == "__main__":')]
    return [
        {"role": "system", "content": _SYSTEM.format(header=header, rules=_RULES)},
        {"role": "user", "content": _USER.format(example=example, task=task)},
    ]


def requests(suite: str, samples: int) -> list[dict[str, Any]]:
    """One request a scene and sample; `custom_id` is what its program is called."""
    return [
        {
            "custom_id": f"{scene.id}-{sample}",
            "temperature": TEMPERATURE,
            "messages": messages(scene.prompt),
        }
        for scene in load_suite(suite).scenes
        for sample in range(samples)
    ]


def main() -> None:
    """Writes the requests, a line each."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--suite", default="paper")
    parser.add_argument("--samples", type=int, default=SAMPLES)
    parser.add_argument("--out", type=Path, required=True)
    asked = parser.parse_args()
    rows = requests(asked.suite, asked.samples)
    text = "".join(json.dumps(row, ensure_ascii=False) + "\n" for row in rows)
    asked.out.write_text(text, "utf-8")
    print(f"{len(rows)} requests in {asked.out}")


if __name__ == "__main__":
    main()
