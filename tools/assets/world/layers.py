"""Makes the surfaces of all worlds: layers of three pictures, and the table of them for scripts.

    cd tools/assets && python3 -m world.layers [--preview FOLDER] [--only plaster,sand]

Writes assets/world/materials/layers_{albedo,normal,orm}.jpg, one material below the other, with
their .import files, and scripts/world/kit/surface_layers.gd. --preview writes single pictures
instead. Needs numpy, scipy and pillow; about two minutes on two cores.
"""

import argparse
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
from PIL import Image

from . import ground, made, noise
from .table import MATERIALS, script

PROJECT = Path(__file__).resolve().parents[3]
# Pixels along an edge of a layer; occlusion, roughness and metal need less.
SIZES = {"albedo": 1024, "normal": 1024, "orm": 512}
QUALITY = {"albedo": 91, "normal": 88, "orm": 84}
IMPORT = """[remap]

importer="2d_array_texture"
type="CompressedTexture2DArray"

[deps]

source_file="res://assets/world/materials/{name}"

[params]

compress/mode=1
compress/high_quality=false
compress/lossy_quality=0.95
compress/uastc_level=0
compress/rdo_quality_loss=0.0
compress/hdr_compression=1
compress/channel_pack=0
mipmaps/generate=true
mipmaps/limit=-1
slices/horizontal=1
slices/vertical={count}
"""


def pictures(name):
    """Albedo, normal (OpenGL's, Y up) and occlusion, roughness, metal, mean colour."""
    maker = getattr(ground, name, None) or getattr(made, name)
    color, height, rough, metallic, edge_m = maker()
    pixel = edge_m / noise.N
    dx = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) / (2 * pixel)
    dy = (np.roll(height, -1, 0) - np.roll(height, 1, 0)) / (2 * pixel)
    normal = np.stack([-dx, dy, np.ones_like(dx)], -1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    occlusion = noise.cavity(height, 10, 60 * (0.006 / max(height.std(), 1e-4)) ** 0.5)
    color = np.clip(color * (0.55 + 0.45 * occlusion)[..., None], 0, 1)
    shiny = np.zeros_like(dx) if metallic is None else metallic
    orm = np.stack([occlusion, np.clip(rough, 0, 1), shiny], -1)
    fields = {"albedo": color ** (1 / 2.2), "normal": normal * 0.5 + 0.5, "orm": orm}
    made_pictures = {}
    for kind, field in fields.items():
        picture = Image.fromarray((np.clip(field, 0, 1) * 255 + 0.5).astype(np.uint8))
        size = SIZES[kind]
        if picture.size[0] != size:
            picture = picture.resize((size, size), Image.Resampling.BOX)
        made_pictures[kind] = np.asarray(picture)
    return name, made_pictures, color.mean((0, 1)), edge_m


def main() -> None:
    """Writes strips and table, or single pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--preview", type=Path)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    names = options.only.split(",") if options.only else [row.name for row in MATERIALS]
    if options.only and not options.preview:
        parser.error("--only goes with --preview: a strip holds all materials")
    began = time.time()
    with ProcessPoolExecutor(2) as pool:
        results = list(pool.map(pictures, names))
    print(f"{len(names)} materials in {time.time() - began:.0f} s", file=sys.stderr)
    if options.preview:
        options.preview.mkdir(parents=True, exist_ok=True)
        for name, layers, _, _ in results:
            for kind, pixels in layers.items():
                Image.fromarray(pixels).save(options.preview / f"{name}_{kind}.png")
        return
    folder = PROJECT / "assets/world/materials"
    folder.mkdir(parents=True, exist_ok=True)
    for kind, quality in QUALITY.items():
        target = folder / f"layers_{kind}.jpg"
        strip = Image.fromarray(np.concatenate([layers[kind] for _, layers, _, _ in results]))
        strip.save(target, quality=quality, subsampling=0, optimize=True)
        setting = target.with_name(target.name + ".import")
        if not setting.exists():
            setting.write_text(IMPORT.format(name=target.name, count=len(results)))
        print(f"{target.name}: {target.stat().st_size / 1e6:.1f} MB", file=sys.stderr)
    averages = {name: average for name, _, average, _ in results}
    edges = {name: edge for name, _, _, edge in results}
    (PROJECT / "scripts/world/kit").mkdir(parents=True, exist_ok=True)
    (PROJECT / "scripts/world/kit/surface_layers.gd").write_text(script(averages, edges))


if __name__ == "__main__":
    main()
