"""One request to a language model, with time-outs, back-off and a limit on the reply's size."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field
import hashlib
import importlib
import importlib.util
import json
from typing import Any, Protocol

from esg.draft.llm.settings import LlmSettings
from esg.outcomes import UserError
from esg.strangers.scrubbing import scrub

MAX_PAUSE_S = 30.0


@dataclass(frozen=True)
class Call:
    """A request: everything that determines the reply, and nothing secret.

    Args:
        stage: Which part of the draft it asks for.
        model: Name of the model.
        instructions: System text.
        messages: (role, text) of the conversation, role "user" or "assistant".
        schema: JSON Schema of the reply; {} for free text.
        seed: Passed to the server.
        temperature: None sends none.
        max_tokens: Longest reply.
        images: PNG or JPEG bytes that accompany the last message.
        round: Revisions of the scene before it: who is told the same once more may answer anew.
    """

    stage: str
    model: str
    instructions: str
    messages: tuple[tuple[str, str], ...]
    schema: dict[str, Any] = field(default_factory=dict[str, Any])
    seed: int = 0
    temperature: float | None = 0.0
    max_tokens: int = 8192
    images: tuple[bytes, ...] = ()
    round: int = 0

    @property
    def key(self) -> str:
        """SHA-256 of the request."""
        parts = {
            "stage": self.stage,
            "model": self.model,
            "instructions": self.instructions,
            "messages": self.messages,
            "schema": self.schema,
            "seed": self.seed,
            "temperature": self.temperature,
            "max_tokens": self.max_tokens,
            "images": [hashlib.sha256(i).hexdigest() for i in self.images],
            "round": self.round,
        }
        return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


@dataclass(frozen=True)
class Reply:
    """An answer.

    Args:
        text: Raw text.
        input_tokens, output_tokens: As the server counts them; 0 if it does not.
        cut_off: Whether the reply stopped at the length limit.
        model: Name by which the model reports itself; "" if it does not.
    """

    text: str
    input_tokens: int = 0
    output_tokens: int = 0
    cut_off: bool = False
    model: str = ""


class ModelFailure(Exception):
    """No answer to one request.

    Args:
        kind: "timeout", "rate_limited", "server", "connection", "refused" or "unreadable".
        message: What happened; free of secrets.
        retryable: Whether the same request may succeed later.
        retry_after_s: The server's wish.
    """

    def __init__(
        self, kind: str, message: str, *, retryable: bool, retry_after_s: float | None = None
    ) -> None:
        super().__init__(message)
        self.kind = kind
        self.retryable = retryable
        self.retry_after_s = retry_after_s


class Waiting(Exception):
    """The request is written down and its answer has not come yet (request files)."""


class Client(Protocol):
    """Answers requests."""

    async def complete(self, call: Call) -> Reply:
        """The reply.

        Raises:
            ModelFailure: If there is none.
        """
        ...


class EndpointClient:
    """Any OpenAI-compatible server, through pydantic-ai.

    The reply is constrained by the JSON Schema where the server can; a server that refuses the
    schema is asked for a JSON object, then for text, with the schema in the instructions.
    """

    MODES = ("json_schema", "json_object", "text")

    def __init__(self, settings: LlmSettings) -> None:
        import_pydantic_ai()
        # Loading the library takes seconds, which must not count as the server's time.
        for name in ("direct", "models.openai", "profiles.openai", "providers.openai"):
            importlib.import_module(f"pydantic_ai.{name}")
        self.settings = settings
        self._mode = 0
        self._models: dict[str, Any] = {}
        self._http: Any = None

    async def aclose(self) -> None:
        """Closes the connections."""
        if self._http is not None:
            await self._http.aclose()

    async def complete(self, call: Call) -> Reply:
        while True:
            try:
                return await self._ask(call, self.MODES[self._mode])
            except ModelFailure as failure:
                unsupported = failure.kind == "refused" and "response_format" in str(failure)
                if not (unsupported and self._mode < len(self.MODES) - 1 and call.schema):
                    raise
                self._mode += 1

    async def _ask(self, call: Call, mode: str) -> Reply:
        from pydantic_ai.direct import model_request
        from pydantic_ai.models import ModelRequestParameters
        from pydantic_ai.output import OutputObjectDefinition

        instructions = call.instructions
        body: dict[str, Any] = {}
        parameters = ModelRequestParameters()
        if call.schema and mode == "json_schema":
            shape = OutputObjectDefinition(json_schema=call.schema, name=call.stage)
            parameters = ModelRequestParameters(output_mode="native", output_object=shape)
        elif call.schema:
            instructions += (
                "\n\nAnswer with one JSON object of this JSON Schema and nothing else:\n"
            )
            instructions += json.dumps(call.schema, sort_keys=True)
            if mode == "json_object":
                body["response_format"] = {"type": "json_object"}
        settings: dict[str, Any] = {
            "max_tokens": call.max_tokens,
            "seed": call.seed,
            "timeout": self.settings.timeout_s,
        }
        if call.temperature is not None:
            settings["temperature"] = call.temperature
        if body:
            settings["extra_body"] = body
        secret = self.settings.secret
        try:
            response = await model_request(
                self._model(call.model),
                _history(call, instructions),
                model_settings=settings,  # type: ignore[arg-type]  # a TypedDict of the library
                model_request_parameters=parameters,
            )
        except asyncio.CancelledError:
            raise
        except Exception as error:
            raise _failure(error, secret) from None
        text = "".join(p.content for p in response.parts if p.part_kind == "text")
        return Reply(
            scrub(text, secret),
            response.usage.input_tokens or 0,
            response.usage.output_tokens or 0,
            response.finish_reason == "length",
            response.model_name or "",
        )

    def _model(self, name: str) -> Any:
        if name not in self._models:
            from openai import AsyncOpenAI, DefaultAsyncHttpxClient
            from pydantic_ai.models.openai import OpenAIChatModel
            from pydantic_ai.profiles.openai import (
                OpenAIJsonSchemaTransformer,
                OpenAIModelProfile,
            )
            from pydantic_ai.providers.openai import OpenAIProvider

            if self._http is None:
                self._http = DefaultAsyncHttpxClient(
                    event_hooks={"response": [self._limit]},
                    timeout=self.settings.timeout_s,
                )
            client = AsyncOpenAI(
                base_url=self.settings.base_url,
                # The client insists on a key; servers without one ignore it.
                api_key=self.settings.secret or "none",
                max_retries=0,
                http_client=self._http,
            )
            profile = OpenAIModelProfile(
                supports_json_schema_output=True,
                supports_json_object_output=True,
                json_schema_transformer=OpenAIJsonSchemaTransformer,
                openai_chat_supports_max_completion_tokens="api.openai.com" in self.settings.place,
            )
            self._models[name] = OpenAIChatModel(
                name, provider=OpenAIProvider(openai_client=client), profile=profile
            )
        return self._models[name]

    async def _limit(self, response: Any) -> None:
        """Stops reading a reply that does not end."""
        library = importlib.import_module(type(response).__module__.partition(".")[0])
        limit, inner = self.settings.max_reply_bytes, response.stream

        class Limited(library.AsyncByteStream):
            async def __aiter__(self) -> Any:
                count = 0
                async for chunk in inner:
                    count += len(chunk)
                    if count > limit:
                        raise library.ReadError(f"the reply exceeds {limit} bytes")
                    yield chunk

            async def aclose(self) -> None:
                await inner.aclose()

        response.stream = Limited()


def import_pydantic_ai() -> None:
    """Checks that the optional client library is installed.

    Raises:
        UserError: Saying how to install it.
    """
    missing = [n for n in ("openai", "pydantic_ai") if importlib.util.find_spec(n) is None]
    if missing:
        raise UserError(
            f"The llm drafter needs an optional package ({' and '.join(missing)} missing): "
            'run pip install "esg-scenes[llm]", or use --drafter rules.'
        )


def _history(call: Call, instructions: str) -> list[Any]:
    from pydantic_ai.messages import (
        BinaryContent,
        ModelRequest,
        ModelResponse,
        SystemPromptPart,
        TextPart,
        UserPromptPart,
    )

    out: list[Any] = []
    for k, (role, text) in enumerate(call.messages):
        if role == "assistant":
            out.append(ModelResponse(parts=[TextPart(text)]))
            continue
        last = k == len(call.messages) - 1
        content: Any = text
        if last and call.images:
            content = [text, *(BinaryContent(i, media_type=_media(i)) for i in call.images)]
        parts: list[Any] = [UserPromptPart(content)]
        if k == 0:
            parts.insert(0, SystemPromptPart(instructions))
        out.append(ModelRequest(parts=parts))
    return out


def _media(image: bytes) -> str:
    return "image/jpeg" if image[:3] == b"\xff\xd8\xff" else "image/png"


def _failure(error: BaseException, secret: str) -> ModelFailure:
    """What an exception of the client library means."""
    chain: list[BaseException] = []
    current: BaseException | None = error
    while current is not None and current not in chain:
        chain.append(current)
        current = current.__cause__ or current.__context__
    status = next((s for e in chain if (s := getattr(e, "status_code", None)) is not None), None)
    names = " ".join(type(e).__name__ for e in chain)
    text = scrub(str(error), secret)[:500]
    if isinstance(status, int) and status >= 400:
        wish = next((getattr(e, "retry_after", None) for e in chain), None)
        body = scrub(str(getattr(error, "body", "") or ""), secret)[:500]
        message = f"the server answered {status}: {body or text}"
        if status == 429:
            return ModelFailure("rate_limited", message, retryable=True, retry_after_s=wish)
        if status >= 500 or status in (408, 409, 425):
            return ModelFailure("server", message, retryable=True, retry_after_s=wish)
        return ModelFailure("refused", message, retryable=False)
    if "Timeout" in names:
        return ModelFailure("timeout", "the server was silent for too long", retryable=True)
    if "exceeds" in " ".join(map(str, chain)):
        return ModelFailure("unreadable", "the reply did not end", retryable=True)
    if any(n in names for n in ("Connect", "APIConnectionError", "ReadError", "RemoteProtocol")):
        return ModelFailure("connection", f"no connection: {text}", retryable=True)
    return ModelFailure("unreadable", f"the reply is unreadable: {text}", retryable=True)


class PatientClient:
    """Repeats requests that failed for a passing reason; no request outlives its time-out.

    Args:
        inner: The server.
        settings: Time-out, attempts and pauses.
    """

    def __init__(self, inner: Client, settings: LlmSettings) -> None:
        self.inner = inner
        self.settings = settings
        self.requests = 0

    async def complete(self, call: Call) -> Reply:
        pause = self.settings.backoff_s
        for attempt in range(1, self.settings.attempts + 1):
            self.requests += 1
            try:
                # A server that sends a byte now and then resets the library's own time-out.
                return await asyncio.wait_for(self.inner.complete(call), self.settings.timeout_s)
            except TimeoutError:
                failure = ModelFailure(
                    "timeout",
                    f"no complete reply in {self.settings.timeout_s:g} s",
                    retryable=True,
                )
            except ModelFailure as caught:
                failure = caught
            if not failure.retryable or attempt == self.settings.attempts:
                raise failure
            await asyncio.sleep(min(max(pause, failure.retry_after_s or 0.0), MAX_PAUSE_S))
            pause *= 2.0
        raise AssertionError("attempts is at least 1")
