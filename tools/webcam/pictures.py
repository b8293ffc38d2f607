# SPDX-License-Identifier: MIT
"""Where pictures come from: a camera (V4L2) or a film."""

from __future__ import annotations

import threading
import time
from pathlib import Path

import cv2

from .device import PictureError, check, silence_of
from .models import Array

WIDTH, HEIGHT, RATE = 1280, 720, 30
# A camera that gives nothing for so long is taken, or gone, s.
SILENT_S = 3.0
# A film of which nothing is known is played at this rate, pictures a second.
USUAL_RATE = 25.0
# A picture is made no larger than this, px: the models look at 256.
MOST_WIDTH = 1280


class Film:
    """A film at its own rate, again and again."""

    def __init__(self, path: str, every_picture: bool, rate: float) -> None:
        self._path = path
        self._every = every_picture
        check(path)
        self._reader = cv2.VideoCapture(path)
        own = self._reader.get(cv2.CAP_PROP_FPS) if self._reader.isOpened() else 0.0
        rate = rate or own
        self.rate = rate if 1.0 <= rate <= 1000.0 else USUAL_RATE
        self._began_s = time.monotonic()
        self._number = 0  # Of the next picture.
        self._played_s = 0.0
        self.name = f"the film {Path(path).name}"

    def read(self) -> tuple[float, Array] | None:
        """The time, s, and the next picture that is due; None at the end of one not looped."""
        if not self._every:
            due = int((time.monotonic() - self._began_s) * self.rate)
            while self._number < due and self._reader.grab():
                self._number += 1
            wait_s = self._began_s + self._number / self.rate - time.monotonic()
            time.sleep(max(wait_s, 0.0))
        there, picture = self._reader.read()
        if there:
            self._number += 1
            if self._every:
                return (self._number - 1) / self.rate, _shrunk(picture)
            return time.time(), _shrunk(picture)
        if self._number == 0:
            name = Path(self._path).name
            raise PictureError(f"{name} is broken or no film: no picture of it can be read")
        if self._every:
            return None
        self._reader.release()
        self._reader = cv2.VideoCapture(self._path)
        self._began_s = time.monotonic()
        self._number = 0
        return self.read()

    def close(self) -> None:
        """Lets go of the film."""
        self._reader.release()


class Camera:
    """The newest picture of a camera: a thread of its own reads, so that none waits."""

    def __init__(self, number: int) -> None:
        self.name = f"camera {number}"
        check(str(number))
        self._reader = cv2.VideoCapture(number, cv2.CAP_V4L2)
        if not self._reader.isOpened():
            raise PictureError(silence_of(number))
        # Uncompressed, USB 2 carries five such pictures a second.
        self._reader.set(cv2.CAP_PROP_FOURCC, cv2.VideoWriter.fourcc(*"MJPG"))
        self._reader.set(cv2.CAP_PROP_FRAME_WIDTH, WIDTH)
        self._reader.set(cv2.CAP_PROP_FRAME_HEIGHT, HEIGHT)
        self._reader.set(cv2.CAP_PROP_FPS, RATE)
        self._reader.set(cv2.CAP_PROP_BUFFERSIZE, 1)
        self._number = number
        self._news = threading.Condition()
        self._newest: tuple[float, Array] | None = None
        self._stops = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def read(self) -> tuple[float, Array] | None:
        """The time, s of Unix time, and a picture that was not read before."""
        with self._news:
            if not self._news.wait_for(lambda: self._newest is not None, SILENT_S):
                raise PictureError(silence_of(self._number))
            newest, self._newest = self._newest, None
        return newest

    def close(self) -> None:
        """Lets go of the camera."""
        self._stops = True
        self._thread.join(1.0)
        self._reader.release()

    def _run(self) -> None:
        while not self._stops:
            there, picture = self._reader.read()
            if not there:
                time.sleep(0.02)
                continue
            now_s = time.time()
            with self._news:
                self._newest = (now_s, _shrunk(picture))
                self._news.notify()


def open_pictures(what: str, every_picture: bool, rate: float) -> Film | Camera:
    """A camera by its number, or else a film."""
    return Camera(int(what)) if what.isdigit() else Film(what, every_picture, rate)


def _shrunk(picture: Array) -> Array:
    width = picture.shape[1]
    if width <= MOST_WIDTH:
        return picture
    scale = MOST_WIDTH / width
    return cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
