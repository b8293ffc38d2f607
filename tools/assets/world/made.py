"""Wood, metal, cloth, glass and palms. Each material: albedo (linear), height (m), roughness,
metallic, length of the picture's edge (m)."""

import numpy as np

from .noise import (
    N,
    blend,
    cells,
    fbm,
    flat,
    grid,
    mix,
    per_cell,
    random_columns,
    rgb,
    step,
    tint,
    unit,
    warp,
    white,
)


def _planks(seed, planks):
    """Grain and figure of planks side by side, the seams between them, and each plank's tone."""
    u, _ = grid()
    plank, place, tone, shift = random_columns(planks, N, seed)
    grain = fbm(48, 4, seed + 1, 0.6, (1, 0.04))
    rings = fbm(8, 3, seed + 2, 0.5, (1, 0.12))
    figure = 0.5 + 0.5 * np.sin(2 * np.pi * (rings * 5 + u * 14))
    for k in range(planks):
        part = plank == k
        for field in (grain, figure):
            rolled = np.roll(field, shift[k], axis=0)
            field[part] = rolled[part]
    seam = 1 - step(np.minimum(place, 1 - place), 0.012, 0.04)
    return grain, figure, seam, tone


def wood(seed=6, planks=8):
    """Old planks."""
    grain, figure, seam, tone = _planks(seed, planks)
    worn = step(fbm(4, 6, seed + 3, 0.6, (2, 0.5)), 0.0, 0.5)
    color = blend(rgb("6e4b2e"), rgb("9a7148"), 0.35 * tone + 0.65 * figure)
    color = blend(color, rgb("a48a68"), 0.5 * worn)
    color *= (0.78 + 0.4 * unit(grain) * (0.6 + 0.4 * tone))[..., None]
    color = blend(color, rgb("1e150d"), 0.9 * seam)
    height = 0.0012 * figure + 0.0015 * grain - 0.006 * seam + 0.001 * tone
    return color, height, 0.7 + 0.2 * worn, None, 1.2


def painted_wood(seed=15, planks=7):
    """Planks with white paint that flakes: a tint gives it its colour."""
    grain, figure, seam, tone = _planks(seed, planks)
    flake = fbm(3, 7, seed + 4, 0.62, (2, 0.6)) + 0.12 * grain + 0.18 * seam
    bare = step(flake, 0.25, 0.31)
    edge = step(flake, 0.19, 0.25) * (1 - bare)
    dirty = unit(fbm(4, 6, seed + 5, 0.6, (2, 0.4)))
    color = tint(rgb("d9d5cb"), 0.80 + 0.12 * tone + 0.10 * (1 - dirty) + 0.04 * grain)
    color = blend(color, rgb("efece4"), 0.5 * edge)
    old = blend(rgb("6b5138"), rgb("95795a"), 0.5 * tone + 0.5 * figure)
    color = blend(color, old * (0.75 + 0.4 * unit(grain))[..., None], bare)
    color = blend(color, rgb("241b12"), 0.85 * seam)
    height = 0.0007 * figure + 0.001 * grain - 0.005 * seam - 0.0012 * bare
    return color, height, mix(0.55 + 0.2 * dirty, 0.85, bare), None, 1.2


def metal(seed=7, paint="6f7c6a"):
    """Painted sheet metal with rust."""
    soft = fbm(2, 7, seed, 0.62)
    fine = fbm(30, 4, seed + 1, 0.65)
    grain = white(seed + 2, 0.6)
    rust = step(soft + 0.25 * fine, 0.28, 0.40)
    edge = step(soft + 0.25 * fine, 0.22, 0.28) * (1 - rust)
    run = step(fbm(16, 5, seed + 3, 0.55, (1, 0.10)), 0.25, 0.6) * 0.6
    bend = fbm(3, 3, seed + 5) * 0.1
    scratch = step(warp(fbm(4, 2, seed + 4, 0.5, (1, 26)), bend, 0), 0.46, 0.5)
    color = tint(rgb(paint), 0.88 + 0.2 * unit(fbm(2, 5, seed + 6)))
    color = blend(color, rgb("7d5a38"), 0.55 * run)
    color = blend(color, rgb("3c3a37"), np.maximum(edge * 0.8, scratch * 0.3))
    rusty = blend(rgb("6a3417"), rgb("a3602b"), unit(fine)) * (0.7 + 0.5 * grain)[..., None]
    color = blend(color, rusty, rust)
    height = 0.0008 * soft + rust * (0.0015 * fine + 0.0008 * grain) - 0.0012 * edge
    rough = mix(0.48 + 0.12 * unit(fine), 0.92, rust)
    return color, height, np.maximum(rough, 0.75 * run), 0.15 * edge + 0.2 * scratch, 2.0


