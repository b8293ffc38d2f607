# SPDX-License-Identifier: MIT
"""Displays in a session: what a window shows of another display, and of one that cannot be."""

from __future__ import annotations

from pathlib import Path

from toolchain.paths import CLIENT_BINARY

from .conftest import SOFTWARE, WINDOW_LIMIT_S, World
from .test_views import Pixel, read_png

WALL = """[station]
eye = 0 1.7 0

[screen front]
bottom-left = -1 1 -1.5
bottom-right = 1 1 -1.5
top-left = -1 2.125 -1.5
top-right = 1 2.125 -1.5
position = 0 0
size = 640 360
"""


def difference(one: list[list[Pixel]], other: list[list[Pixel]]) -> float:
    """The mean difference of two pictures, 0 to 255."""
    pairs = [(a, b) for r, s in zip(one, other, strict=True) for a, b in zip(r, s, strict=True)]
    return sum(abs(a[i] - b[i]) for a, b in pairs for i in range(3)) / (3 * len(pairs))


def look(world: World, display: dict[str, str], name: str, *options: str) -> list[list[Pixel]]:
    """The window of an observer with such a display."""
    picture = world.folder / f"{name}.png"
    world.take_picture(display, picture, "--camera=0,20,4", *options, name=name, size="640x360")
    return read_png(picture)


def test_both_eyes_see_the_session_side_by_side(world: World, display: dict[str, str]) -> None:
    world.server()
    world.trainee().await_text("joined")
    rows = look(world, display, "stereo", "--display=side-by-side")
    left = [row[:320] for row in rows]
    right = [row[320:] for row in rows]
    # The same world, from places that are apart.
    assert 0.3 < difference(left, right) < 40.0


def test_a_wall_shows_the_session(world: World, display: dict[str, str], tmp_path: Path) -> None:
    world.server()
    world.trainee().await_text("joined")
    layout = tmp_path / "one.wall"
    layout.write_text(WALL, encoding="utf-8")
    rows = look(world, display, "wall", "--display=wall", f"--layout={layout}")
    colours = {pixel for row in rows[60:300] for pixel in row}
    assert len(colours) > 200, "nothing of the world is seen"


def test_what_cannot_be_shown_is_said_and_the_window_goes_on(
    world: World, display: dict[str, str], tmp_path: Path
) -> None:
    world.server()
    world.trainee().await_text("joined")
    flat = tmp_path / "flat.wall"
    flat.write_text(WALL.replace("top-left = -1 2.125", "top-left = -1 1"), encoding="utf-8")
    cases = {
        "hmd": (["--display=hmd"], "OpenXR"),
        "flat": (["--display=wall", f"--layout={flat}"], "flat.wall:"),
        "none": (["--display=wall", "--layout=/nonexistent.wall"], "/nonexistent.wall"),
    }
    for name, (options, why) in cases.items():
        environment = {**display, "XR_RUNTIME_JSON": "/nonexistent.json"}
        rows = look(world, environment, name, *options)
        said = log_of(world, name)
        assert why in said, said
        assert len({pixel for row in rows[60:300] for pixel in row}) > 200, name


def test_a_wearer_without_a_headset_sees_the_session_and_why(
    world: World, display: dict[str, str], tmp_path: Path
) -> None:
    world.server()
    world.trainee().await_text("joined")
    environment = {**display, "XR_RUNTIME_JSON": "/nonexistent.json"}
    options = ["--role=trainee", "--display=hmd", f"--port={world.port}", "--quality=low"]
    picture = tmp_path / "wearer.png"
    options.append(f"--screenshot={picture}")
    command = [str(CLIENT_BINARY), *SOFTWARE, "--resolution", "320x180", "--", *options]
    wearer = world.start("wearer", command, environment)
    # Nothing moves a body instead of the headset, and nothing keeps its wearer out.
    seen = wearer.await_report(
        lambda report: report["shown_frames"] > 4 and report["latency_count"] > 0, WINDOW_LIMIT_S
    )
    assert seen["people"] == []
    assert "No headset: the OpenXR runtime" in wearer.log()
    assert "needs a motion source" not in wearer.log()
    # What the window says for as long as it waits: the news of it have gone by then.
    wearer.await_report(lambda report: report["seconds"] > seen["seconds"] + 8.0, WINDOW_LIMIT_S)
    wearer.end()
    rows = read_png(picture)
    assert sum(is_note(pixel) for row in rows[:90] for pixel in row) > 40


def is_note(pixel: Pixel) -> bool:
    """Notes are amber."""
    red, green, blue = pixel
    return red > 200 and 150 < green < 220 and 60 < blue < 130


def log_of(world: World, name: str) -> str:
    """What a client has said."""
    return (world.folder / f"{name}.log").read_text(encoding="utf-8", errors="replace")
