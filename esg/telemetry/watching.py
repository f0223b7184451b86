"""The switch: what `ESG_TRACES` and `ESG_PROMETHEUS` ask for listens to a command's progress."""

from __future__ import annotations

from collections.abc import Generator, Sequence
import contextlib
import os

TRACES = "ESG_TRACES"
NUMBERS = "ESG_PROMETHEUS"


@contextlib.contextmanager
def watched(arguments: Sequence[str]) -> Generator[None]:
    """Traces and counts the stages of all scenes while the body runs, where that is asked for.

    Args:
        arguments: Of the command line; the first names the trace.

    Raises:
        UserError: If a variable says nothing that can be done, or a package is missing.
    """
    traces, numbers = (os.environ.get(name, "").strip() for name in (TRACES, NUMBERS))
    if not traces and not numbers:
        yield
        return
    from esg.progress import listening

    command = next((a for a in arguments if not a.startswith("-")), "")
    with contextlib.ExitStack() as stack:
        if traces:
            from esg.telemetry.traces import tracing

            stack.enter_context(listening(stack.enter_context(tracing(traces, command))))
        if numbers:
            from esg.telemetry.numbers import counting

            stack.enter_context(listening(stack.enter_context(counting(numbers))))
        yield
