"""What the studio was asked for: one scene at a time, a queue that shows, a history that stays.

Every change of a job is a line of `studio.jsonl` in the studio's folder, so that a server that was
killed knows afterwards what was asked, what came of it, and what it did not come to.
"""

from __future__ import annotations

from collections.abc import Callable
import contextlib
from dataclasses import asdict, dataclass, fields, replace
import json
from pathlib import Path
import threading
import time
from typing import Any, Literal

from esg.outcomes import Outcome, UserError
from esg.pipeline import STAGES, SceneRequest, SceneState, run_scene
from esg.progress import StageEvent, listening
from esg.scenefolder import publish
from esg.workers import WorkerPool

LOG = "studio.jsonl"
MOST_WAITING = 50
"""Scenes that may wait at once."""
Status = Literal["waiting", "running", "done", "failed", "cancelled", "interrupted"]
_OPEN = ("waiting", "running")


@dataclass(frozen=True)
class Job:
    """One scene that somebody asked for.

    Args:
        id: Counts up from 1.
        prompt, seed: What was asked.
        document: The changed scene graph that stands for the draft; empty for none.
        status: How far it is.
        asked_at: Time of asking [s since 1970].
        stages: Of those that ran or run: name, seconds (None while it runs), whether it was found
            in the cache.
        folder: Name of the scene folder in the studio's; empty while there is none.
        outcome, reason: How the scene ended.
    """

    id: int
    prompt: str
    seed: int
    document: str = ""
    status: Status = "waiting"
    asked_at: float = 0.0
    stages: tuple[tuple[str, float | None, bool], ...] = ()
    folder: str = ""
    outcome: str = ""
    reason: str = ""

    def to_json(self) -> dict[str, Any]:
        """For the page: all but the document, of which it says whether there is one; advice."""
        row = asdict(self)
        row["advice"] = Outcome(self.outcome).advice if self.outcome else ""
        row["edited"] = bool(row.pop("document"))
        row["stages"] = [
            {"name": name, "seconds": seconds, "cached": cached}
            for name, seconds, cached in self.stages
        ]
        return row