def corrugated(seed=16, waves=16):
    """Corrugated sheet with pale paint and runs of rust: a tint gives it its colour."""
    u, v = grid()
    wave = 0.5 + 0.5 * np.cos(2 * np.pi * u * waves)
    soft = fbm(2, 6, seed, 0.6)
    fine = fbm(30, 4, seed + 1, 0.65)
    grain = white(seed + 2, 0.7)
    run = step(fbm(14, 5, seed + 3, 0.6, (1, 0.08)) + 0.15 * soft, 0.10, 0.45)
    seam = 1 - step(np.abs(((v + 0.25) % 1) - 0.5), 0.0025, 0.006)
    below = np.clip(1 - ((v - 0.25) % 1) / 0.35, 0, 1) ** 2
    screw_u = np.abs(((u * waves / 2) % 1) - 0.5) * 2 / waves
    screw_v = np.abs(((v + 0.28) % 1) - 0.5)
    screw = 1 - step(np.hypot(screw_u, screw_v), 0.0035, 0.0055)
    rust = np.clip(step(soft + 0.3 * fine, 0.30, 0.44) + 0.75 * run * below + 0.5 * seam, 0, 1)
    color = tint(rgb("b9bcb8"), 0.80 + 0.2 * unit(soft) + 0.06 * wave)
    color = blend(color, rgb("8e8c84"), 0.5 * step(fbm(8, 5, seed + 5, 0.6, (1, 0.2)), 0.0, 0.5))
    rusty = blend(rgb("6d3a1e"), rgb("a2643a"), unit(fine)) * (0.75 + 0.4 * grain)[..., None]
    color = blend(color, rusty, 0.85 * rust)
    color = blend(color, rgb("55524d"), 0.7 * screw)
    color *= (0.80 + 0.20 * wave)[..., None]
    height = 0.018 * wave + 0.002 * seam + 0.004 * screw + 0.0006 * fine * rust
    return color, height, mix(0.5 + 0.1 * unit(fine), 0.9, rust), 0.35 * (1 - rust), 2.4


def steel(seed=17, across=12):
    """Tread plate: bare steel with raised lozenges, worn bright on top."""
    u, v = grid()
    x, y = u * across, v * across
    odd = (np.floor(x) + np.floor(y)).astype(int) % 2
    fx, fy = x % 1 - 0.5, y % 1 - 0.5
    along = np.where(odd == 0, fx + fy, fx - fy) * 0.7071
    over = np.where(odd == 0, fx - fy, fx + fy) * 0.7071
    bar = 1 - step(np.hypot(along / 0.46, over / 0.13), 0.7, 1.0)
    soft = fbm(3, 6, seed, 0.6)
    grain = white(seed + 1, 0.7)
    rust = step(fbm(3, 7, seed + 2, 0.62), 0.16, 0.42) * (1 - 0.6 * bar)
    color = tint(rgb("77787a"), 0.72 + 0.25 * unit(soft) + 0.05 * grain)
    color = blend(color, rgb("a5a6a7"), 0.55 * bar)
    color = blend(color, tint(rgb("70492f"), 0.7 + 0.5 * grain), 0.7 * rust)
    height = 0.0032 * bar + 0.0006 * soft + 0.0003 * grain
    return color, height, mix(0.55 - 0.15 * bar, 0.88, rust), 0.6 * (1 - rust), 0.9


def _weave(thread):
    """Height of threads over and under one another, 0..1."""
    u, v = grid()
    a, b = np.sin(np.pi * u * thread) ** 2, np.sin(np.pi * v * thread) ** 2
    return np.where((np.floor(u * thread) + np.floor(v * thread)) % 2 == 0, a, b)


