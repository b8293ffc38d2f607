# SPDX-License-Identifier: MIT
"""`./run load`: many clients on one server, over a bad network, and what becomes of them."""

from __future__ import annotations

import contextlib
import json
import math
import os
import shlex
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from .console import Failure, say, step, tail
from .load_report import TICK_RATE, Measured, add_stats
from .nearest import options_in, unknown_option
from .paths import CLIENT_BINARY, CLIPS, OUT, SERVER_BINARY, make_folder
from .process_times import thread_seconds
from .processes import Group, ask, require_port
from .project import prepare
from .stats import Stats
from .udp_proxy import ProxyProcess

MAX_CLIENTS = 500
MAX_SNAPSHOTS = 2560
FILE = "load.json"

HELP = """./run load [options]

Puts many clients on one server, over a bad network between them, and measures what becomes of them:
docs/load.md. All results are left in out/load.json.

  --trainees=N          clients that send motion, 0 to 500 (8)
  --walkers=N           clients that walk without a suit, 0 to 500 (0)
  --observers=N         clients that watch, 0 to 500 (24)
  --loss=P              datagrams that get lost, % in each direction, 0 to 95 (0)
  --delay=MS            what each datagram takes, ms in each direction, 0 to 2000 (0)
  --jitter=MS           how much more or less it takes, ms, at most --delay (0)
  --seconds=S           length of the measurement, 2 to 3600 (20)
  --rate=N              samples a second of a trainee, 1 to 240 (60)
  --snapshot-rate=N     snapshots a second that clients ask for, 0 to 240; 0: each tick (0 up to 42
                        clients, then 2560 for all of them together: 10 for each of 256)
  --seed=N              of the network's random numbers (1)
  --bvh=FILE            the motion (assets/motion/01_01.bvh)
  --port=NUMBER         UDP port of the server, 1 to 65535 (7777)
  --server-options=TEXT further options of the server, such as "--bandwidth=100 --root=held"
  --json                one JSON object a line instead of the table
  --no-goals            exit code 0 also where a goal is missed

Exit codes: 0 done, 1 failed, 2 wrong options, 5 a goal is missed.
"""


class Settings:
    """Options of `./run load`."""

    def __init__(self, arguments: list[str]) -> None:
        values = {
            "trainees": "8",
            "walkers": "0",
            "observers": "24",
            "loss": "0",
            "delay": "0",
            "jitter": "0",
            "seconds": "20",
            "rate": "60",
            "snapshot-rate": "",
            "seed": "1",
            "bvh": str(CLIPS / "01_01.bvh"),
            "port": os.environ.get("DISMOUNT_PORT", "7777"),
            "server-options": "",
        }
        self.json = "--json" in arguments
        self.has_goals = "--no-goals" not in arguments
        for argument in (one for one in arguments if one not in ("--json", "--no-goals")):
            name, _, value = argument.removeprefix("--").partition("=")
            if not argument.startswith("--") or name not in values:
                raise Failure(unknown_option("./run load", argument, options_in(HELP)), 2)
            values[name] = value
        self.trainees = _whole(values, "trainees", 0, MAX_CLIENTS)
        self.walkers = _whole(values, "walkers", 0, MAX_CLIENTS)
        self.observers = _whole(values, "observers", 0, MAX_CLIENTS)
        self.loss = _number(values, "loss", 95.0, "%")
        self.delay = _number(values, "delay", 2000.0, "ms")
        self.jitter = _number(values, "jitter", 2000.0, "ms")
        self.seconds = _whole(values, "seconds", 2, 3600)
        self.rate = _whole(values, "rate", 1, 240)
        values["snapshot-rate"] = values["snapshot-rate"] or str(self._light_rate())
        self.snapshot_rate = _whole(values, "snapshot-rate", 0, 240)
        self.seed = _whole(values, "seed", 0, 2**31)
        self.port = _whole(values, "port", 1, 65535)
        self.bvh = values["bvh"]
        if self.clients == 0:
            raise Failure("There are no clients: ask for --trainees, --walkers or --observers.", 2)
        if self.jitter > self.delay:
            raise Failure("--jitter is at most --delay: nothing arrives before it was sent.", 2)
        if not Path(self.bvh).is_file():
            raise Failure(f"There is no motion file {self.bvh}: name one with --bvh=FILE.", 2)
        try:
            self.server_options = shlex.split(values["server-options"])
        except ValueError as error:
            raise Failure(f"--server-options cannot be read: {error}.", 2) from None

    def _light_rate(self) -> int:
        """What many clients ask for, so that one process can take in what comes for all of them."""
        rate = MAX_SNAPSHOTS // max(self.clients, 1)
        return 0 if rate >= TICK_RATE else rate

    @property
    def clients(self) -> int:
        """All of them."""
        return self.trainees + self.walkers + self.observers

    @property
    def has_proxy(self) -> bool:
        """Whether anything is to happen to datagrams on their way."""
        return self.loss > 0.0 or self.delay > 0.0 or self.jitter > 0.0


