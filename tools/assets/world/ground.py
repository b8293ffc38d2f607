"""Sand, earth, stone and road. Each material: albedo (linear), height (m), roughness, metallic,
length of the picture's edge (m)."""

import numpy as np

from .noise import (
    blend,
    cells,
    cracks,
    fbm,
    flat,
    grid,
    mix,
    per_cell,
    rgb,
    step,
    tint,
    unit,
    warp,
    white,
)


def sand(seed=2):
    """Fine sand with ripples and few small stones."""
    _, v = grid()
    bend = fbm(2, 4, seed, 0.5)
    phase = v * 22 + bend * 2.2 + fbm(5, 3, seed + 1) * 0.5
    wave = 0.5 + 0.5 * np.sin(2 * np.pi * (phase - 0.12 * np.sin(2 * np.pi * phase)))
    strength = step(fbm(2, 4, seed + 2), -0.35, 0.45)
    grain = white(seed + 3, 0.6)
    soft = fbm(3, 6, seed + 4, 0.55)
    f1, _, which = cells(900, seed + 5)
    stone = step(per_cell(which, seed) ** 3 * 0.009 - f1, 0, 0.003)
    height = 0.009 * wave * strength + 0.012 * soft + 0.0008 * grain + 0.004 * stone
    color = tint(rgb("c9a26e"), 0.92 + 0.14 * unit(soft))
    color = blend(color, rgb("dfc092"), 0.45 * wave * strength)
    color = blend(color, tint(rgb("8d7355"), 0.8 + 0.5 * per_cell(which, 7)), 0.6 * stone)
    color *= (0.90 + 0.2 * grain)[..., None]
    return color, height, 0.93 + 0.05 * grain, None, 3.0


def dirt(seed=3):
    """Trodden earth with stones."""
    soft = fbm(3, 7, seed, 0.6)
    grain = white(seed + 1, 0.8)
    f1, _, which = cells(2600, seed + 2)
    stone = step(per_cell(which, seed) ** 2 * 0.014 - f1, 0, 0.004)
    shade = per_cell(which, seed + 9)
    ruts = step(fbm(2, 5, seed + 3), 0.05, 0.5)
    height = 0.015 * soft + 0.006 * stone + 0.001 * grain
    color = tint(rgb("b39068"), 0.82 + 0.3 * unit(soft))
    color = blend(color, rgb("c8a67c"), 0.55 * ruts)
    color = blend(color, tint(rgb("9c8a73"), 0.7 + 0.6 * shade), 0.85 * stone)
    color *= (0.92 + 0.16 * grain)[..., None]
    return color, height, 0.9 + 0.08 * grain - 0.1 * stone, None, 3.0


def gravel(seed=12):
    """Desert pavement: stones of all sizes close together, sand between them."""
    bend = (fbm(24, 3, seed) * 0.004, fbm(24, 3, seed + 1) * 0.004)
    grain = white(seed + 2, 0.7)
    soft = fbm(3, 6, seed + 3, 0.55)
    color = tint(rgb("b08d64"), 0.85 + 0.25 * unit(soft))
    color *= (0.9 + 0.2 * grain)[..., None]
    height = 0.004 * soft + 0.0006 * grain
    for count, keep, lift, number in ((14000, 0.5, 0.003, 4), (2600, 0.30, 0.008, 5)):
        f1, border, which = cells(count, seed + number, bend)
        size = 0.5 / np.sqrt(count)
        there = per_cell(which, seed + 20 + number) < keep * (0.75 + 0.5 * unit(soft))
        round_off = step(border - 0.12 * f1, 0.0, 0.35 * size) * there
        shade = per_cell(which, seed + 30 + number)
        hue = per_cell(which, seed + 40 + number)
        stone = blend(rgb("8a7258"), rgb("6b5d50"), hue) * (0.65 + 0.75 * shade)[..., None]
        stone = blend(stone, rgb("b9a183"), 0.8 * (shade > 0.85))
        stone *= (0.88 + 0.2 * white(seed + 50 + number, 1.2))[..., None]
        color = blend(color, stone, step(round_off, 0.15, 0.5))
        height = np.maximum(height, lift * round_off * (0.5 + 0.5 * shade) + 0.3 * height)
    return color, height, 0.86 + 0.1 * grain, None, 2.5


