# SPDX-License-Identifier: MIT
"""A session as its users see it: who joins, what moves, what is measured, what is kept."""

from __future__ import annotations

import csv
from pathlib import Path

from toolchain.paths import CLIPS

from .conftest import World, shared
from .own_client import Crowd, OwnClient
from .own_seal import VERSION

# Stretches of steps in one of which a machine beside other work keeps up.
STRETCHES = 20


class Session:
    """A server and a trainee."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.server = world.server()
        self.trainee = world.trainee("--name=Ada")
        self.server.await_line("trainee 'Ada' (", "joined")

    def await_steps(self, name: str, steps: int) -> tuple[dict, dict]:
        """What the server says of a person, and again when its body has made so many steps."""

        def of(told: dict) -> dict:
            return {person["name"]: person for person in told["people"]}[name]

        before = of(self.server.await_report(lambda told: bool(of(told))))
        after = self.server.await_report(
            lambda told: of(told)["count"] > before["count"] + 16 * steps
        )
        return before, of(after)

    def await_following(self, name: str, steps: int, most_deg: float) -> float:
        """Mean error of a person's limbs over so many steps, degrees.

        A machine that is held up keeps samples from the server, which counts in the mean of all
        steps so far: it is asked of a stretch in which the body could follow, soon or later.
        """
        mean = 180.0
        for _ in range(STRETCHES):
            before, after = self.await_steps(name, steps)
            sums = [row["mean_deg"] * row["count"] for row in (before, after)]
            mean = (sums[1] - sums[0]) / (after["count"] - before["count"])
            if mean < most_deg:
                break
        return mean


session = shared(Session)


def test_a_trainee_moves_and_an_observer_sees_it(session: Session) -> None:
    observer = session.world.client("observer")
    observer.await_report(lambda seen: seen["snapshots"] > 60 and seen["latency_count"] > 0)
    assert session.await_following("Ada", 60, 5.0) < 5.0
    assert observer.end() == 0, observer.log()
    assert observer.report()["latency_ms_mean"] > 0.0
    assert "ERROR" not in observer.log()


def test_a_second_trainee_has_a_body_of_its_own_and_leaves(session: Session) -> None:
    """Its file counts from where the program was started."""
    (session.world.folder / "box.bvh").write_bytes((CLIPS / "Boxing_Toes.bvh").read_bytes())
    trainee = session.world.client(
        "trainee", "--bvh=box.bvh", "--name=Bob", name="bob", cwd=session.world.folder
    )
    session.await_steps("Bob", 30)
    session.await_steps("Ada", 30)
    people = session.server.report()["people"]
    assert sorted(person["name"] for person in people) == ["Ada", "Bob"]
    trainee.await_report(lambda seen: seen["snapshots"] > 10)
    assert trainee.end() == 0, trainee.log()
    assert "ERROR" not in trainee.log()
    session.server.await_line("'Bob' (", "left")


def test_what_an_observer_has_written_survives_a_kill(session: Session) -> None:
    """A recording, and the latency of each sample."""
    recording = session.world.folder / "session"
    file = session.world.folder / "latency.csv"
    options = (f"--record={recording}", f"--latency-csv={file}", "--fps=60")
    observer = session.world.client("observer", *options)
    # The recording is on the disk after a second.
    observer.await_report(
        lambda seen: (
            seen["snapshots"] > 60 and len(_rows(file)) > 60 and recording.stat().st_size > 10000
        )
    )
    observer.kill()
    rows = _rows(file)
    assert list(rows[0])[:4] == ["person", "sample", "tick", "sampled_usec"]
    samples = [int(row["sample"]) for row in rows]
    assert len(set(samples)) == len(samples)
    for row in rows[:-1]:
        total = (int(row["displayed_usec"]) - int(row["sampled_usec"])) / 1000.0
        assert abs(total - float(row["total_ms"])) < 0.01
        # A starved observer shows what is old; a wrong clock would be off by years.
        assert -5.0 < total < 60000.0
    replay = session.world.client("replay", f"--file={recording}", name="replay")
    assert replay.await_exit() == 0, replay.log()
    assert replay.report()["snapshots"] > 20
    assert "ERROR" not in replay.log()


def _rows(file: Path) -> list[dict[str, str]]:
    with file.open(encoding="utf-8") as handle:
        return list(csv.DictReader(handle))


def test_a_wrong_version_is_refused(session: Session) -> None:
    client = session.world.client("observer", "--protocol=999")
    assert client.await_exit() == 3
    assert f"protocol version 999, the server {VERSION}" in client.log()
    session.server.await_text("protocol version 999")
    assert session.server.log().count("protocol version 999") == 1


def test_a_place_is_kept_for_who_was_killed_and_free_for_others_when_he_is_lost(
    world: World,
) -> None:
    server = world.server("--max-clients=1")
    first = world.trainee("--name=Ada")
    server.await_report(lambda report: report["people"][0]["count"] > 0)
    first.kill()
    again = world.trainee("--name=Ada", name="again")
    again.await_text("joined")
    server.await_text("'Ada' (1) from 127.0.0.1 is back")
    report = server.await_report(lambda report: report["sessions"][0]["state"] == "here")
    assert [(row["session"], row["name"]) for row in report["sessions"]] == [(1, "Ada")]
    assert len(report["people"]) == 1
    # Somebody else waits for room, until the place is that of a lost connection.
    other = world.client("observer", name="other")
    other.await_text("waiting for room, position 1")
    # On a slow machine the first connection was lost too, before its trainee came back.
    lost_before = server.log().count("is lost")
    again.kill()
    server.await_text("is lost", count=lost_before + 1)
    other.await_text("joined")
    server.await_text("'Ada' (1) from 127.0.0.1 left")
    with Crowd() as crowd:
        last = OwnClient(world.port, name="last")
        crowd.add(last)
        crowd.go_on_until(lambda: (last.position, last.waits_for) == (1, 1))
        # Whoever leaves makes room.
        other.process.terminate()
        crowd.go_on_until(lambda: last.is_joined)
        server.await_report(lambda report: report["clients"] == 1)
    assert other.await_exit() == 0
    assert "ERROR" not in server.log()
