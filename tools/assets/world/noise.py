"""Noise on a torus, so that every picture made of it tiles: numpy, scipy's KD-tree and FFT."""

import numpy as np
from scipy.ndimage import map_coordinates
from scipy.spatial import cKDTree

# Pixels along each edge of every picture.
N = 1024


def grid():
    """u to the right and v downwards, 0 to 1, for every pixel."""
    axis = (np.arange(N) + 0.5) / N
    return np.meshgrid(axis, axis)


def gradient_noise(cells_x, cells_y, seed):
    """One octave of gradient noise with the given number of cells along each edge."""
    rng = np.random.default_rng(seed)
    angle = rng.uniform(0, 2 * np.pi, (cells_y, cells_x))
    gx, gy = np.cos(angle), np.sin(angle)
    u, v = grid()
    x, y = u * cells_x, v * cells_y
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = x - x0, y - y0
    sx, sy = fx**3 * (fx * (fx * 6 - 15) + 10), fy**3 * (fy * (fy * 6 - 15) + 10)

    def corner(dx, dy):
        i, j = (x0 + dx) % cells_x, (y0 + dy) % cells_y
        return gx[j, i] * (fx - dx) + gy[j, i] * (fy - dy)

    top = corner(0, 0) * (1 - sx) + corner(1, 0) * sx
    bottom = corner(0, 1) * (1 - sx) + corner(1, 1) * sx
    return (top * (1 - sy) + bottom * sy) * 1.6


def fbm(cells, octaves, seed, gain=0.5, stretch=(1, 1)):
    """Octaves of gradient noise, each twice as fine and gain times as strong as the last."""
    total, weight, norm = np.zeros((N, N)), 1.0, 0.0
    for octave in range(octaves):
        scale = 2**octave
        cx, cy = max(1, int(cells * stretch[0]) * scale), max(1, int(cells * stretch[1]) * scale)
        if max(cx, cy) > N // 2:
            break
        total += weight * gradient_noise(cx, cy, seed + 17 * octave)
        norm += weight
        weight *= gain
    return total / norm


def white(seed, blur=0.0):
    """A random number for every pixel; with a blur of some pixels it is brought to 0..1."""
    noise = np.random.default_rng(seed).normal(size=(N, N))
    return unit(smooth(noise, blur)) if blur else noise


def smooth(field, radius):
    """Gaussian blur on the torus, radius in pixels."""
    f = np.fft.fftfreq(N)
    kernel = np.exp(-2 * (np.pi * radius) ** 2 * (f[None, :] ** 2 + f[:, None] ** 2))
    return np.fft.ifft2(np.fft.fft2(field) * kernel).real


def warp(field, dx, dy):
    """A field at places that are moved by dx, dy (in edges of the picture)."""
    j, i = np.mgrid[0:N, 0:N].astype(float)
    return map_coordinates(field, [j + dy * N, i + dx * N], order=1, mode="grid-wrap")


def cells(count, seed, move=None):
    """Cellular noise: distance to the nearest point, to its cell's border, and the point's number.

    move, a pair of fields in edges of the picture, bends the borders.
    """
    rng = np.random.default_rng(seed)
    points = rng.random((count, 2))
    u, v = grid()
    if move is not None:
        u, v = u + move[0], v + move[1]
    tree = cKDTree(points, boxsize=1.0)
    near, which = tree.query(np.stack([u.ravel() % 1, v.ravel() % 1], 1), k=2)
    shape = (N, N)
    apart = points[which[:, 0]] - points[which[:, 1]]
    apart = np.linalg.norm(apart - np.round(apart), axis=1)
    border = (near[:, 1] ** 2 - near[:, 0] ** 2) / (2 * apart + 1e-9)
    return near[:, 0].reshape(shape), border.reshape(shape), which[:, 0].reshape(shape)


def per_cell(which, seed):
    """A random number 0..1 for each cell, at each of its pixels."""
    return np.random.default_rng(seed).random(int(which.max()) + 1)[which]


def unit(field):
    """Brought to 0..1, the outermost half per cent cut."""
    low, high = np.percentile(field, [0.5, 99.5])
    return np.clip((field - low) / (high - low + 1e-9), 0, 1)


def step(field, low, high):
    """0 below low, 1 above high, smooth between."""
    t = np.clip((field - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    """a at t = 0, b at t = 1."""
    return a + (b - a) * t


def rgb(text):
    """Linear colour of hexadecimal digits."""
    c = np.array([int(text[i : i + 2], 16) for i in (0, 2, 4)]) / 255.0
    return c**2.2


def tint(base, field):
    """A colour for every pixel: base * field."""
    return np.asarray(base)[None, None, :] * field[..., None]


def flat(base):
    """The same colour at every pixel."""
    return np.broadcast_to(np.asarray(base, dtype=float), (N, N, 3))


def blend(a, b, t):
    """Colours a at t = 0, b at t = 1."""
    a = a if a.ndim == 3 else flat(a)
    b = b if b.ndim == 3 else flat(b)
    return a + (b - a) * t[..., None]


def cavity(height, radius, gain):
    """Darkening of what lies lower than its surroundings."""
    return np.clip(1 - gain * np.maximum(smooth(height, radius) - height, 0), 0.25, 1)


def cracks(count, seed, width, bend=0.02):
    """1 in the cracks between count cells, width in edges of the picture."""
    _, edge, _ = cells(count, seed)
    edge = warp(edge, fbm(6, 5, seed + 1) * bend, fbm(6, 5, seed + 2) * bend)
    return 1 - step(edge, 0, width)


def random_columns(columns, count_max, seed):
    """Pixels' own numbers of cells in columns, for planks: whole number, and place within it."""
    u, _ = grid()
    place = u * columns
    number = np.floor(place).astype(int)
    rng = np.random.default_rng(seed)
    return number, place - number, rng.random(columns)[number], rng.integers(0, count_max, columns)
