# SPDX-License-Identifier: MIT
"""What operators do and see: stats, signals, limits, a machine that is too slow."""

from __future__ import annotations

import json
import os
import signal
import socket
import time
import urllib.error
import urllib.request
from collections.abc import Callable
from pathlib import Path

import pytest

from .conftest import Process, World
from .relay import Relay


def ask(port: int, path: str = "/") -> dict:
    with urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=60) as reply:
        assert reply.status == 200
        assert reply.headers["Content-Type"] == "application/json"
        return json.load(reply)


def await_line(process: Process, begin: str, end: str, limit_s: float = 120.0) -> None:
    until = time.monotonic() + limit_s
    while not any(begin in line and line.endswith(end) for line in process.log().splitlines()):
        assert time.monotonic() < until, process.log()
        time.sleep(0.05)


def listeners(port: int) -> list[str]:
    """Local addresses, as the kernel writes them, that a TCP port is open on."""
    found = []
    for table in ("/proc/net/tcp", "/proc/net/tcp6"):
        if not Path(table).exists():
            continue
        for line in Path(table).read_text().splitlines()[1:]:
            address, state = line.split()[1], line.split()[3]
            if state == "0A" and address.endswith(f":{port:04X}"):
                found.append(address)
    return found


def await_status(port: int, holds: Callable[[dict], bool], limit_s: float = 120.0) -> dict:
    """The status as soon as something holds of it."""
    end = time.monotonic() + limit_s
    while True:
        told = ask(port)
        if holds(told):
            return told
        assert time.monotonic() < end, told
        time.sleep(0.2)


def test_the_status_while_people_are_there(world: World) -> None:
    server = world.server()
    trainee = world.trainee("--name=Ada")
    observer = world.client("observer", "--name=Bob")
    trainee.await_text("joined")
    observer.await_text("joined")
    told = await_status(
        world.port,
        lambda seen: (
            [person["count"] > 16 * 60 for person in seen["people"]] == [True]
            and all(session["datagrams"] > 30 for session in seen["sessions"])
            and len(seen["sessions"]) == 2
        ),
    )
    assert told["role"] == "server"
    assert told["ticks"] > 60
    assert told["clients"] == 2
    assert told["is_slow"] == (told["speed"] < 0.95)
    people = {person["name"]: person for person in told["people"]}
    assert set(people) == {"Ada"}
    assert people["Ada"]["count"] > 16 * 60
    sessions = {session["name"]: session for session in told["sessions"]}
    assert set(sessions) == {"Ada", "Bob"}
    assert [sessions[name]["role"] for name in ("Ada", "Bob")] == ["trainee", "observer"]
    for session in sessions.values():
        assert session["state"] == "here"
        assert session["address"] == "127.0.0.1"
        assert 0.0 <= session["loss_percent"] < 50.0
        assert 0.0 < session["round_trip_ms"] < 5000.0
        assert 1.0 < session["sent_kbit_per_second"] < 250.0
        assert session["datagrams"] > 30
    assert set(told) == set(server.report()), "the report has the same stats"


def test_the_status_is_for_this_machine_only(world: World) -> None:
    world.server("--password=sesame", "--instructor-password=mellon")
    assert listeners(world.port) == [f"0100007F:{world.port:04X}"]
    text = json.dumps(ask(world.port, "/status"))
    assert "sesame" not in text
    assert "mellon" not in text
    with pytest.raises(urllib.error.HTTPError) as refused:
        ask(world.port, "/etc/passwd")
    assert refused.value.code == 404


def test_the_port_of_the_status(world: World) -> None:
    with socket.socket() as occupant:
        occupant.bind(("127.0.0.1", 0))
        occupant.listen()
        taken = occupant.getsockname()[1]
        server = world.server(f"--status-port={taken}")
        server.await_text(f"TCP port {taken} is in use: there is no status")
        world.client("observer").await_text("joined")
        assert server.process.poll() is None
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        other = probe.getsockname()[1]
    world.port += 1
    second = world.server(f"--status-port={other}", name="second")
    second.await_text(f"status at http://127.0.0.1:{other}/")
    assert ask(other)["clients"] == 0
    assert listeners(world.port) == []


def test_a_server_that_is_asked_to_end(world: World) -> None:
    server = world.server()
    trainee = world.trainee("--name=Ada")
    observer = world.client("observer")
    trainee.await_text("joined")
    observer.await_text("joined")
    server.await_report(lambda report: report["ticks"] > 60 and len(report["people"]) == 1)
    assert server.end() == 0, server.log()
    for client in (trainee, observer):
        # Whoever has to find it out by itself says that the connection is lost.
        client.await_text("was closed; trying again")
        assert "is lost" not in client.log()
    assert "stopped by a signal" in server.log()
    assert "ERROR" not in server.log()
    stats = server.report()
    assert stats["ticks"] > 60
    assert [person["name"] for person in stats["people"]] == ["Ada"]
    assert not Path(f"{server.report_file}.part").exists()
    world.server(name="second")
    trainee.await_text("joined", count=2)
    observer.await_text("joined", count=2)


def test_clients_that_are_asked_to_end(world: World) -> None:
    server = world.server()
    recording = world.folder / "session"
    trainee = world.trainee("--name=Ada")
    observer = world.client("observer", "--name=Bob", f"--record={recording}")
    trainee.await_text("joined")
    observer.await_text("joined")
    for client, name in ((observer, "Bob"), (trainee, "Ada")):
        client.await_report(lambda report: report["snapshots"] > 60)
        client.process.send_signal(signal.SIGTERM if name == "Bob" else signal.SIGINT)
        assert client.await_exit() == 0, client.log()
        await_line(server, f"'{name}' (", "left")
    assert " is lost" not in server.log()
    seen = observer.report()["snapshots"]
    replay = world.client("replay", f"--file={recording}", name="replay")
    assert replay.await_exit() == 0, replay.log()
    # What came while the level was loaded is in the file too, and was of no use before.
    assert replay.report()["snapshots"] >= seen, "nothing is missing at the end"