def fabric(seed=10, one="a33b2a", two="e3d3b4"):
    """Striped cotton: awnings, flags, curtains."""
    u, _ = grid()
    weave = _weave(128)
    soft = unit(fbm(2, 6, seed, 0.6))
    stripe = step(np.abs(((u * 4) % 1) - 0.5), 0.235, 0.25)
    color = blend(rgb(one), rgb(two), stripe) * (0.75 + 0.3 * soft)[..., None]
    color *= (0.75 + 0.3 * weave)[..., None]
    return color, 0.0012 * weave + 0.006 * fbm(3, 4, seed + 1), 0.95 + 0 * u, None, 1.5


def carpet(seed=18):
    """A knotted carpet: borders, lozenges, faded colours."""
    u, v = grid()
    knots = 160
    x, y = (np.floor(t * knots) / knots for t in (u, v))
    border = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    star = np.abs(((x * 6) % 1) - 0.5) + np.abs(((y * 6) % 1) - 0.5)
    ring = np.abs(x - 0.5) * 1.3 + np.abs(y - 0.5)
    teeth = 0.012 * (np.floor((x + y) * 40) % 2)
    color = flat(rgb("7c2a22"))
    color = blend(color, rgb("c9a873"), 1.0 * (np.abs(star - 0.32) < 0.06))
    color = blend(color, rgb("24384f"), 1.0 * (star < 0.18))
    color = blend(color, rgb("24384f"), 1.0 * (ring + teeth < 0.30))
    color = blend(color, rgb("c9a873"), 1.0 * (np.abs(ring + teeth - 0.30) < 0.016))
    color = blend(color, rgb("8f3a28"), 1.0 * (ring + teeth < 0.17))
    edge = border + teeth
    color = blend(color, rgb("2b2f3d"), 1.0 * (edge < 0.115))
    blossom = np.abs(((x * 20) % 1) - 0.5) + np.abs(((y * 20) % 1) - 0.5)
    color = blend(color, rgb("b5603a"), 1.0 * (edge < 0.105) * (blossom < 0.33))
    color = blend(color, rgb("d3bb8c"), 1.0 * (np.abs(edge - 0.115) < 0.008))
    color = blend(color, rgb("8a2f25"), 1.0 * (border < 0.03))
    knot = np.sin(np.pi * u * knots) ** 2 * np.sin(np.pi * v * knots) ** 2
    faded = unit(fbm(3, 6, seed, 0.6))
    color = blend(color, rgb("a08a6c"), 0.12 + 0.25 * faded)
    color = color * (0.68 + 0.35 * knot + 0.1 * white(seed + 1, 0.7))[..., None]
    return color, 0.002 * knot + 0.004 * fbm(4, 4, seed + 2), 0.97 + 0 * u, None, 2.0


def burlap(seed=19):
    """Sackcloth of sandbags: coarse threads, dust, stains."""
    u, _ = grid()
    move = (fbm(6, 4, seed) * 0.006, fbm(6, 4, seed + 1) * 0.006)
    weave = warp(_weave(64), *move)
    thick = unit(fbm(64, 2, seed + 2, 0.5, (1, 0.1)) + fbm(64, 2, seed + 3, 0.5, (0.1, 1)))
    stain = unit(fbm(3, 6, seed + 4, 0.6))
    color = blend(rgb("8d744f"), rgb("b89c70"), 0.6 * thick + 0.4 * stain)
    color *= (0.58 + 0.5 * weave)[..., None]
    color = blend(color, rgb("c2a273"), 0.3 * step(stain, 0.55, 0.9))
    height = 0.0016 * weave * (0.6 + 0.4 * thick) + 0.01 * fbm(3, 4, seed + 5)
    return color, height, 0.95 + 0 * u, None, 0.6


