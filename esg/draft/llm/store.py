"""Replies kept for later: a cache by content hash, and cassettes that replay without a server."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import asdict
from functools import lru_cache
import json
from pathlib import Path
from typing import Any, Literal

from esg.draft.llm.client import Call, Client, ModelFailure, Reply
from esg.files import atomic_file
from esg.outcomes import UserError
from esg.strangers.scrubbing import scrub

VERSION = 1


def record_of(call: Call, reply: Reply, secret: str) -> dict[str, Any]:
    """A recorded reply with its request, without the key."""
    return {
        "version": VERSION,
        "key": call.key,
        "stage": call.stage,
        "model": call.model,
        "messages": [[role, scrub(text, secret)] for role, text in call.messages],
        "reply": {**asdict(reply), "text": scrub(reply.text, secret)},
    }


def _record(call: Call, reply: Reply, secret: str) -> str:
    return json.dumps(record_of(call, reply, secret), sort_keys=True, ensure_ascii=False)


def _reply(record: Any) -> Reply:
    reply = record["reply"]
    return Reply(
        str(reply["text"]),
        int(reply["input_tokens"]),
        int(reply["output_tokens"]),
        bool(reply["cut_off"]),
        str(reply.get("model", "")),
    )


class CachingClient:
    """Keeps each reply in a file named by the request's hash.

    Args:
        inner: Asked for what is not kept yet.
        folder: Created when needed; a damaged file counts as absent.
        secret: Never written.
    """

    def __init__(self, inner: Client, folder: Path, secret: str = "") -> None:
        self.inner = inner
        self.folder = folder
        self.secret = secret

    async def complete(self, call: Call) -> Reply:
        path = self.folder / call.key[:2] / f"{call.key}.json"
        with suppress(OSError, ValueError, KeyError, TypeError):
            return _reply(json.loads(path.read_text(encoding="utf-8")))
        reply = await self.inner.complete(call)
        if not reply.cut_off:
            write_whole(path, _record(call, reply, self.secret) + "\n")
        return reply


def write_whole(path: Path, text: str) -> None:
    """Writes a file under a temporary name and renames it, so that nobody reads half of it.

    Raises:
        UserError: If the folder cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_file(path) as file:
            file.write(text.encode())
    except OSError as error:
        raise UserError(f"{path} cannot be written: {error.strerror}.", exit_code=1) from None


class CassetteClient:
    """Replays recorded replies and records new ones.

    Args:
        inner: Asked for what is not recorded; None in mode "replay".
        path: JSON Lines file, one reply a line.
        mode: "replay" never asks; "auto" asks for what is missing; "record" asks for everything.
        secret: Never written.

    Raises:
        UserError: If the file cannot be read.
    """

    def __init__(
        self,
        inner: Client | None,
        path: Path,
        mode: Literal["auto", "record", "replay"] = "auto",
        secret: str = "",
    ) -> None:
        self.inner = inner
        self.path = path
        self.mode = mode
        self.secret = secret
        self.records = {} if mode == "record" else read_cassette(path, missing_ok=mode == "auto")
        if mode == "record":
            write_whole(path, "")

    async def complete(self, call: Call) -> Reply:
        if call.key in self.records:
            return _reply(self.records[call.key])
        if self.inner is None or self.mode == "replay":
            raise ModelFailure(
                "refused",
                f"the cassette {self.path} holds no reply to this {call.stage} request; record "
                "it again (the prompt, the model, the seed or the instructions have changed)",
                retryable=False,
            )
        reply = await self.inner.complete(call)
        line = _record(call, reply, self.secret)
        self.records[call.key] = json.loads(line)
        try:
            with self.path.open("a", encoding="utf-8") as file:
                file.write(line + "\n")
        except OSError as error:
            message = f"Cassette {self.path} cannot be written: {error.strerror}."
            raise UserError(message, exit_code=1) from None
        return reply


def read_cassette(path: Path, *, missing_ok: bool = False) -> dict[str, Any]:
    """Records of a cassette by the hash of their request.

    Raises:
        UserError: If the file is missing or a line is no record.
    """
    if missing_ok and not path.exists():
        return {}
    try:
        stamp = path.stat()
    except OSError as error:
        raise UserError(f"Cassette {path} cannot be read: {error}.") from None
    return dict(_records(path, stamp.st_mtime_ns, stamp.st_size))


@lru_cache(maxsize=4)
def _records(path: Path, changed_ns: int, size: int) -> dict[str, Any]:
    """The records of a file as it was then: a dataset's scenes all read the same one."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise UserError(f"Cassette {path} cannot be read: {error}.") from None
    records: dict[str, Any] = {}
    for number, line in enumerate(lines, 1):
        if not line.strip():
            continue
        try:
            record = json.loads(line)
            _reply(record)
            if record["version"] != VERSION:
                raise ValueError(f"version {record['version']!r}, expected {VERSION}")
            records[str(record["key"])] = record
        except (ValueError, KeyError, TypeError) as error:
            message = f"Cassette {path}, line {number}, is no recorded reply: {error!r}."
            raise UserError(message) from None
    return records
