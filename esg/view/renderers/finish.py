"""From light to pixels, the same for the renderers that do not draw the sky themselves."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.camera import Camera
from esg.view.maps import encoded
from esg.view.skies import haze_of, sky_at, sky_map
from esg.view.surroundings import Sky
from esg.view.truth import Pinhole

Denoiser = Callable[..., NDArray[np.float32]]


def finished(
    color: NDArray[Any],
    alpha: NDArray[Any],
    distance: NDArray[Any],
    sky: Sky,
    seed: int,
    camera: Camera,
) -> NDArray[np.uint8]:
    """The sky behind a picture, haze before what is far, and encoded; shape [H, L, 3].

    Args:
        color: Linear light of what is there, times its coverage, shape [H, L, 3].
        alpha: How much of each pixel is covered, shape [H, L].
        distance: Of what covers it [m], shape [H, L].
        sky: Its colours.
        seed: Of the clouds.
        camera: That took the picture.
    """
    height, width = alpha.shape
    seen = sky_map(sky, seed)
    haze_m = haze_of(sky)
    out = np.asarray(color, float)
    covered = alpha[..., None]
    if haze_m:
        far = np.where(alpha > 0, np.clip(distance, 0.0, 1e5), 0.0)
        thin = np.exp(-((far / haze_m) ** 1.5))[..., None]
        out = out * thin + covered * (1.0 - thin) * seen[0].mean(axis=0)
    return encoded(out + (1.0 - covered) * sky_at(seen, view_directions(camera, (width, height))))


def view_directions(camera: Camera, size: tuple[int, int]) -> NDArray[np.float64]:
    """Unit directions in the world through all pixel centres, shape [H, L, 3]."""
    points = Pinhole.of(camera, size).unproject(np.ones((size[1], size[0])))
    d = points - np.asarray(camera.eye)
    return d / np.linalg.norm(d, axis=-1, keepdims=True)


def denoiser() -> Denoiser | None:
    """A function of colour, albedo and normal, each of shape [H, L, 3]; None if not installed."""
    try:
        oidn: Any = import_module("mitsuba_oidn")
    except ImportError:
        return None

    def denoise(*images: NDArray[Any]) -> NDArray[np.float32]:
        plain = (np.ascontiguousarray(v, np.float32) for v in images)
        return np.maximum(np.asarray(oidn.denoise(*plain, hdr=True)), 0.0)

    return denoise
