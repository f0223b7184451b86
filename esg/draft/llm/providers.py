"""Visual priors: a reference image of the start and what a vision model reads from it.

Both come from the same server as the text model. What they suggest enters the draft as soft
relations and layout preferences with low confidence, and only where it contradicts nothing.
"""

from __future__ import annotations

import asyncio
import base64
from collections.abc import Awaitable, Callable, Sequence
import copy
import hashlib
import json
from pathlib import Path
from typing import Any, Protocol

from esg.draft.llm.client import ModelFailure, Reply, import_pydantic_ai
from esg.draft.llm.names import Names
from esg.draft.llm.settings import LlmSettings
from esg.draft.llm.stages import VisualReply, read_reply
from esg.graph.verifier import verify
from esg.graph.violations import pointer

MAX_CONFIDENCE = 0.4
"""A picture of an imagined scene is a hint; the prompt's own relations have 1.0."""

Complete = Callable[..., Awaitable[Reply]]


class ImageProvider(Protocol):
    """Draws a scene."""

    async def render(self, description: str, seed: int) -> bytes:
        """PNG or JPEG of the scene's initial state.

        Raises:
            ModelFailure: If there is no image.
        """
        ...


class EndpointImages:
    """The images interface of an OpenAI-compatible server; images are kept in the cache folder."""

    def __init__(self, settings: LlmSettings) -> None:
        self.settings = settings

    def path(self, description: str, seed: int) -> Path | None:
        """Where the image of a description is kept."""
        if self.settings.cache is None:
            return None
        text = json.dumps([self.settings.image_model, description, seed])
        return self.settings.cache / "images" / f"{hashlib.sha256(text.encode()).hexdigest()}.png"

    async def render(self, description: str, seed: int) -> bytes:
        path = self.path(description, seed)
        if path is not None and path.is_file():
            return path.read_bytes()
        import_pydantic_ai()
        from openai import AsyncOpenAI

        settings = self.settings
        client = AsyncOpenAI(
            base_url=settings.base_url,
            api_key=settings.secret or "none",
            max_retries=0,
            timeout=settings.timeout_s,
        )
        try:
            answer: Any = await asyncio.wait_for(
                client.images.generate(
                    model=settings.image_model or "",
                    prompt=f"Photograph, seen from the front: {description[:3000]}",
                    response_format="b64_json",
                    n=1,
                ),
                settings.timeout_s,
            )
            data = base64.b64decode(answer.data[0].b64_json, validate=True)
        except asyncio.CancelledError:
            raise
        except Exception as error:
            message = f"no reference image ({type(error).__name__})"
            raise ModelFailure("refused", message, retryable=False) from None
        finally:
            await client.close()
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            part = path.with_suffix(".tmp")
            part.write_bytes(data)
            part.replace(path)
        return data


async def read_priors(
    settings: LlmSettings,
    description: str,
    objects: Sequence[str],
    seed: int,
    complete: Complete,
    images: ImageProvider | None = None,
) -> VisualReply:
    """Draws the scene and reads relations and places of the named objects from the picture.

    Args:
        settings: Server and models.
        description: Of the initial state.
        objects: Names that may occur in the answer.
        seed: For the image.
        complete: Asks the vision model: (stage, messages, images) -> Reply.
        images: Default: the server's.

    Raises:
        ModelFailure: If there is no image or no answer.
        UnreadableReply: If the answer does not fit.
    """
    image = await (images or EndpointImages(settings)).render(description, seed)
    question = f"Objects: {', '.join(objects)}. Read the picture."
    reply = await complete("visual", (("user", question),), (image,))
    return read_reply(reply.text, VisualReply, cut_off=reply.cut_off)


def merge_priors(raw: dict[str, Any], prior: VisualReply) -> tuple[str, ...]:
    """Adds what the picture suggests to a document's plain JSON, where no rule speaks against it.

    Args:
        raw: Changed in place.
        prior: Soft relations and places.

    Returns:
        What was added, in words.
    """
    nodes = raw["spatial_relation_graph"]["nodes"]
    names = Names("object")
    for name, node in nodes.items():
        names.add(name, *([node["label"]] if node.get("label") else []))
    before = len(verify(raw))
    added: list[str] = []
    for seen in prior.relations:
        trial = copy.deepcopy(raw)
        edge = {
            "from": names.one(seen.subject),
            "to": names.one(seen.object),
            "relation_type": seen.relation.value,
            "confidence": min(seen.confidence, MAX_CONFIDENCE),
            "semantic_description": "suggested by the reference image",
        }
        if edge["from"] not in nodes or edge["to"] not in nodes:
            continue
        trial["spatial_relation_graph"]["edges"]["binary_relations"].append(edge)
        if len(verify(trial)) <= before:
            raw["spatial_relation_graph"]["edges"]["binary_relations"].append(edge)
            added.append(f"image suggests {edge['from']} {seen.relation.value} {edge['to']}")
    for place in prior.places:
        name = names.one(place.object)
        if name not in nodes or nodes[name].get("is_structural") or place.anchor == "none":
            continue
        weight = min(place.confidence, MAX_CONFIDENCE)
        nodes[name]["layout_preference"] = {"anchor": place.anchor, "weight": weight}
        where = pointer("spatial_relation_graph", "nodes", name, "layout_preference")
        added.append(f"image suggests {place.anchor} at {where}")
    return tuple(added)
