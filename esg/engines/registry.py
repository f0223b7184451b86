"""Engines by name."""

from __future__ import annotations

from esg.engines.base import ENGINES, SURROGATE, Engine
from esg.outcomes import UserError


def get_engine(name: str, device: str = "cpu") -> Engine:
    """The engine called `name`; imports it only now.

    Raises:
        UserError: For an unknown name, or a device the engine does not run on.
    """
    if name == "newton":
        from esg.engines.newton.engine import NewtonEngine

        return NewtonEngine(device=device)
    if name == "physx":
        from esg.engines.physx_engine import PhysxEngine

        return PhysxEngine()
    if name == "rapier":
        from esg.engines.rapier_engine import RapierEngine

        return RapierEngine()
    if name == SURROGATE:
        from esg.engines.surrogate.engine import SurrogateEngine

        return SurrogateEngine(device=device)
    raise UserError(f"unknown engine {name!r}; choose one of {', '.join(ENGINES)}")
