"""The folder of a dataset: its plan, its lock, and the marks of finished batches.

meta/plan.json          the specification: what a resumed run must agree with
meta/prompts.jsonl      the prompts, if they came from a file
meta/layouts.json       layouts that it was asked to have (esg.dataset.layouts)
meta/run.json           when it began, software and machine (no part of the dataset)
parts/<table>/*.parquet finished batches; removed when the dataset is put together
marks/*.json            one a finished batch: the whole protocol of resuming
locks/, .lock-*         empty files that running processes hold
mcap/, previews/        recordings of scenes that get one
meshes/buffers/         what meshes are made of, once each (esg.dataset.meshes)
scenes/, trajectories/, ...  the dataset (esg.dataset.finish)
layouts/                the dataset again, as training code reads it
failures.jsonl, README.md, meta/info.json
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
import contextlib
import datetime
import json
import os
from pathlib import Path
import platform
from typing import TYPE_CHECKING

from filelock import FileLock, Timeout

from esg.dataset.job import BatchResult, batch_name
from esg.dataset.plan import DatasetSpec, Prompt, Shard, kept_prompts, prompts_text
from esg.files import atomic_file
from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.dataset.remote import Remote
    from esg.store.records import RunInfo

PLAN = Path("meta") / "plan.json"
PROMPTS = Path("meta") / "prompts.jsonl"
RUN = Path("meta") / "run.json"
INFO = Path("meta") / "info.json"


class DatasetFolder:
    """A dataset's folder on this machine.

    Args:
        path: The folder; need not exist.
        label: What messages call it; default the path.
    """

    def __init__(self, path: Path, label: str = "") -> None:
        self.path = path
        self.label = label or str(path)

    def begin(self, spec: DatasetSpec, prompts: Sequence[Prompt], *, resume: bool) -> RunInfo:
        """Makes the folder, or checks that it holds this very dataset.

        Args:
            spec: What is to be made.
            prompts: Its prompts, if they come from a file.
            resume: Whether an existing dataset may be continued.

        Returns:
            The run that everything in the folder belongs to.

        Raises:
            UserError: If the folder holds something else, or a dataset and `resume` is not set.
        """
        found = self.spec()
        if found is not None:
            if not resume:
                state = "is complete" if self.finished() else "was begun"
                raise UserError(
                    f"{self.label} holds a dataset that {state}; add --resume to go on with it "
                    "(finished scenes are kept), or choose another --out"
                )
            differences = spec.differences(found)
            if differences:
                lines = "\n".join(f"  {d}" for d in differences)
                raise UserError(
                    f"{self.label} was begun with other settings; repeat those, or choose another "
                    f"--out:\n{lines}"
                )
        elif self.path.exists() and any(
            p for p in self.path.iterdir() if not p.name.startswith(".") and not _is_unbegun(p)
        ):
            raise UserError(f"{self.label} holds files but no dataset; choose another --out")
        run = self._run(spec)
        if found is None:
            if prompts:
                self._write(PROMPTS, prompts_text(prompts))
            self._write(PLAN, json.dumps(spec.model_dump(mode="json"), indent=2, sort_keys=True))
        return run

    def spec(self) -> DatasetSpec | None:
        """The specification of the dataset in the folder, None if there is none.

        Raises:
            UserError: If it is damaged or of another version.
        """
        path = self.path / PLAN
        try:
            data = path.read_bytes()
        except (FileNotFoundError, NotADirectoryError):
            return None
        except OSError as error:
            raise UserError(f"{path} cannot be read: {error.strerror}") from None
        try:
            return DatasetSpec.model_validate_json(data)
        except ValueError as error:
            reason = str(error).splitlines()[0]
            raise UserError(
                f"{path} is damaged or of another version ({reason}); choose another --out"
            ) from None

    def prompts(self) -> list[Prompt]:
        """The kept prompts, none for a sampled dataset.

        Raises:
            UserError: If they are damaged.
        """
        path = self.path / PROMPTS
        if not path.is_file():
            return []
        try:
            return kept_prompts(path.read_text("utf-8"))
        except ValueError:
            raise UserError(f"{path} is damaged; choose another --out") from None

    def finished(self) -> bool:
        """Whether the dataset has been put together."""
        return (self.path / INFO).is_file()

    def done(self, numbers: Sequence[int], remote: Remote | None = None) -> dict[int, BatchResult]:
        """Results of the finished ones among some batches.

        Args:
            numbers: Of the batches.
            remote: Where the dataset is, if it is elsewhere: the marks there count, and those here
                of batches that have not arrived do not.
        """
        if remote is None:
            found = ((n, read_mark(self.path, n)) for n in numbers)
            return {n: result for n, result in found if result is not None}
        there = set(remote.names("marks"))
        wanted = [n for n in numbers if mark_name(n) in there]
        remote.pull(self.path, [mark_name(n) for n in wanted])
        return self.marked(wanted)

    def marked(self, numbers: Sequence[int]) -> dict[int, BatchResult]:
        """Results by their marks alone, wherever their files are by now."""
        found = ((n, read_mark(self.path, n, parts=False)) for n in numbers)
        return {n: result for n, result in found if result is not None}

    def run(self) -> RunInfo:
        """The run that everything in the folder belongs to.

        Raises:
            FileNotFoundError: If no dataset was begun here.
            UserError: If it is damaged.
        """
        from esg.store.records import RunInfo

        path = self.path / RUN
        try:
            data = json.loads(path.read_text("utf-8"))
            data["started_at"] = datetime.datetime.fromisoformat(data["started_at"])
            return RunInfo(**data)
        except (ValueError, KeyError, TypeError):
            raise UserError(f"{path} is damaged; choose another --out") from None

    def _run(self, spec: DatasetSpec) -> RunInfo:
        now = current_run(spec)
        try:
            run = self.run()
        except (FileNotFoundError, NotADirectoryError):
            data = {**vars(now), "started_at": now.started_at.isoformat()}
            self._write(RUN, json.dumps(data, indent=2, sort_keys=True))
            return now
        if run.code_version != now.code_version and not self.finished():
            raise UserError(
                f"{self.label} was begun with version {run.version} (code {run.code_version}) of "
                f"this software; this is {now.version} (code {now.code_version}), and scenes of "
                "two versions do not mix: finish it with the former, or choose another --out"
            )
        return run

    def _write(self, name: Path, text: str) -> None:
        try:
            with atomic_file(self.path / name) as file:
                file.write(f"{text.rstrip()}\n".encode())
        except OSError as error:
            raise UserError(
                f"cannot write to --out {self.label}: {error.strerror or error}", exit_code=1
            ) from None

    @contextlib.contextmanager
    def locked(self, shard: Shard) -> Generator[None]:
        """Holds a shard of the folder; the system lets go of it when the process dies.

        Raises:
            UserError: If another process works on the same shard.
        """
        path = self.path / f".lock-{shard.index}-of-{shard.count}"
        fresh = not path.exists()
        lock = FileLock(path, blocking=False)
        try:
            lock.acquire()
        except Timeout:
            raise UserError(
                f"another process is working on {self.label}; wait for it, give each its own "
                "--shard, or choose another --out"
            ) from None
        except OSError as error:
            raise UserError(f"cannot write to --out {self.label}: {error.strerror}") from None
        try:
            yield
            if self.finished():
                path.unlink(missing_ok=True)
        except UserError:
            if fresh and not (self.path / PLAN).exists():
                path.unlink(missing_ok=True)  # a folder of somebody else
            raise
        finally:
            lock.release()


def _is_unbegun(path: Path) -> bool:
    """Whether this is all there is of a dataset that another shard just begins, or whose
    beginning a kill or a full disk cut off.
    """
    if path.name != PLAN.parent.name or not path.is_dir():
        return False
    known = {PROMPTS.name, RUN.name}
    return all(p.name in known or p.name.startswith(".") for p in path.iterdir())


@contextlib.contextmanager
def batch_lock(out: Path, number: int) -> Generator[None]:
    """Waits for and holds a batch: of several processes that make it, one works at a time."""
    with FileLock(out / "locks" / batch_name(number)):
        yield


@contextlib.contextmanager
def finish_lock(out: Path) -> Generator[None]:
    """Waits for and holds the right to put the dataset together."""
    with FileLock(out / ".lock-finish"):
        yield
        if (out / INFO).is_file():
            remove_locks(out)


def remove_locks(out: Path) -> None:
    """Removes the lock files of a finished dataset that no other process holds.

    Whoever waits for one, or opened it before, finds the dataset finished.
    """
    for path in out.glob(".lock-*"):
        with contextlib.suppress(OSError), contextlib.ExitStack() as held:
            if path.name != ".lock-finish":  # held by the caller
                held.enter_context(FileLock(path, blocking=False))
            path.unlink(missing_ok=True)


def current_run(spec: DatasetSpec) -> RunInfo:
    """A run of a dataset that begins now."""
    import hashlib

    from esg import __version__
    from esg.codeversion import code_version
    from esg.pipeline import STAGES
    from esg.stages import REPLAY_RATE_HZ
    from esg.store.records import RunInfo

    versions = "".join(code_version(stage) for stage in STAGES)
    return RunInfo(
        run_id=spec.name(),
        kind="dataset",
        started_at=datetime.datetime.now(datetime.UTC),
        strategy=spec.strategy,
        engine=spec.engine,
        dt_s=1.0 / REPLAY_RATE_HZ,
        version=__version__,
        code_version=hashlib.sha256(versions.encode()).hexdigest()[:16],
        machine=f"{platform.machine()}, {os.cpu_count()} cores, {spec.device}",
    )


def write_mark(out: Path, result: BatchResult) -> None:
    """Says that a batch is done; its files are complete by then."""
    with atomic_file(out / mark_name(result.number)) as file:
        file.write(result.to_json().encode())


def mark_name(number: int) -> str:
    """Where a batch's mark is in the dataset's folder."""
    return f"marks/{batch_name(number)}.json"


def read_mark(out: Path, number: int, *, parts: bool = True) -> BatchResult | None:
    """What came of a finished batch; None if it is not finished or a file of it is missing.

    Args:
        out: Folder of the dataset.
        number: Of the batch.
        parts: Whether its files must be there.
    """
    path = out / mark_name(number)
    try:
        result = BatchResult.from_json(path.read_text("utf-8"))
    except (OSError, ValueError, TypeError):
        return None
    if not parts or (out / INFO).is_file():
        return result  # the parts have become the dataset
    for name, size in result.files.items():
        try:
            if (out / name).stat().st_size != size:
                return None
        except OSError:
            return None
    return result
