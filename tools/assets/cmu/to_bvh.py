# SPDX-License-Identifier: MIT
"""Turns Carnegie Mellon's skeletons and motions (ASF and AMC) into BVH.

Run as `python3 -m cmu.to_bvh SKELETON.asf MOTION.amc OUT.bvh` in tools/assets; needs no packages.
The lengths keep the library's unit (0.45 to the inch), joints are called as in the common
conversions. Those leave out the offsets of neck and shoulders, so that the thorax has no length.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

from avatar.vector3 import Quat

from .acclaim import ROOT, AcclaimError, Bone, Frame, bones_of, read_motion, read_skeleton

RATE = 120
"""Frames a second of the library's motions, but for a few (its page lists them)."""

NAMES = {
    ROOT: "Hips",
    "lhipjoint": "LHipJoint",
    "lfemur": "LeftUpLeg",
    "ltibia": "LeftLeg",
    "lfoot": "LeftFoot",
    "ltoes": "LeftToeBase",
    "rhipjoint": "RHipJoint",
    "rfemur": "RightUpLeg",
    "rtibia": "RightLeg",
    "rfoot": "RightFoot",
    "rtoes": "RightToeBase",
    "lowerback": "LowerBack",
    "upperback": "Spine",
    "thorax": "Spine1",
    "lowerneck": "Neck",
    "upperneck": "Neck1",
    "head": "Head",
    "lclavicle": "LeftShoulder",
    "lhumerus": "LeftArm",
    "lradius": "LeftForeArm",
    "lwrist": "LeftHand",
    "lhand": "LeftFingerBase",
    "lfingers": "LFingers",
    "lthumb": "LThumb",
    "rclavicle": "RightShoulder",
    "rhumerus": "RightArm",
    "rradius": "RightForeArm",
    "rwrist": "RightHand",
    "rhand": "RightFingerBase",
    "rfingers": "RFingers",
    "rthumb": "RThumb",
}


def convert(root: Bone, frames: list[Frame], rate: int = RATE) -> str:
    """The text of a BVH file."""
    lines = ["HIERARCHY", *_joint_lines(root, (0.0, 0.0, 0.0), 0)]
    lines += ["MOTION", f"Frames: {len(frames)}", f"Frame Time: {1 / rate:.7f}"]
    bones = bones_of(root)
    for frame in frames:
        row = list(frame.place)
        for bone in bones:
            still = [0.0] * len(bone.freedoms)
            row += euler_zyx(bone.rotation(frame.degrees.get(bone.name, still)))
        lines.append(" ".join(_number(value, 4) for value in row))
    return "\n".join(lines) + "\n"


def euler_zyx(q: Quat) -> tuple[float, float, float]:
    """The degrees about Z, Y, X of a rotation that turns about X first, then Y, then Z."""
    x, y, z, w = q
    along = 1.0 - 2.0 * (y * y + z * z)
    across = 2.0 * (x * y + w * z)
    turned_y = math.atan2(2.0 * (w * y - x * z), math.hypot(along, across))
    if math.hypot(along, across) < 1e-9:
        # Z and X turn about the same line: X does it all.
        turned_x = math.atan2(2.0 * (w * x - y * z), 1.0 - 2.0 * (x * x + z * z))
        return (0.0, math.degrees(turned_y), math.degrees(turned_x))
    turned_x = math.atan2(2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y))
    return (
        math.degrees(math.atan2(across, along)),
        math.degrees(turned_y),
        math.degrees(turned_x),
    )


def main(arguments: list[str]) -> int:
    """Converts a motion; returns 2 if the files are not such."""
    if len(arguments) != 3:
        print("expected: SKELETON.asf MOTION.amc OUT.bvh", file=sys.stderr)
        return 2
    skeleton, motion, out = (Path(argument) for argument in arguments)
    try:
        root = read_skeleton(skeleton)
        out.write_text(convert(root, read_motion(motion, root)), encoding="ascii")
    except (AcclaimError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0


def _joint_lines(bone: Bone, offset: tuple[float, float, float], depth: int) -> list[str]:
    pad = "\t" * depth
    kind = "ROOT" if bone.name == ROOT else "JOINT"
    channels = "6 Xposition Yposition Zposition" if bone.name == ROOT else "3"
    lines = [
        f"{pad}{kind} {NAMES.get(bone.name, bone.name)}",
        f"{pad}{{",
        f"{pad}\tOFFSET {_offset(offset)}",
        f"{pad}\tCHANNELS {channels} Zrotation Yrotation Xrotation",
    ]
    for child in bone.children:
        lines += _joint_lines(child, bone.end, depth + 1)
    if not bone.children:
        lines += [f"{pad}\tEnd Site", f"{pad}\t{{", f"{pad}\t\tOFFSET {_offset(bone.end)}"]
        lines.append(f"{pad}\t}}")
    return [*lines, f"{pad}}}"]


def _offset(offset: tuple[float, float, float]) -> str:
    return " ".join(_number(value, 5) for value in offset)


def _number(value: float, places: int) -> str:
    """In as few characters as the places allow, and never -0."""
    text = f"{value:.{places}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
