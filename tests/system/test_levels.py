# SPDX-License-Identifier: MIT
"""Levels that a server offers, over real processes: download, stop, damage, refusal, change."""

from __future__ import annotations

import hashlib
import json
import random
from pathlib import Path

from toolchain.paths import ROOT

from .conftest import Process, World, shared
from .own_client import TRAINEE, Crowd, OwnClient

# Of a level's largest file, and the speed at which it is offered: two seconds of each download.
SIZE = 1_000_000
KBITS = 4000
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


class Range:
    """A server that offers levels of its own, slowly, and an instructor."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.share = world.folder / "share"
        self.share.mkdir()
        self.options = [f"--levels={self.share}", f"--level-bandwidth={KBITS}"]
        self.server = world.server(*self.options)
        self.instructor = world.instructor()

    def stored(self, digest: str) -> Path:
        """Where the clients keep a level."""
        found = list((self.world.folder / "DATA").rglob(f"levels/{digest}"))
        assert len(found) == 1, found
        return found[0]

    def change_to(self, name: str) -> None:
        """Lets the instructor change the level."""
        self.instructor.mark()
        self.instructor.type(f"level {name}")
        self.instructor.await_text(f"the world is now '{name}'")


def await_level(client: Process, name: str) -> dict:
    """What a client says of its level, once it has one of a name."""
    return client.await_report(
        lambda seen: seen["level"]["name"] == name and seen["level"]["waits_for"] == "nothing"
    )["level"]


offers = shared(Range)


def test_a_client_gets_the_level_that_it_lacks_once_and_again_where_it_was_damaged(
    offers: Range,
) -> None:
    digest = make_level(offers.share, "once", further_bytes=SIZE)
    offers.change_to("once")
    people = len(offers.server.report()["people"])
    trainee = offers.world.trainee()
    level = await_level(trainee, "once")
    assert level["downloaded_bytes"] > SIZE
    assert "is not the server's" not in trainee.log()
    file = offers.stored(digest) / "once.bake"
    assert file.stat().st_size == SIZE
    # It has a body, and what it sends arrives.
    offers.server.await_report(lambda seen: len(seen["people"]) == people + 1)
    assert trainee.end() == 0
    observer = offers.world.client("observer")
    assert await_level(observer, "once")["downloaded_bytes"] == 0
    assert observer.end() == 0
    content = bytearray(file.read_bytes())
    content[SIZE // 2] ^= 1
    file.write_bytes(content)
    late = offers.world.client("observer", name="late")
    late.await_text("the stored world 'once' is damaged (once.bake is not what level.json says")
    assert await_level(late, "once")["downloaded_bytes"] > SIZE
    assert "ERROR" not in trainee.log() + observer.log()


def test_a_client_that_is_killed_halfway_goes_on_later(offers: Range) -> None:
    make_level(offers.share, "half", further_bytes=SIZE)
    offers.change_to("half")
    first = offers.world.client("observer", name="first")
    first.await_report(lambda seen: 0.3 < seen["level"]["progress"] < 1.0)
    first.kill()
    second = offers.world.client("observer", name="second")
    level = await_level(second, "half")
    assert level["resumed_bytes"] > 0.2 * SIZE
    assert level["downloaded_bytes"] < SIZE


def test_what_differs_from_its_hash_is_refused_and_the_client_stays(offers: Range) -> None:
    make_level(offers.share, "other", further_bytes=100_000)
    offers.change_to("other")
    # The server has read the level; what it sends from now on is something else.
    (offers.share / "other" / "other.bake").write_bytes(b"x" * 100_000)
    client = offers.world.client("observer")
    client.await_text("other.bake is not what was offered: its SHA-256 differs")
    waiting = client.await_report(lambda seen: seen["level"]["waits_for"] == "another")
    assert waiting["level"]["loaded"] == 0
    offers.change_to("hall")
    await_level(client, "hall")
    assert client.log().count("joined") == 1


def test_a_change_of_level_drops_nobody(offers: Range) -> None:
    make_level(offers.share, "range", further_bytes=100_000)
    broken = HALL.read_text(encoding="utf-8") + '\n[connection signal="x"]'
    make_level(offers.share, "broken", scene=broken)
    offers.change_to("hall")
    people = len(offers.server.report()["people"])
    trainee = offers.world.trainee("--name=T0")
    await_level(trainee, "hall")
    with Crowd() as crowd:
        # The other one only listens; it is lost as soon as nobody lets it go on for some seconds.
        other = OwnClient(offers.world.port, TRAINEE, name="T1")
        crowd.join([other])
        offers.server.mark()
        # It may have to wait for its turn: the other one goes on listening.
        offers.instructor.type("level range")
        crowd.go_on_until(lambda: "the world is now 'range'" in offers.instructor.log())
        crowd.go_on_until(lambda: "world 'range' is there" in trainee.log())
        _refuse_levels(offers, crowd)
        report = offers.server.report()
        assert report["level"]["name"] == "range"
        here = {row["name"] for row in report["sessions"] if row["state"] == "here"}
        assert here == {"instructor", "T0", "T1"}
        assert len(report["people"]) == people + 1
        crowd.go_on()
        assert not other.is_gone
        for word in ("is lost", "is back", "thrown"):
            assert word not in offers.server.log()
    assert trainee.log().count("joined") == 1


def _refuse_levels(offers: Range, crowd: Crowd) -> None:
    for order, answer in {
        "broken": "world 'broken' is refused: broken.tscn, line",
        "atlantis": "there is no world 'atlantis' here: ",
    }.items():
        offers.instructor.type(f"level {order}")
        crowd.go_on_until(lambda answer=answer: answer in offers.instructor.log())


def test_a_download_goes_on_when_the_server_is_back_and_it_ends_while_it_loads(
    offers: Range,
) -> None:
    offers.world.is_spent = True
    make_level(offers.share, "back", further_bytes=SIZE)
    offers.change_to("back")
    client = offers.world.client("observer")
    client.await_report(lambda seen: 0.3 < seen["level"]["progress"] < 1.0)
    offers.server.kill()
    server = offers.world.server(*offers.options, "--world=back", name="again")
    assert await_level(client, "back")["resumed_bytes"] > 0.2 * SIZE
    server.await_line("instructor 'instructor' (", "joined")
    offers.instructor.type("level town")
    server.await_text("loading world 'town'")
    # A thread that loads waits for a frame: whoever waits for that thread instead hangs.
    assert server.end() == 0, server.log()


def test_a_share_that_cannot_be_used_is_named(world: World) -> None:
    share = world.folder / "share"
    make_level(share)
    manifest = share / "range" / "level.json"
    manifest.write_text(manifest.read_text().replace('"kit": 1', '"kit": 3'))
    server = world.server(f"--levels={share}", "--world=range", wait=False)
    assert server.await_exit() == 2
    assert "it needs level kit 3; this program has 1" in server.log()
