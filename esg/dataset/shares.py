"""A batch in shares: its search has a device to itself, and any core makes what comes around it.

    draft_share, of every share -> search_batch -> prove_share, of every share -> close_batch

At the end of a run on many cores, where there are fewer batches than workers, they make the shares
of what is left (`make_share`).

Each is a call of its own, in whatever process has time for it. What one has made lies in the
batch's store under keys of its content, and only the states of the scenes travel: a batch that was
killed anywhere finds it all again, as one that is made in one piece does.
"""

from __future__ import annotations

from collections.abc import Sequence

from esg.costs.spent import Meter
from esg.dataset.batch import leave, timed, whole
from esg.dataset.job import BatchJob, BatchResult
from esg.dataset.running import SCENE_STAGES, batch_store, run_stages, with_alternatives
from esg.machine.memory import give_back
from esg.pipeline import SceneState

_SEARCH = SCENE_STAGES.index("optimize")
DRAFT, SEARCH, PROOF = SCENE_STAGES[:_SEARCH], ("optimize",), SCENE_STAGES[_SEARCH + 1 :]


def make_share(share: BatchJob) -> BatchResult:
    """All of a share at once, where each scene is searched by itself.

    Raises:
        OSError: If it cannot be written; finished stages are kept.
    """
    spent = Meter()
    with spent.on("batch"):
        result = whole(share, spent)
    give_back()
    return timed(result, spent)


def draft_share(share: BatchJob) -> list[SceneState]:
    """The scenes of a share as far as a search can take them over."""
    states = [SceneState(scene.request) for scene in share.scenes]
    with batch_store(share):
        return run_stages(share, states, DRAFT, Meter())


def search_batch(job: BatchJob, states: Sequence[SceneState]) -> list[SceneState]:
    """The scenes of a whole batch, searched.

    Args:
        job: The batch.
        states: What `draft_share` returned, of all shares in order.
    """
    with batch_store(job):
        searched = run_stages(job, states, SEARCH, Meter())
    give_back()
    return searched


def prove_share(share: BatchJob, states: Sequence[SceneState]) -> BatchResult:
    """Compiles, replays and judges the scenes of a share and writes what they leave.

    Args:
        share: The share.
        states: Of its scenes, searched.

    Raises:
        OSError: If it cannot be written; finished stages are kept.
    """
    spent = Meter()
    before = [entry for state in states for entry in state.log]
    with spent.on("batch"), batch_store(share):
        made = with_alternatives(share, run_stages(share, states, PROOF, spent))
        result = leave(share, made, spent)
    seconds = sum(float(entry["seconds"]) for entry in before)
    give_back()
    spent.add("batch", seconds, sum(float(entry.get("core_seconds", 0.0)) for entry in before))
    return timed(result, spent)
