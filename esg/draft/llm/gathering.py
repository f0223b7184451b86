"""Drafts of many prompts through request files: what is drafted, what waits, what to do next."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
import os
from pathlib import Path
from typing import Any

from esg.draft.llm.drafter import draft_llm_batch
from esg.draft.llm.records import LlmDraft, Variant
from esg.draft.llm.requestfiles import CASSETTE, PROBLEMS, REQUESTS, Problem, RequestFiles
from esg.draft.llm.settings import ENV_PREFIX, LlmSettings, load_settings

TOLD = 20
"""Problems that a message lists."""


@dataclass(frozen=True)
class Gathered:
    """State of a folder of request files after a pass.

    Args:
        folder: Of requests and answers.
        drafts: One a prompt, in order; those that wait have `waiting`.
        requests: Number of open requests.
        problems: What is wrong with answers.
    """

    folder: Path
    drafts: tuple[LlmDraft, ...]
    requests: int
    problems: tuple[Problem, ...]

    @property
    def waiting(self) -> int:
        """Number of scenes that wait."""
        return sum(d.waiting for d in self.drafts)

    def data(self) -> dict[str, Any]:
        """The state as plain JSON."""
        by_stage: dict[str, int] = {}
        for draft in self.drafts:
            if draft.waiting:
                at = f"{len(draft.calls) + 1}"
                by_stage[at] = by_stage.get(at, 0) + 1
        return {
            "folder": str(self.folder),
            "scenes": len(self.drafts),
            "waiting": self.waiting,
            "requests": self.requests,
            "requests_file": str(self.folder / REQUESTS) if self.requests else None,
            "by_reply": dict(sorted(by_stage.items())),
            "cassette": str(self.folder / CASSETTE),
            "problems": [vars(p) for p in self.problems],
        }

    def text(self) -> str:
        """The state and what to do next, for people."""
        lines = [f"answers: {p}" for p in self.problems[:TOLD]]
        if len(self.problems) > TOLD:
            lines.append(f"answers: {len(self.problems) - TOLD} more in {self.folder / PROBLEMS}")
        if self.requests:
            lines += [
                f"{self.waiting} of {len(self.drafts)} scenes wait for {self.requests} answers.",
                f"  Requests: {self.folder / REQUESTS} (form of the OpenAI batch interface).",
                "  Put the answers (custom_id, response.body) into the same folder as a .jsonl "
                "file of any other name, and run the same command again.",
            ]
        return "\n".join(lines)


def gather(
    prompts: Sequence[str],
    folder: Path,
    *,
    seed: int | Sequence[int] = 0,
    settings: LlmSettings | None = None,
    variant: Variant = "full",
) -> Gathered:
    """Drafts as far as the answers in a folder go, and writes the open requests.

    Args:
        prompts: English descriptions; equal ones with equal seeds share their requests.
        folder: Created when needed.
        seed: One for all, or one a prompt.
        settings: Default: from the environment; no server is needed, and none is asked.
        variant: As of `draft_llm`.

    Raises:
        UserError: If the folder cannot be read or written.
    """
    config = (settings or load_settings()).model_copy(
        update={"image_model": None, "cassette": None, "cache": None}
    )
    files = RequestFiles(folder, config.secret)
    drafts = draft_llm_batch(prompts, seed=seed, settings=config, variant=variant, client=files)
    files.write()
    return Gathered(folder, drafts, files.waiting, tuple(files.problems))


@contextmanager
def replaying(folder: Path) -> Generator[None]:
    """Lets drafts in this process, and in those that it starts, come from a folder's answers."""
    values = {"CASSETTE": str((folder / CASSETTE).resolve()), "CASSETTE_MODE": "replay"}
    told = {f"{ENV_PREFIX}{k}": v for k, v in values.items()}
    silent = [f"{ENV_PREFIX}IMAGE_MODEL", f"{ENV_PREFIX}CACHE"]
    before = {k: os.environ.get(k) for k in (*told, *silent)}
    os.environ.update(told)
    for name in silent:
        os.environ.pop(name, None)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value