def _whole(values: dict[str, str], name: str, least: int, most: int) -> int:
    value = values[name]
    # Not isdigit() alone: it takes digits that int() does not.
    if not (value.isascii() and value.isdigit()) or not least <= int(value) <= most:
        raise Failure(f"--{name} is between {least} and {most}, found '{value}'.", 2)
    return int(value)


def _number(values: dict[str, str], name: str, most: float, unit: str) -> float:
    try:
        value = float(values[name])
    except ValueError:
        value = math.nan
    if not 0.0 <= value <= most:
        raise Failure(f"--{name} is between 0 and {most:g} {unit}, found '{values[name]}'.", 2)
    return value


def main(arguments: list[str]) -> int:
    """Runs a session and prints its stats."""
    settings = Settings(arguments)
    require_port(settings.port)
    make_folder(OUT)
    (OUT / ".gdignore").touch()
    prepare(export=True)
    with step(f"{settings.clients} clients for {settings.seconds} s"):
        measured = run_session(settings)
    stats = Stats("load", settings.json)
    add_stats(stats, measured)
    code = stats.finish()
    (OUT / FILE).write_text(json.dumps(measured.whole(), indent=1) + "\n", encoding="utf-8")
    if not settings.json:
        print(f"\nof each client  {OUT / FILE}")
    if code != 0:
        say('A goal is missed: see the column "holds".')
    return code if settings.has_goals else 0


def run_session(settings: Settings) -> Measured:
    """A server, the clients and the network between them."""
    with (
        tempfile.TemporaryDirectory(prefix="dismount-") as folder,
        Group(Path(folder), {}) as group,
    ):
        work = Path(folder)
        status_port = _start_server(group, settings)
        with _network(settings) as network:
            _start_clients(group, settings, work, network.port if network else settings.port)
            group.await_text("load", "INFO  load: counting", 60 + 0.2 * settings.clients)
            before = _look(group, status_port)
            if network:
                network.restart()
            group.await_text("load", "INFO  load: counted", settings.seconds + 60)
            wire = network.stats() if network else None
            after = _look(group, status_port)
        clients = json.loads((work / "load.json").read_text(encoding="utf-8"))
        if group.exit_code("server") is not None:
            raise Failure(f"The server ended too early:\n{tail(group.log('server'))}")
        logs = {name: group.log(name) for name in ("server", "load")}
    return Measured(vars(settings), before, after, clients, wire, logs)


def _start_server(group: Group, settings: Settings) -> int:
    # All come from one address.
    options = [f"--port={settings.port}", f"--max-clients={settings.clients}"]
    options += ["--max-per-address=0"]
    options += settings.server_options
    group.start("server", [str(SERVER_BINARY), "--headless", "--", "--role=server", *options])
    return group.await_status(35)


def _start_clients(group: Group, settings: Settings, work: Path, port: int) -> None:
    options = [
        "--role=load",
        f"--port={port}",
        f"--trainees={settings.trainees}",
        f"--walkers={settings.walkers}",
        f"--observers={settings.observers}",
        f"--rate={settings.rate}",
        f"--snapshot-rate={settings.snapshot_rate}",
        f"--bvh={settings.bvh}",
        f"--duration={settings.seconds}",
        f"--report={work / 'load.json'}",
    ]
    group.start("load", [str(CLIENT_BINARY), "--headless", "--", *options])


@contextlib.contextmanager
def _network(settings: Settings) -> Iterator[ProxyProcess | None]:
    if not settings.has_proxy:
        yield None
        return
    conditions = (settings.loss, settings.delay, settings.jitter, settings.seed)
    with ProxyProcess(settings.port, conditions) as proxy:
        yield proxy


def _look(group: Group, status_port: int) -> dict[str, Any]:
    """What the server reports of itself, and what the system reports of it."""
    try:
        status = ask(status_port)
    except (OSError, ValueError) as error:
        log = tail(group.log("server"))
        raise Failure(f"The server serves no status ({error}):\n{log}") from error
    return {
        "status": status,
        "threads": thread_seconds(group.number("server")),
        "client_threads": thread_seconds(group.number("load")),
    }
