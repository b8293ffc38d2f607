# SPDX-License-Identifier: MIT
"""Follows people from picture to picture: each keeps a number."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .models import Array, Detector, Landmarker, Landmarks, Region

# Below this score there is nobody where somebody was.
MIN_SCORE = 0.5
# How often it is looked for people who are not followed yet, s: while nobody is, and else.
LOOK_S = 0.1
LOOK_FOR_OTHERS_S = 1.0
# Of two regions whose middles are nearer than this share of their size, one is a person followed.
NEAR = 0.25
# Somebody who comes back within this time where he was lost has his old number, s.
REMEMBERED_S = 2.0
# Most people that are looked for.
MOST = 4


@dataclass
class Person:
    """Somebody who is followed."""

    number: int
    region: Region
    seen_s: float
    landmarks: Landmarks | None = None
    is_mirrored: bool = False  # Whether the model looked at the last picture in a mirror.


class People:
    """Those in the pictures of a camera."""

    def __init__(self, detector: Detector, landmarker: Landmarker, most: int) -> None:
        self._detector = detector
        self._landmarker = landmarker
        self._most = most
        self._lost: list[Person] = []
        self._looked_s = -math.inf
        self._next = 0
        self.people: list[Person] = []
        # How many people were in the picture that was looked through last, followed or not.
        self.count = 0

    def advance(self, picture: Array, now_s: float) -> list[Person]:
        """Those who are seen in the picture (RGB) of a time, s."""
        followed = []
        for person in self.people:
            # Every other picture in a mirror: what the model errs by to one side is taken back by
            # what it errs to the other, once poses are smoothed.
            person.is_mirrored = not person.is_mirrored
            person.landmarks = self._landmarker.find(picture, person.region, person.is_mirrored)
            is_there = person.landmarks.score >= MIN_SCORE
            region = person.landmarks.next_region
            if is_there and not any(_is_same(region, other.region) for other in followed):
                person.region = region
                person.seen_s = now_s
                followed.append(person)
            else:
                self._lost.append(person)
        self.people = followed
        self._lost = [one for one in self._lost if now_s - one.seen_s < REMEMBERED_S]
        period_s = LOOK_FOR_OTHERS_S if followed else LOOK_S
        if now_s - self._looked_s >= period_s or now_s < self._looked_s:
            self._looked_s = now_s
            self._look(picture, now_s)
        return self.people

    def _look(self, picture: Array, now_s: float) -> None:
        found = self._detector.find(picture, MOST)
        fresh = [
            region
            for region in found
            if not any(_is_same(region, person.region) for person in self.people)
        ]
        self.count = len(self.people)
        # The largest is nearest, and most likely the one who wants to be captured.
        for region in sorted(fresh, key=lambda one: -one.size):
            landmarks = self._landmarker.find(picture, region)
            next_region = landmarks.next_region
            if landmarks.score < MIN_SCORE:
                continue
            if any(_is_same(next_region, person.region) for person in self.people):
                continue
            self.count += 1
            if len(self.people) < self._most:
                number = self._number_of(region)
                self.people.append(Person(number, next_region, now_s, landmarks))

    def _number_of(self, region: Region) -> int:
        """The old number of who was lost here, or a new one."""
        for person in self._lost:
            if math.hypot(person.region.x - region.x, person.region.y - region.y) < region.size:
                self._lost.remove(person)
                return person.number
        self._next += 1
        return self._next - 1


def _is_same(one: Region, other: Region) -> bool:
    size = min(one.size, other.size)
    return math.hypot(one.x - other.x, one.y - other.y) < NEAR * size
