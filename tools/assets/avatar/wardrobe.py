"""Everything an avatar can wear, by the names that recipes use, and how it is put on."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from . import head_kit, headwear, stage_kit
from .bare_parts import Head, make_gloves, make_hands
from .boots import add_boot
from .collar import add_undershirt
from .figure import Figure
from .head_kit import FULL_RIM, HelmetFit, fit_helmet
from .head_straps import add_chin_strap
from .kit import Kit
from .leg_kit import add_cargo_pocket, add_holster, add_knee_pad
from .quad_mesh import Layer, QuadMesh
from .recipe import Recipe
from .rig import SIDES
from .robe import add_robe
from .torso_kit import TorsoKit
from .uniform import UniformCut


@dataclass
class Fitting:
    """An avatar while it is dressed."""

    figure: Figure
    recipe: Recipe
    cut: UniformCut
    head: Head
    kit: Kit = field(init=False)
    torso: TorsoKit = field(init=False)
    helmet: HelmetFit = field(init=False)
    lens: QuadMesh | None = None
    """The transparent lens of glasses."""
    flesh: QuadMesh | None = None
    """Bare hands and arms."""

    def __post_init__(self) -> None:
        self.kit = Kit(self.figure, self.cut.uniform, self.recipe.palette)
        self.torso = TorsoKit(self.kit)
        self.helmet = fit_helmet(self.head.skin, self.head.eye_centres[0])


def _both(add: Callable[[Kit, str], None]) -> Callable[[Fitting], None]:
    def add_both(fitting: Fitting) -> None:
        for side in SIDES:
            add(fitting.kit, side)

    return add_both


def _add_boots(fitting: Fitting) -> None:
    for side in SIDES:
        add_boot(fitting.kit, fitting.cut.boots, side)


def _add_shoulder_straps(fitting: Fitting) -> None:
    for side in SIDES:
        fitting.torso.add_shoulder_strap(side)


def _add_belt_pouches(fitting: Fitting) -> None:
    fitting.torso.add_belt()
    for side in SIDES:
        fitting.torso.add_belt_pouches(side)


def _add_gloves(fitting: Fitting) -> None:
    fitting.kit.add(make_gloves(fitting.figure), fitting.recipe.palette.gloves, Layer.LEATHER, 0.22)


def _add_smooth_hands(fitting: Fitting) -> None:
    gloves = make_gloves(fitting.figure)
    fitting.kit.add(gloves, fitting.recipe.palette.gloves, Layer.SMOOTH, 0.45)


def _add_hands(fitting: Fitting) -> None:
    begins = -0.62 if fitting.recipe.clothes.cut == "polo" else 0.80
    fitting.flesh = make_hands(fitting.figure, begins)


def _add_full_helmet(fitting: Fitting) -> None:
    head = fitting.head
    fitting.helmet = fit_helmet(head.skin, head.eye_centres[0], FULL_RIM, 0.021)
    head_kit.add_shell(fitting.kit, fitting.helmet, has_cover=False)
    headwear.add_helmet_band(fitting.kit, fitting.helmet)


def _add_glasses(fitting: Fitting) -> None:
    fitting.lens = head_kit.add_glasses(fitting.kit, fitting.head.eyes)


ITEMS: dict[str, Callable[[Fitting], None]] = {
    "plate_carrier": lambda f: f.torso.add_plates(),
    "plate_pouches": lambda f: f.torso.add_plate_pouches(),
    "chest_rig": lambda f: f.torso.add_chest_rig(),
    "tabard": lambda f: f.torso.add_tabard(),
    "shoulder_straps": _add_shoulder_straps,
    "belt": lambda f: f.torso.add_belt(),
    "belt_pouches": _add_belt_pouches,
    "knee_pads": _both(add_knee_pad),
    "cargo_pockets": _both(add_cargo_pocket),
    "holster": lambda f: add_holster(f.kit),
    "boots": _add_boots,
    "gloves": _add_gloves,
    "smooth_hands": _add_smooth_hands,
    "hands": _add_hands,
    "robe": lambda f: add_robe(f.kit),
    "joint_rings": lambda f: stage_kit.add_joint_rings(f.kit),
    "glow_lines": lambda f: stage_kit.add_glow_lines(f.kit),
    "ruff": lambda f: stage_kit.add_ruff(f.kit, f.head),
    "helmet": lambda f: head_kit.add_helmet(f.kit, f.helmet),
    "full_helmet": _add_full_helmet,
    "ear_protection": lambda f: head_kit.add_ear_protection(f.kit, f.helmet),
    "chin_strap": lambda f: add_chin_strap(f.kit, f.helmet, f.head.skin),
    "glasses": _add_glasses,
    "goggles": lambda f: headwear.add_goggles(f.kit, f.helmet),
    "scarf": lambda f: headwear.add_scarf(f.kit, f.head),
    "head_cloth": lambda f: headwear.add_head_cloth(f.kit, f.head),
    "cap": lambda f: headwear.add_cap(f.kit, f.head),
    "headset": lambda f: headwear.add_headset(f.kit, f.head),
    "hair": lambda f: headwear.add_hair(f.kit, f.head),
    "hair_bun": lambda f: headwear.add_hair_bun(f.kit, f.head),
    "mask": lambda f: stage_kit.add_mask(f.kit, f.head),
    "crest": lambda f: stage_kit.add_crest(f.kit, f.head),
}
"""What recipes may name; each adds its parts to the kit."""

_UNDERSHIRT = np.array([0.13, 0.125, 0.11])


def put_on(fitting: Fitting) -> None:
    """Put everything on that the recipe names; raises ValueError for what nobody knows."""
    unknown = [item for item in fitting.recipe.kit if item not in ITEMS]
    if unknown:
        known = ", ".join(sorted(ITEMS))
        raise ValueError(f"{fitting.recipe.name}: nobody knows {unknown}; there are {known}")
    for item in fitting.recipe.kit:
        ITEMS[item](fitting)
    add_undershirt(fitting.kit, _UNDERSHIRT)
