"""Reading the files of a scene folder back: they may have been cut off, edited or overwritten.

Every reader either gives values of the promised types or raises one `UserError` that names the
file, says what is wrong with it and what to do.
"""

from __future__ import annotations

from collections.abc import Callable
import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.engines.manifest import Manifest
    from esg.engines.scene import Rollout

REMEDY = "run the command that made it again; finished stages come from the cache"
MAX_REASON = 200
_Value = TypeVar("_Value")


def damaged(path: Path, why: str) -> UserError:
    """A file that cannot be used, in one line.

    Args:
        path: Of the file.
        why: What is wrong with it.
    """
    return UserError(f"{path} is damaged ({why}); {REMEDY}")


def first_line(error: BaseException) -> str:
    """The first line of a message that others wrote, cut to what a terminal shows."""
    lines = str(error).strip().splitlines() or [type(error).__name__]
    return lines[0][:MAX_REASON]


def collected(problems: list[str], read: Callable[[], _Value], otherwise: _Value) -> _Value:
    """What `read` gives, or `otherwise`, with the first line of what is wrong added to `problems`.

    Args:
        problems: Receives the message.
        read: A reader of this module.
        otherwise: What stands in for a file that cannot be used.
    """
    try:
        return read()
    except UserError as error:
        problems.append(str(error).splitlines()[0])
        return otherwise


def absent(path: Path) -> bool:
    """Whether there is nothing at `path`; a folder or a device there is damage, not absence."""
    return not path.exists()


def read_text(path: Path) -> str:
    """A text file.

    Raises:
        UserError: If it cannot be read or is not UTF-8.
    """
    try:
        return path.read_bytes().decode("utf-8")
    except OSError as error:
        raise damaged(path, error.strerror or str(error)) from None
    except UnicodeDecodeError as error:
        raise damaged(path, f"byte {error.start + 1} is not UTF-8") from None


def read_object(path: Path) -> dict[str, Any]:
    """A file with one JSON object, every number finite.

    Raises:
        UserError: If it holds anything else.
    """
    text = read_text(path)
    try:
        value = json.loads(text, parse_constant=_refuse, parse_float=_finite)
    except json.JSONDecodeError as error:
        what = "empty" if not text.strip() else f"not JSON: {error}"
        raise damaged(path, what) from None
    except ValueError as error:
        raise damaged(path, str(error)) from None
    except RecursionError:
        raise damaged(path, "nested too deeply") from None
    if not isinstance(value, dict):
        raise damaged(path, f"a JSON {type(value).__name__} where an object belongs")
    return value


def read_document(path: Path) -> dict[str, Any]:
    """A scene graph (`esg.json`) as JSON, its casting applied; {} if there is none.

    Raises:
        UserError: If it does not fit the schema.
    """
    if absent(path):
        return {}
    from esg.graph import canonical_json, effective
    from esg.graph.files import read_json
    from esg.graph.parsing import parse
    from esg.graph.violations import Findings

    found = Findings()
    raw = read_json(path, found)
    doc = None if raw is None else parse(raw, found).doc
    if doc is None or found.items:
        first, more = found.items[0], len(found.items) - 1
        what = f"{first.message.rstrip('.')}, at {first.pointer or '/'}"
        if more:
            what += f", and {more} more; esg check lists them"
        raise damaged(path, what)
    return json.loads(canonical_json(effective(doc)))


def read_metrics(path: Path) -> dict[str, Any]:
    """What the judge wrote (`metrics.json`); {} if there is nothing.

    Raises:
        UserError: If it is not what a judge writes.
    """
    if absent(path):
        return {}
    from pydantic import BaseModel, ConfigDict, Field, ValidationError

    strict = ConfigDict(extra="ignore", strict=True)

    class Lost(BaseModel):
        model_config = strict

        words: str
        start: int
        end: int
        status: str
        reason: str

    class Said(Lost):
        id: str
        says: str
        kept: bool | None
        measured: dict[str, float]

    class Measured(BaseModel):
        model_config = strict

        name: str
        unit: str
        ok: bool
        measured: float | None = None
        limit: float | None = None
        body: str = ""
        time_s: float | None = None
        note: str = ""

    class Plausible(BaseModel):
        model_config = strict

        plausible: bool
        worst: str = ""
        checks: list[Measured]

    class Facts(BaseModel):
        model_config = strict

        outcome: str = ""
        reason: str = ""
        advice: str = ""
        proof: str
        judged_against: str = ""
        verified: bool = False
        statements: list[Said] = Field(default_factory=list)
        not_kept: list[Lost] = Field(default_factory=list)
        plausibility: Plausible | None = None

    value = read_object(path)
    try:
        facts = Facts.model_validate(value).model_dump()
    except ValidationError as error:
        raise damaged(path, _first(error, "")) from None
    facts["verdict"] = _verdict(path, value, "verdict")
    if "own_timeline" in value:
        facts["own_timeline"] = _verdict(path, value, "own_timeline")
    return facts