def clay(seed=13):
    """The dry bed of a wadi: curled plates of clay between deep cracks."""
    bend = (fbm(5, 5, seed, 0.55) * 0.02, fbm(5, 5, seed + 1, 0.55) * 0.02)
    _, border, which = cells(130, seed + 2, bend)
    _, fine, _ = cells(900, seed + 3, bend)
    grain = white(seed + 4, 0.7)
    soft = fbm(3, 6, seed + 5, 0.55)
    gap = 1 - step(border, 0.0022, 0.0062)
    hair = (1 - step(fine, 0.0005, 0.0020)) * (1 - gap) * step(fbm(3, 4, seed + 6), -0.1, 0.3)
    rim = step(border, 0.004, 0.012) * (1 - step(border, 0.012, 0.03))
    shade = per_cell(which, seed + 7)
    color = tint(rgb("bd9c74"), 0.86 + 0.14 * shade + 0.12 * unit(soft))
    color = blend(color, rgb("d5ba93"), 0.4 * rim)
    color = blend(color, rgb("4d3a28"), 0.85 * gap)
    color = blend(color, rgb("7d6044"), 0.6 * hair)
    color *= (0.94 + 0.12 * grain)[..., None]
    height = 0.006 * step(border, 0, 0.01) + 0.004 * rim + 0.003 * soft * (1 - gap)
    height += 0.002 * shade - 0.0015 * hair + 0.0004 * grain
    return color, height, 0.86 + 0.08 * grain, None, 3.0


def asphalt(seed=8):
    """An old road: stones in tar, cracks, dust."""
    _, border, which = cells(9000, seed)
    shade, size = per_cell(which, seed), per_cell(which, seed + 1)
    stone = step(border, 0.0004, 0.0016) * step(size, 0.25, 0.5)
    soft = fbm(2, 6, seed + 1, 0.55)
    crack = cracks(7, seed + 2, 0.002, 0.05) * step(fbm(2, 3, seed + 3), -0.05, 0.2)
    dust = step(fbm(2, 6, seed + 4, 0.6), -0.1, 0.6)
    color = tint(rgb("4b4a48"), 0.7 + 0.7 * shade * stone)
    color = blend(color, rgb("a98d68"), 0.18 + 0.45 * dust)
    color = blend(color, rgb("2a2825"), 0.8 * crack)
    color *= (0.92 + 0.14 * white(seed + 5, 0.6))[..., None]
    height = 0.0022 * stone + 0.004 * soft - 0.005 * crack
    return color, height, 0.82 + 0.12 * dust, None, 2.5


def rock(seed=9):
    """Layered sandstone, weathered, with few cracks."""
    bend = 0.06 * fbm(3, 4, seed + 2)
    layer = warp(fbm(2, 7, seed + 1, 0.56, (1, 7)), 0.04 * fbm(3, 4, seed + 3), bend)
    bed = unit(layer)
    shelf = step(np.abs((bed * 5) % 1 - 0.5), 0.30, 0.5)
    ridge = 1 - np.abs(fbm(4, 7, seed, 0.58, (1, 1.8)))
    pit = step(fbm(22, 4, seed + 7, 0.6), 0.16, 0.42)
    crack = cracks(9, seed + 4, 0.0035, 0.07) * step(fbm(2, 4, seed + 8), -0.05, 0.25)
    grain = white(seed + 5, 0.8)
    color = blend(rgb("94704e"), rgb("bb9569"), bed) * (0.74 + 0.34 * unit(ridge))[..., None]
    color = blend(color, rgb("a5673f"), 0.35 * step(fbm(2, 4, seed + 9, 0.5, (1, 4)), 0.0, 0.5))
    color = blend(color, rgb("6b5038"), 0.45 * shelf + 0.3 * pit)
    color = blend(color, rgb("463527"), 0.7 * crack)
    color *= (0.92 + 0.16 * grain)[..., None]
    height = 0.045 * ridge + 0.035 * bed - 0.018 * shelf - 0.012 * pit - 0.025 * crack
    return color, height + 0.001 * grain, 0.88 + 0.06 * grain, None, 3.0


def concrete(seed=4):
    """Cast concrete with pores, stains and hair cracks."""
    soft = fbm(2, 7, seed, 0.58)
    grain = white(seed + 1, 0.6)
    f1, _, which = cells(2600, seed + 2)
    pore = step(per_cell(which, seed) ** 9 * 0.0045 - f1, -0.0005, 0.0012)
    stain = step(fbm(2, 6, seed + 3, 0.6), 0.05, 0.5)
    crack = cracks(5, seed + 4, 0.0014, 0.04) * step(fbm(2, 3, seed + 5), -0.1, 0.2)
    color = tint(rgb("a19c92"), 0.85 + 0.22 * unit(soft))
    color = blend(color, rgb("7d776c"), 0.45 * stain)
    color = blend(color, rgb("55504a"), np.maximum(0.55 * pore, 0.6 * crack))
    color *= (0.94 + 0.12 * grain)[..., None]
    height = 0.0025 * soft + 0.0006 * grain - 0.0025 * pore - 0.003 * crack
    return color, height, 0.82 + 0.1 * unit(soft) - 0.1 * stain, None, 2.5


