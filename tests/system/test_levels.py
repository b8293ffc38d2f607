# SPDX-License-Identifier: MIT
"""Levels that a server offers, over real processes: download, stop, damage, refusal, change."""

from __future__ import annotations

import hashlib
import json
import random
from pathlib import Path

import pytest
from toolchain.paths import ROOT

from .conftest import Process, World

HALL = ROOT / "scenes" / "world" / "hall" / "hall.tscn"


def make_level(share: Path, name: str = "range", further_bytes: int = 0, scene: str = "") -> str:
    """A folder of a level as ./run level pack makes it; returns its hash."""
    folder = share / name
    folder.mkdir(parents=True)
    text = scene or HALL.read_text(encoding="utf-8").replace('title = "Hall"', f'title = "{name}"')
    files = {f"{name}.tscn": text.encode()}
    if further_bytes:
        files[f"{name}.bake"] = random.Random(7).randbytes(further_bytes)
    rows = []
    for file, content in files.items():
        (folder / file).write_bytes(content)
        digest = hashlib.sha256(content).hexdigest()
        rows.append({"name": file, "size": len(content), "sha256": digest})
    manifest = {"format": 1, "kit": 1, "name": name, "title": name.title(), "files": rows}
    content = json.dumps(manifest).encode()
    (folder / "level.json").write_bytes(content)
    return hashlib.sha256(content).hexdigest()


def stored(world: World, digest: str) -> Path:
    """Where the clients of a test keep a level."""
    found = list((world.folder / "DATA").rglob(f"levels/{digest}"))
    assert len(found) == 1, found
    return found[0]


def await_level(client: Process, name: str) -> dict:
    """What a client says of its level, once it has one of a name."""
    return client.await_report(
        lambda seen: seen["level"]["name"] == name and seen["level"]["waits_for"] == "nothing"
    )["level"]


@pytest.fixture
def share(tmp_path: Path) -> Path:
    return tmp_path / "share"


def test_a_client_gets_the_level_that_it_lacks_once(world: World, share: Path) -> None:
    digest = make_level(share, further_bytes=3_000_000)
    server = world.server(f"--levels={share}", "--world=range")
    trainee = world.trainee()
    level = await_level(trainee, "range")
    assert level["downloaded_bytes"] > 3_000_000
    assert "is not the server's" not in trainee.log()
    assert (stored(world, digest) / "range.bake").stat().st_size == 3_000_000
    # It has a body, and what it sends arrives.
    server.await_report(lambda seen: len(seen["people"]) == 1)
    trainee.end()
    observer = world.client("observer")
    assert await_level(observer, "range")["downloaded_bytes"] == 0
    assert "ERROR" not in server.log() + trainee.log() + observer.log()


def test_a_client_that_is_killed_halfway_goes_on_later(world: World, share: Path) -> None:
    make_level(share, further_bytes=2_000_000)
    world.server(f"--levels={share}", "--world=range", "--level-bandwidth=4000")
    first = world.client("observer", name="first")
    first.await_report(lambda seen: 0.3 < seen["level"]["progress"] < 1.0)
    first.kill()
    second = world.client("observer", name="second")
    level = await_level(second, "range")
    assert level["resumed_bytes"] > 400_000
    assert level["downloaded_bytes"] < 2_000_000


def test_a_download_goes_on_when_the_server_is_back(world: World, share: Path) -> None:
    make_level(share, further_bytes=2_000_000)
    options = (f"--levels={share}", "--world=range", "--level-bandwidth=4000")
    server = world.server(*options)
    client = world.client("observer")
    client.await_report(lambda seen: 0.3 < seen["level"]["progress"] < 1.0)
    server.kill()
    world.server(*options, name="again")
    assert await_level(client, "range")["resumed_bytes"] > 400_000


def test_a_damaged_store_is_noticed(world: World, share: Path) -> None:
    digest = make_level(share, further_bytes=100_000)
    world.server(f"--levels={share}", "--world=range")
    first = world.client("observer", name="first")
    await_level(first, "range")
    first.end()
    file = stored(world, digest) / "range.bake"
    content = bytearray(file.read_bytes())
    content[50_000] ^= 1
    file.write_bytes(content)
    second = world.client("observer", name="second")
    second.await_text("the stored world 'range' is damaged (range.bake is not what level.json says")
    assert await_level(second, "range")["downloaded_bytes"] > 100_000


def test_what_differs_from_its_hash_is_refused_and_the_client_stays(
    world: World, share: Path
) -> None:
    make_level(share, further_bytes=100_000)
    server = world.server(f"--levels={share}", "--world=range")
    # The server has read the level; what it sends from now on is something else.
    (share / "range" / "range.bake").write_bytes(b"x" * 100_000)
    client = world.client("observer")
    client.await_text("range.bake is not what was offered: its SHA-256 differs")
    waiting = client.await_report(lambda seen: seen["level"]["waits_for"] == "another")
    assert waiting["level"]["loaded"] == 0
    world.client("instructor", "--orders=world:hall")
    await_level(client, "hall")
    assert server.report()["clients"] >= 1
    assert client.log().count("joined") == 1


def test_a_change_of_level_drops_nobody(world: World, share: Path) -> None:
    make_level(share, further_bytes=500_000)
    make_level(
        share, "broken", scene=HALL.read_text(encoding="utf-8") + '\n[connection signal="x"]'
    )
    server = world.server(f"--levels={share}")
    trainees = [world.trainee(f"--name=T{i}", name=f"trainee{i}") for i in range(2)]
    for trainee in trainees:
        await_level(trainee, "hall")
    world.client("instructor", "--orders=world:range").await_text("the world is now 'range'")
    for trainee in trainees:
        assert await_level(trainee, "range")["seconds"] < 10.0
    for order, answer in {
        "broken": "world 'broken' is refused: broken.tscn, line",
        "atlantis": "there is no world 'atlantis' here: ",
    }.items():
        world.client("instructor", f"--orders=world:{order}", name=order).await_text(answer)
    report = server.fresh_report()
    assert report["level"]["name"] == "range"
    assert report["clients"] >= 2
    assert len(report["people"]) == 2
    for word in ("is lost", "is back", "thrown"):
        assert word not in server.log()
    for trainee in trainees:
        assert trainee.log().count("joined") == 1


def test_a_share_that_cannot_be_used_is_named(world: World, share: Path) -> None:
    make_level(share)
    manifest = share / "range" / "level.json"
    manifest.write_text(manifest.read_text().replace('"kit": 1', '"kit": 3'))
    for options, words in {
        (f"--levels={share}/none",): "there is no folder",
        (f"--levels={share}", "--world=range"): "it needs level kit 3; this program has 1",
        (f"--levels={share}", "--world=rang"): "did you mean range?",
    }.items():
        server = world.server(*options, name="wrong", wait=False)
        assert server.await_exit() == 2
        assert words in server.log()


def test_a_server_ends_while_it_loads_a_level(world: World) -> None:
    server = world.server()
    world.client("instructor", "--orders=world:town", name="instructor")
    server.await_text("loading world 'town'")
    # A thread that loads waits for a frame: whoever waits for that thread instead hangs.
    assert server.end() == 0, server.log()
