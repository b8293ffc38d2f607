# SPDX-License-Identifier: MIT
"""What networks do to a session: other addresses, small datagrams, a server that is gone."""

from __future__ import annotations

import pytest
from toolchain.udp_relay import Relay

from .conftest import Process, World, shared

# What passes where a network takes nothing but the least that IPv4 asks for, bytes of a packet.
SMALL_MTU = 576


class Net:
    """A server whose clients come through a network of ours."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.server = world.server()
        # Where nobody moves there is little to send.
        self.trainee = world.trainee()
        self.server.await_report(lambda report: len(report["people"]) == 1)

    def client(self, relay: Relay, role: str = "observer", *options: str) -> Process:
        name = f"{role}{relay.port}"
        return self.world.client(role, f"--port={relay.port}", *options, name=name)

    def moved(self) -> int:
        return int(self.server.report()["transport"]["moved"])


net = shared(Net)


def _go_on(client: Process, snapshots: int = 60) -> None:
    seen = client.fresh_report()["snapshots"]
    client.await_report(lambda report: report["snapshots"] > seen + snapshots)


def test_a_client_whose_address_changes_goes_on(net: Net) -> None:
    before = net.moved()
    with Relay(net.world.port) as relay:
        observer = net.client(relay)
        observer.await_text("world 'hall' is there")
        for _ in range(3):
            _go_on(observer)
            relay.move()
        _go_on(observer)
        assert net.moved() == before + 3
        assert "lost" not in observer.log()
        assert observer.log().count("joined") == 1
        observer.end()
    assert "is lost" not in net.server.log()


@pytest.mark.parametrize("sealing", ["--sealing=1", "--sealing=0"])
def test_a_network_that_carries_only_small_datagrams(world: World, sealing: str) -> None:
    """The level's data and the table of entities do not fit, nor does what ENet makes of them."""
    server = world.server("--world=yard", sealing)
    with Relay(world.port) as relay, Relay(world.port) as other:
        relay.mtu = other.mtu = SMALL_MTU
        observer = world.client("observer", f"--port={relay.port}", sealing)
        trainee = world.trainee("--name=Ada", f"--port={other.port}", sealing)
        observer.await_text("world 'yard' is there")
        server.await_report(lambda report: len(report["people"]) == 1)
        _go_on(observer)
        observer.await_text("the network carries no datagrams of more than about 528 bytes")
        _go_on(observer)
        assert "lost" not in observer.log() + trainee.log()
        for one in (observer, trainee):
            assert one.end() == 0, one.log()
    assert "ERROR" not in server.log()


def test_a_network_that_loses_and_overtakes(net: Net) -> None:
    with Relay(net.world.port) as relay:
        relay.loss = 0.2
        relay.jitter_s = 0.05
        observer = net.client(relay)
        observer.await_text("world 'hall' is there")
        _go_on(observer, 120)
        assert "lost" not in observer.log()
        observer.end()


def test_a_server_of_which_nothing_comes_is_given_up(net: Net) -> None:
    with Relay(net.world.port) as relay:
        observer = net.client(relay)
        observer.await_text("world 'hall' is there")
        _go_on(observer)
        relay.is_cut = True
        observer.await_text("nothing has come from the server for 5.5 s")
        relay.is_cut = False
        observer.await_text("joined", count=2)
        _go_on(observer)
        observer.end()
