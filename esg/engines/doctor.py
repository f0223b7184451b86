"""Which engines work here, and compiling the Newton kernels ahead of the first scene."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
import itertools
import time

from esg.engines.base import ENGINES, SURROGATE
from esg.engines.joints import joint_between
from esg.engines.program import AdjustProperties, Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Body, Shape, ShapeKind, SimScene

_KINDS: tuple[ShapeKind, ...] = ("sphere", "box", "capsule", "cylinder", "convex")


def available() -> dict[str, tuple[bool, str]]:
    """Which engines can run here (`esg.engines.available`)."""
    out: dict[str, tuple[bool, str]] = {}
    for name in ENGINES:
        try:
            out[name] = (True, _version(name))
        except Exception as error:  # an import of a compiled package can fail in any way
            out[name] = (False, f"{type(error).__name__}: {error}")
    return out


def _version(name: str) -> str:
    if name == "newton":
        from importlib.metadata import version

        from esg.engines.newton.setup import quiet_warp

        wp = quiet_warp()
        devices = ", ".join(str(d) for d in wp.get_devices())
        return f"newton {version('newton')}, warp {version('warp-lang')} on {devices}"
    if name == "physx":
        from importlib.metadata import version

        from esg.engines.physx_engine import physx_module

        return f"PhysX {physx_module().version()} in sapien {version('sapien')}"
    import rapier3d

    return f"rapier3d {rapier3d.__version__}"


def warmup(
    progress: Callable[[str, int, int], None] | None = None, device: str = "cpu"
) -> dict[str, float]:
    """Runs a tiny scene for every combination of shapes that compiles kernels of its own.

    Newton specializes its narrow phase for the shape types of a model, so scenes of few kinds are
    covered one by one, the mixture of all kinds after them and joints last.
    """
    steps = tiny_scenes()
    seconds: dict[str, float] = {}
    for i, (what, scene) in enumerate(steps.items()):
        if progress is not None:
            progress(what, i, len(steps))
        start = time.perf_counter()
        play(scene, device)
        seconds[what] = time.perf_counter() - start
    if progress is not None:
        progress("done", len(steps), len(steps))
    return seconds


def tiny_scenes() -> dict[str, SimScene]:
    """What the scenes that compile kernels of their own consist of, and the scenes."""
    mixtures = [kinds for n in (1, 2) for kinds in itertools.combinations(_KINDS, n)] + [_KINDS]
    return {" + ".join(kinds): _scene(kinds) for kinds in mixtures} | {"joints": _jointed()}


def play(scene: SimScene, device: str = "cpu") -> None:
    """Plays a moment of a scene in Newton, with all that a program can do."""
    name = scene.bodies[0].name
    program = Program(
        (SetVelocity(name, 0.0, (1.0, 0.0, 0.0)), AdjustProperties(name, 0.0, friction=0.4)),
        0.05,
    )
    get_engine("newton", device).rollout(scene, batch_programs([program], scene.names))


def spheres(count: int) -> SimScene:
    """A row of so many spheres."""
    first = _scene(("sphere",)).bodies[0]
    return SimScene(
        "warmup",
        tuple(
            replace(first, name=f"sphere {k}", position=(0.3 * k, 0.0, 0.1)) for k in range(count)
        ),
    )


def load_kernels(device: str = "cpu") -> None:
    """Loads the kernels that nearly every search needs, by a moment of a tiny scene."""
    scene = _scene(("sphere", "box"))
    program = Program((SetVelocity(scene.bodies[0].name, 0.0, (1.0, 0.0, 0.0)),), 0.05)
    for name in (SURROGATE, "newton"):
        get_engine(name, device).rollout(scene, batch_programs([program], scene.names))


def _scene(kinds: tuple[ShapeKind, ...]) -> SimScene:
    """Two bodies of every kind that collide with each other and the ground."""
    sides = (-0.1, 0.1)
    corners = tuple((x, y, z) for x in sides for y in sides for z in sides)
    i = 0.004
    inertia = ((i, 0.0, 0.0), (0.0, i, 0.0), (0.0, 0.0, i))
    bodies = [
        Body(
            name=f"{kind} {k}",
            static=False,
            mass=1.0,
            inertia=inertia,
            shapes=(Shape(kind, (0.1, 0.1, 0.1), vertices=corners if kind == "convex" else ()),),
            position=(0.15 * (2 * i + k), 0.0, 0.1),
        )
        for i, kind in enumerate(kinds)
        for k in range(2)
    ]
    return SimScene("warmup", tuple(bodies))


def _jointed() -> SimScene:
    """A joint in a tree with all that it can do, one that may break, a rope and a spring."""
    scene = _scene(("sphere", "box"))
    first, second, third, fourth = scene.bodies
    joints = (
        replace(
            joint_between("hinge", "hinge", first, None, at=first.position),
            upper=1.0, damping=0.1, friction=0.1,
        ),
        replace(
            joint_between("ball", "ball", second, None, at=second.position),
            upper=1.0, break_impulse=9.0,
        ),
        replace(joint_between("rope", "rope", third, None, at=third.position), upper=1.0),
        replace(
            joint_between("spring", "spring", fourth, None, at=fourth.position),
            upper=0.1, stiffness=1.0,
        ),
    )  # fmt: skip
    return replace(scene, joints=joints)
