"""Kept answers of a model, found by what was asked, and tokens counted by a stated proxy.

A cassette fits the instructions that it was recorded with to the letter. When these have changed
since (a further jointed thing in a list), an answer to the same prompt is still worth scoring, as
long as it is said how many were given to other instructions.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
import json
from pathlib import Path
from typing import Any

from esg.draft.llm.client import Call, ModelFailure, Reply
from esg.draft.llm.store import read_cassette
from esg.outcomes import UserError

ENCODING = "o200k_base"
"""A vocabulary of 200,000 tokens that the package `bpe-openai` brings along."""


def counter() -> Callable[[str], int]:
    """Counts the tokens of a text by `ENCODING`: a proxy for a model's own tokenizer.

    Raises:
        UserError: If the package is not installed.
    """
    try:
        import bpe_openai  # pyright: ignore[reportMissingImports]  # optional, for this figure only
    except ImportError:
        raise UserError(
            'Tokens are counted with the package "bpe-openai": pip install bpe-openai'
        ) from None
    encoding: Any = bpe_openai.get_encoding(ENCODING)  # pyright: ignore[reportUnknownMemberType]

    @cache
    def count(text: str) -> int:
        return len(encoding.encode_ordinary(text))

    return count


class KeptAnswers:
    """Answers requests from a cassette: by the whole request, else by its stage and messages.

    Args:
        path: JSON Lines file of a cassette.
        count: Counts the tokens of a text, for replies that came without; None leaves them at 0.
    """

    def __init__(self, path: Path, count: Callable[[str], int] | None = None) -> None:
        self.path, self.count = path, count
        self.records: dict[str, Any] = read_cassette(path, missing_ok=False)
        self.by_messages = {_asked(r["stage"], r["messages"]): r for r in self.records.values()}
        self.exact = self.other = 0

    async def complete(self, call: Call) -> Reply:
        """The kept reply.

        Raises:
            ModelFailure: If there is none to these messages.
        """
        record = self.records.get(call.key)
        self.exact += record is not None
        if record is None:
            record = self.by_messages.get(_asked(call.stage, call.messages))
            self.other += record is not None
        if record is None:
            told = f"{self.path} holds no answer to this {call.stage} request"
            raise ModelFailure("refused", told, retryable=False)
        reply = record["reply"]
        counted = (int(reply["input_tokens"]), int(reply["output_tokens"]))
        if self.count is not None and not any(counted):
            counted = (self._sent(call, self.count), self.count(reply["text"]))
        return Reply(str(reply["text"]), *counted, bool(reply["cut_off"]), str(reply["model"]))

    @staticmethod
    def _sent(call: Call, count: Callable[[str], int]) -> int:
        """Tokens of instructions, schema and messages; not those of a chat's own frame."""
        schema = json.dumps(call.schema, separators=(",", ":")) if call.schema else ""
        return sum(map(count, (call.instructions, schema, *(text for _, text in call.messages))))

    def text(self) -> str:
        """How many requests were answered as they are now, and how many as they were then."""
        return (
            f"{self.exact} requests as they were answered, {self.other} with the same messages and "
            "other instructions"
        )


def _asked(stage: str, messages: Any) -> str:
    return json.dumps([stage, [list(m) for m in messages]])
