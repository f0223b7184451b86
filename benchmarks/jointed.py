"""Does every jointed thing leave the house whole, as USD and as MJCF?

    python -m benchmarks.jointed [RUN ...] [--ovphysx PYTHON] [--usdcheck PYTHON] [--json FILE]

One scene for every row of `articulations.csv`, one for every other thing that joints hold, and the
compiled scenes below each RUN. Of each: OpenUSD's validators and usdchecker find no error, MuJoCo
loads and steps it, Newton's importer takes all of its bodies and joints with their masses,
NVIDIA's PhysX (`ovphysx`) plays it and keeps its joints together. Then the pendulums of
`benchmarks.joints`, as files, in those three.

`ovphysx` asks for other versions than this package does, and usd-core 26.3 is the last that has
usdchecker's rules: each PYTHON is the interpreter of a virtual environment of its own
(docs/usd.md). What has none is left out. The command fails if anything does.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
import json
import math
from pathlib import Path
import subprocess
import sys
import tempfile

import numpy as np

from benchmarks.analytic import DT, Film
from benchmarks.joints import kept, pendulums, period, positions
from esg.commands.console import table
from esg.compile.export import export
from esg.engines.manifest import load_manifest, manifest_bytes, manifest_to_json
from esg.engines.program import Program
from esg.engines.rollout_file import load_rollout
from esg.engines.scene import SimScene
from esg.scenefolder import is_scene_folder

PLAYER = Path(__file__).parents[1] / "docs" / "play_usd.py"
STEPS = 240
"""Of MuJoCo and Newton: a second."""
APART_M = {"rope": 0.03, "spring": math.inf}
"""How far anchors may come apart in `ovphysx`, which gives a rope 25 mm more; a spring is long."""
APART_ELSE_M = 5e-3
MASS = 1e-5
"""Share by which a mass may differ after the way through text."""

OTHERS = {
    "hanging thing": "A ball hangs from a beam by a rope.",
    "hanging load": "A crate hangs from a crane.",
    "weight on a spring": "A weight hanging from a spring bounces up and down.",
    "hitch": "A pickup truck tows a trailer down the road.",
    "towing rope": "A tractor pulls a log along the ground with a rope.",
    "rider": "A girl rides a skateboard into a crate.",
    "load of a seesaw": "A crate drops onto one end of a seesaw and launches a ball.",
    "rope that snaps": "The rope of a hanging flower pot snaps, and the pot falls to the ground.",
    "below a ceiling": "A lamp hanging from the ceiling is hit by a tennis ball.",
}
"""What joints hold that has no row with parts of its own, and a prompt of it."""

USDCHECK = """
import json, sys
from pxr import UsdUtils
for path in sys.argv[1:]:
    checker = UsdUtils.ComplianceChecker()
    checker.CheckCompliance(path)
    told = (checker.GetErrors(), checker.GetFailedChecks(), checker.GetWarnings())
    print(json.dumps([line for lines in told for line in lines]))
"""


@dataclass
class Left:
    """One scene and what each reader made of it; a missing value: not tried.

    Args:
        name: Row or scene.
        joints: Kinds of its joints.
        validators, usdchecker: What they object to.
        newton: Joints that its importer took.
        newton_masses: Whether bodies and masses are the scene's.
        mujoco: Whether it loads, has the joints and steps for a second without a warning.
        apart_m: The farthest that anchors came apart in `ovphysx`, by kind of joint.
        problems: What went wrong.
    """

    name: str
    joints: list[str] = field(default_factory=list)
    validators: list[str] = field(default_factory=list)
    usdchecker: list[str] | None = None
    newton: int = 0
    newton_masses: bool = False
    mujoco: bool = False
    apart_m: dict[str, float] | None = None
    problems: list[str] = field(default_factory=list)

    @property
    def whole(self) -> bool:
        """Whether nothing is wrong."""
        close = all(d <= APART_M.get(k, APART_ELSE_M) for k, d in (self.apart_m or {}).items())
        taken = self.newton == len(self.joints) and self.newton_masses
        said = self.validators or self.usdchecker or self.problems
        return bool(self.joints) and taken and self.mujoco and close and not said


def prompts() -> dict[str, str]:
    """A prompt for every jointed thing, by its name."""
    from esg.lexicon.articulations import articulations

    out: dict[str, str] = {}
    for row in dict.fromkeys(articulations().values()):
        # What stands open in use is jointed only where a prompt tells of its joint.
        seen = f"open {row.nouns[0]}" if row.start and row.carries == "becomes" else row.nouns[0]
        out[row.nouns[0]] = f"A ball rolls past the {seen}."
    return out | OTHERS


def compiled(prompt: str, folder: Path) -> None:
    """Writes a prompt's scene with its first guess, which nobody has searched on."""
    from esg.assets import resolve
    from esg.compile import compile_scene
    from esg.draft import draft
    from esg.dynamics import start_hints
    from esg.dynamics.casting import fitted
    from esg.dynamics.plan.build import build_scene
    from esg.dynamics.plan.planner import make_plan
    from esg.layout import solve

    doc = fitted(resolve(draft(prompt, seed=0), seed=0))
    doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
    plan = make_plan(doc, build_scene(doc), seed=0)
    compile_scene(doc, folder, scene=plan.scene, program=plan.compile(plan.initial()))


