"""Judging files of trajectories: `esg.judge_trajectories`, what `esg judge` does."""

from __future__ import annotations

from collections.abc import Mapping
import csv
import json
from pathlib import Path
from typing import TYPE_CHECKING

from esg.api.inputs import checked, existing_file
from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.judging.verdict import Judged

MOST_NAMES_BYTES = 2**20


def judge_trajectories(
    file: str | Path,
    suite: str | Path,
    scene: str | None = None,
    *,
    names: Mapping[str, str] | str | Path | None = None,
    frame: str = "z-up",
) -> Judged:
    """Judges the motion that a file holds by a scene of a suite (docs/judging.md).

    Args:
        file: CSV, Parquet, NPZ, MCAP, GLB, USD or Kubric's metadata.json.
        suite: Suite file, or name of one that comes with the package: paper.
        scene: Id of the scene; default what the name of the file or of its folder says.
        names: Words for bodies of the file by name, or a JSON or CSV file of them.
        frame: Axes and units of formats that state none: z-up, y-up or unreal.

    Raises:
        UserError: With everything that is wrong.
    """
    from esg.judging.recording import FRAMES
    from esg.judging.verdict import judge_file, scene_for
    from esg.metrics import load_suite

    path = Path(file)
    if frame not in FRAMES:
        raise UserError(f"--frame {frame!r}: choose {', '.join(FRAMES)}")
    _, loaded, words = checked(
        lambda: existing_file(path, "trajectories"),
        lambda: load_suite(suite),
        lambda: load_names(names) if isinstance(names, str | Path) else dict(names or {}),
    )
    return judge_file(path, scene_for(path, loaded, scene), frame=frame, names=words)


def load_names(file: str | Path) -> dict[str, str]:
    """Words for bodies by name.

    Args:
        file: JSON object, or CSV with two columns and no head: name, words.

    Raises:
        UserError: If it is neither.
    """
    from esg.files import read_limited

    path = existing_file(Path(file), "--names")
    try:
        text = read_limited(path, MOST_NAMES_BYTES).decode("utf-8-sig")
    except (UnicodeDecodeError, OSError) as error:
        raise UserError(f"--names {path} cannot be read: {error}") from None
    if path.suffix.lower() == ".csv":
        rows = [row for row in csv.reader(text.splitlines()) if row]
        wrong = [
            k for k, row in enumerate(rows, 1) if len(row) != 2 or not all(map(str.strip, row))
        ]
        if wrong:
            raise UserError(f"--names {path}: line {wrong[0]} is not `name,words`")
        return {name.strip(): words.strip() for name, words in rows}
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UserError(f"--names {path} is no JSON: {error}") from None
    if not isinstance(data, dict) or not all(isinstance(v, str) for v in data.values()):
        raise UserError(f'--names {path}: write {{"name in the file": "words", ...}}')
    return {str(name): words for name, words in data.items()}