def tiles(seed=14, across=8):
    """Cement floor tiles, worn, with a few that were replaced."""
    u, v = grid()
    column, row = np.floor(u * across).astype(int), np.floor(v * across).astype(int)
    number = row * across + column
    edge = np.minimum(*(np.minimum((t * across) % 1, 1 - (t * across) % 1) for t in (u, v)))
    edge = edge + 0.006 * fbm(24, 4, seed)
    body = step(edge, 0.012, 0.035)
    tone, odd = per_cell(number, seed), per_cell(number, seed + 1)
    worn = step(fbm(3, 6, seed + 2, 0.6), -0.05, 0.5)
    stain = step(fbm(4, 6, seed + 3, 0.6), 0.12, 0.5)
    grain = white(seed + 4, 0.8)
    color = blend(rgb("b8a78c"), rgb("a8876a"), ((row + column) % 2).astype(float) * 0.8)
    color = blend(color, rgb("9c7a5e"), 0.5 * (odd > 0.9)) * (0.84 + 0.22 * tone)[..., None]
    color = blend(color, rgb("cdbb9c"), 0.25 * worn)
    color = blend(color, rgb("7d6a55"), 0.35 * stain)
    color = blend(tint(rgb("6f6250"), 0.8 + 0.3 * grain), color, body)
    chip = step(fbm(9, 5, seed + 5, 0.6) - 1.4 * edge, 0.30, 0.34)
    color = blend(color, rgb("c9bda6"), 0.6 * chip) * (0.96 + 0.08 * grain)[..., None]
    height = 0.003 * body + 0.0012 * tone - 0.002 * chip + 0.0003 * grain
    return color, height, mix(0.9, 0.55 + 0.25 * worn, body), None, 2.4


def plaster(seed=1, wall="d3b48c", chip="a27a55"):
    """Lime plaster on clay, with streaks, cracks and lost pieces."""
    trowel = fbm(3, 6, seed, 0.6, (1.0, 2.2))
    trowel = warp(trowel, fbm(4, 3, seed + 3) * 0.05, fbm(4, 3, seed + 4) * 0.05)
    blotch = unit(fbm(2, 5, seed + 5, 0.55))
    grain = white(seed + 6, 0.7)
    rough_patch = step(fbm(3, 6, seed + 7, 0.65), 0.12, 0.3)
    crack = cracks(14, seed + 8, 0.0028) * step(fbm(3, 3, seed + 9), 0.0, 0.25)
    lost = step(fbm(3, 7, seed + 10, 0.62), 0.36, 0.40)
    streak = unit(fbm(10, 5, seed + 11, 0.6, (1, 0.12)))
    color = tint(rgb(wall), 0.86 + 0.22 * blotch + 0.05 * trowel)
    color = blend(color, tint(rgb("b89168"), 0.9 + 0.2 * blotch), 0.3 * step(streak, 0.55, 0.95))
    color = blend(color, rgb("e2cba6"), 0.35 * rough_patch)
    under = tint(rgb(chip), 0.75 + 0.4 * unit(fbm(24, 4, seed + 12, 0.7)))
    color = blend(color, under, lost)
    color = blend(color, rgb("5e4630"), 0.6 * crack * (1 - lost))
    color *= (0.96 + 0.08 * grain)[..., None]
    height = 0.004 * trowel + 0.0011 * (grain - 0.5) * (1 + rough_patch) - 0.003 * crack
    height += lost * (-0.009 + 0.004 * fbm(20, 5, seed + 13, 0.65))
    return color, height, 0.88 + 0.08 * grain, None, 2.5


def plaster_pale():
    """Whitewashed plaster."""
    return plaster(41, "ded0b4", "b39671")


def brick(seed=5, rows=16, columns=6):
    """Fired clay bricks in old mortar."""
    u, v = grid()
    wob_u, wob_v = fbm(8, 4, seed) * 0.004, fbm(8, 4, seed + 1) * 0.004
    row = np.floor((v + wob_v) * rows).astype(int)
    x = ((u + wob_u) * columns + 0.5 * (row % 2)) % columns
    column = np.floor(x).astype(int)
    number = (row % rows) * columns + column
    tone, lift, red = (per_cell(number, seed + k) for k in (0, 6, 7))
    du = np.minimum(x - column, 1 - (x - column)) / columns
    dv = np.minimum(((v + wob_v) * rows) % 1, 1 - ((v + wob_v) * rows) % 1) / rows
    edge = np.minimum(du, dv) + 0.003 * fbm(40, 3, seed + 2)
    body = step(edge, 0.0035, 0.0085)
    grain = white(seed + 3, 0.7)
    soft = fbm(12, 5, seed + 4, 0.6)
    color = blend(rgb("9a6846"), rgb("b98a5f"), tone) * (0.8 + 0.35 * unit(soft))[..., None]
    color = blend(color, flat(rgb("7d5138")), 0.5 * (red > 0.75))
    mortar = tint(rgb("b7a181"), 0.8 + 0.3 * grain)
    color = blend(mortar, color, body) * (0.93 + 0.14 * grain)[..., None]
    height = body * (0.010 + 0.005 * lift + 0.003 * soft) + 0.001 * grain
    return color, height, 0.9 + 0.06 * grain, None, 1.6