def check(name: str, folder: Path, out: Path, ovphysx: str) -> Left:
    """One compiled scene in every reader but usdchecker, which takes all at once."""
    scene = load_manifest(folder / "manifest.json").scene
    left = Left(name, [j.kind for j in scene.joints])
    files = export(folder, "usd", out)
    left.validators = _validated(files)
    left.newton, left.newton_masses = _in_newton(out / "scene.usda", scene)
    left.mujoco = _in_mujoco(export(folder, "mjcf", out)[0], scene)
    if ovphysx:
        left.apart_m = _in_ovphysx(out, scene, ovphysx)
    return left


def _validated(files: list[Path]) -> list[str]:
    from pxr import Usd, UsdValidation

    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    context = UsdValidation.ValidationContext(validators)
    serious = UsdValidation.ValidationErrorType.Error
    found = [e for path in files for e in context.Validate(Usd.Stage.Open(str(path)))]
    return [e.GetMessage() for e in found if e.GetType() == serious]


def _in_newton(usd: Path, scene: SimScene) -> tuple[int, bool]:
    import newton

    from esg.engines.newton import quiet_warp

    quiet_warp()
    builder = newton.ModelBuilder()
    builder.add_usd(str(usd))
    joints = sum(label.startswith("/World/Joints/") for label in builder.joint_label)
    masses = sorted(b.mass for b in scene.bodies if b.collides and not b.static)
    taken = sorted(builder.body_mass)
    return joints, len(taken) == len(masses) and np.allclose(taken, masses, rtol=MASS)


def _in_mujoco(mjcf: Path, scene: SimScene) -> bool:
    import mujoco

    model = mujoco.MjModel.from_xml_path(str(mjcf))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_step(model, data, STEPS)
    free = model.jnt_type == mujoco.mjtJoint.mjJNT_FREE
    # A cord is a tendon there, a ring an equality, and what is fixed to a body a part of it.
    parts = (model.body_parentid[1:] > 0) & (model.body_jntnum[1:] == 0)
    held = int((~free).sum()) + model.neq + model.ntendon + int(parts.sum())
    calm = np.isfinite(data.qpos).all() and data.warning.number.sum() == 0
    return bool(calm) and held >= len(scene.joints)


def _played(usd: Path, python: str) -> Path:
    record = usd.with_suffix(".npz")
    command = [python, str(PLAYER), str(usd), "--record", str(record)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr[-500:])
    return record


def _in_ovphysx(out: Path, scene: SimScene, python: str) -> dict[str, float]:
    """The farthest that anchors come apart [m], by kind; what may break is left out."""
    film = Film(scene, load_rollout(_played(out / "scene.usda", python)))
    apart: dict[str, float] = {}
    for joint in scene.joints:
        if joint.break_impulse is None or not math.isfinite(joint.break_impulse):
            gap = float(positions(film, joint)[1].max())
            apart[joint.kind] = max(apart.get(joint.kind, 0.0), round(gap, 5))
    return apart


def usdchecked(left: list[Left], work: Path, python: str) -> None:
    """Fills in what usdchecker says of each scene's layer and animation."""
    tried = [x for x in left if (work / x.name / "scene.usda").exists()]
    paths = [
        str(work / x.name / name) for x in tried for name in ("scene.usda", "scene_animation.usda")
    ]
    done = subprocess.run(
        [python, "-c", USDCHECK, *paths], capture_output=True, text=True, check=True
    )
    told = [json.loads(line) for line in done.stdout.splitlines()]
    for n, x in enumerate(tried):
        x.usdchecker = told[2 * n] + told[2 * n + 1]


def swings(work: Path, ovphysx: str) -> list[list[str]]:
    """The pendulums as files in other simulators: error of the period, of the amplitude kept."""
    rows: list[list[str]] = []
    for n, case in enumerate(pendulums()):
        folder = work / f"pendulum {n}"
        folder.mkdir(parents=True)
        told = manifest_to_json(case.scene, Program((), case.seconds), dt=DT)
        (folder / "manifest.json").write_bytes(manifest_bytes(told))
        usd = export(folder, "usd", folder)[0]
        row = [case.name.removeprefix("pendulum: ")]
        for path in _paths(folder, usd, case.scene, case.seconds, ovphysx):
            if isinstance(path, str):
                row.append(path)
                continue
            x, _, z = (path - (0.0, 0.0, 3.0)).T
            angles = np.unwrap(np.arctan2(-x, -z))
            late = abs(period(angles) / case.exact[0] - 1.0)
            row.append(f"{late:.3%}, {abs(kept(angles, case.exact[0]) - 1.0):.2%}")
        rows.append(row)
    return rows


