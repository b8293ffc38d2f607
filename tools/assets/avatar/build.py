"""Builds an avatar by its recipe: body, clothes, kit, pictures, materials, file.

Run as `python3 -m avatar.build NAME --data FOLDER` in tools/assets, or through
`tools/assets/build_avatar`, which also fetches what this needs (numpy, pillow, bpy and the data).
"""

import argparse
import logging
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .bare_parts import Head, fill_eye, fill_mouth, make_eyes, smooth_head, take_head
from .cloth import fold_procedurally, simulate
from .details import paint_details
from .far_mesh import Coloured, build_far_mesh, sample
from .figure import Figure, build_figure
from .gltf_export import Part, Surface, export_avatar
from .hems import finish_hems
from .makehuman import MakeHumanData
from .materials import write_avatar_materials, write_import, write_shared_materials
from .occlusion import bake_occlusion
from .quad_mesh import Layer, QuadMesh, join
from .recipe import Recipe, read_recipe, recipe_names
from .textures import Textures, map_kit, paint_flesh, paint_textures
from .uniform import UniformCut, cut_uniform
from .wardrobe import Fitting, put_on

logger = logging.getLogger("avatar")

_PLAIN_TRIANGLES = 16000
_DARK = np.array([0.02, 0.02, 0.018])


def dress(figure: Figure, recipe: Recipe, with_cloth: bool) -> UniformCut:
    """Cut the clothes and give them folds."""
    cut = recipe.clothes.cut
    pieces = cut_uniform(figure, cut)
    if cut == "suit":
        return pieces
    if with_cloth and recipe.clothes.is_simulated:
        simulate(pieces.uniform, pieces.body_form, figure.rig)
    else:
        fold_procedurally(pieces.uniform, figure.rig, figure.noise)
    finish_hems(pieces.uniform, pieces.boots, pieces.body_form, figure.rig, cut)
    return pieces


def make_head(figure: Figure, recipe: Recipe) -> Head:
    """Take the head; a blank face loses its features."""
    head = take_head(figure)
    head.hair = recipe.face.hair
    head.skin.layer, head.skin.gloss = Layer.SKIN, 0.35
    if recipe.face.is_blank:
        smooth_head(head.skin)
        head.skin.layer, head.skin.gloss = Layer.SMOOTH, 0.45
    return head


@dataclass
class Divided:
    """An avatar's meshes, sorted."""

    parts: list[Part]
    """The nodes of the file: body, head, what hangs loose."""
    coloured: list[Coloured]
    """All meshes, the colours of their pictures in the vertices."""


def divide(fitting: Fitting, textures: Textures, name: str) -> Divided:
    """Sort everything into the nodes of the file."""
    rig = fitting.figure.rig
    bodies: dict[str, list[QuadMesh]] = {}

    def put(node: str, material: str, mesh: QuadMesh) -> None:
        bodies.setdefault(f"{node} {material}", []).append(mesh)

    put("BodyMesh", f"{name}_cloth", fitting.cut.uniform)
    put("HeadMesh", f"{name}_skin", fitting.head.skin)
    if fitting.recipe.face.is_blank:
        for eye in fitting.head.eyes:
            fill_eye(eye, fitting.recipe.face.tone)
            put("HeadMesh", "parts", eye)
        if "mask" not in fitting.recipe.kit:
            put("HeadMesh", "parts", fill_mouth(fitting.head, fitting.recipe.face.tone))
    else:
        put("HeadMesh", f"{name}_eyes", make_eyes(fitting.head))
    if fitting.flesh is not None:
        put("BodyMesh", "parts", fitting.flesh)
    for part in fitting.kit.parts:
        is_head = part.weights[:, rig.index["Head"]].mean() > 0.45
        node = "DrapeMesh" if part.is_loose else "HeadMesh" if is_head else "BodyMesh"
        put(node, f"{name}_tile" if part.camouflaged else "parts", part)
    if fitting.lens is not None:
        put("HeadMesh", "lens", fitting.lens)
    nodes: dict[str, list[Surface]] = {}
    for key, meshes in bodies.items():
        node, material = key.split()
        nodes.setdefault(node, []).append(Surface(material, join(meshes)))
    painted = {"cloth": textures.cloth.colour, "skin": textures.skin}
    painted |= {"eyes": textures.eyes, "tile": textures.tile}
    coloured = []
    for key, meshes in bodies.items():
        picture = painted.get(key.split()[1].removeprefix(f"{name}_"))
        for mesh in meshes:
            colours = mesh.colours if picture is None else mesh.colours * sample(mesh, picture)
            if key.endswith(" lens"):
                colours = np.tile(_DARK, (len(mesh.vertices), 1))
            coloured.append(Coloured(mesh, colours))
    return Divided([Part(node, surfaces) for node, surfaces in nodes.items()], coloured)


