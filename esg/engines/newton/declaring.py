"""Declares kernels of warp without reading their source before somebody asks for it.

Importing a library of kernels has warp parse each of its functions and look up all that these call;
a search launches a fifth of them. Neither changes a kernel: its hash and its code are made from
the same source, read when a module is hashed. What is called by what is kept by warp for modules
that are loaded again in one process, which a command does not do.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
import inspect
from types import CodeType
from typing import Any

WARP = "1.19."
"""Versions whose insides are known here; any other one declares kernels as it always does."""
_READ = ("source", "tree", "source_lines", "fun_lineno", "_shared_source")
"""What an adjoint knows of its function's source."""


@contextlib.contextmanager
def unread() -> Generator[None]:
    """Functions and kernels that the body declares are read at their first use; for one thread.

    For processes that load no module of kernels twice.
    """
    import warp

    if not warp.__version__.startswith(WARP):
        yield
        return
    from warp._src import codegen
    from warp._src.context import Module

    adjoint: Any = codegen.Adjoint
    before = adjoint.__init__, Module._find_references
    adjoint.__getattr__ = _read
    adjoint.__init__ = _declared(before[0])
    module: Any = Module
    module._find_references = _looks_up_nothing
    try:
        yield
    finally:
        adjoint.__init__, module._find_references = before


def _looks_up_nothing(module: Any, adjoint: Any) -> None:
    """What a module's references come to where nobody loads one twice."""


def _declared(read: Callable[..., None]) -> Callable[..., None]:
    """How an adjoint begins without its source.

    Args:
        read: How it begins with it.
    """

    def begin(
        adjoint: Any,
        func: Callable[..., object],
        *more: object,
        source: str | None = None,
        transformers: object = None,
        **rest: object,
    ) -> None:
        code = getattr(inspect.unwrap(func), "__code__", None)
        if source is not None or transformers or len(more) > 1 or code is None or _static(code):
            read(adjoint, func, *more, source=source, transformers=transformers, **rest)
            return
        # All else that is known at the beginning is known from the signature.
        read(adjoint, func, *more, source=f"def {code.co_name}(): pass", **rest)
        for name in _READ:
            del vars(adjoint)[name]

    return begin


def _static(code: CodeType) -> bool:
    """Whether a function may have expressions that warp evaluates where it is declared."""
    inner = (c for c in code.co_consts if isinstance(c, CodeType))
    return "static" in code.co_names or any(map(_static, inner))


def _read(adjoint: Any, name: str) -> Any:
    """An attribute that an adjoint lacks: reads its source if it is of that."""
    if name not in _READ or "func" not in vars(adjoint):
        raise AttributeError(name)
    from warp._src import codegen

    code = inspect.unwrap(adjoint.func).__code__
    shared = codegen._shared_source_for_code(code)
    if shared is None:
        shared = codegen._SharedFunctionSource(*adjoint.extract_function_source(adjoint.func))
        codegen._store_shared_source(code, shared)
    vars(adjoint).update(
        source=shared.source,
        tree=shared.tree,
        source_lines=shared.source.splitlines(),
        fun_lineno=shared.fun_lineno,
        _shared_source=shared,
    )
    return vars(adjoint)[name]