def _paths(
    folder: Path, usd: Path, scene: SimScene, seconds: float, ovphysx: str
) -> Iterator[np.ndarray | str]:
    """Centre of the only body [m], shape [T, 3], or why there is none: a reader after another."""
    if ovphysx:
        yield Film(scene, load_rollout(_played(usd, ovphysx))).path(scene.names[0])
    else:
        yield ""
    try:
        yield _newton_path(usd, seconds)
    except (NotImplementedError, ValueError) as error:
        yield str(error).splitlines()[0]
    yield _mujoco_path(export(folder, "mjcf", folder)[0], seconds)


def _newton_path(usd: Path, seconds: float) -> np.ndarray:
    """In MuJoCo's solver; what hangs on the world is made an articulation first."""
    import newton

    builder = newton.ModelBuilder()
    builder.add_usd(str(usd))
    if not builder.articulation_start:
        builder.add_articulation(list(range(builder.joint_count)))
    model = builder.finalize(device="cpu")
    solver = newton.solvers.SolverMuJoCo(model)
    state, after = model.state(), model.state()
    newton.eval_fk(model, model.joint_q, model.joint_qd, state)
    com = model.body_com.numpy()[0].astype(float)
    out = [_world(state.body_q.numpy()[0], com)]
    for _ in range(round(seconds / DT)):
        state.clear_forces()
        solver.step(state, after, None, None, DT)
        state, after = after, state
        out.append(_world(state.body_q.numpy()[0], com))
    return np.array(out)


def _world(pose: np.ndarray, point: np.ndarray) -> np.ndarray:
    from esg.units import quat_rotate

    return pose[:3] + quat_rotate(pose[3:].astype(float), point)


def _mujoco_path(mjcf: Path, seconds: float) -> np.ndarray:
    import mujoco

    model = mujoco.MjModel.from_xml_path(str(mjcf))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    out = [data.xipos[1].copy()]
    for _ in range(round(seconds / DT)):
        mujoco.mj_step(model, data)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        out.append(data.xipos[1].copy())
    return np.array(out)


def run(runs: list[Path], work: Path, ovphysx: str, usdcheck: str) -> list[Left]:
    """All scenes.

    Args:
        runs: Folders of finished scenes.
        work: Empty folder.
        ovphysx, usdcheck: Interpreters that have them, "" for none.
    """
    folders = {name: work / "made" / name for name in prompts()}
    scenes = [p for run in runs for p in sorted(run.iterdir()) if is_scene_folder(p)]
    finished = {p.name: p for p in scenes if (p / "manifest.json").exists()}
    jointed = {n: p for n, p in finished.items() if load_manifest(p / "manifest.json").scene.joints}
    left: list[Left] = []
    for name, folder in (folders | jointed).items():
        try:
            if name in folders:
                compiled(prompts()[name], folder)
            left.append(check(name, folder, work / name, ovphysx))
        except Exception as error:
            left.append(Left(name, problems=[f"{type(error).__name__}: {error}"]))
    if usdcheck:
        usdchecked(left, work, usdcheck)
    return left


def text(left: list[Left]) -> str:
    """The sums, and whatever is not whole."""

    def sums(made: list[Left]) -> list[str]:
        checked = [x for x in made if x.usdchecker is not None]
        moved = [x for x in made if x.apart_m is not None]
        gaps = [g for x in moved for k, g in (x.apart_m or {}).items() if k not in APART_M]
        return [
            str(len(made)),
            str(sum(len(x.joints) for x in made)),
            str(sum(not x.validators for x in made)),
            f"{sum(not x.usdchecker for x in checked)} of {len(checked)}",
            str(sum(x.newton == len(x.joints) and x.newton_masses for x in made)),
            str(sum(x.mujoco for x in made)),
            f"{len(moved)}, {1e3 * max(gaps, default=0.0):.1f} mm",
        ]

    names = prompts()
    groups = (
        ["things", *sums([x for x in left if x.name in names])],
        ["scenes of runs", *sums([x for x in left if x.name not in names])],
    )
    head = ["", "scenes", "joints", "validators", "usdchecker", "newton", "mujoco", "ovphysx"]
    lines = [table(head, [g for g in groups if g[1] != "0"])]
    lines += [json.dumps(asdict(x)) for x in left if not x.whole]
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("runs", type=Path, nargs="*", metavar="RUN")
    parser.add_argument("--ovphysx", default="", metavar="PYTHON")
    parser.add_argument("--usdcheck", default="", metavar="PYTHON")
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        left = run(options.runs, Path(folder), options.ovphysx, options.usdcheck)
        print(text(left))
        rows = swings(Path(folder), options.ovphysx)
    print(table(["period, amplitude kept", "ovphysx", "newton", "mujoco"], rows))
    if options.json:
        lines = ",\n".join(json.dumps(asdict(x)) for x in left)
        options.json.write_text(f'{{"scenes": [\n{lines}\n]}}\n', "utf-8")
    sys.exit(0 if all(x.whole for x in left) else 1)


if __name__ == "__main__":
    main()
