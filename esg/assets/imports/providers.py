"""Neural generators that make a GLB from words: TRELLIS as a local package or an HTTP service.

The service is asked by `POST <url>` with JSON `{"prompt", "seed", "format": "glb"}` (and `"image"`,
base64, where there is one) and answers with the GLB itself or with JSON `{"glb": base64}`.
Everything that can go wrong is a `GenerationError` with one sentence; no answer is trusted before
its container has been checked.
"""

from __future__ import annotations

import base64
import binascii
from dataclasses import dataclass
import json
import os
import struct
import time
from typing import Any, Protocol
import urllib.error
import urllib.request

from esg.outcomes import UserError

MAX_BYTES = 64 * 1024 * 1024
TIMEOUT_S = 120.0
RETRIES = 2
BACKOFF_S = 1.0
_CHUNK = 1 << 16
_RETRIED = frozenset({408, 425, 429, 500, 502, 503, 504})


class GenerationError(Exception):
    """Why a generator gave no usable mesh; the scene goes on with a parametric body."""


class Generator(Protocol):
    """Makes meshes from words."""

    @property
    def name(self) -> str:
        """What is recorded as the provider, and part of the cache's key."""
        ...

    def generate(self, prompt: str, seed: int, image: bytes | None = None) -> bytes:
        """A GLB file (Y up, front towards +Z), or GenerationError."""
        ...


def check_glb(data: bytes) -> bytes:
    """The data, if it is a whole binary glTF 2.0 file.

    Raises:
        GenerationError: For another type, a file that is cut off, or another version.
    """
    if len(data) < 20 or data[:4] != b"glTF":
        raise GenerationError(f"the answer is no GLB (it starts with {data[:8]!r})")
    version, length = struct.unpack("<II", data[4:12])
    if version != 2:
        raise GenerationError(f"glTF version {version}, expected 2")
    if length != len(data):
        raise GenerationError(f"the GLB is cut off: {len(data)} of {length} bytes")
    return data


@dataclass(frozen=True)
class TrellisService:
    """A TRELLIS server reached over HTTP.

    Args:
        url: Address of its generation endpoint.
        timeout_s: For one attempt, connection, waiting and download together.
        retries: Further attempts after a busy, failing or silent server.
        backoff_s: Wait before the first retry; doubled for each further one.
        max_bytes: Longer answers are refused before they are read.
    """

    url: str
    timeout_s: float = TIMEOUT_S
    retries: int = RETRIES
    backoff_s: float = BACKOFF_S
    max_bytes: int = MAX_BYTES

    @property
    def name(self) -> str:
        return "trellis-http"

    def generate(self, prompt: str, seed: int, image: bytes | None = None) -> bytes:
        """Asks the service; waits and asks again where that may help."""
        body: dict[str, Any] = {"prompt": prompt, "seed": seed, "format": "glb"}
        if image is not None:
            body["image"] = base64.b64encode(image).decode()
        for attempt in range(self.retries + 1):
            try:
                return check_glb(self._ask(json.dumps(body).encode()))
            except _Refused as error:
                raise GenerationError(str(error)) from None
            except GenerationError:
                if attempt == self.retries:
                    raise
                time.sleep(self.backoff_s * 2**attempt)
        raise AssertionError("unreachable")

    def _ask(self, body: bytes) -> bytes:
        request = urllib.request.Request(
            self.url,
            data=body,
            headers={
                "Content-Type": "application/json",
                "Accept": "model/gltf-binary, application/json",
            },
        )
        deadline = time.monotonic() + self.timeout_s
        try:
            with urllib.request.urlopen(request, timeout=self.timeout_s) as answer:
                data = self._read(answer, deadline)
                kind = answer.headers.get_content_type()
        except urllib.error.HTTPError as error:
            with error:
                text = f"the service answered {error.code} {error.reason}"
            if error.code in _RETRIED:
                raise GenerationError(text) from None
            raise _Refused(text) from None
        except (TimeoutError, urllib.error.URLError, OSError) as error:
            reason = getattr(error, "reason", error)
            if isinstance(reason, TimeoutError):
                reason = f"no answer within {self.timeout_s:g} s"
            raise GenerationError(f"the service cannot be reached: {reason}") from None
        return _unwrapped(data) if kind == "application/json" else data

    def _read(self, answer: Any, deadline: float) -> bytes:
        announced = answer.headers.get("Content-Length")
        if announced and announced.isdigit() and int(announced) > self.max_bytes:
            raise _Refused(f"the answer is too large: {announced} bytes, at most {self.max_bytes}")
        parts, total = [], 0
        # A server that trickles would outlive a timeout that only counts silence.
        while chunk := answer.read1(_CHUNK):
            total += len(chunk)
            if total > self.max_bytes:
                raise _Refused(f"the answer is too large: more than {self.max_bytes} bytes")
            if time.monotonic() > deadline:
                raise GenerationError(f"the answer took longer than {self.timeout_s:g} s")
            parts.append(chunk)
        if announced and announced.isdigit() and total < int(announced):
            raise GenerationError(f"the answer is cut off: {total} of {announced} bytes")
        return b"".join(parts)