def build_avatar(
    data: MakeHumanData, recipe: Recipe, output: Path, with_cloth: bool, plain: Path | None = None
) -> None:
    """Build an avatar into a folder: NAME.glb, textures/, materials/.

    The order of the steps is part of the result: pictures draw from one random generator.
    """
    figure = build_figure(data, recipe.body)
    logger.info("rigged the body: %d bones", len(figure.rig.names))
    cut = dress(figure, recipe, with_cloth)
    logger.info("dressed it: %d vertices of cloth", len(cut.uniform.vertices))
    fitting = Fitting(figure, recipe, cut, make_head(figure, recipe))
    put_on(fitting)
    logger.info("equipped it: %d parts", len(fitting.kit.parts))
    shaded = [cut.uniform, fitting.head.skin, *fitting.kit.parts]
    if fitting.flesh is not None:
        paint_flesh(fitting.flesh, recipe.face, figure.noise)
        map_kit([fitting.flesh], fitting.helmet)
        shaded.append(fitting.flesh)
    bake_occlusion(shaded)
    logger.info("baked the occlusion")
    has_tile = any(part.camouflaged for part in fitting.kit.parts)
    textures = paint_textures(data, figure, recipe, cut.uniform, fitting.head, has_tile)
    logger.info("painted it")
    map_kit(fitting.kit.parts, fitting.helmet)
    for folder in ("textures", "materials"):
        (output / folder).mkdir(parents=True, exist_ok=True)
    pictures = textures.encode()
    for ending, content in pictures.items():
        (output / "textures" / f"{recipe.name}_{ending}").write_bytes(content)
    (output / "textures" / "details.png").write_bytes(paint_details())
    for picture in (output / "textures").glob("*.[jp][pn]g"):
        write_import(picture)
    write_avatar_materials(output / "materials", recipe.name, pictures)
    write_shared_materials(output / "materials")
    path = output / f"{recipe.name}.glb"
    divided = divide(fitting, textures, recipe.name)
    root = "".join(word.capitalize() for word in recipe.name.split("_"))
    far = Part("FarMesh", [Surface("far", build_far_mesh(divided.coloured))])
    export_avatar(path, root, figure.rig, [*divided.parts, far])
    if plain is not None:
        mesh = build_far_mesh(divided.coloured, _PLAIN_TRIANGLES)
        export_avatar(plain, root, figure.rig, [Part("Body", [Surface("Figure", mesh)])], False)
    logger.info("wrote %s: %.1f MB", path, path.stat().st_size / 1e6)


def main() -> None:
    """Parse the command line and build."""
    parser = argparse.ArgumentParser(prog="build_avatar", description="Build an avatar.")
    parser.add_argument("name", choices=recipe_names(), help="its recipe, recipes/NAME.json")
    parser.add_argument("--output", type=Path, required=True, help="the folder to write into")
    parser.add_argument("--data", type=Path, required=True, help="MakeHuman's mpfb2 data folder")
    parser.add_argument("--no-cloth", action="store_true", help="procedural folds, half the time")
    parser.add_argument(
        "--plain", type=Path, help="also write a .glb that needs no pictures and no shader of ours"
    )
    arguments = parser.parse_args()
    logging.basicConfig(
        level=logging.INFO, format="[%(relativeCreated)6d ms] %(levelname)s %(name)s: %(message)s"
    )
    recipe = read_recipe(arguments.name)
    data = MakeHumanData(arguments.data)
    build_avatar(data, recipe, arguments.output, not arguments.no_cloth, arguments.plain)


if __name__ == "__main__":
    main()
