"""Makes the pictures of particles: assets/effects/textures, with their .import files.

    cd tools/assets && python3 -m effects.textures [FOLDER]

Needs numpy, scipy and pillow; 50 s on one core, 2.5 MB.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from PIL import Image

from . import puff, shapes

PROJECT = Path(__file__).resolve().parents[3]
FOLDER = "assets/effects/textures"
# Colours behind transparent pixels stay: the flipbook keeps brightness and heat there.
IMPORT = """[remap]

importer="texture"
type="CompressedTexture2D"

[deps]

source_file="res://{folder}/{name}"

[params]

compress/mode=0
mipmaps/generate=true
process/fix_alpha_border=false
detect_3d/compress_to=0
"""


def save(folder: Path, name: str, data: np.ndarray) -> None:
    """Writes a picture, and how it is imported where that is not known."""
    Image.fromarray((np.clip(data, 0, 1) * 255 + 0.5).astype(np.uint8)).save(folder / name)
    settings = folder / f"{name}.import"
    if not settings.exists():
        settings.write_text(IMPORT.format(folder=FOLDER, name=name))


def make(folder: Path) -> None:
    """Makes all pictures."""
    folder.mkdir(parents=True, exist_ok=True)
    front, back = puff.flipbook()
    save(folder, "puff_a.png", front)
    save(folder, "puff_b.png", back)
    save(folder, "flash.png", shapes.flash(128))
    save(folder, "spark.png", shapes.spark(64))
    save(folder, "flare.png", shapes.flare(64))
    save(folder, "chunks.png", shapes.chunks(128))


if __name__ == "__main__":
    make(Path(sys.argv[1]) if len(sys.argv) > 1 else PROJECT / FOLDER)
