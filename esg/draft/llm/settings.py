"""Settings of the language-model drafter, from the environment (prefix ESG_LLM_) or arguments."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Literal
from urllib.parse import urlsplit

from pydantic import Field, SecretStr, ValidationError
from pydantic_settings import BaseSettings, SettingsConfigDict

from esg.outcomes import UserError

ENV_PREFIX = "ESG_LLM_"


class LlmSettings(BaseSettings):
    """Where the model is and what a scene may cost; every field is ESG_LLM_<NAME> too."""

    model_config = SettingsConfigDict(env_prefix=ENV_PREFIX, frozen=True, extra="forbid")

    base_url: str | None = Field(None, repr=False)
    """Of any OpenAI-compatible server, e.g. http://localhost:8080/v1."""
    model: str | None = None
    """Name that the server knows the model by."""
    api_key: SecretStr | None = None
    """Sent to the server and written nowhere."""
    timeout_s: float = Field(60.0, gt=0.0, le=3600.0)
    """For one request, from sending to the last byte."""
    deadline_s: float = Field(600.0, gt=0.0)
    """For one scene, all requests, pauses and rounds together."""
    max_rounds: int = Field(4, ge=0, le=20)
    """Revisions after the first draft of a scene."""
    attempts: int = Field(4, ge=1, le=20)
    """Requests for one reply: the first and its repetitions after a failure."""
    backoff_s: float = Field(1.0, ge=0.0)
    """First pause before a repetition; doubles each time, up to 30 s."""
    concurrency: int = Field(4, ge=1, le=256)
    """Scenes of a batch in work at a time."""
    max_tokens: int = Field(8192, ge=64)
    """Longest reply."""
    profile: Literal["large", "small"] = "large"
    """`small` asks once, in a short shape, for models under a few billion parameters."""
    max_items: int | None = Field(None, ge=1)
    """Longest list of a reply (maxItems of its schema): small local models ramble without it."""
    max_text: int | None = Field(None, ge=20)
    """Longest free text of a reply [characters]."""
    max_reply_bytes: int = Field(4_000_000, ge=1000)
    temperature: float | None = 0.0
    """None sends none, for models that accept only their own."""
    price_in: float | None = Field(None, ge=0.0)
    """USD per million input tokens; the cost is unknown without it."""
    price_out: float | None = Field(None, ge=0.0)
    """USD per million output tokens."""
    cache: Path | None = None
    """Folder of replies by content hash; the same request is never paid twice."""
    cassette: Path | None = None
    """JSON Lines file of recorded replies."""
    cassette_mode: Literal["auto", "record", "replay"] = "auto"
    """`replay` needs neither server nor key; `auto` replays what is recorded, else records."""
    image_model: str | None = None
    """Text-to-image model of the same server, for visual priors; off without it."""
    vision_model: str | None = None
    """Model that reads the image; default `model`."""

    @property
    def secret(self) -> str:
        """The key, or ""; for the client and for scrubbing only."""
        return self.api_key.get_secret_value() if self.api_key else ""

    @property
    def place(self) -> str:
        """The server without credentials or query, for messages."""
        parts = urlsplit(self.base_url or "")
        port = f":{parts.port}" if parts.port else ""
        return f"{parts.scheme}://{parts.hostname or ''}{port}{parts.path}"


def load_settings() -> LlmSettings:
    """Settings from the environment.

    Raises:
        UserError: Naming every variable with an unusable value.
    """
    try:
        return LlmSettings()  # pyright: ignore[reportCallIssue]
    except ValidationError as error:
        problems = "; ".join(
            f"{ENV_PREFIX}{str(e['loc'][0]).upper()}: {e['msg'][:1].lower()}{e['msg'][1:]}"
            for e in error.errors(include_url=False, include_input=False)
        )
        raise UserError(f"Settings of the model are unusable: {problems}.") from None


def require_endpoint(settings: LlmSettings) -> None:
    """Checks that there is a model to ask.

    Raises:
        UserError: Naming the variables to set.
    """
    missing = [
        f"{ENV_PREFIX}{name.upper()}"
        for name, value in (("base_url", settings.base_url), ("model", settings.model))
        if not value
    ]
    if missing:
        raise UserError(
            f"The llm drafter has no model to ask: set {' and '.join(missing)} "
            f"(and {ENV_PREFIX}API_KEY if the server wants one), for example "
            f"{ENV_PREFIX}BASE_URL=http://localhost:8080/v1 {ENV_PREFIX}MODEL=my-model; "
            "or use --drafter rules."
        )
    parts = urlsplit(settings.base_url or "")
    if parts.scheme not in ("http", "https") or not parts.hostname:
        raise UserError(
            f"{ENV_PREFIX}BASE_URL is {settings.place!r}; give an http(s) address such as "
            "http://localhost:8080/v1."
        )
    if parts.username or parts.password:
        raise UserError(
            f"{ENV_PREFIX}BASE_URL holds a user or password; give the key in {ENV_PREFIX}API_KEY, "
            "where it is kept out of logs and artifacts."
        )


def identity() -> str:
    """What decides about a model's drafts beside prompt and seed, as a hash; "" without a model.

    Raises:
        UserError: If a setting is unusable.
    """
    config = load_settings()
    if config.base_url is None and config.cassette is None:
        return ""
    told = config.model_dump(
        mode="json",
        include={"model", "profile", "max_rounds", "max_tokens", "max_items", "max_text",
                 "temperature", "image_model", "vision_model"},
    )  # fmt: skip
    replies = b""
    if config.cassette is not None and config.cassette_mode == "replay":
        try:
            replies = config.cassette.read_bytes()
        except OSError:
            replies = b"unreadable"
    text = json.dumps(told, sort_keys=True).encode()
    return hashlib.sha256(text + b"\0" + replies).hexdigest()[:16]
