"""The physical scene that our own exports carry: bodies, shapes, masses, regions and program."""

from __future__ import annotations

from typing import Any

from esg.engines.manifest import Manifest, manifest_from_json
from esg.judging.recording import Faults
from esg.outcomes import UserError


def manifest_of(data: Any, faults: Faults) -> Manifest:
    """A manifest that a file carries.

    Args:
        data: JSON values.
        faults: Of the file.

    Raises:
        UserError: If it does not hold.
    """
    try:
        return manifest_from_json(data)
    except (UserError, ValueError, TypeError, RecursionError) as error:
        first = " ".join(str(error).split())[:300]
        raise faults.fail(f"the manifest in it does not hold: {first}") from None
