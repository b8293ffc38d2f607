# SPDX-License-Identifier: MIT
"""Runs the models over pictures and sends what they see to the client, in datagrams of JSON.

Each picture gives one datagram for each person; twice a second one tells how it goes, and a few
times a second one has a small picture for the panel. docs/sources.md names their fields.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator
from typing import Any

import cv2

from . import environment
from .device import PictureError
from .health import Health
from .models import Array, Detector, Landmarker
from .people import People, Person
from .pictures import Camera, Film, open_pictures
from .sender import STATUS_S, Sender, is_alive, wait

PREVIEW_S = 0.15
PREVIEW_WIDTH = 320
PREVIEW_QUALITY = 60
# A camera or film that cannot be opened is tried again after this time, s.
AGAIN_S = 2.0


def run(given: argparse.Namespace) -> int:
    """Looks through pictures until the client ends, or a film that is not looped does; what is
    given are the options of __main__.py."""
    sender = Sender(given.port)
    every = given.every_picture
    detector = Detector(environment.models(), given.threads)
    landmarker = Landmarker(environment.models(), given.threads)
    while is_alive(given.parent):
        try:
            pictures = open_pictures(given.pictures, every, given.rate)
            try:
                people = People(detector, landmarker, given.people)
                _look_through(pictures, people, sender, given.parent, given.people)
            finally:
                pictures.close()
            if every:
                return 0
        except PictureError as error:
            sender.send_fault(str(error))
            if every:
                print(error, file=sys.stderr)
                return 1
            wait(AGAIN_S, given.parent)
    return 0


def _look_through(
    pictures: Film | Camera, people: People, sender: Sender, parent: int, most: int
) -> None:
    health = Health(most)
    told_s = shown_s = checked_s = -1e9
    while (taken := pictures.read()) is not None:
        taken_s, picture = taken
        began = time.monotonic()
        seen = people.advance(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB), taken_s)
        height, width = picture.shape[:2]
        for person in seen:
            sender.send(message_of(person, taken_s, width, height))
        now = time.monotonic()
        health.note(taken_s, picture, len(seen), people.count, now - began)
        if now - told_s >= STATUS_S:
            told_s = now
            sender.send({"status": status_of(health, pictures, people)})
        if now - shown_s >= PREVIEW_S:
            shown_s = now
            sender.send_bytes(_preview(picture))
        if now - checked_s >= AGAIN_S:
            checked_s = now
            if not is_alive(parent):
                return


def message_of(person: Person, taken_s: float, width: int, height: int) -> dict[str, Any]:
    """The datagram of one person in one picture."""
    landmarks = person.landmarks
    assert landmarks is not None
    image = landmarks.image.copy()
    image[:, :3] /= width
    return {
        "time": round(taken_s, 6),
        "person": person.number,
        "picture": [width, height],
        "score": round(landmarks.score, 3),
        "world_landmarks": list(_rows(landmarks.world)),
        "landmarks": list(_rows(image)),
    }


def status_of(health: Health, pictures: Film | Camera, people: People) -> dict[str, Any]:
    """How it goes, for the panel."""
    return {
        "name": pictures.name,
        "rate_hz": round(health.rate_hz(), 1),
        "work_ms": round(health.work_s * 1000.0, 1),
        "people": people.count,
        "faults": health.faults(),
    }


def _rows(values: Array) -> Iterator[list[float]]:
    for row in values:
        yield [round(float(value), 4) for value in row]


def _preview(picture: Array) -> bytes:
    height = picture.shape[0] * PREVIEW_WIDTH // picture.shape[1]
    small = cv2.resize(picture, (PREVIEW_WIDTH, height), interpolation=cv2.INTER_AREA)
    _done, jpeg = cv2.imencode(".jpg", small, [cv2.IMWRITE_JPEG_QUALITY, PREVIEW_QUALITY])
    return bytes(jpeg)