def log_entries(text: str) -> tuple[tuple[dict[str, Any], ...], str]:
    """The entries that can be read, and what is wrong with the first that cannot.

    Args:
        text: Of `log.jsonl`.
    """
    entries: list[dict[str, Any]] = []
    wrong = ""
    for number, line in enumerate(text.splitlines(), 1):
        try:
            entry = json.loads(line, parse_constant=_refuse, parse_float=_finite)
        except (ValueError, RecursionError):
            entry = None
        if isinstance(entry, dict) and _is_entry(entry):
            entries.append(entry)
        else:
            wrong = wrong or f"line {number} is no log entry"
    if not entries or "outcome" not in entries[-1]:
        wrong = wrong or "its last line does not say how the scene ended"
    return tuple(entries), wrong


def read_manifest(path: Path) -> Manifest:
    """A compiled scene.

    Raises:
        UserError: If it breaks the schema.
    """
    from esg.engines.manifest import load_manifest

    try:
        return load_manifest(path)
    except UserError as error:
        why = str(error).replace(f"{path}: ", "").replace(f"{path} is ", "")
        raise damaged(path, ": ".join(why.splitlines()[:2])) from None


def read_rollout(path: Path, bodies: int) -> Rollout:
    """A recorded replay.

    Args:
        path: Of `rollout.npz`.
        bodies: How many the scene has.

    Raises:
        UserError: If it is no rollout, or not of this scene.
    """
    import zipfile
    import zlib

    import numpy as np

    from esg.engines.rollout_file import load_rollout

    try:
        rollout = load_rollout(path)
    except OSError as error:
        raise damaged(path, error.strerror or str(error)) from None
    except (ValueError, KeyError, TypeError, EOFError, zipfile.BadZipFile, zlib.error) as error:
        said = f": {error}" if type(error) is ValueError else f": {type(error).__name__}"
        raise damaged(path, f"not a recording{said}") from None
    frames = np.shape(rollout.time)
    want = (1, *frames, bodies)
    shapes = {
        "position": (*want, 3),
        "quaternion": (*want, 4),
        "linear_velocity": (*want, 3),
        "angular_velocity": (*want, 3),
    }
    off = [name for name, shape in shapes.items() if getattr(rollout, name).shape != shape]
    if len(frames) != 1 or not frames[0] or off:
        what = f"{off[0]} has shape {getattr(rollout, off[0]).shape}" if off else "no frames"
        raise damaged(path, f"not a recording of these {bodies} bodies: {what}")
    if not (math.isfinite(rollout.dt) and rollout.dt > 0 and np.isfinite(rollout.time).all()):
        raise damaged(path, "its times are not finite")
    return rollout


def _is_entry(entry: dict[str, Any]) -> bool:
    seconds = entry.get("seconds", 0.0)
    return (
        isinstance(seconds, int | float)
        and not isinstance(seconds, bool)
        and isinstance(entry.get("stage", ""), str)
        and isinstance(entry.get("outcome"), str | None)
        and isinstance(entry.get("reason"), str | None)
    )


def _verdict(path: Path, metrics: dict[str, Any], name: str) -> dict[str, Any]:
    from pydantic import ValidationError

    from esg.metrics import SceneVerdict

    raw = metrics.get(name)
    if not isinstance(raw, dict):
        raise damaged(path, f"/{name} is missing" if raw is None else f"/{name} is no object")
    try:
        return SceneVerdict.from_json(raw).to_json()
    except ValidationError as error:
        raise damaged(path, _first(error, f"/{name}")) from None


def _first(error: Any, place: str) -> str:
    first = error.errors(include_url=False)[0]
    where = place + "".join(f"/{part}" for part in first["loc"])
    return f"{where}: {first['msg'].lower()}"


def _refuse(name: str) -> float:
    raise ValueError(f"the number {name} is not finite")


def _finite(text: str) -> float:
    value = float(text)
    return value if math.isfinite(value) else _refuse(text)
