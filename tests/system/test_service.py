# SPDX-License-Identifier: MIT
"""The server as a service: configuration file, log file, SIGHUP."""

from __future__ import annotations

import signal
from collections.abc import Callable

from toolchain.paths import CLIPS
from toolchain.udp_relay import Relay

from .conftest import World, shared
from .own_client import Crowd, OwnClient

BANDWIDTH_KBIT = 64


class Service:
    """A server with a configuration file and a log file."""

    def __init__(self, world: World, **settings: object) -> None:
        self.world = world
        self.config = world.folder / "server.cfg"
        self.log = world.folder / "dismount.log"
        self.settings = {"password": "old", "log-file": self.log, "max-per-address": 0, **settings}
        self.write()
        self.server = world.server(f"--config={self.config}", "--world=hall")

    def write(self) -> None:
        lines = [f"{name} = {value}\n" for name, value in self.settings.items()]
        self.config.write_text("[server]\n" + "".join(lines), encoding="utf-8")

    def change(self, **settings: object) -> None:
        """Writes the file anew and lets the server read it."""
        self.settings |= {name.replace("_", "-"): value for name, value in settings.items()}
        self.write()
        self.server.process.send_signal(signal.SIGHUP)

    def newcomer(self, name: str, password: str = "") -> OwnClient:
        password = password or str(self.settings["password"])
        return OwnClient(self.world.port, password=password, name=name)


service = shared(Service)


def test_a_configuration_with_mistakes_starts_nothing(world: World) -> None:
    config = world.folder / "server.cfg"
    config.write_text("[server]\nmax-client = 8\nport = 0\n", encoding="utf-8")
    server = world.server(f"--config={config}", wait=False)
    assert server.await_exit() == 2
    assert f"{config}:2: there is no option max-client: did you mean max-clients?" in server.log()
    assert f"{config}:3: port is 1 to 65535" in server.log()


def _join(crowd: Crowd, client: OwnClient) -> None:
    """Joins one, while the others stay."""
    crowd.add(client)
    crowd.go_on_until(lambda: client.is_joined)


def _says(crowd: Crowd, service: Service, text: str) -> None:
    crowd.go_on_until(lambda: text in service.server.log())


def test_sighup_rereads_the_configuration_and_reopens_the_log(service: Service) -> None:
    with Crowd() as crowd:
        stays = service.newcomer("stays")
        _join(crowd, stays)
        service.change(max_clients=1)
        _says(crowd, service, "changed: max-clients 1")
        second = service.newcomer("second")
        crowd.add(second)
        crowd.go_on_until(lambda: second.position == 1)
        moved = service.log.with_suffix(".1")
        service.log.rename(moved)
        service.change(max_clients=2, max_people=5, pose_error=1)
        _says(crowd, service, "changed: max-clients 2, max-people 5")
        _says(crowd, service, "these take effect with the next start: pose-error")
        crowd.go_on_until(lambda: second.is_joined)
        assert "listening on UDP port" in moved.read_text(encoding="utf-8")
        assert "changed: max-clients 2" in service.log.read_text(encoding="utf-8")
        assert "changed: max-clients 2" not in moved.read_text(encoding="utf-8")
        service.change(max_clients="none")
        _says(crowd, service, "nothing is changed: ")
        line = service.server.await_line("nothing is changed: ")
        assert f"{service.config}:" in line
        assert ": max-clients expects" in line
        service.change(max_clients=16, max_people=16)
        _says(crowd, service, "changed: max-clients 16, max-people 16")
        assert not stays.is_gone


def test_sighup_changes_the_password(service: Service) -> None:
    with Crowd() as crowd:
        stays = service.newcomer("stays")
        _join(crowd, stays)
        service.change(password="fresh")
        _says(crowd, service, "changed: password")
        guesser = service.newcomer("second", "old")
        crowd.add(guesser)
        crowd.go_on_until(lambda: guesser.is_refused)
        _join(crowd, service.newcomer("third"))
        assert not stays.is_gone
    assert "fresh" not in service.server.log()


def test_sighup_changes_the_password_without_sealing(world: World) -> None:
    service = Service(world, sealing=0)
    options = ["--sealing=0", "--password=old"]
    stays = world.client("observer", *options, "--name=Stays", name="stays")
    stays.await_text("joined")
    service.change(password="fresh")
    service.server.await_text("changed: password")
    assert world.client("observer", *options, name="second").await_exit() == 3
    options[1] = "--password=fresh"
    world.client("observer", *options, name="third").await_text("joined")
    assert stays.process.poll() is None
    assert "lost" not in stays.log()
    assert "fresh" not in service.server.log()


def _in_ticks(service: Service, ticks: int, count: Callable[[dict], int]) -> float:
    """How much something grows in so many ticks."""
    began = service.server.report()
    before = count(began)
    now = service.server.await_report(lambda seen: seen["ticks"] >= began["ticks"] + ticks)
    grown = count(now) - before
    # Of this moment: what has been counted came in no fewer ticks.
    passed = service.server.report()["ticks"] - began["ticks"]
    return grown * ticks / passed


def test_sighup_changes_the_bandwidth_and_it_is_kept(service: Service) -> None:
    """Snapshots of eight people take more than any of it; what counts is how many ticks it took."""
    password = f"--password={service.settings['password']}"
    service.change(bandwidth=2)
    crowd = ("--trainees=8", "--observers=0", f"--bvh={CLIPS / '01_01.bvh'}", password)
    service.world.client("load", *crowd)
    with Relay(service.world.port) as relay:
        options = (f"--port={relay.port}", "--fps=60", "--name=Bob", password)
        observer = service.world.client("observer", *options)
        observer.await_text("joined")
        service.server.await_report(lambda status: len(status["people"]) == 8)
        service.server.await_text("changed: bandwidth 2")

        def datagrams(seen: dict) -> int:
            return next(row["datagrams"] for row in seen["sessions"] if row["name"] == "Bob")

        # 250 bytes a second, and at least 68 in each datagram.
        assert _in_ticks(service, 240, datagrams) < 40
        service.change(bandwidth=BANDWIDTH_KBIT)
        service.server.await_text(f"changed: bandwidth {BANDWIDTH_KBIT}")
        # A client that acknowledges late is sent less: never more than its share, and once it has
        # its turn, a good part of it.
        for _try in range(20):
            passed = _in_ticks(service, 180, lambda _seen: relay.to_client)
            kbit = passed * 8.0 / 1000.0 / (180 / 60)
            print(f"{kbit:.1f} kbit/s pass, if there are 60 ticks a second")
            # What is sent beside snapshots comes by the clock: more of it between late ticks.
            assert kbit < BANDWIDTH_KBIT * 1.5
            if kbit > 10.0:
                break
        assert kbit > 10.0
        seen = observer.fresh_report()["snapshots"]
        observer.await_report(lambda report: report["snapshots"] > seen + 10)
        assert observer.end() == 0


def test_lines_below_the_level_are_left_out(world: World) -> None:
    log = world.folder / "dismount.log"
    server = world.server("--log-level=warning", f"--log-file={log}", wait=False)
    with Crowd() as crowd:
        crowd.join([OwnClient(world.port)])
    assert server.end() == 0
    assert " INFO " not in server.log()


def test_a_log_file_that_cannot_be_written(world: World) -> None:
    server = world.server("--log-file=/no/such/folder/log", wait=False)
    assert server.await_exit() == 2
    assert "the log file /no/such/folder/log cannot be written" in server.log()
