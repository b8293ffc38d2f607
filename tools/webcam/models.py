# SPDX-License-Identifier: MIT
"""MediaPipe's two pose models: where people are in a picture, and the landmarks of one of them.

What the numbers mean is described with the models (BlazePose GHUM 3D's model card, MediaPipe's
graphs of pose_detection and pose_landmark); the code is our own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from ai_edge_litert.interpreter import Interpreter

Array = Any  # A numpy array: its own types differ between versions.

DETECTOR_SIZE = 224
LANDMARK_SIZE = 256
# Strides of the detector's maps, and how many anchors each has at a place.
LAYERS = ((8, 2), (16, 2), (32, 6))
MIN_SCORE = 0.5
# Boxes that share more than this are the same person's.
SAME_PERSON = 0.3
# What is looked at is larger than the person by this.
MARGIN = 1.25
LANDMARKS = 33
# The model's own points after the landmarks: the middle of the hips, and a point on the circle that
# holds the whole body.
MIDDLE, ROUND = 33, 34
# Side of the heat map around a landmark that says where it is exactly, and the least heat for it.
KERNEL = 7
MIN_HEAT = 0.5
# Pairs of landmarks, left and right, that a mirror exchanges; the nose has none.
PAIRS = ((1, 4), (2, 5), (3, 6), *((left, left + 1) for left in range(7, LANDMARKS, 2)))


@dataclass
class Region:
    """A turned square in a picture, px."""

    x: float
    y: float
    size: float
    turn: float  # Of a person who stands upright 0, rad, clockwise.

    def corners(self) -> Array:
        """Top left, top right and bottom left, px."""
        half = self.size / 2.0
        c, s = math.cos(self.turn), math.sin(self.turn)
        around = ((-half, -half), (half, -half), (-half, half))
        points = [(self.x + x * c - y * s, self.y + x * s + y * c) for x, y in around]
        return np.array(points, np.float32)


@dataclass
class Landmarks:
    """What the model says about one person."""

    image: Array  # 33 rows: x, y, px; z, px, towards the camera negative; how well it is seen, 0-1.
    world: Array  # 33 rows: x, y, z, m, with the hips' middle at the origin; how well it is seen.
    score: float  # Whether there is a person at all, 0 to 1.
    next_region: Region  # Where to look in the next picture.


def region_between(middle: Array, around: Array) -> Region:
    """Where to look for a person by the middle of the hips and a point on the circle around."""
    away = around - middle
    distance = float(np.hypot(away[0], away[1]))
    turn = math.pi / 2.0 - math.atan2(-float(away[1]), float(away[0]))
    turn = (turn + math.pi) % (2.0 * math.pi) - math.pi
    return Region(float(middle[0]), float(middle[1]), max(2.0 * distance * MARGIN, 1.0), turn)


def _sigmoid(values: Array) -> Array:
    return 1.0 / (1.0 + np.exp(-np.clip(values, -80.0, 80.0)))


class _Model:
    """One of the networks."""

    def __init__(self, file: Path, threads: int) -> None:
        self._network = Interpreter(model_path=str(file), num_threads=threads)
        self._network.allocate_tensors()
        self._input = self._network.get_input_details()[0]["index"]
        outputs = self._network.get_output_details()
        self._outputs = {tuple(one["shape"][1:]): one["index"] for one in outputs}

    def run(self, picture: Array) -> None:
        self._network.set_tensor(self._input, picture[np.newaxis])
        self._network.invoke()

    def output(self, *shape: int) -> Array:
        return self._network.get_tensor(self._outputs[shape])[0]


class Detector(_Model):
    """Finds people in a whole picture."""

    def __init__(self, folder: Path, threads: int) -> None:
        super().__init__(folder / "pose_detection.tflite", threads)
        anchors = []
        for stride, count in LAYERS:
            cells = DETECTOR_SIZE // stride
            for row in range(cells):
                for column in range(cells):
                    anchors += [((column + 0.5) / cells, (row + 0.5) / cells)] * count
        self._anchors = np.array(anchors, np.float32)

    def find(self, picture: Array, most: int) -> list[Region]:
        """Where people are, best first; the picture is RGB."""
        height, width = picture.shape[:2]
        scale = DETECTOR_SIZE / max(width, height)
        small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        left, top = (DETECTOR_SIZE - small.shape[1]) // 2, (DETECTOR_SIZE - small.shape[0]) // 2
        square = np.full((DETECTOR_SIZE, DETECTOR_SIZE, 3), -1.0, np.float32)
        inside = (slice(top, top + small.shape[0]), slice(left, left + small.shape[1]))
        square[inside] = small.astype(np.float32) / 127.5 - 1.0
        self.run(square)
        scores = _sigmoid(self.output(len(self._anchors), 1)[:, 0])
        chosen = np.flatnonzero(scores >= MIN_SCORE)
        raw = self.output(len(self._anchors), 12)[chosen] / DETECTOR_SIZE
        points = raw.reshape(-1, 6, 2)
        # Middles of boxes and key points are seen from the anchors; the second pair is a size.
        places = (points + self._anchors[chosen][:, np.newaxis]) * DETECTOR_SIZE
        places = (places - (left, top)) / scale
        sizes = points[:, 1] * DETECTOR_SIZE / scale
        boxes = np.concatenate([places[:, 0] - sizes / 2.0, places[:, 0] + sizes / 2.0], axis=1)
        regions = []
        for group in _groups(boxes, scores[chosen])[:most]:
            weights = scores[chosen][group][:, np.newaxis]
            middle = (places[group, 2] * weights).sum(0) / weights.sum()
            around = (places[group, 3] * weights).sum(0) / weights.sum()
            regions.append(region_between(middle, around))
        return regions


def _groups(boxes: Array, scores: Array) -> list[Array]:
    """Indices of boxes that lie over one another, the best score first."""
    left = list(np.argsort(-scores))
    groups = []
    while left:
        best = boxes[left[0]]
        others = boxes[left]
        low = np.maximum(best[:2], others[:, :2])
        high = np.minimum(best[2:], others[:, 2:])
        shared = np.prod(np.maximum(high - low, 0.0), axis=1)
        areas = np.prod(np.maximum(others[:, 2:] - others[:, :2], 1e-6), axis=1)
        overlap = shared / (areas + areas[0] - shared)
        groups.append(np.array([one for one, o in zip(left, overlap, strict=True) if o > 0.3]))
        left = [one for one, o in zip(left, overlap, strict=True) if o <= SAME_PERSON]
        if not len(groups[-1]):
            groups.pop()
    return groups


class Landmarker(_Model):
    """Finds the landmarks of the person in a region."""

    def __init__(self, folder: Path, threads: int) -> None:
        super().__init__(folder / "pose_landmark_full.tflite", threads)

    def find(self, picture: Array, region: Region, is_mirrored: bool = False) -> Landmarks:
        """The landmarks of who is in a region of an RGB picture; the model may look at it in a
        mirror, where it errs the other way."""
        left, right = (LANDMARK_SIZE, 0) if is_mirrored else (0, LANDMARK_SIZE)
        target = np.array(((left, 0), (right, 0), (left, LANDMARK_SIZE)), np.float32)
        to_square = cv2.getAffineTransform(region.corners(), target)
        square = cv2.warpAffine(
            picture, to_square, (LANDMARK_SIZE, LANDMARK_SIZE), flags=cv2.INTER_LINEAR
        )
        self.run(square.astype(np.float32) / 255.0)
        points = self.output(195).reshape(39, 5).copy()
        _refine(points, self.output(64, 64, 39))
        places = self.output(117).reshape(39, 3).copy()
        if is_mirrored:
            points[:, 0] = LANDMARK_SIZE - points[:, 0]
            places[:, 0] = -places[:, 0]
            points, places = points[_MIRRORED], places[_MIRRORED]
        seen = np.minimum(_sigmoid(points[:, 3]), _sigmoid(points[:, 4]))
        per_px = region.size / LANDMARK_SIZE
        c, s = math.cos(region.turn), math.sin(region.turn)
        turn = np.array(((c, -s), (s, c)), np.float32)
        flat = (points[:, :2] - LANDMARK_SIZE / 2.0) * per_px @ turn.T + (region.x, region.y)
        image = np.column_stack([flat, points[:, 2] * per_px, seen])
        places[:, :2] = places[:, :2] @ turn.T
        world = np.column_stack([places, seen])
        return Landmarks(
            image[:LANDMARKS],
            world[:LANDMARKS],
            float(self.output(1)[0]),
            region_between(flat[MIDDLE], flat[ROUND]),
        )


def _mirrored() -> Array:
    """Which point each one is in a mirror."""
    order = np.arange(39)
    for left, right in PAIRS:
        order[[left, right]] = right, left
    return order


_MIRRORED = _mirrored()


def _refine(points: Array, heat: Array) -> None:
    """Moves landmarks to the middle of the heat around them, where there is enough of it."""
    side = heat.shape[0]
    per_cell = LANDMARK_SIZE / side
    half = KERNEL // 2
    for number, point in enumerate(points):
        column, row = int(point[0] / per_cell), int(point[1] / per_cell)
        if not (0 <= column < side and 0 <= row < side):
            continue
        x, y = max(column - half, 0), max(row - half, 0)
        around = _sigmoid(heat[y : row + half + 1, x : column + half + 1, number])
        if around.max() < MIN_HEAT:
            continue
        total = float(around.sum())
        point[0] = (float(around.sum(0) @ np.arange(x, x + around.shape[1])) / total) * per_cell
        point[1] = (float(around.sum(1) @ np.arange(y, y + around.shape[0])) / total) * per_cell
