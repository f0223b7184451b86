"""What is changed in Newton: models share kernels, and only the contacts there are get sorted."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from functools import cache, wraps
from typing import Any

from esg.engines.newton.setup import quiet_warp
from esg.engines.newton.sizes import rung


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
def share_sizes() -> None:
    """Lets worlds on a GPU have room for one of few numbers of coordinates (`sizes.rung`).

    Newton compiles the sweep of its solver for the most coordinates that a world has; what a
    smaller world lacks is left out by every kernel. Where no joint is, no row couples coordinates,
    and whether pairs of such rows are kept in fast memory, which goes by the number of worlds,
    makes no difference but another kernel.
    """
    from newton._src.solvers.steel import solver_steel

    solver = solver_steel.SolverSteel
    names = ("_compute_world_response_dof_mapping", "_detect_jy_world_identity")
    if not all(hasattr(solver, name) for name in names):
        return
    mapping, identity = (getattr(solver, name) for name in names)

    @wraps(mapping)
    def widened(self: Any, model: Any) -> None:
        mapping(self, model)
        if _widens(model.device) and self._max_world_dofs:
            _widen(self, model, rung(self._max_world_dofs))

    @wraps(identity)
    def same_layout(self: Any) -> bool:
        return identity(self) and self._max_world_dofs == self._size_groups[0]

    setattr(solver, names[0], widened)
    setattr(solver, names[1], same_layout)
    pairs = getattr(solver_steel, "_use_mfgs_pair_cache", None)
    if pairs is not None:

        @wraps(pairs)
        def paired(rows: int, *sizes: Any, **options: Any) -> bool:
            return rows > 1 and bool(pairs(rows, *sizes, **options))

        solver_steel._use_mfgs_pair_cache = paired


def _widens(device: Any) -> bool:
    return bool(device.is_cuda)


def _widen(solver: Any, model: Any, dofs: int) -> None:
    """Gives all worlds of a solver room for so many coordinates; -1 stands for none."""
    import numpy as np

    known = solver._world_dof_indices.numpy()
    wide = np.full((len(known), dofs), -1, np.int32)
    wide[:, : known.shape[1]] = known
    solver._max_world_dofs = dofs
    solver._world_dof_indices = quiet_warp().array(wide, dtype=int, device=model.device)


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
