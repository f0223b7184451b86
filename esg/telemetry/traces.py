"""A run as an OpenTelemetry trace: the command is the root, every stage of every scene a span."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from pathlib import Path
import threading
from typing import Any

from esg.outcomes import UserError
from esg.progress import StageEvent

OTLP = "otlp"
"""Sends spans to where OTEL_EXPORTER_OTLP_ENDPOINT says; anything else names a file."""


@contextlib.contextmanager
def tracing(where: str, command: str) -> Generator[Callable[[StageEvent], None]]:
    """A listener that makes spans.

    Args:
        where: `otlp`, or a file that gets one span a line as JSON.
        command: Name of the root span, after `esg`.

    Raises:
        UserError: If the packages are missing or the file cannot be written.
    """
    try:
        from opentelemetry import trace
        from opentelemetry.sdk.resources import Resource
        from opentelemetry.sdk.trace import TracerProvider
        from opentelemetry.sdk.trace.export import BatchSpanProcessor
    except ImportError:
        raise UserError('ESG_TRACES needs packages: pip install "esg-scenes[observe]"') from None
    from esg import __version__

    about = {"service.name": "esg", "service.version": __version__}
    with contextlib.ExitStack() as stack:
        provider = TracerProvider(resource=Resource.create(about))
        provider.add_span_processor(BatchSpanProcessor(_exporter(where, stack)))
        stack.callback(provider.shutdown)  # sends what is left
        tracer = provider.get_tracer("esg", __version__)
        with tracer.start_as_current_span(f"esg {command}".strip()) as root:
            yield _Spans(tracer, trace.set_span_in_context(root))


def _exporter(where: str, stack: contextlib.ExitStack) -> Any:
    if where == OTLP:
        from opentelemetry.exporter.otlp.proto.http.trace_exporter import OTLPSpanExporter

        return OTLPSpanExporter()
    from opentelemetry.sdk.trace.export import ConsoleSpanExporter

    try:
        file = Path(where).open("a", encoding="utf-8")  # noqa: SIM115 (closed with the stack)
    except OSError as error:
        raise UserError(
            f"ESG_TRACES={where}: {error.strerror}; give a file that can be written, or {OTLP}"
        ) from None
    stack.callback(file.close)
    return ConsoleSpanExporter(out=file, formatter=lambda span: span.to_json(indent=None) + "\n")


class _Spans:
    """Opens a span when a stage starts and ends it when the stage does.

    A stage whose end is never told (a killed worker) has no span. One whose start was not told was
    found in the cache.
    """

    def __init__(self, tracer: Any, context: Any) -> None:
        self._tracer, self._context = tracer, context
        self._open: dict[tuple[str, int, str], Any] = {}
        self._lock = threading.Lock()

    def __call__(self, event: StageEvent) -> None:
        key = (event.scene, event.seed, event.stage)
        if event.status == "started":
            span = self._tracer.start_span(event.stage, context=self._context)
            with self._lock:
                self._open[key] = span
            return
        with self._lock:
            span = self._open.pop(key, None)
        if span is None:
            span = self._tracer.start_span(event.stage, context=self._context)
        span.set_attributes(
            {
                "esg.scene": event.scene,
                "esg.seed": event.seed,
                "esg.cached": event.cached,
                "esg.seconds": event.seconds,
                "esg.outcome": event.outcome,
                "esg.reason": event.reason,
            }
        )
        if event.outcome == "crashed":
            from opentelemetry.trace import Status, StatusCode

            span.set_status(Status(StatusCode.ERROR, event.reason))
        span.end()
