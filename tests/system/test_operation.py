# SPDX-License-Identifier: MIT
"""What operators do and see: stats, signals, a machine that is too slow, traffic, a restart."""

from __future__ import annotations

import json
import os
import signal
import socket
import time
import urllib.error
from pathlib import Path

import pytest
from toolchain.processes import free_port
from toolchain.udp_relay import Relay

from .conftest import World, ask, shared
from .own_client import Crowd, OwnClient

PASSWORDS = ["--password=sesame", "--instructor-password=mellon"]
# Bytes that pass for a snapshot of one person: 40 kbit/s, if 30 come a second.
SNAPSHOT_BYTES = 40_000 / 8 / 30


class Session:
    """A server whose status has a port of its own, a trainee and an observer."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.options = [*PASSWORDS, f"--status-port={free_port()}"]
        self.server = world.server(*self.options)
        self.server.await_text(f"status at http://127.0.0.1:{self.server.status_port}/")
        self.trainee = world.trainee("--name=Ada", PASSWORDS[0])
        self.observer = world.client("observer", "--name=Bob", PASSWORDS[0])
        for client in (self.trainee, self.observer):
            client.await_text("joined")


session = shared(Session)


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


def test_the_status_while_people_are_there(session: Session) -> None:
    told = session.server.await_report(
        lambda seen: (
            [person["count"] > 16 * 60 for person in seen["people"]] == [True]
            and all(row["datagrams"] > 30 and row["round_trip_ms"] > 0 for row in seen["sessions"])
        )
    )
    assert told["role"] == "server"
    assert told["ticks"] > 60
    assert told["clients"] == 2
    assert told["memory_bytes"] > 20_000_000
    assert told["is_slow"] == (told["speed"] < 0.95)
    assert [person["name"] for person in told["people"]] == ["Ada"]
    sessions = {row["name"]: row for row in told["sessions"]}
    assert set(sessions) == {"Ada", "Bob"}
    assert [sessions[name]["role"] for name in ("Ada", "Bob")] == ["trainee", "observer"]
    for row in sessions.values():
        assert row["state"] == "here"
        assert row["address"] == "127.0.0.1"
        assert 0.0 <= row["loss_percent"] <= 100.0
        assert row["sent_kbit_per_second"] > 0.0
    written = json.loads(session.server.report_file.read_text(encoding="utf-8"))
    assert set(told) == set(written), "the report has the same stats"


def test_the_status_is_for_this_machine_only(session: Session) -> None:
    port = session.server.status_port
    assert listeners(port) == [f"0100007F:{port:04X}"]
    assert listeners(session.world.port) == []
    text = json.dumps(ask(port, "/status"))
    assert "sesame" not in text
    assert "mellon" not in text
    with pytest.raises(urllib.error.HTTPError) as refused:
        ask(port, "/etc/passwd")
    assert refused.value.code == 404


def test_a_status_whose_port_is_in_use(world: World) -> None:
    with socket.socket() as occupant, Crowd() as crowd:
        occupant.bind(("127.0.0.1", 0))
        occupant.listen()
        taken = occupant.getsockname()[1]
        server = world.server(f"--status-port={taken}")
        server.await_text(f"TCP port {taken} is in use: there is no status")
        crowd.join([OwnClient(world.port)])
        assert server.process.poll() is None


def test_a_machine_that_is_too_slow(session: Session) -> None:
    server = session.server
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
    for client in (session.trainee, session.observer):
        assert client.process.poll() is None
        assert "joined" not in client.log(), "it came back"
        assert "lost" not in client.log()
    assert server.report()["slow_seconds"] >= 1


def test_a_snapshot_of_one_person_is_short_and_comes_as_often_as_was_asked_for(
    session: Session,
) -> None:
    with Relay(session.world.port) as relay:
        options = (f"--port={relay.port}", "--snapshot-rate=30", PASSWORDS[0])
        observer = session.world.client("observer", *options, name="relayed")
        observer.await_report(lambda report: report["snapshots"] > 30)
        began = session.server.report()["ticks"]
        # A report is a moment old: those that came meanwhile count as snapshots, not as bytes.
        seen = observer.fresh_report()["snapshots"]
        before = relay.to_client
        observer.await_report(lambda report: report["snapshots"] > seen + 120)
        passed = relay.to_client - before
        last = observer.fresh_report()["snapshots"] - seen
        ticks = session.server.report()["ticks"] - began
        assert observer.end() == 0
    print(f"{passed / last:.0f} bytes a snapshot, {last} snapshots in {ticks} ticks")
    assert passed / last < SNAPSHOT_BYTES
    # 30 of 60 ticks a second.
    assert last <= ticks // 2 + 2


def test_a_recording_goes_on_over_a_restart_and_all_end_when_they_are_asked_to(
    session: Session,
) -> None:
    session.world.is_spent = True
    recording = session.world.folder / "session"
    options = (f"--record={recording}", "--name=Cid", PASSWORDS[0])
    recorder = session.world.client("observer", *options, name="recorder")
    before = recorder.await_report(lambda report: report["snapshots"] > 30)["snapshots"]
    clients = (session.trainee, session.observer, recorder)
    assert session.server.end() == 0, session.server.log()
    for client in clients:
        # Whoever has to find it out by itself says that the connection is lost.
        client.await_text("was closed; trying again")
        assert "is lost" not in client.log()
        client.mark()
    assert "stopped by a signal" in session.server.log()
    assert "ERROR" not in session.server.log()
    stats = session.server.report()
    assert stats["ticks"] > 60
    assert [person["name"] for person in stats["people"]] == ["Ada"]
    assert not Path(f"{session.server.report_file}.part").exists()
    server = session.world.server(*session.options, name="second")
    for client in clients:
        client.await_text("joined")
    recorder.await_report(lambda report: report["snapshots"] > before + 60)
    for client, name, number in (
        (recorder, "Cid", signal.SIGTERM),
        (session.trainee, "Ada", signal.SIGINT),
    ):
        client.process.send_signal(number)
        assert client.await_exit() == 0, client.log()
        server.await_line(f"'{name}' (", "left")
    assert " is lost" not in server.log()
    seen = recorder.report()["snapshots"]
    replay = session.world.client("replay", f"--file={recording}", name="replay")
    assert replay.await_exit() == 0, replay.log()
    assert "ERROR" not in replay.log()
    # What came while the level was loaded is in the file too, and was of no use before.
    assert replay.report()["snapshots"] >= seen, "nothing is missing at the end"


def test_many_signals_are_one_clean_end(world: World) -> None:
    server = world.server()
    with Crowd() as crowd:
        crowd.join([OwnClient(world.port)])
        for _ in range(83):
            if server.process.poll() is None:
                server.process.send_signal(signal.SIGTERM)
        assert server.await_exit() == 0, server.log()
    assert "ERROR" not in server.log()
    assert server.log().count("stopped by a signal") == 1