class _Refused(Exception):
    """An answer that asking again would not change."""


def _unwrapped(data: bytes) -> bytes:
    try:
        return base64.b64decode(json.loads(data)["glb"], validate=True)
    except (ValueError, KeyError, TypeError, binascii.Error):
        raise GenerationError("the answer is JSON without a base64 `glb`") from None


@dataclass(frozen=True)
class TrellisPackage:
    """TRELLIS in this process: the `trellis` package, its weights and a CUDA device.

    Args:
        model: Name or folder of the text pipeline's weights.
        image_model: The same for prompts with an image.
        simplify: Share of triangles to remove.
        texture_size: Pixels along each side of the baked texture.
    """

    model: str = "microsoft/TRELLIS-text-xlarge"
    image_model: str = "microsoft/TRELLIS-image-large"
    simplify: float = 0.95
    texture_size: int = 1024

    @property
    def name(self) -> str:
        return f"trellis:{self.model}"

    def _pipeline(self, image: bool) -> Any:
        key = (self.model, self.image_model, image)
        if key not in _PIPELINES:
            try:
                from trellis import pipelines  # type: ignore[import-not-found]  # optional package

                kind = "TrellisImageTo3DPipeline" if image else "TrellisTextTo3DPipeline"
                loader = getattr(pipelines, kind)
                pipeline = loader.from_pretrained(self.image_model if image else self.model)
                pipeline.cuda()
            except Exception as error:  # missing package, weights, driver or memory
                raise GenerationError(
                    f"TRELLIS cannot be loaded ({type(error).__name__}: {error}); install the "
                    "package and its weights, or set ESG_TRELLIS_URL to a service"
                ) from None
            _PIPELINES[key] = pipeline
        return _PIPELINES[key]

    def generate(self, prompt: str, seed: int, image: bytes | None = None) -> bytes:
        """Runs the pipeline and bakes its mesh to a GLB."""
        pipeline = self._pipeline(image is not None)
        try:
            from trellis.utils import postprocessing_utils  # type: ignore[import-not-found]

            # Without `formats` a radiance field, which nothing here reads, is decoded too.
            made = pipeline.run(
                prompt if image is None else _picture(image),
                seed=seed,
                formats=["mesh", "gaussian"],
            )
            mesh = postprocessing_utils.to_glb(
                made["gaussian"][0],
                made["mesh"][0],
                simplify=self.simplify,
                texture_size=self.texture_size,
            )
            return check_glb(mesh.export(file_type="glb"))
        except GenerationError:
            raise
        except Exception as error:  # out of memory, an empty mesh, a changed API
            raise GenerationError(f"TRELLIS failed ({type(error).__name__}: {error})") from None


_PIPELINES: dict[Any, Any] = {}


def _picture(data: bytes) -> Any:
    import io

    from PIL import Image

    return Image.open(io.BytesIO(data))


def _positive(name: str, usual: float) -> float:
    text = os.environ.get(name)
    try:
        value = float(text) if text else usual
    except ValueError:
        value = -1.0
    if not 0 < value < 1e9:
        raise UserError(f"{name}={text!r}: expected a positive number")
    return value


def chosen_generator() -> Generator | None:
    """The generator that the environment asks for; None for the parametric library alone.

    `ESG_GENERATOR` is `parametric` (default) or `trellis`; `ESG_TRELLIS_URL` selects a service
    (else the local package), `ESG_TRELLIS_MODEL` the weights, `ESG_TRELLIS_TIMEOUT_S`,
    `ESG_TRELLIS_RETRIES` and `ESG_TRELLIS_MAX_MB` its limits.

    Raises:
        UserError: For another provider, a bad address or a bad number.
    """
    kind = os.environ.get("ESG_GENERATOR", "parametric").strip().lower() or "parametric"
    if kind == "parametric":
        return None
    if kind != "trellis":
        raise UserError(f"ESG_GENERATOR={kind!r}: choose parametric or trellis")
    url = os.environ.get("ESG_TRELLIS_URL", "").strip()
    if not url:
        model = os.environ.get("ESG_TRELLIS_MODEL", "").strip()
        return TrellisPackage(model) if model else TrellisPackage()
    if not url.startswith(("http://", "https://")):
        raise UserError(f"ESG_TRELLIS_URL={url!r}: expected an http:// or https:// address")
    retries = os.environ.get("ESG_TRELLIS_RETRIES", str(RETRIES))
    if not retries.isdigit() or int(retries) > 10:
        raise UserError(f"ESG_TRELLIS_RETRIES={retries!r}: expected 0 to 10")
    return TrellisService(
        url,
        timeout_s=_positive("ESG_TRELLIS_TIMEOUT_S", TIMEOUT_S),
        retries=int(retries),
        max_bytes=int(_positive("ESG_TRELLIS_MAX_MB", MAX_BYTES / 2**20) * 2**20),
    )
