"""Builds vehicles: python -m vehicle.build NAME... --output FOLDER."""

import argparse
import importlib
import pathlib

from . import paint, parts

NAMES = ("tank", "carrier", "truck", "scootmobile")


def build(name, folder, size, samples):
    """Models, paints and bakes one vehicle."""
    parts.start()
    module = importlib.import_module(f".{name}", __package__)
    materials = module.materials() if hasattr(module, "materials") else paint.military()
    own = module.make(materials)
    parts.apply_modifiers()
    parts.share_copies()
    parts.join(own)
    textures = folder / "textures"
    textures.mkdir(parents=True, exist_ok=True)
    paint.bake(materials, name, textures, size or getattr(module, "TEXTURE", 2048), samples)
    for part in parts.bpy.data.objects:
        if part.name == "TrackLink":
            part.location = (0, 0, 0)
    parts.export(folder / f"{name}.glb")


def main():
    """Reads the command line."""
    reader = argparse.ArgumentParser(description=__doc__)
    reader.add_argument("names", nargs="+", choices=NAMES)
    reader.add_argument("--output", type=pathlib.Path, required=True)
    reader.add_argument("--size", type=int, default=0)
    reader.add_argument("--samples", type=int, default=8)
    chosen = reader.parse_args()
    for name in chosen.names:
        build(name, chosen.output.resolve(), chosen.size, chosen.samples)


if __name__ == "__main__":
    main()
