# SPDX-License-Identifier: MIT
"""An OpenXR runtime (Monado) whose headset, controllers and hands a test moves.

Its "remote" driver takes packets over TCP, laid out as struct r_remote_data of Monado's
src/xrt/drivers/remote/r_interface.h; nothing but tests uses it. Poses are in metres, +Y up, -Z
ahead; quaternions are x, y, z, w.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import struct
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType

from .processes import Program, free_port
from .xr_prefix import XrPrefix

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

START_LIMIT_S = 60.0
UPRIGHT: Quaternion = (0.0, 0.0, 0.0, 1.0)

_MAGIC = b"mndrmt3\0"
_PACKET_BYTES = 376
_BUTTONS = (
    "system_click",
    "system_touch",
    "a_click",
    "a_touch",
    "b_click",
    "b_touch",
    "trigger_click",
    "trigger_touch",
    "thumbstick_click",
    "thumbstick_touch",
    "trackpad_touch",
)


@dataclass
class Hand:
    """A controller of the Index and the hand that holds it."""

    position: Vector = (0.0, 1.2, -0.4)
    rotation: Quaternion = UPRIGHT
    curl: tuple[float, float, float, float, float] = (0.0, 0.0, 0.0, 0.0, 0.0)
    trigger: float = 0.0
    squeeze: float = 0.0
    thumbstick: tuple[float, float] = (0.0, 0.0)
    is_hand_tracked: bool = True
    is_active: bool = True
    pressed: set[str] = field(default_factory=set)

    def packed(self) -> bytes:
        """The bytes of struct r_remote_controller_data."""
        unknown = self.pressed - set(_BUTTONS)
        if unknown:
            raise ValueError(f"no such button: {', '.join(sorted(unknown))}; known: {_BUTTONS}")
        pose = struct.pack("<7f", *self.rotation, *self.position)
        motion = struct.pack("<6f", *[0.0] * 6)
        axes = [self.trigger, self.squeeze, self.squeeze, *self.thumbstick, 0.0, 0.0, 0.0]
        buttons = [button in self.pressed for button in _BUTTONS]
        states = [self.is_hand_tracked, self.is_active, *buttons, False, False, False]
        return pose + motion + struct.pack("<13f16?", *self.curl, *axes, *states)


@dataclass
class Wearer:
    """Where head and hands are."""

    position: Vector = (0.0, 1.6, 0.0)
    rotation: Quaternion = UPRIGHT
    left: Hand = field(default_factory=lambda: Hand(position=(-0.2, 1.2, -0.4)))
    right: Hand = field(default_factory=lambda: Hand(position=(0.2, 1.2, -0.4)))

    def packed(self) -> bytes:
        """The bytes of struct r_remote_data; the runtime keeps its own eyes' views."""
        views = struct.pack("<24f", *([0.0] * 4 + [*UPRIGHT] + [0.0] * 4) * 2)
        head = struct.pack("<7f4?", *self.rotation, *self.position, False, False, False, False)
        return _MAGIC + views + head + self.left.packed() + self.right.packed()


class Monado:
    """The runtime's service, in folders and on a port of its own.

    Eyes see pictures of 320x240 at 20 Hz, which the processor draws; with `card_hz` pictures as
    large as a headset's at that rate, which the machine's graphics card draws and puts together in
    a window.
    """

    def __init__(self, display: dict[str, str], card_hz: int = 0) -> None:
        self.prefix = XrPrefix()
        self.prefix.ensure()
        # A socket's path is short: not in a test's own deep folder.
        self.folder = Path(tempfile.mkdtemp(prefix="dismount-xr-"))
        self.port = free_port()
        self.wearer = Wearer()
        self._program: Program | None = None
        self._display = display
        self._vulkan = {"VK_DRIVER_FILES": str(self.prefix.driver)}
        self._compositor = {"XRT_COMPOSITOR_NULL": "1"}
        if card_hz > 0:
            self._vulkan = {}
            self._compositor = {
                "XRT_COMPOSITOR_FORCE_XCB": "1",
                "XRT_COMPOSITOR_DEFAULT_FRAMERATE": str(card_hz),
                "XRT_COMPOSITOR_SCALE_PERCENTAGE": "200",
            }
        self._remote: socket.socket | None = None
        config = self.folder / "config" / "monado" / "config_v0.json"
        config.parent.mkdir(parents=True)
        # Without view_count the port is ignored.
        remote = {"version": 0, "port": self.port, "view_count": 2}
        config.write_text(json.dumps({"active": "remote", "remote": remote}), encoding="utf-8")
        (self.folder / "run").mkdir(mode=0o700)

    def __enter__(self) -> Monado:
        self.start()
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        self.close()

    def environment(self) -> dict[str, str]:
        """What a program needs to find this runtime, and the Vulkan that draws."""
        return {
            **self._display,
            **self._vulkan,
            "XDG_RUNTIME_DIR": str(self.folder / "run"),
            "XR_RUNTIME_JSON": str(self.prefix.runtime),
        }

    def start(self) -> None:
        """Starts the service and waits until it takes poses."""
        (self.folder / "run" / "monado_comp_ipc").unlink(missing_ok=True)
        own = {
            "XDG_CONFIG_HOME": str(self.folder / "config"),
            **self._compositor,
            "P_OVERRIDE_ACTIVE_CONFIG": "remote",
        }
        command = [str(self.prefix.program("monado-service"))]
        whole = {**os.environ, **self.environment(), **own}
        # It ends when its standard input does.
        self._program = Program(command, self.folder / "service.log", whole, types=True)
        self._connect()
        # Programs come by another way, which opens later.
        self._await_socket()
        self.send()

    def send(self) -> None:
        """Moves head, hands and buttons to what the wearer says."""
        packet = self.wearer.packed()
        assert len(packet) == _PACKET_BYTES
        assert self._remote is not None, "the runtime does not run"
        self._remote.sendall(packet)

    def kill(self) -> None:
        """Ends the service as a crash does."""
        self._disconnect()
        if self._program is not None:
            self._program.kill()
        self._program = None

    def stall(self) -> None:
        """Stops the service, which stays connected and answers nothing."""
        self._signal(signal.SIGSTOP)

    def resume(self) -> None:
        """Lets a stalled service go on."""
        self._signal(signal.SIGCONT)

    def close(self) -> None:
        """Ends the service and removes its folders."""
        self.kill()
        shutil.rmtree(self.folder, ignore_errors=True)

    def hand_over(self) -> None:
        """Lets another program move the headset: one at a time is connected."""
        self._disconnect()

    def _signal(self, number: signal.Signals) -> None:
        if self._program is not None and self._program.process.poll() is None:
            self._program.process.send_signal(number)

    def _connect(self) -> None:
        assert self._program is not None
        self._remote = self._program.await_that(
            lambda: socket.create_connection(("127.0.0.1", self.port), 5.0),
            "the way to move the headset",
            START_LIMIT_S,
        )
        # It tells where it begins and where it is; whoever leaves before ends it by SIGPIPE.
        left = 2 * _PACKET_BYTES
        while left > 0:
            left -= len(self._remote.recv(left)) or left

    def _await_socket(self) -> None:
        def is_open() -> bool:
            with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as client:
                client.connect(str(self.folder / "run" / "monado_comp_ipc"))
            return True

        assert self._program is not None
        self._program.await_that(is_open, "the way of programs to the headset", START_LIMIT_S)

    def _disconnect(self) -> None:
        if self._remote is not None:
            self._remote.close()
        self._remote = None
