"""Request files: what a model is to be asked, and the answers that somebody puts beside them.

The forms are those of the OpenAI batch interface. A folder holds

    requests.jsonl    the open requests of all scenes; whoever has a model answers them
    *.jsonl           answers, in any number of files of any other name
    asked.jsonl       every request that was ever written: what an answer may belong to
    cassette.jsonl    all answers that were used, as recorded replies
    problems.jsonl    what is wrong with answers, where, and what to do

A `custom_id` is a hash of the whole request, so that an answer fits exactly one question.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
import json
from pathlib import Path
import re
from typing import Any

from esg.draft.llm.client import Call, Reply, Waiting
from esg.draft.llm.store import record_of, write_whole
from esg.outcomes import UserError
from esg.strangers.scrubbing import scrub
from esg.untyped import is_list, is_object

REQUESTS, ASKED, CASSETTE, PROBLEMS = (
    "requests.jsonl", "asked.jsonl", "cassette.jsonl", "problems.jsonl",
)  # fmt: skip
OWN = re.compile(r"(requests(-\d+)?|asked|cassette|problems)\.jsonl")
"""Files that are written here and hold no answers."""
URL = "/v1/chat/completions"
MOST_REQUESTS = 50_000
"""In one file: the limit of the OpenAI batch interface; more go to requests-2.jsonl ..."""
MAX_ANSWERS_BYTES = 1 << 30
NO_MODEL = "unnamed"
"""What the body says where no model is configured; the interface wants some name."""


@dataclass(frozen=True)
class Problem:
    """What is wrong with an answer.

    Args:
        kind: unreadable, incomplete, foreign, late, doubled, failed, empty or cut_off.
        file: Name of the answers file.
        line: Its line, from 1.
        custom_id: Of the request it names; "" if none can be read.
        message: What is wrong, and what was made of it.
        remedy: What to do.
    """

    kind: str
    file: str
    line: int
    custom_id: str
    message: str
    remedy: str

    def __str__(self) -> str:
        name = f" ({self.custom_id})" if self.custom_id else ""
        return f"{self.file}, line {self.line}{name}: {self.message} {self.remedy}"


@dataclass(frozen=True)
class _Answer:
    reply: Reply
    file: str
    line: int


@dataclass
class RequestFiles:
    """A client that answers from files, and writes down what it cannot answer.

    Args:
        folder: Created when needed.
        secret: Never written.

    Raises:
        UserError: If the folder or its files cannot be read.
    """

    folder: Path
    secret: str = ""
    problems: list[Problem] = field(default_factory=list[Problem])
    _answers: dict[str, _Answer] = field(default_factory=dict[str, _Answer])
    _asked: dict[str, dict[str, Any]] = field(default_factory=dict[str, dict[str, Any]])
    _open: dict[str, Call] = field(default_factory=dict[str, Call])
    _used: dict[str, Call] = field(default_factory=dict[str, Call])

    def __post_init__(self) -> None:
        self._asked = _ledger(self.folder / ASKED)
        for path in answer_files(self.folder):
            self._read(path)

    async def complete(self, call: Call) -> Reply:
        """The answer to a request.

        Raises:
            Waiting: If there is none; the request is open.
        """
        name = custom_id(call)
        if name in self._answers:
            self._used[name] = call
            return self._answers[name].reply
        self._open[name] = call
        raise Waiting(f"request {name} waits for its answer")

    @property
    def waiting(self) -> int:
        """Number of open requests."""
        return len(self._open)

    def write(self) -> None:
        """Writes all files anew, whole or not at all; the same answers give the same bytes.

        Raises:
            UserError: If the folder cannot be written.
        """
        for name, answer in self._answers.items():
            if name not in self._used and name not in self._open:
                self._told(
                    "late", answer.file, answer.line, name,
                    "answers a request that nobody asks any more: what it followed, or what is "
                    "drafted, has changed.",
                    "It is left out; nothing to do.",
                )  # fmt: skip
        for name, call in {**self._used, **self._open}.items():
            self._asked.setdefault(name, _entry(call))
        # First of all: an answer to a request that nobody remembers would be called foreign.
        _write(self.folder / ASKED, [{"custom_id": n, **v} for n, v in sorted(self._asked.items())])
        requests = [body_of(call, self.secret) for _, call in sorted(self._open.items())]
        parts = [requests[k : k + MOST_REQUESTS] for k in range(0, len(requests), MOST_REQUESTS)]
        for k, part in enumerate(parts or [[]]):
            name = REQUESTS if k == 0 else f"requests-{k + 1}.jsonl"
            _write(self.folder / name, part)
        for path in self.folder.glob("requests-*.jsonl"):
            if OWN.fullmatch(path.name) and int(path.stem.rpartition("-")[2]) > len(parts):
                path.unlink()
        records = [
            record_of(call, self._answers[name].reply, self.secret)
            for name, call in sorted(self._used.items())
        ]
        _write(self.folder / CASSETTE, records)
        _write(self.folder / PROBLEMS, [vars(p) for p in self.problems])

    def _told(self, kind: str, file: str, line: int, name: str, message: str, remedy: str) -> None:
        self.problems.append(Problem(kind, file, line, name, message, remedy))

    def _read(self, path: Path) -> None:
        """Takes the answers of one file; what cannot be used is told and its request stays open."""
        try:
            if path.stat().st_size > MAX_ANSWERS_BYTES:
                raise UserError(f"{path} is larger than {MAX_ANSWERS_BYTES} bytes; split it.")
            data = path.read_bytes()
        except OSError as error:
            raise UserError(f"{path} cannot be read: {error.strerror}.") from None
        for number, raw in enumerate(data.splitlines(), 1):
            if raw.strip():
                self._line(path.name, number, raw)

    def _line(self, file: str, number: int, raw: bytes) -> None:
        again = "Ask that request again; it is still in requests.jsonl."
        try:
            row: Any = json.loads(raw.decode("utf-8"))
        except (ValueError, RecursionError):
            self._told(
                "unreadable", file, number, _id_in(raw), "is no complete JSON object.",
                "If the file was cut off, put the whole one in its place; else ask that request "
                "again.",
            )  # fmt: skip
            return
        name = row.get("custom_id") if is_object(row) else None
        if not isinstance(name, str) or not name:
            self._told(
                "unreadable", file, number, "", "has no custom_id.",
                "Copy the custom_id of the request into its answer.",
            )  # fmt: skip
            return
        if name not in self._asked:
            self._told(
                "foreign", file, number, name, "answers a request that was never asked here.",
                "It is left out; put it into the folder that it belongs to.",
            )  # fmt: skip
            return
        found = _reply(row, self.secret)
        if isinstance(found, str):
            kind = "empty" if "empty" in found else "failed"
            self._told(kind, file, number, name, found, again)
            return
        first = self._answers.get(name)
        if first is not None:
            same = "the same" if first.reply.text == found.text else "another"
            self._told(
                "doubled", file, number, name,
                f"gives {same} answer again; the first is used ({first.file}, line {first.line}).",
                "Nothing to do, or remove the one that you do not want.",
            )  # fmt: skip
            return
        if found.cut_off:
            self._told(
                "cut_off", file, number, name, "stopped at the limit of its length.",
                "If it cannot be read, a briefer one is asked for; a higher limit "
                "(ESG_LLM_MAX_TOKENS) asks everything again.",
            )  # fmt: skip
        self._answers[name] = _Answer(found, file, number)


def custom_id(call: Call) -> str:
    """Name of a request: its stage, its round, and a hash of all that determines the answer."""
    return f"{call.stage}-r{call.round}-{call.key[:32]}"


def body_of(call: Call, secret: str = "") -> dict[str, Any]:
    """A request in the form of the OpenAI batch interface."""
    messages = [{"role": "system", "content": call.instructions}]
    messages += [{"role": role, "content": scrub(text, secret)} for role, text in call.messages]
    body: dict[str, Any] = {
        "model": call.model or NO_MODEL,
        "messages": messages,
        "max_tokens": call.max_tokens,
        "seed": call.seed,
    }
    if call.temperature is not None:
        body["temperature"] = call.temperature
    if call.schema:
        shape = {"name": call.stage, "schema": call.schema, "strict": False}
        body["response_format"] = {"type": "json_schema", "json_schema": shape}
    return {"custom_id": custom_id(call), "method": "POST", "url": URL, "body": body}


def answer_files(folder: Path) -> list[Path]:
    """Files of a folder that may hold answers, by name.

    Raises:
        UserError: If the folder cannot be read.
    """
    if not folder.exists():
        return []
    try:
        paths = sorted(folder.glob("*.jsonl"))
    except OSError as error:
        raise UserError(f"{folder} cannot be read: {error.strerror}.") from None
    return [p for p in paths if not OWN.fullmatch(p.name)]


def _entry(call: Call) -> dict[str, Any]:
    """What the ledger remembers of a request."""
    found = re.search(r"<<<\n(.*)\n>>>", call.messages[0][1], re.DOTALL)
    prompt = found[1] if found is not None else ""
    return {"stage": call.stage, "round": call.round, "seed": call.seed, "prompt": prompt[:200]}


def _ledger(path: Path) -> dict[str, dict[str, Any]]:
    out: dict[str, dict[str, Any]] = {}
    if not path.exists():
        return out
    try:
        for line in path.read_text(encoding="utf-8").splitlines():
            row = json.loads(line)
            out[str(row.pop("custom_id"))] = row
    except (OSError, ValueError, KeyError, AttributeError) as error:
        raise UserError(
            f"{path} cannot be read ({error!r}); it is written by esg and not meant to be changed. "
            "Without it answers are not recognized: restore it, or begin in a new folder."
        ) from None
    return out


def _reply(row: dict[str, Any], secret: str) -> Reply | str:
    """The reply of an answer's line; what is wrong with it, in words, if there is none."""
    if row.get("error"):
        return f"says that the request failed: {scrub(str(row['error']), secret)[:200]}."
    response = row.get("response")
    if not is_object(response):
        return "has no response."
    status = response.get("status_code", 200)
    body = response.get("body")
    if status != 200 or not is_object(body):
        return f"has status {status} and no usable body."
    choices = body.get("choices")
    choice = choices[0] if is_list(choices) and choices else None
    message = choice.get("message") if is_object(choice) else None
    text = message.get("content") if is_object(message) else None
    if is_object(text):
        text = json.dumps(text, ensure_ascii=False)  # some put the object itself there
    if not isinstance(text, str) or not text.strip():
        return "is empty."
    assert is_object(choice)
    usage = body.get("usage")
    counts = usage if is_object(usage) else {}
    return Reply(
        scrub(text, secret),
        _count(counts.get("prompt_tokens")),
        _count(counts.get("completion_tokens")),
        choice.get("finish_reason") == "length",
        str(body.get("model") or ""),
    )


def _count(value: Any) -> int:
    return value if isinstance(value, int) and not isinstance(value, bool) and value > 0 else 0


def _id_in(raw: bytes) -> str:
    """The custom_id in a line that is no JSON, if one can be seen."""
    found = re.search(rb'"custom_id"\s*:\s*"([\w.-]{1,64})"', raw)
    return found[1].decode() if found is not None else ""


def _write(path: Path, rows: Iterable[dict[str, Any]]) -> None:
    lines = (json.dumps(row, ensure_ascii=False, sort_keys=True) + "\n" for row in rows)
    write_whole(path, "".join(lines))
