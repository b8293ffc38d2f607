"""Makes the picture of clouds that sky and flying dust are drawn with.

cd tools/assets && python3 -m world.clouds
"""

import numpy as np
from PIL import Image

from .layers import PROJECT
from .noise import fbm, unit, warp

SIZE = 512


def main() -> None:
    """Writes assets/world/materials/clouds.png, grey."""
    bend = 0.035
    field = warp(fbm(4, 7, 71, 0.56), fbm(5, 5, 72) * bend, fbm(5, 5, 73) * bend)
    pixels = (unit(field) * 255 + 0.5).astype(np.uint8)
    picture = Image.fromarray(pixels).resize((SIZE, SIZE), Image.Resampling.BOX)
    picture.save(PROJECT / "assets/world/materials/clouds.png", optimize=True)


if __name__ == "__main__":
    main()
