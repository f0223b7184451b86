"""Answers to the requests as program files, with where they come from.

    python -m benchmarks.rivals.scene_language.answers ANSWERS.jsonl --model "..." --date 2026-11-23

A line is {"custom_id": "S1-0", "content": "..."}, or a line of a batch interface's output file.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
import re
from typing import Any

from benchmarks.rivals.scene_language.requests import PUBLISHED

PROGRAMS = Path(__file__).parent / "programs"
_ID = re.compile(r"[A-Za-z]+\d+-\d+")


def content_of(row: dict[str, Any]) -> str:
    """The text of an answer."""
    if "content" in row:
        return str(row["content"])
    body = row.get("response", {}).get("body", row.get("response", {}))
    return str(body["choices"][0]["message"]["content"])


def program_of(content: str) -> str | None:
    """The program in an answer, as Scene Language takes it: the first block of Python."""
    found = re.search(r"```python\s*\n(.*?)\n```", content, re.S)
    return found[1].strip() + "\n" if found else None


def main() -> None:
    """Writes the programs and tells which answers hold none."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("answers", type=Path)
    parser.add_argument("--model", required=True)
    parser.add_argument("--date", required=True)
    parser.add_argument("--out", type=Path, default=PROGRAMS)
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    written = 0
    for line in args.answers.read_text("utf-8").splitlines():
        row = json.loads(line)
        name = str(row["custom_id"])
        program = program_of(content_of(row))
        if not _ID.fullmatch(name) or program is None:
            print(f"{name}: no program")
            continue
        head = (
            f"# Answer of {args.model}, {args.date}, to the request {name} of\n"
            "# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own\n"
            f"# prompts, {PUBLISHED.name}/); unchanged.\n"
        )
        (args.out / f"{name}.py").write_text(head + program, "utf-8")
        written += 1
    print(f"{written} programs in {args.out}")


if __name__ == "__main__":
    main()
