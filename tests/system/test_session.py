# SPDX-License-Identifier: MIT
"""A session as its users see it: who joins, what moves, what is measured, what is kept."""

from __future__ import annotations

from toolchain.paths import CLIPS

from .conftest import World


def test_a_trainee_moves_and_an_observer_sees_it(world: World) -> None:
    server = world.server()
    trainee = world.trainee("--name=Ada")
    trainee.await_text("joined")
    observer = world.client("observer", f"--record={world.folder / 'session'}")
    observer.await_report(lambda seen: seen["snapshots"] > 60 * 4 and seen["latency_count"] > 3)
    stats = server.await_report(lambda told: told["people"][0]["count"] > 16 * 60 * 5)
    for client in (observer, trainee):
        client.process.terminate()
        assert client.await_exit() == 0, client.log()
    person = stats["people"][0]
    assert person["name"] == "Ada"
    assert person["mean_deg"] < 5.0
    assert observer.report()["latency_ms_mean"] > 0.0
    assert "trainee 'Ada'" in server.log()
    assert "ERROR" not in server.log() + trainee.log() + observer.log()


def test_two_trainees_have_two_bodies(world: World) -> None:
    server = world.server()
    first = world.trainee("--name=Ada", name="ada")
    second = world.trainee("--name=Bob", name="bob", clip="Boxing_Toes.bvh")
    first.await_text("joined")
    second.await_text("joined")
    stats = server.await_report(
        lambda told: (
            len(told["people"]) == 2 and all(person["count"] > 16 * 60 for person in told["people"])
        )
    )
    assert {person["name"] for person in stats["people"]} == {"Ada", "Bob"}


def test_a_recording_can_be_played_and_survives_a_kill(world: World) -> None:
    world.server()
    trainee = world.trainee()
    trainee.await_text("joined")
    recording = world.folder / "session"
    observer = world.client("observer", f"--record={recording}")
    observer.await_text("joined")
    observer.await_report(lambda seen: seen["snapshots"] > 60 * 3)
    observer.kill()
    replay = world.client("replay", f"--file={recording}", name="replay")
    assert replay.await_exit() == 0, replay.log()
    assert replay.report()["snapshots"] > 60
    assert "ERROR" not in replay.log()


def test_a_person_leaves_and_another_comes(world: World) -> None:
    server = world.server()
    first = world.trainee(name="first")
    first.await_report(lambda seen: seen["snapshots"] > 10)
    assert first.end() == 0
    server.await_text("left")
    again = world.trainee(name="second")
    again.await_report(lambda seen: seen["snapshots"] > 60)
    assert again.end() == 0
    assert "ERROR" not in server.log()


def test_the_server_is_full(world: World) -> None:
    world.server("--max-clients=1")
    world.client("observer", name="first").await_text("joined")
    second = world.client("observer", name="second")
    assert second.await_exit() == 3
    assert "the server is full" in second.log()


def test_files_count_from_where_the_program_was_started(world: World) -> None:
    world.server()
    (world.folder / "walk.bvh").write_bytes((CLIPS / "01_01.bvh").read_bytes())
    trainee = world.client("trainee", "--bvh=walk.bvh", cwd=world.folder)
    trainee.await_text("joined")
    assert trainee.end() == 0, trainee.log()


def test_a_killed_trainee_that_is_started_anew_has_its_body_again(world: World) -> None:
    server = world.server("--max-clients=1")
    first = world.trainee("--name=Ada")
    server.await_report(lambda report: report["people"] and report["people"][0]["count"] > 0)
    first.kill()
    again = world.trainee("--name=Ada", name="again")
    again.await_text("joined")
    server.await_text("'Ada' (1) from 127.0.0.1 is back")
    report = server.await_report(lambda report: report["sessions"][0]["state"] == "here")
    assert [(row["session"], row["name"]) for row in report["sessions"]] == [(1, "Ada")]
    assert len(report["people"]) == 1
    # Somebody else finds no room, until the place is that of a lost connection.
    other = world.client("observer", name="other")
    assert other.await_exit() == 3
    # On a slow machine the first connection was lost too, before its trainee came back.
    lost_before = server.log().count("is lost")
    again.kill()
    server.await_text("is lost", count=lost_before + 1)
    late = world.client("observer", name="late")
    late.await_text("joined")
    assert "'Ada' (1) from 127.0.0.1 left" in server.log()
