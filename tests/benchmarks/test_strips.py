"""What is told on the command line of strips of finished scenes."""

from pathlib import Path

import pytest

from benchmarks.strips import told


@pytest.mark.parametrize(
    ("text", "angles", "times"),
    [
        ("runs/a", (), ()),
        ("runs/a@30", (30.0,), ()),
        ("runs/a@-30,10", (-30.0, 10.0), ()),
        ("runs/a@@0,0.5,1", (), (0.0, 0.5, 1.0)),
        ("runs/a@330,10@1,2.5", (330.0, 10.0), (1.0, 2.5)),
    ],
)
def test_a_scene_comes_with_its_camera_and_moments(
    text: str, angles: tuple[float, ...], times: tuple[float, ...]
) -> None:
    assert told(text) == (Path("runs/a"), angles, times)
