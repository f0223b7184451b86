"""Checks of what people type: one clear message before any work starts."""

from __future__ import annotations

from pathlib import Path

from esg.outcomes import UserError

MAX_PROMPT_CHARS = 8000


def clean_prompt(prompt: str) -> str:
    """The prompt without surrounding space.

    Raises:
        UserError: If nothing is left, it holds control characters, or is unreasonably long.
    """
    text = prompt.strip()
    if not text:
        raise UserError('the prompt is empty; describe a scene, e.g. "A car hits a trash bin."')
    if any(ord(c) < 32 and c not in "\t\n\r" for c in text):
        raise UserError("the prompt holds control characters; give plain text")
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
        raise UserError(f"--seed {seed}: choose a number from 0")
    return seed


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


def check_device(device: str) -> str:
    """A device name.

    Raises:
        UserError: If it is neither cpu nor cuda:N, or the machine lacks it.
    """
    if device == "cpu":
        return device
    kind, _, number = device.partition(":")
    if kind != "cuda" or (number and not number.isdigit()):
        raise UserError(f"--device {device!r}: choose cpu or cuda:N")
    from esg.engines.newton_model import quiet_warp

    count = quiet_warp().get_cuda_device_count()
    if int(number or 0) >= count:
        raise UserError(f"--device {device}: this machine has {count} CUDA devices; use cpu")
    return f"cuda:{number or 0}"


def find_scene(scene: str) -> Path:
    """A scene folder by path or by id below ./runs.

    Raises:
        UserError: If there is none, or the id names several.
    """
    from esg.scenefolder import is_scene_folder

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
