"""Three-vectors and quaternions as plain tuples, for the tools that run without numpy.

Vectors are (x, y, z); quaternions are (x, y, z, w), the order of glTF and of Godot.
"""

import math

Vec3 = tuple[float, float, float]
Quat = tuple[float, float, float, float]


def add(a: Vec3, b: Vec3) -> Vec3:
    """Return a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vec3, b: Vec3) -> Vec3:
    """Return a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a: Vec3, factor: float) -> Vec3:
    """Return a times factor."""
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a: Vec3, b: Vec3) -> float:
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vec3, b: Vec3) -> Vec3:
    """Return the vector product (right-handed)."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def length(a: Vec3) -> float:
    """Return the Euclidean length."""
    return math.sqrt(dot(a, a))


def multiply(p: Quat, q: Quat) -> Quat:
    """Return the Hamilton product p q: first q turns, then p."""
    px, py, pz, pw = p
    qx, qy, qz, qw = q
    return (
        pw * qx + px * qw + py * qz - pz * qy,
        pw * qy - px * qz + py * qw + pz * qx,
        pw * qz + px * qy - py * qx + pz * qw,
        pw * qw - px * qx - py * qy - pz * qz,
    )


def conjugate(q: Quat) -> Quat:
    """Return the inverse of a unit quaternion."""
    return (-q[0], -q[1], -q[2], q[3])


def normalized(q: Quat) -> Quat:
    """Return q at unit length, with w >= 0 so that equal turns print equally."""
    norm = math.sqrt(sum(c * c for c in q))
    sign = -1.0 if q[3] < 0 else 1.0
    return (q[0] / norm * sign, q[1] / norm * sign, q[2] / norm * sign, q[3] / norm * sign)


def rotate(q: Quat, v: Vec3) -> Vec3:
    """Turn v by the unit quaternion q."""
    axis = (q[0], q[1], q[2])
    twice = scale(cross(axis, v), 2.0)
    return add(add(v, scale(twice, q[3])), cross(axis, twice))


def yaw(angle: float) -> Quat:
    """Return the turn by angle (radians) about the vertical Y axis."""
    return (0.0, math.sin(angle / 2), 0.0, math.cos(angle / 2))
