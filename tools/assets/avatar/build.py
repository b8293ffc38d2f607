"""Builds the soldier: body, uniform, kit, textures, file.

Run as `python3 -m avatar.build OUT.glb --data FOLDER` in tools/assets, or through
`tools/assets/build_avatar`, which also fetches what this needs (numpy, pillow, bpy and the data).
"""

import argparse
import logging
from pathlib import Path

from .bare_parts import Head, make_eyes, make_gloves, take_head
from .boots import add_boot
from .cloth import fold_procedurally, simulate
from .figure import Figure, build_figure
from .gltf_export import Surface, export_avatar
from .head_kit import (
    HelmetFit,
    add_ear_protection,
    add_glasses,
    add_helmet,
    fit_helmet,
)
from .head_straps import add_chin_strap
from .hems import finish_hems
from .kit import Kit
from .kit_parts import GLOVE_OLIVE
from .leg_kit import add_cargo_pocket, add_knee_pad
from .makehuman import BodyParameters, MakeHumanData
from .occlusion import bake_occlusion
from .quad_mesh import QuadMesh, join
from .rig import SIDES
from .textures import map_kit, paint_textures
from .torso_kit import TorsoKit
from .uniform import UniformCut, cut_uniform

logger = logging.getLogger("avatar")


def dress(figure: Figure, with_cloth: bool) -> UniformCut:
    """Cut the uniform and give it folds."""
    cut = cut_uniform(figure)
    if with_cloth:
        simulate(cut.uniform, cut.body_form, figure.rig)
    else:
        fold_procedurally(cut.uniform, figure.rig, figure.noise)
    finish_hems(cut.uniform, cut.boots, cut.body_form, figure.rig)
    return cut


def equip(figure: Figure, cut: UniformCut, head: Head) -> tuple[Kit, HelmetFit, QuadMesh]:
    """Hang the kit on the dressed figure; returns it, the helmet's fit and the glasses' lens."""
    kit = Kit(figure, cut.uniform)
    torso = TorsoKit(kit)
    torso.add_webbing()
    torso.add_plate_pouches()
    for side in SIDES:
        torso.add_shoulder_strap(side)
        torso.add_belt_pouches(side)
        add_knee_pad(kit, side)
        add_cargo_pocket(kit, side)
        add_boot(kit, cut.boots, side)
    kit.add(make_gloves(figure), GLOVE_OLIVE)
    helmet = fit_helmet(head.skin, head.eye_centres[0])
    add_helmet(kit, helmet)
    add_ear_protection(kit, helmet)
    add_chin_strap(kit, helmet, head.skin)
    lens = add_glasses(kit, head.eyes)
    return kit, helmet, lens


def build_avatar(
    data: MakeHumanData, parameters: BodyParameters, output: Path, with_cloth: bool = True
) -> None:
    """Build the avatar and write it as .glb.

    The order of the steps is part of the result: textures draw from one random generator.
    """
    figure = build_figure(data, parameters)
    logger.info("rigged the body: %d bones", len(figure.rig.names))
    cut = dress(figure, with_cloth)
    logger.info("dressed it: %d vertices of cloth", len(cut.uniform.vertices))
    head = take_head(figure)
    kit, helmet, lens = equip(figure, cut, head)
    logger.info("equipped it: %d parts", len(kit.parts))
    bake_occlusion([cut.uniform, head.skin, *kit.parts])
    logger.info("baked the occlusion")
    textures = paint_textures(data, cut.uniform, head, helmet, figure.noise)
    map_kit(kit.parts, helmet)
    plain = [part for part in kit.parts if not part.camouflaged]
    camouflaged = [part for part in kit.parts if part.camouflaged]
    surfaces = [
        Surface("Uniform", *join([cut.uniform])),
        Surface("Skin", *join([head.skin])),
        Surface("Eyes", *join([make_eyes(head)])),
        Surface("Kit", *join(plain)),
        Surface("KitCamo", *join(camouflaged)),
        Surface("Lens", *join([lens]), shaded=False),
    ]
    export_avatar(output, figure.rig, surfaces, textures)
    logger.info("wrote %s: %.1f MB", output, output.stat().st_size / 1e6)


def main() -> None:
    """Parse the command line and build."""
    parser = argparse.ArgumentParser(prog="build_avatar", description="Build the soldier avatar.")
    parser.add_argument("output", type=Path, help="the .glb file to write")
    parser.add_argument("--data", type=Path, required=True, help="MakeHuman's mpfb2 data folder")
    parser.add_argument(
        "--params",
        default="{}",
        help='JSON: {"height": metres, "muscle": 0..1, "weight": 0..1, "extra": {target: amount}}',
    )
    parser.add_argument("--no-cloth", action="store_true", help="procedural folds, half the time")
    arguments = parser.parse_args()
    logging.basicConfig(
        level=logging.INFO, format="[%(relativeCreated)6d ms] %(levelname)s %(name)s: %(message)s"
    )
    parameters = BodyParameters.from_json(arguments.params)
    data = MakeHumanData(arguments.data)
    build_avatar(data, parameters, arguments.output, with_cloth=not arguments.no_cloth)


if __name__ == "__main__":
    main()
