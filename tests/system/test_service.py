# SPDX-License-Identifier: MIT
"""The server as a service: configuration file, log file, signals."""

from __future__ import annotations

import signal
import time
from pathlib import Path

import pytest

from .conftest import Process, World
from .test_operation import ask, await_status

STEP_S = 60.0


def configured(world: World, text: str) -> tuple[Process, Path, Path]:
    """A server with a configuration file and a log file."""
    config = world.folder / "server.cfg"
    log = world.folder / "dismount.log"
    config.write_text(text + f"log-file = {log}\n", encoding="utf-8")
    return world.server(f"--config={config}"), config, log


def test_a_configuration_with_mistakes_starts_nothing(world: World) -> None:
    config = world.folder / "server.cfg"
    config.write_text("[server]\nmax-client = 8\nport = 0\n", encoding="utf-8")
    server = world.server(f"--config={config}", wait=False)
    assert server.await_exit() == 2
    assert f"{config}:2: there is no option max-client: did you mean max-clients?" in server.log()
    assert f"{config}:3: port is 1 to 65535" in server.log()
    missing = world.server("--config=nowhere.cfg", name="missing", wait=False)
    assert missing.await_exit() == 2
    assert "nowhere.cfg cannot be read" in missing.log()


def test_sighup_rereads_the_configuration_and_reopens_the_log(world: World) -> None:
    server, config, log = configured(world, "[server]\nmax-clients = 1\n")
    stays = world.client("observer", "--name=Stays", name="stays")
    stays.await_text("joined")
    assert world.client("observer", name="second").await_exit() == 3
    moved = log.with_suffix(".1")
    log.rename(moved)
    more = "max-clients = 2\nmax-people = 5"
    text = config.read_text(encoding="utf-8").replace("max-clients = 1", more)
    config.write_text(text + "pose-error = 1\n", encoding="utf-8")
    server.process.send_signal(signal.SIGHUP)
    server.await_text("changed: max-clients 2, max-people 5")
    server.await_text("these take effect with the next start: pose-error")
    world.client("observer", name="third").await_text("joined")
    assert "listening on UDP port" in moved.read_text(encoding="utf-8")
    assert "changed: max-clients 2" in log.read_text(encoding="utf-8")
    assert "changed:" not in moved.read_text(encoding="utf-8")
    config.write_text("[server]\nmax-clients = none\n", encoding="utf-8")
    server.process.send_signal(signal.SIGHUP)
    server.await_text(f"nothing is changed: {config}:2: max-clients expects")
    server.process.send_signal(signal.SIGTERM)
    assert server.await_exit() == 0
    assert "lost" not in stays.log().split("joined")[0]


@pytest.mark.parametrize("sealing", ["1", "0"])
def test_sighup_changes_passwords(world: World, sealing: str) -> None:
    given = f"[server]\nsealing = {sealing}\npassword = old\n"
    server, config, _ = configured(world, given)
    options = [f"--sealing={sealing}", "--password=old"]
    stays = world.client("observer", *options, "--name=Stays", name="stays")
    stays.await_text("joined")
    text = config.read_text(encoding="utf-8").replace("= old", "= fresh")
    config.write_text(text, encoding="utf-8")
    server.process.send_signal(signal.SIGHUP)
    server.await_text("changed: password")
    assert world.client("observer", *options, name="second").await_exit() == 3
    options[1] = "--password=fresh"
    world.client("observer", *options, name="third").await_text("joined")
    assert stays.process.poll() is None
    assert "fresh" not in server.log()


def datagrams_in(world: World, ticks: int) -> int:
    """Datagrams with snapshots that the server sends its only observer in so many ticks."""
    before = status = ask(world.port)
    while status["ticks"] < before["ticks"] + ticks:
        time.sleep(0.2)
        status = ask(world.port)
    first, last = (
        next(row["datagrams"] for row in one["sessions"] if row["role"] == "observer")
        for one in (before, status)
    )
    return last - first


def test_sighup_changes_the_bandwidth(world: World) -> None:
    server, config, _ = configured(world, "[server]\nbandwidth = 2\n")
    world.trainee("--fps=30").await_text("joined")
    observer = world.client("observer", "--fps=30")
    observer.await_text("joined")
    await_status(world.port, lambda status: len(status["people"]) == 1)
    # 250 bytes a second, and at least 68 in each datagram.
    assert datagrams_in(world, 240) < 40
    text = config.read_text(encoding="utf-8").replace("= 2\n", "= 250\n")
    config.write_text(text, encoding="utf-8")
    server.process.send_signal(signal.SIGHUP)
    server.await_text("changed: bandwidth 250")
    end = time.monotonic() + STEP_S
    while datagrams_in(world, 120) < 60:
        assert time.monotonic() < end


def test_many_signals_are_one_clean_end(world: World) -> None:
    for number in range(3):
        server = world.server(name=f"server{number}")
        world.client("observer", name=f"observer{number}").await_text("joined")
        for _ in range(3 + 40 * number):
            if server.process.poll() is None:
                server.process.send_signal(signal.SIGTERM)
        assert server.await_exit() == 0, server.log()
        assert "ERROR" not in server.log()
        assert server.log().count("stopped by a signal") == 1


def test_lines_below_the_level_are_left_out(world: World) -> None:
    log = world.folder / "dismount.log"
    server = world.server("--log-level=warning", f"--log-file={log}", wait=False)
    world.client("observer").await_text("joined")
    server.process.send_signal(signal.SIGTERM)
    assert server.await_exit() == 0
    assert " INFO " not in server.log()
    nowhere = world.server("--log-file=/no/such/folder/log", name="nowhere", wait=False)
    assert nowhere.await_exit() == 2
    assert "the log file /no/such/folder/log cannot be written" in nowhere.log()