def test_a_machine_that_is_too_slow(world: World) -> None:
    server = world.server()
    trainee = world.trainee()
    observer = world.client("observer")
    trainee.await_text("joined")
    observer.await_text("joined")
    server.await_report(lambda report: len(report["people"]) == 1 and report["clients"] == 2)
    end = time.monotonic() + 120.0
    while "the machine is too slow" not in server.log():
        assert time.monotonic() < end, server.log()
        # The engine catches up with up to 8 steps at once: it has to stand for longer than that.
        os.kill(server.process.pid, signal.SIGSTOP)
        time.sleep(0.3)
        os.kill(server.process.pid, signal.SIGCONT)
        time.sleep(0.05)
    server.await_text("% of its speed (1 people, 2 clients)")
    server.await_text("the world runs at full speed again")
    for client in (trainee, observer):
        assert client.process.poll() is None
        assert client.log().count("joined") == 1
        assert "lost" not in client.log()
    assert ask(world.port)["slow_seconds"] >= 1


def test_a_share_of_the_network_is_kept(world: World) -> None:
    world.server("--bandwidth=64")
    trainees = [
        world.trainee("--fps=30", f"--name=T{number}", name=f"trainee{number}")
        for number in range(8)
    ]
    for trainee in trainees:
        trainee.await_text("joined")
    with Relay(world.port) as relay:
        observer = world.client("observer", f"--port={relay.port}", "--fps=60", "--name=Bob")
        observer.await_text("joined")
        # Until then the table is told as well, which is none of what the share is for.
        await_status(world.port, lambda status: len(status["people"]) == 8)
        time.sleep(2.0)
        kbit, end = 0.0, time.monotonic() + 120.0
        # A busy machine makes fewer ticks a second, and sends less; to an observer who acknowledges
        # late, less again: never more than the share, and once it has its turn, a good part of it.
        while kbit < 10.0:
            assert time.monotonic() < end, f"{kbit:.1f} kbit/s pass"
            before, began = relay.to_client, ask(world.port)["ticks"]
            time.sleep(3.0)
            passed, ticks = relay.to_client - before, ask(world.port)["ticks"] - began
            kbit = passed * 8.0 / 1000.0 / (ticks / 60.0)
            print(f"{kbit:.1f} kbit/s pass")
            assert kbit < 64.0 * 1.1
            rows = ask(world.port)["sessions"]
            assert all(row["sent_kbit_per_second"] < 64.0 * 1.1 for row in rows)
        observer.await_report(lambda report: report["snapshots"] > 30)


def test_whoever_leaves_makes_room(world: World) -> None:
    server = world.server("--max-clients=2")
    stays = world.client("observer", name="stays")
    leaves = world.client("observer", "--name=Leaves", name="leaves")
    stays.await_text("joined")
    leaves.await_text("joined")
    assert world.client("observer", name="third").await_exit() == 3
    leaves.process.send_signal(signal.SIGTERM)
    await_line(server, "'Leaves' (", "left")
    world.client("observer", name="fourth").await_text("joined")
    # The server counts it when it has taken in that the client has.
    end = time.monotonic() + 60.0
    while ask(world.port)["clients"] != 2:
        assert time.monotonic() < end, server.log()
        time.sleep(0.05)
    assert "lost" not in stays.log()


def test_one_person_takes_less_than_40_kbit_per_second(world: World) -> None:
    world.server()
    world.trainee("--fps=120").await_text("joined")
    with Relay(world.port) as relay:
        observer = world.client("observer", f"--port={relay.port}", "--snapshot-rate=30")
        observer.await_text("joined")
        observer.await_report(lambda report: report["snapshots"] > 30)
        seen = observer.fresh_report()["snapshots"]
        before, began = relay.to_client, ask(world.port)["ticks"]
        last = observer.await_report(lambda report: report["snapshots"] > seen + 120)["snapshots"]
        # A busy machine makes fewer ticks a second.
        seconds = (ask(world.port)["ticks"] - began) / 60.0
        kbit = (relay.to_client - before) * 8.0 / 1000.0 / seconds
        rate = (last - seen) / seconds
    print(f"{kbit:.1f} kbit/s at {rate:.0f} snapshots/s")
    assert 20.0 < rate < 40.0
    assert 5.0 < kbit < 40.0


def test_a_recording_goes_on_over_a_restart_of_the_server(world: World) -> None:
    server = world.server()
    recording = world.folder / "session"
    world.trainee("--name=Ada").await_text("joined")
    observer = world.client("observer", f"--record={recording}")
    observer.await_text("joined")
    before = observer.await_report(lambda report: report["snapshots"] > 30)["snapshots"]
    assert server.end() == 0
    world.server(name="second")
    observer.await_text("joined", count=2)
    observer.await_report(lambda report: report["snapshots"] > before + 120)
    assert observer.end() == 0
    seen = observer.report()["snapshots"]
    replay = world.client("replay", f"--file={recording}", name="replay")
    assert replay.await_exit() == 0, replay.log()
    assert "ERROR" not in replay.log()
    assert replay.report()["snapshots"] >= seen
