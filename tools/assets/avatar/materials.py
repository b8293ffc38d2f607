"""Writes the material resources of an avatar, beside its pictures, in the engine's text format."""

from collections.abc import Collection
from pathlib import Path

_SHADER = "res://assets/shaders/person.gdshader"
_TEXTURES = "res://assets/avatar/textures"
_IMPORTS = """[remap]

importer="{importer}"
type="{kind}"

[params]

compress/mode={mode}
compress/lossy_quality=0.85
mipmaps/generate=true
{more}
"""
_HEADER = '[gd_resource type="ShaderMaterial" format=3]\n\n'


def write_import(picture: Path) -> None:
    """Say how a picture is imported, unless that is said already; the editor adds the rest."""
    path = picture.with_name(picture.name + ".import")
    if path.exists():
        return
    if picture.stem == "details":
        more = "slices/horizontal=8\nslices/vertical=1"
        text = _IMPORTS.format(
            importer="2d_array_texture", kind="CompressedTexture2DArray", mode=0, more=more
        )
    else:
        # Normals are read by our shader as they are: two channels would be swapped about.
        text = _IMPORTS.format(
            importer="texture",
            kind="CompressedTexture2D",
            mode=1,
            more="compress/normal_map=2\ndetect_3d/compress_to=0",
        )
    path.write_text(text)


def write_material(
    path: Path, textures: dict[str, str], numbers: dict[str, str], shader: str = _SHADER
) -> None:
    """Write a ShaderMaterial: pictures by the shader's names of them, and other parameters."""
    lines = [_HEADER + f'[ext_resource type="Shader" path="{shader}" id="shader"]']
    for name, file in textures.items():
        kind = "CompressedTexture2DArray" if name == "detail_layers" else "Texture2D"
        path_there = f"{_TEXTURES}/{file}"
        lines.append(f'[ext_resource type="{kind}" path="{path_there}" id="{name}"]')
    lines.append('\n[resource]\nshader = ExtResource("shader")')
    for name in sorted([*textures, *numbers]):
        value = numbers.get(name, f'ExtResource("{name}")')
        lines.append(f"shader_parameter/{name} = {value}")
    path.write_text("\n".join(lines) + "\n")


def write_avatar_materials(folder: Path, avatar: str, pictures: Collection[str]) -> None:
    """Write what only this avatar has: cloth and skin, eyes and the pockets' tile if it has them.

    `pictures` are the endings of its pictures' names.
    """
    details = {"detail_layers": "details.png"}
    write_material(
        folder / f"{avatar}_cloth.tres",
        {
            "albedo_texture": f"{avatar}_cloth.jpg",
            "normal_texture": f"{avatar}_cloth_normals.jpg",
            **details,
        },
        {"detail_tiles": "Vector2(26, 17)", "detail_strength": "0.8"},
    )
    write_material(
        folder / f"{avatar}_skin.tres",
        {"albedo_texture": f"{avatar}_skin.jpg", **details},
        {"detail_tiles": "Vector2(11, 11)", "detail_strength": "0.5", "softness": "0.35"},
    )
    if "eyes.jpg" in pictures:
        write_material(folder / f"{avatar}_eyes.tres", {"albedo_texture": f"{avatar}_eyes.jpg"}, {})
    if "tile.jpg" in pictures:
        write_material(
            folder / f"{avatar}_tile.tres",
            {"albedo_texture": f"{avatar}_tile.jpg", **details},
            {"detail_tiles": "Vector2(9, 9)", "detail_strength": "0.8"},
        )


def write_shared_materials(folder: Path) -> None:
    """Write what all avatars share: kit of any structure, far figures, lenses."""
    write_material(
        folder / "parts.tres", {"detail_layers": "details.png"}, {"detail_strength": "1.0"}
    )
    write_material(folder / "far.tres", {}, {"detail_strength": "0.0"})
    write_material(folder / "lens.tres", {}, {}, "res://assets/shaders/lens.gdshader")
