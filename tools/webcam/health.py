# SPDX-License-Identifier: MIT
"""What is wrong with pictures that do come, as sentences for people."""

from __future__ import annotations

from .models import Array

# Mean brightness below which a picture is dark, of 255.
DARK = 28.0
# Pictures a second below which motion stutters.
SLOW_HZ = 12.0
# Seconds after which it is said that nobody is seen, and over which rates are counted.
NOBODY_S = 2.0
SPAN_S = 2.0
# Mean time for a picture from which on this machine is too slow, of the time between pictures.
BUSY = 1.5


class Health:
    """Watches pictures come."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._times: list[float] = []
        self._light = 255.0
        self._seen_s: float | None = None
        self._count = 0
        self.work_s = 0.0

    def note(self, now_s: float, picture: Array, seen: int, count: int, work_s: float) -> None:
        """Notes a picture that was looked through: how many people are followed and are there, and
        how long it took, s."""
        self._times = [one for one in self._times if 0.0 <= now_s - one < SPAN_S] + [now_s]
        light = float(picture[::16, ::16].mean())
        self._light += (light - self._light) * 0.1 if len(self._times) > 1 else light - self._light
        self.work_s += (work_s - self.work_s) * 0.1
        if seen or self._seen_s is None:
            self._seen_s = now_s
        self._count = count
        self._now_s = now_s

    def rate_hz(self) -> float:
        """Pictures that were looked through in a second."""
        if len(self._times) < 2:
            return 0.0
        return (len(self._times) - 1) / max(self._times[-1] - self._times[0], 1e-6)

    def faults(self) -> list[str]:
        """What is wrong now."""
        found = []
        rate = self.rate_hz()
        if self._light < DARK:
            found.append("the picture is dark: turn on a light in front of you, or open the cover")
        if len(self._times) > 3 and rate < SLOW_HZ:
            if self.work_s * rate * BUSY > 1.0:
                found.append(f"this machine manages only {rate:.0f} pictures a second")
            else:
                more = "more light lets cameras be faster"
                found.append(f"the camera gives only {rate:.0f} pictures a second: {more}")
        if self._seen_s is not None and self._now_s - self._seen_s > NOBODY_S:
            found.append("nobody is in the picture: step back until all of you is seen")
        elif self._count > self._most:
            who = "one of them moves" if self._most == 1 else f"{self._most} of them move"
            found.append(f"{self._count} people are in the picture, and only {who}")
        return found
