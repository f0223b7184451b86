"""A run in numbers that Prometheus collects: seconds by stage, scenes by outcome."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from pathlib import Path

from esg.outcomes import UserError
from esg.progress import StageEvent

BUCKETS_S = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0)


@contextlib.contextmanager
def counting(where: str) -> Generator[Callable[[StageEvent], None]]:
    """A listener that counts.

    Args:
        where: A port of this machine (9464) that answers while the command runs, or a file (*.prom,
            for the textfile collector) that is written at its end.

    Raises:
        UserError: If the package is missing, the port is taken, or `where` is neither.
    """
    try:
        from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram
    except ImportError:
        raise UserError(
            'ESG_PROMETHEUS needs a package: pip install "esg-scenes[observe]"'
        ) from None
    registry = CollectorRegistry()
    seconds = Histogram(
        "esg_stage_seconds", "Time of a stage of a scene that was computed", ["stage"],
        buckets=BUCKETS_S, registry=registry,
    )  # fmt: skip
    cached = Counter(
        "esg_cached_stages", "Stages of scenes that were found", ["stage"], registry=registry
    )
    running = Gauge("esg_running_stages", "Scenes in a stage", ["stage"], registry=registry)
    scenes = Gauge("esg_scenes", "Scenes by their outcome so far", ["outcome"], registry=registry)
    outcomes: dict[tuple[str, int], str] = {}

    def count(event: StageEvent) -> None:
        if event.status == "started":
            running.labels(event.stage).inc()
            return
        running.labels(event.stage).dec()
        if event.cached:
            cached.labels(event.stage).inc()
        else:
            seconds.labels(event.stage).observe(event.seconds)
        scene = (event.scene, event.seed)
        if event.outcome and event.outcome != (before := outcomes.get(scene)):
            outcomes[scene] = event.outcome  # the judge may take back what the search claimed
            scenes.labels(event.outcome).inc()
            if before:
                scenes.labels(before).dec()

    with _told(where, registry):
        yield count


@contextlib.contextmanager
def _told(where: str, registry: object) -> Generator[None]:
    """Answers at a port while the body runs, or writes a file after it."""
    import prometheus_client as prometheus

    assert isinstance(registry, prometheus.CollectorRegistry)
    if where.isdecimal():
        try:
            server, thread = prometheus.start_http_server(int(where), "127.0.0.1", registry)
        except (OSError, OverflowError) as error:
            raise UserError(f"ESG_PROMETHEUS={where}: {error}; give another port") from None
        try:
            yield
        finally:
            server.shutdown()
            server.server_close()
            thread.join()
        return
    path = Path(where)
    if path.suffix != ".prom" or not path.parent.is_dir():
        raise UserError(
            f"ESG_PROMETHEUS={where}: give a port, or a file *.prom in a folder that is there"
        )
    try:
        yield
    finally:
        prometheus.write_to_textfile(where, registry)
