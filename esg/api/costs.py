"""What scenes took that were made."""

from __future__ import annotations

from collections.abc import Iterable
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.api.scene import Scene

LOG = "log.jsonl"


def cost(scenes: Iterable[Scene]) -> dict[str, Any]:
    """Seconds and core-hours a scene by stage, as `esg bench` and `esg dataset` end with.

    Args:
        scenes: Of `generate`, `generate_many` or `Scene.load`; stages from the cache cost nothing.
    """
    from esg.costs.spent import spent

    return spent(_log(Path(scene.folder)) for scene in scenes).to_json()


def _log(folder: Path) -> list[dict[str, Any]]:
    return [json.loads(row) for row in (folder / LOG).read_text(encoding="utf-8").splitlines()]
