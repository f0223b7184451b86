"""What dressing costs: `python -m benchmarks.places` makes ten scenes and tells their figures."""

from __future__ import annotations

import argparse
import time

from esg.dressing import dress
from esg.dressing.meshes import meshes_of
from esg.engines.rollout_file import load_rollout
from esg.pipeline import STAGES, SceneRequest, SceneState, run_stage
from esg.stages import ROLLOUT, load_doc, load_scene

PROMPTS = (
    "A car drives along the street and hits a trash bin at the kerb.",
    "A dog chases a cat across the park and knocks over a bench.",
    "A forklift pushes a pallet across the warehouse into a stack of boxes.",
    "In the kitchen, a cup slides off the table and falls to the floor.",
    "A ball rolls across the living room and knocks over a vase.",
    "A medicine ball rolls across the gym and hits a bench.",
    "A soccer ball bounces off the post and goes into the goal.",
    "A beach ball rolls along the beach and hits a parasol.",
    "A puck slides over the ice rink and hits the goal.",
    "In the workshop, a hammer falls off the workbench onto a toolbox.",
)


def finished(prompt: str, seed: int) -> SceneState:
    """A scene with its replay; from the store if it was made before."""
    state = SceneState(SceneRequest(prompt, seed=seed))
    for stage in STAGES[: STAGES.index("judge")]:
        state = run_stage(stage, state)
    return state


def main() -> int:
    """Prints a row a scene: processor time of stage and meshes [ms], things, triangles."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=0)
    seed = parser.parse_args().seed
    print(f"{'place':14} {'sky':12} {'dress':>6} {'meshes':>6} {'things':>6} {'triangles':>9}")
    for prompt in (PROMPTS[0], *PROMPTS):  # the first one twice: imports are not counted
        state = finished(prompt, seed)
        scene, _ = load_scene(state)
        rollout = load_rollout(state.artifact("replay") / ROLLOUT)
        document = load_doc(state)
        start = time.process_time()
        made = dress(document, scene, rollout, seed=seed).dressing
        middle = time.process_time()
        if made is None:
            continue
        meshes = list(meshes_of(made))
        end = time.process_time()
        triangles = sum(len(m.faces) for m in meshes)
        spent = f"{1e3 * (middle - start):6.0f} {1e3 * (end - middle):6.0f}"
        print(f"{made.place:14} {made.sky:12} {spent} {len(made.items):6} {triangles:9}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
