"""Everything that leaves the house, checked on finished scenes: class, USD, MJCF, GLB, MCAP.

    esg bench data/suites/breadth.yaml --runs 1 --out runs/breadth
    python -m benchmarks.compile --suite runs/breadth [--json FILE]

Per scene: the class breaks no rule, compiles and runs; class and program agree in PhysX and in
Rapier; OpenUSD's validators find no error; the USD file loads in Newton with the right masses and
its first collision comes when PhysX's does; the MJCF file loads and steps in MuJoCo; Khronos'
validator finds no error in the GLB; the MCAP log reads back.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
import json
import math
from pathlib import Path
import shutil
import subprocess
import tempfile
from typing import Any

import numpy as np

from esg.compile import compile_many, replay_class
from esg.compile.build import ClassFiles, Library
from esg.compile.export import export
from esg.compile.names import unique_identifiers
from esg.engines.manifest import Manifest, load_manifest
from esg.engines.program import HoldVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Rollout
from esg.scenefolder import is_scene_folder

GLTF = Path(__file__).parents[2] / "tests" / "compile" / "gltf"
SETTLED_S = 0.05
"""Pairs that touch before this time lie on one another from the start."""

CLOSE_S = 0.1
"""How far apart in time two solvers may see the first collision."""

TOUCH_M = 0.002
STEPS = 240
NEWTON_ITERATIONS = 8
APART_M = 1e-3


@dataclass
class Report:
    """What was found out about one scene; a missing value means that it could not be tried."""

    scene: str
    bodies: int = 0
    compiles: bool = False
    runs: bool = False
    apart_m: dict[str, float] = field(default_factory=dict)
    same_contacts: dict[str, bool] = field(default_factory=dict)
    usd_errors: int | None = None
    newton_masses: bool | None = None
    newton_first: str | None = None
    mujoco_steps: bool | None = None
    glb_errors: int | None = None
    glb_warnings: int | None = None
    mcap_messages: int | None = None
    problems: list[str] = field(default_factory=list)


def check_scenes(run: Path) -> dict[str, Any]:
    """All checks on the compiled scenes below a folder.

    Args:
        run: Folder of scene folders.
    """
    folders = sorted(
        p for p in run.iterdir() if is_scene_folder(p) and (p / "manifest.json").exists()
    )
    libraries = compile_many([ClassFiles.read(p) for p in folders])
    reports: list[Report] = []
    with tempfile.TemporaryDirectory() as work:
        for folder, library in zip(folders, libraries, strict=True):
            reports.append(_check(folder, library, Path(work, folder.name)))
        _validate_glbs(reports, Path(work))
    return {"run": run.name, "totals": _totals(reports), "scenes": [asdict(r) for r in reports]}


def _check(folder: Path, library: Library | Exception, out: Path) -> Report:
    manifest = load_manifest(folder / "manifest.json")
    report = Report(folder.name, len(manifest.scene.bodies))
    report.compiles = isinstance(library, Library)
    if not report.compiles:
        report.problems.append(str(library))
        return report
    rollout: Rollout | None = None
    for engine in ("physx", "rapier"):
        replayed = replay_class(folder, engine=engine).rollout  # type: ignore[arg-type]
        batch = batch_programs([manifest.program], manifest.scene.names)
        program = get_engine(engine).rollout(manifest.scene, batch)
        one, two = first_touches(replayed), first_touches(program)
        late = max((abs(one[p] - two[p]) for p in one.keys() & two.keys()), default=0.0)
        report.same_contacts[engine] = one.keys() == two.keys() and late <= replayed.dt * 1.0001
        apart = float(np.abs(replayed.position - program.position).max())
        report.apart_m[engine] = round(apart, 9)
        if rollout is None:
            rollout = replayed
            report.runs = bool(replayed.valid.all())
    assert rollout is not None
    for name, step in (("usd", _usd), ("mjcf", _mjcf), ("glb", _glb), ("mcap", _mcap)):
        try:
            step(report, folder, manifest, rollout, out)
        except Exception as error:
            report.problems.append(f"{name}: {type(error).__name__}: {error}")
    return report


def first_touches(rollout: Rollout) -> dict[tuple[int, int], float]:
    """Time [s] of the first touch of every pair of bodies."""
    log, out = rollout.contacts, {}
    for a, b, t in zip(log.a.tolist(), log.b.tolist(), log.time.tolist(), strict=True):
        out.setdefault((a, b), t)
    return out


def _usd(report: Report, folder: Path, manifest: Manifest, rollout: Rollout, out: Path) -> None:
    from pxr import Usd, UsdValidation

    files = export(folder, "usd", out, rollout=rollout)
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    report.usd_errors = 0
    for path in files:
        errors = context.Validate(Usd.Stage.Open(str(path)))
        bad = [e for e in errors if e.GetType() == UsdValidation.ValidationErrorType.Error]
        report.usd_errors += len(bad)
        report.problems += [f"usd: {e.GetMessage()}" for e in bad]
    _newton(report, files[0], manifest, rollout)


def expected_first(manifest: Manifest, rollout: Rollout) -> tuple[str, str, float] | str:
    """First collision of the replay that the USD file can show, or why there is none to compare.

    UsdPhysics states velocities at the start and nothing later, so the collision must follow from
    those alone: commands of another kind or time before it make the file another scene.
    """
    names = manifest.scene.names
    hits = sorted((t, p) for p, t in first_touches(rollout).items() if t > SETTLED_S)
    if not hits:
        return "no collision"
    time, (a, b) = hits[0]
    for command in manifest.program.primitives:
        if isinstance(command, HoldVelocity):
            if command.start < time:
                return "motion under own power"
        elif manifest.dt / 2 < command.time < time:
            return "commands after the start"
    return names[a], names[b], time


def _newton(report: Report, usd: Path, manifest: Manifest, rollout: Rollout) -> None:
    import newton

    from esg.engines.newton import quiet_warp

    quiet_warp()
    builder = newton.ModelBuilder()
    builder.add_usd(str(usd))
    masses = sorted(b.mass for b in manifest.scene.bodies if b.collides and not b.static)
    report.newton_masses = bool(np.allclose(sorted(builder.body_mass), masses, rtol=1e-5))
    expected = expected_first(manifest, rollout)
    if isinstance(expected, str):
        report.newton_first = expected
        return
    idents = unique_identifiers(manifest.scene.names)
    pair = {idents[expected[0]], idents[expected[1]]}
    damping = _damping(usd)
    found = _newton_touch(newton, builder, pair, damping, expected[2] + 2 * CLOSE_S)
    if found is None:
        report.newton_first = "missed"
    elif abs(found - expected[2]) <= CLOSE_S:
        report.newton_first = "same"
    else:
        report.newton_first = f"{found - expected[2]:+.3f} s"


def _damping(usd: Path) -> dict[str, tuple[float, float]]:
    """Linear and angular damping [1/s] by prim name, which the file says beside UsdPhysics."""
    from pxr import Usd

    keys = ("physxRigidBody:linearDamping", "physxRigidBody:angularDamping")
    stage = Usd.Stage.Open(str(usd))
    return {
        prim.GetName(): tuple(float(prim.GetAttribute(k).Get()) for k in keys)
        for prim in stage.Traverse()
        if prim.HasAttribute(keys[0])
    }  # type: ignore[return-value]  # two keys, two numbers


def _newton_touch(
    newton: Any,
    builder: Any,
    pair: set[str],
    damping: dict[str, tuple[float, float]],
    until_s: float,
) -> float | None:
    """Time [s] at which the two named bodies of a loaded USD scene first touch in Newton."""
    names = [label.split("/")[-1] for label in builder.body_label]
    kept = np.ones((len(names), 6), np.float32)
    for i, name in enumerate(names):
        linear, angular = damping.get(name, (0.0, 0.0))
        kept[i, :3], kept[i, 3:] = 1.0 - linear / STEPS, 1.0 - angular / STEPS
    model = builder.finalize(device="cpu")
    owner = [label.split("/")[2] for label in model.shape_label]
    body = model.shape_body.numpy()
    solver = newton.solvers.SolverXPBD(model, iterations=NEWTON_ITERATIONS)
    state, after, contacts = model.state(), model.state(), model.contacts()
    for step in range(math.ceil(until_s * STEPS)):
        state.clear_forces()
        model.collide(state, contacts)
        n = int(contacts.rigid_contact_count.numpy()[0])
        ends = [getattr(contacts, f"rigid_contact_shape{k}").numpy()[:n] for k in (0, 1)]
        for i in range(n):
            if {owner[ends[0][i]], owner[ends[1][i]]} == pair:
                poses = state.body_q.numpy()
                points = [
                    _world(poses, body[ends[k][i]],
                           getattr(contacts, f"rigid_contact_point{k}").numpy()[i])
                    for k in (0, 1)
                ]  # fmt: skip
                normal = contacts.rigid_contact_normal.numpy()[i]
                thick = sum(
                    float(getattr(contacts, f"rigid_contact_margin{k}").numpy()[i]) for k in (0, 1)
                )
                if float(np.dot(normal, points[1] - points[0])) - thick < TOUCH_M:
                    return step / STEPS
        solver.step(state, after, None, contacts, 1.0 / STEPS)
        state, after = after, state
        state.body_qd.assign(state.body_qd.numpy() * kept)
    return None


def _world(poses: Any, body: int, point: Any) -> Any:
    from esg.units import quat_rotate

    if body < 0:
        return np.asarray(point, float)
    return poses[body, :3] + quat_rotate(poses[body, 3:].astype(float), np.asarray(point, float))


def _mjcf(report: Report, folder: Path, manifest: Manifest, rollout: Rollout, out: Path) -> None:
    import mujoco

    model = mujoco.MjModel.from_xml_path(str(export(folder, "mjcf", out)[0]))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    for _ in range(STEPS):
        mujoco.mj_step(model, data)
    report.mujoco_steps = bool(np.isfinite(data.qpos).all() and data.warning.number.sum() == 0)


def _glb(report: Report, folder: Path, manifest: Manifest, rollout: Rollout, out: Path) -> None:
    export(folder, "glb", out, rollout=rollout)


def _validate_glbs(reports: list[Report], work: Path) -> None:
    if not shutil.which("node") or not (GLTF / "node_modules").is_dir():
        return
    files = {r.scene: work / r.scene / "scene.glb" for r in reports}
    files = {scene: path for scene, path in files.items() if path.is_file()}
    command = ["node", str(GLTF / "validate.mjs"), *map(str, files.values())]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    found = dict(zip(files, json.loads(done.stdout), strict=True))
    for report in reports:
        if report.scene in found:
            report.glb_errors = found[report.scene]["numErrors"]
            report.glb_warnings = found[report.scene]["numWarnings"]


def _mcap(report: Report, folder: Path, manifest: Manifest, rollout: Rollout, out: Path) -> None:
    from mcap.reader import make_reader

    with (folder / "rollout.mcap").open("rb") as file:
        report.mcap_messages = sum(1 for _ in make_reader(file).iter_messages())


def _totals(reports: list[Report]) -> dict[str, Any]:
    def count(test: Any) -> int:
        return sum(bool(test(r)) for r in reports)

    tried = [r for r in reports if r.newton_first in ("same", "missed") or
             (r.newton_first or "").endswith(" s")]  # fmt: skip
    out: dict[str, Any] = {
        "scenes": len(reports),
        "lint and compile": count(lambda r: r.compiles),
        "run": count(lambda r: r.runs),
    }
    for engine in ("physx", "rapier"):
        out |= {
            f"class = program in {engine}: same contacts within a step": count(
                lambda r, e=engine: r.same_contacts.get(e)
            ),
            f"class = program in {engine}: within 1 mm": count(
                lambda r, e=engine: r.apart_m.get(e, math.inf) <= APART_M
            ),
            f"class = program in {engine}: largest distance [m]": max(
                (r.apart_m[engine] for r in reports if engine in r.apart_m), default=None
            ),
        }
    return out | {
        "USD without validator errors": count(lambda r: r.usd_errors == 0),
        "USD loads in Newton with its masses": count(lambda r: r.newton_masses),
        "USD in Newton: scenes whose first collision the file can show": len(tried),
        "USD in Newton: of these the same within 0.1 s": count(lambda r: r.newton_first == "same"),
        "MJCF loads and steps in MuJoCo": count(lambda r: r.mujoco_steps),
        "GLB without validator errors": count(lambda r: r.glb_errors == 0),
        "GLB without validator warnings": count(lambda r: r.glb_warnings == 0),
        "MCAP read back": count(lambda r: r.mcap_messages),
    }


def text(result: dict[str, Any]) -> str:
    """The totals and every problem."""
    lines = [f"{name:<62}{value}" for name, value in result["totals"].items()]
    for scene in result["scenes"]:
        lines += [f"{scene['scene']}: {p}" for p in scene["problems"]]
        if scene["newton_first"] == "missed" or str(scene["newton_first"]).endswith(" s"):
            lines.append(f"{scene['scene']}: first collision in Newton: {scene['newton_first']}")
    return "\n".join(lines)


def as_json(result: dict[str, Any]) -> str:
    """JSON with one line per scene."""
    head = json.dumps({k: v for k, v in result.items() if k != "scenes"}, indent=1)[:-2]
    scenes = ",\n".join(f"  {json.dumps(scene)}" for scene in result["scenes"])
    return f'{head},\n "scenes": [\n{scenes}\n ]\n}}\n'