def glass(seed=20):
    """A window pane seen against a dark room: dust in the corners of the pane, smears."""
    u, v = grid()
    smear = unit(fbm(4, 6, seed, 0.6, (1, 2)))
    speck = step(white(seed + 1, 0.9), 0.80, 0.95)
    border = np.minimum(np.minimum(u, 1 - u), np.minimum(v, 1 - v))
    dusty = np.clip(0.55 * (1 - step(border, 0.0, 0.16)) + 0.30 * smear + 0.25 * speck, 0, 1)
    color = blend(rgb("27302f"), rgb("9a8c74"), 0.75 * dusty)
    return color, 0.0004 * smear + 0.0002 * speck, 0.08 + 0.6 * dusty, None, 1.0


def bark(seed=21, rings=10):
    """A palm's trunk: rows of cut leaf stalks."""
    u, v = grid()
    y = v * rings + 0.06 * fbm(6, 4, seed) * rings
    row = np.floor(y).astype(int)
    x = u * 9 + 0.5 * (row % 2)
    fx, fy = np.abs((x % 1) - 0.5) * 2, y % 1
    scale = fy + 0.45 * fx**2
    lip = step(scale, 0.62, 0.95) * (1 - step(scale, 1.02, 1.22))
    number = (row % rings) * 9 + np.floor(x).astype(int) % 9
    fibre = unit(fbm(60, 3, seed + 1, 0.6, (1, 0.08)))
    tone = per_cell(number, seed + 2)
    color = blend(rgb("5b4632"), rgb("8c7354"), 0.45 * fibre + 0.4 * tone)
    color = blend(color, rgb("ab9472"), 0.55 * lip)
    color = blend(color, rgb("2f241a"), 0.7 * (1 - step(fy, 0.0, 0.22)))
    height = 0.014 * np.clip(scale, 0, 1) + 0.008 * lip + 0.003 * fibre
    return color * (0.75 + 0.35 * fibre)[..., None], height, 0.93 + 0 * u, None, 1.2


def leaf(seed=22):
    """Leaflets of a palm along v, darker between them: for blades of any shape."""
    u, _ = grid()
    blade = np.abs(((u * 16) % 1) - 0.5) * 2
    vein = unit(fbm(64, 3, seed, 0.6, (1, 0.05)))
    number = np.floor(u * 16).astype(int)
    tone = per_cell(number, seed + 1)
    dry = step(fbm(3, 5, seed + 2, 0.6, (1, 0.5)) + 0.3 * (tone - 0.5), 0.1, 0.5)
    color = blend(rgb("4d5434"), rgb("7b7d50"), 0.5 * vein + 0.4 * tone)
    color = blend(color, rgb("a18c5e"), 0.75 * dry)
    color = blend(color, rgb("2a3018"), 0.7 * step(blade, 0.72, 1.0))
    color = blend(color, rgb("9c9c6c"), 0.4 * (1 - step(blade, 0.03, 0.12)))
    height = 0.004 * (1 - blade**2) + 0.0008 * vein
    return color, height, 0.62 + 0.25 * dry, None, 1.0


def cells_of_rust(count, seed):
    """Patches where paint has come off, for hulls that burnt: 0..1."""
    _, border, which = cells(count, seed, (fbm(6, 5, seed) * 0.05, fbm(6, 5, seed + 1) * 0.05))
    return step(border, 0, 0.02) * (per_cell(which, seed + 2) > 0.5)


def burnt(seed=23):
    """Burnt-out steel: rust in all shades, soot, scale that flakes. For wrecks."""
    soft = fbm(3, 7, seed, 0.62)
    fine = fbm(28, 5, seed + 1, 0.65)
    grain = white(seed + 2, 0.6)
    soot = step(fbm(2, 6, seed + 3, 0.6), -0.15, 0.35)
    scale = cells_of_rust(260, seed + 4)
    ash = step(fbm(3, 6, seed + 8, 0.6) + 0.2 * fine, 0.22, 0.42)
    color = blend(rgb("4a2f22"), rgb("80502f"), unit(soft + 0.5 * fine))
    color = blend(color, rgb("6b4631"), 0.5 * scale)
    color = blend(color, rgb("2a2523"), 0.78 * soot)
    color = blend(color, rgb("9b948a"), 0.35 * ash)
    color *= (0.8 + 0.35 * grain)[..., None]
    height = 0.0016 * fine + 0.0014 * scale + 0.0006 * grain
    return color, height, 0.9 + 0.06 * grain, None, 2.0
