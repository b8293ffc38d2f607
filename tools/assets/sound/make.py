"""Makes all sounds of Dismount: blasts, resonant bodies, engine cycles, noise.

    cd tools/assets && python3 -m sound.make [--folder FOLDER] [NAME...]

Writes assets/sound/NAME.wav (mono, 48 or 24 kHz, 16 bit) and its .import file. A name that ends
with _loop is a loop, made to end where it begins. Needs what requirements.txt names; 15 s on a
core.
"""

import argparse
import hashlib
import struct
import sys
from pathlib import Path

import numpy as np
from scipy.signal import resample

from .table import DULL, PEAKS, sounds
from .waves import RATE, rng, samples

PROJECT = Path(__file__).resolve().parents[3]
FOLDER = PROJECT / "assets" / "sound"
# How the engine reads them: as they are, because a codec would move the ends of loops.
IMPORT = """[remap]

importer="wav"
type="AudioStreamWAV"

[deps]

source_file="res://assets/sound/{name}.wav"

[params]

force/8_bit=false
force/mono=false
force/max_rate=false
force/max_rate_hz=44100
edit/trim=false
edit/normalize=false
edit/loop_mode={mode}
edit/loop_begin=0
edit/loop_end=-1
compress/mode=0
"""
# What is quieter than this beside the peak at the end of a sound is left out.
QUIET = 10 ** (-60 / 20)
# Values of edit/loop_mode: none, forward.
NO_LOOP, FORWARD = 1, 2


def finish(name: str, x: np.ndarray) -> tuple[np.ndarray, int]:
    """Whole numbers of a sound with its peak and its ends in order, and how many are a second."""
    is_loop = name.endswith("_loop")
    if is_loop:
        x = x - x.mean()
        # It begins where it is near nothing and hardly moves: neither seam nor start are heard.
        x = np.roll(x, -int(np.argmin(np.abs(x) + np.abs(np.roll(x, 1)))))
    else:
        last = np.flatnonzero(np.abs(x) > QUIET * np.abs(x).max())[-1]
        x = x[: last + samples(0.02)]
        fade = min(samples(0.02), len(x) // 4)
        x[-fade:] *= np.linspace(1, 0, fade)
    rate = RATE
    if name.startswith(DULL):
        rate = RATE // 2
        x = resample(x, len(x) // 2)
    peak_db = PEAKS.get(name.rsplit("_", 1)[0], -3.0 if is_loop else -1.0)
    x = x / np.abs(x).max() * 10 ** (peak_db / 20)
    seed = int.from_bytes(hashlib.sha256(name.encode()).digest()[:4], "big")
    dithered = x * 32767 + rng(seed).uniform(-0.5, 0.5, len(x))
    return np.clip(np.round(dithered), -32768, 32767).astype("<i2"), rate


def wav(values: np.ndarray, rate: int) -> bytes:
    """A WAV file of mono samples."""
    data = values.tobytes()
    form = struct.pack("<HHIIHH", 1, 1, rate, rate * 2, 2, 16)
    body = b"WAVEfmt " + struct.pack("<I", len(form)) + form
    body += b"data" + struct.pack("<I", len(data)) + data
    return b"RIFF" + struct.pack("<I", len(body)) + body


def main(arguments: list[str]) -> None:
    """Makes the sounds that are named, or all."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder", type=Path, default=FOLDER)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args(arguments)
    made = sounds()
    unknown = [name for name in options.names if name not in made]
    if unknown:
        parser.error(f"there is no sound {unknown[0]}; there are {', '.join(made)}")
    options.folder.mkdir(parents=True, exist_ok=True)
    total = 0
    for name in options.names or made:
        data = wav(*finish(name, made[name]()))
        total += len(data)
        (options.folder / f"{name}.wav").write_bytes(data)
        target = options.folder / f"{name}.wav.import"
        if not target.exists():
            mode = FORWARD if name.endswith("_loop") else NO_LOOP
            target.write_text(IMPORT.format(name=name, mode=mode))
    print(f"{len(options.names or made)} sounds, {total / 1e6:.1f} MB, in {options.folder}")


if __name__ == "__main__":
    main(sys.argv[1:])
