"""Rollouts: Newton (reference), PhysX (verify) and Rapier (audit) behind one interface.

`get_engine` returns an engine; `available` says which can be used here, `warmup`
compiles what Newton needs before a user's first scene has to wait for it.
"""

from __future__ import annotations

from collections.abc import Callable

from esg.engines.base import ENGINES, VERIFY_DT_S, Engine
from esg.engines.registry import get_engine

__all__ = ["ENGINES", "VERIFY_DT_S", "Engine", "available", "get_engine", "warmup"]


def available() -> dict[str, tuple[bool, str]]:
    """Which engines can run here.

    Returns:
        For each name in `ENGINES`: (True, version) or (False, reason).
    """
    from esg.engines.doctor import available as run

    return run()


def warmup(
    progress: Callable[[str, int, int], None] | None = None, device: str = "cpu"
) -> dict[str, float]:
    """Compiles and caches the Newton kernels that scenes need (minutes once, then a second).

    Args:
        progress: Called before each step with (what, steps done, steps in all).
        device: Warp device.

    Returns:
        Seconds each step took.
    """
    from esg.engines.doctor import warmup as run

    return run(progress, device)
