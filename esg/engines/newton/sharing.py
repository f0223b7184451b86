"""What is changed in Newton so that models share kernels and sort only the contacts there are."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from functools import cache, wraps
from typing import Any

from esg.engines.newton.setup import quiet_warp


@cache
def share_kernels() -> None:
    """Lets all models of a process share Newton's narrow-phase kernels.

    Newton writes these two kernels anew for every collision pipeline, although they depend on a
    few switches only. Generating and hashing them again takes longer than simulating a scene.
    """
    from newton._src.geometry import narrow_phase

    for name in ("create_narrow_phase_primitive_kernel", "create_narrow_phase_kernel_gjk_mpr"):
        factory = getattr(narrow_phase, name, None)
        if factory is not None:
            setattr(narrow_phase, name, cache(factory))


@cache
def sort_few_contacts() -> None:
    """Lets Newton sort the contacts there are on the CPU, not all it has room for.

    Before friction is solved, every step sorts the contacts of all worlds by pair of bodies. Warp's
    radix sort counts in four tables of 65,536 numbers whatever there is to sort, which took a third
    of the time of a scene with few contacts. The order is the same.
    """
    wp = quiet_warp()
    from newton._src.solvers.steel import friction_patches

    from esg.engines.newton.kernels import sort_pairs

    state = getattr(friction_patches, "_FrictionPatchState", None)
    if state is None or not hasattr(state, "build"):
        return
    build = state.build

    @wraps(build)
    def build_and_sort(self: Any, model: Any, poses: Any, contacts: Any, **options: Any) -> None:
        if model.device.is_cuda:
            build(self, model, poses, contacts, **options)
            return
        with _sorting(wp, self.current.keys, contacts.rigid_contact_count, sort_pairs):
            build(self, model, poses, contacts, **options)

    state.build = build_and_sort


@contextmanager
def _sorting(wp: Any, known: Any, count: Any, kernel: Any) -> Generator[None]:
    """Sorts `known`, whose first count[0] keys are in use, by a kernel, all else as always."""
    usual = wp.utils.radix_sort_pairs

    def sort(keys: Any, values: Any, limit: int, *bits: Any, **more: Any) -> None:
        if keys is known and not bits and not more:
            wp.launch(kernel, dim=1, inputs=[count, limit, keys, values], device=keys.device)
        else:
            usual(keys, values, limit, *bits, **more)

    wp.utils.radix_sort_pairs = sort
    try:
        yield
    finally:
        wp.utils.radix_sort_pairs = usual