class Jobs:
    """The jobs of a studio.

    Args:
        folder: Where scene folders and the log go.
        pool: Makes the process that scenes are made in: one, replaced when a scene is cancelled.
    """

    def __init__(
        self, folder: Path, pool: Callable[[], WorkerPool] = lambda: WorkerPool(1)
    ) -> None:
        self.folder = folder
        self._make_pool, self._pool = pool, pool()
        self._changed = threading.Condition()
        self._version = 0
        self._ended = False
        folder.mkdir(parents=True, exist_ok=True)
        self._jobs = {job.id: job for job in _logged(folder / LOG)}
        for job in self.all():
            if job.status in _OPEN:
                self._set(replace(job, status="interrupted", reason="the studio was stopped"))
        self._thread = threading.Thread(target=self._work, name="esg-studio", daemon=True)
        self._thread.start()

    def all(self) -> list[Job]:
        """Every job, the oldest first."""
        with self._changed:
            return [self._jobs[k] for k in sorted(self._jobs)]

    def get(self, number: int) -> Job:
        """One job.

        Raises:
            UserError: If there is none of that number.
        """
        with self._changed:
            if number not in self._jobs:
                raise UserError(f"there is no job {number}")
            return self._jobs[number]

    def ask(self, prompt: str, seed: int, document: str = "") -> Job:
        """Puts a scene at the end of the queue.

        Raises:
            UserError: If too many wait already.
        """
        with self._changed:
            waiting = sum(job.status in _OPEN for job in self._jobs.values())
            if waiting >= MOST_WAITING:
                raise UserError(f"{waiting} scenes wait already; cancel some, or wait")
            number = max(self._jobs, default=0) + 1
            job = Job(number, prompt, seed, document, asked_at=round(time.time(), 3))
            self._set(job)
            return job

    def cancel(self, number: int) -> Job:
        """Takes a job out of the queue, or stops it; one that has ended stays as it is."""
        job = self.get(number)
        with self._changed:
            if job.status in _OPEN:
                self._set(replace(self._jobs[number], status="cancelled", reason="cancelled"))
        if job.status == "running":
            self._pool.stop()
        return self.get(number)

    def changed_since(self, seen: int, wait_s: float) -> int | None:
        """The number of the state that is not the one seen last, after waiting for it.

        Args:
            seen: Number of a state; -1 for none.
            wait_s: Longest wait [s]; after it the number may be the same.

        Returns:
            The number, None once the studio is closed.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._version != seen or self._ended, wait_s)
            return None if self._ended else self._version

    def close(self) -> None:
        """Stops what runs and the thread that waits for more."""
        with self._changed:
            self._ended = True
            self._changed.notify_all()
        self._pool.stop()
        self._thread.join(10.0)
        self._pool.close()

    def _set(self, job: Job) -> None:
        with self._changed:
            before = self._jobs.get(job.id)
            self._jobs[job.id] = job
            self._version += 1
            self._changed.notify_all()
            if before is None or before.status != job.status:
                line = json.dumps(asdict(job), ensure_ascii=False) + "\n"
                with (self.folder / LOG).open("a", encoding="utf-8") as log:
                    log.write(line)

    def _next(self) -> Job | None:
        """The next job, marked as running; None once the studio is closed."""

        def waiting() -> list[Job]:
            return [j for j in self.all() if j.status == "waiting"]

        with self._changed:
            self._changed.wait_for(lambda: self._ended or bool(waiting()))
            if self._ended:
                return None
            job = replace(waiting()[0], status="running")
            self._set(job)
            return job

    def _work(self) -> None:
        while (job := self._next()) is not None:
            with listening(lambda event, number=job.id: self._staged(number, event)):
                ended = self._run(job)
            if self.get(job.id).status == "running":
                self._set(replace(self.get(job.id), **ended))

    def _run(self, job: Job) -> dict[str, Any]:
        """Makes a scene; what changes in its job."""
        request = SceneRequest(job.prompt, job.seed, name=f"scene-{job.id}", document=job.document)
        try:
            state: SceneState = self._pool.run(run_scene, request)
            if self.get(job.id).status != "running":
                return {}
            folder = publish(state, self.folder)
        except KeyboardInterrupt:  # the pool was stopped: cancelled, or the studio closes
            self._renew()
            return {"status": "cancelled", "reason": "cancelled"}
        except Exception as error:
            self._renew()
            return {"status": "failed", "reason": str(error) or type(error).__name__}
        good = state.outcome is not None and state.outcome.has_scene
        return {
            "status": "done" if good else "failed",
            "folder": folder.name,
            "outcome": state.outcome.value if state.outcome else "",
            "reason": state.reason,
        }

    def _renew(self) -> None:
        if not self._ended:
            with contextlib.suppress(Exception):
                self._pool.close()
            self._pool = self._make_pool()

    def _staged(self, number: int, event: StageEvent) -> None:
        """Notes a stage of the running job that begins or has ended."""
        with self._changed:
            job = self._jobs[number]
            if job.status != "running" or event.stage not in STAGES:
                return
            before = tuple(s for s in job.stages if s[0] != event.stage)
            seconds = event.seconds if event.status == "finished" else None
            self._set(replace(job, stages=(*before, (event.stage, seconds, event.cached))))


def _logged(path: Path) -> list[Job]:
    """The last state of every job in a log; lines that were cut off are passed over."""
    known = {f.name for f in fields(Job)}
    found: dict[int, Job] = {}
    try:
        lines = path.read_text("utf-8", errors="replace").splitlines()
    except FileNotFoundError:
        return []
    for line in lines:
        with contextlib.suppress(ValueError, TypeError, KeyError, AttributeError):
            row = {k: v for k, v in json.loads(line).items() if k in known}
            row["stages"] = tuple((str(n), s, bool(c)) for n, s, c in row.get("stages", ()))
            found[int(row["id"])] = Job(**row)
    return list(found.values())
