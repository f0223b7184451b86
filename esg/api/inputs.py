"""Checks of what people type: one clear message before any work starts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar
from unicodedata import category

from esg.outcomes import UserError

Number = TypeVar("Number", int, float)

MAX_PROMPT_CHARS = 8000
MAX_WORKERS = 256


def checked(*checks: Callable[[], Any]) -> list[Any]:
    """Results of all checks.

    Args:
        checks: Each takes nothing and raises a `UserError` if something is wrong.

    Raises:
        UserError: With the mistakes of all of them.
    """
    results: list[Any] = []
    mistakes: list[UserError] = []
    for check in checks:
        try:
            results.append(check())
        except Mistakes as error:
            mistakes += error.mistakes
        except UserError as error:
            mistakes.append(error)
    if mistakes:
        raise Mistakes(mistakes)
    return results


class Mistakes(UserError):
    """Several mistakes in one message.

    Args:
        mistakes: At least one; a mistake of the user decides about the exit code.
    """

    def __init__(self, mistakes: Sequence[UserError]) -> None:
        self.mistakes = tuple(mistakes)
        code = 2 if any(m.exit_code == 2 for m in mistakes) else mistakes[0].exit_code
        super().__init__(listed([str(m) for m in mistakes]), exit_code=code)


def listed(problems: Sequence[str]) -> str:
    """One problem as it is, several with their number, a line each."""
    if len(problems) == 1:
        return problems[0]
    lines = [line for p in problems for line in p.splitlines()]
    return f"{len(problems)} problems" + "".join(f"\n  {line}" for line in lines)


def clean_prompt(prompt: str) -> str:
    """The prompt without surrounding space.

    Raises:
        UserError: If nothing is left, it holds what is no text, or is unreasonably long.
    """
    text = prompt.strip()
    if not text:
        raise UserError('the prompt is empty; describe a scene, e.g. "A car hits a trash bin."')
    bad = next((c for c in text if c not in "\t\n\r" and category(c) in ("Cc", "Cs")), None)
    if bad is not None:
        what = "a control character" if category(bad) == "Cc" else "a byte that is not UTF-8"
        place = text.index(bad) + 1
        raise UserError(f"the prompt holds {what} (character {place}); give plain text")
    if len(text) > MAX_PROMPT_CHARS:
        raise UserError(
            f"the prompt has {len(text)} characters; at most {MAX_PROMPT_CHARS} are read as a scene"
        )
    return text


def check_seed(seed: int) -> int:
    """A seed.

    Raises:
        UserError: If it is negative or larger than a generator takes.
    """
    if not 0 <= seed < 2**63:
        raise UserError(f"--seed {seed}: choose 0 to {2**63 - 1}")
    return seed


def in_range(option: str, value: Number, low: Number, high: Number) -> Number:
    """A number within bounds.

    Args:
        option: As it is typed, e.g. --runs.
        value: What was given.
        low, high: Smallest and largest that will do.

    Raises:
        UserError: If it is out of bounds or no number.
    """
    if not low <= value <= high:
        raise UserError(f"{option} {value}: choose {low} to {high}")
    return value


def check_workers(workers: int | None, low: int = 0) -> int | None:
    """A number of worker processes, None for one a core.

    Raises:
        UserError: If it is out of bounds.
    """
    return None if workers is None else in_range("--workers", workers, low, MAX_WORKERS)


def existing_file(path: Path, what: str) -> Path:
    """The path of a readable file.

    Raises:
        UserError: If it is missing, a folder or unreadable.
    """
    if not path.exists():
        raise UserError(f"{what} {path} does not exist")
    if not path.is_file():
        raise UserError(f"{what} {path} is not a file")
    try:
        with path.open("rb"):
            pass
    except OSError as error:
        raise UserError(f"{what} {path} cannot be read: {error.strerror}") from None
    return path


def check_target(option: str, path: Path, what: str) -> Path:
    """Finds out early whether a file can be written.

    Args:
        option: That names it, e.g. --json.
        path: The file; its folder may not exist yet.
        what: It is, e.g. a JSON file.

    Raises:
        UserError: If not.
    """
    from esg.scenefolder import check_writable

    if path.is_dir():
        raise UserError(f"{option} {path} is a folder; give {what}")
    try:
        check_writable(path.absolute().parent)
    except UserError as error:
        raise UserError(str(error).replace("--out", option)) from None
    return path


def check_cache() -> None:
    """Finds out early whether results can be kept on the way.

    Raises:
        UserError: If the cache folder cannot be written.
    """
    from esg.paths import cache_dir
    from esg.scenefolder import check_writable

    try:
        check_writable(cache_dir())
    except UserError as error:
        told = str(error).replace("--out", "the cache folder (ESG_CACHE_DIR)")
        raise UserError(told, exit_code=1) from None


def check_device(device: str) -> str:
    """A device name.

    Raises:
        UserError: If it is neither cpu nor cuda:N, or the machine lacks it.
    """
    if device == "cpu":
        return device
    kind, _, number = device.partition(":")
    if kind != "cuda" or (number and not (number.isdecimal() and len(number) < 4)):
        raise UserError(f"--device {device!r}: choose cpu or cuda:N")
    from esg.engines.newton import quiet_warp

    count = quiet_warp().get_cuda_device_count()
    if int(number or 0) >= count:
        raise UserError(f"--device {device}: this machine has {count} CUDA devices; use cpu")
    return f"cuda:{number or 0}"


def find_scene(scene: str, *, whole: bool = True) -> Path:
    """A scene folder by path or by id below ./runs, whatever is in which may be opened.

    Args:
        scene: Folder or id.
        whole: Whether pictures that are still being drawn into it are waited for; a note on stderr
            tells that they do not come.

    Raises:
        UserError: If there is none, the id names several, or something in it may not be opened.
    """
    from esg.notices import warn
    from esg.scenefolder.unfinished import settled
    from esg.strangers.folders import admitted

    found = admitted(_scene_at(scene))
    if whole:
        warn(filter(None, [settled(found)]))
    return found


def _scene_at(scene: str) -> Path:
    from esg.scenefolder import is_scene_folder

    if not scene.strip():
        raise UserError("SCENE is empty; give a scene folder or the id of one below runs/")
    path = Path(scene)
    if is_scene_folder(path):
        return path
    if path.exists():
        raise UserError(f"{scene} is not a scene folder (it lacks prompt.txt or log.jsonl)")
    runs = Path("runs")
    found = sorted(p for p in runs.glob(f"**/{path.name}") if is_scene_folder(p))
    if len(found) == 1:
        return found[0]
    if found:
        raise UserError(
            f"scene {scene!r} is ambiguous: {', '.join(map(str, found))}; give the path"
        )
    raise UserError(f"no scene folder {scene!r}, neither here nor below {runs}/")
