"""The materials in the order of their layers, and the script that names them."""

from typing import NamedTuple


class Material(NamedTuple):
    """A layer: name, key for sound and dust, what it is."""

    name: str
    key: str
    meaning: str


# New materials go to the end: levels keep numbers.
MATERIALS = [
    Material("plaster", "plaster", "Lime plaster, ochre."),
    Material("plaster_pale", "plaster", "Whitewashed plaster."),
    Material("concrete", "concrete", "Cast concrete."),
    Material("brick", "brick", "Fired clay bricks."),
    Material("wood", "wood", "Old brown planks, along v."),
    Material("metal", "metal", "Sheet metal with green paint and rust."),
    Material("fabric", "cloth", "Red and white stripes along v."),
    Material("dirt", "dirt", "Trodden earth."),
    Material("sand", "sand", "Sand with ripples."),
    Material("asphalt", "asphalt", "An old road."),
    Material("rock", "rock", "Layered sandstone, layers along u."),
    Material("tiles", "concrete", "Cement floor tiles of 0.3 m."),
    Material("corrugated", "metal", "Corrugated sheet, pale: to be tinted. Waves along v."),
    Material("steel", "metal", "Tread plate."),
    Material("carpet", "cloth", "A carpet of 2 x 2 m, once over the picture."),
    Material("bark", "wood", "A palm's trunk, upwards along -v."),
    Material("leaf", "leaf", "Leaflets of a palm, along v."),
    Material("burlap", "cloth", "Sackcloth of sandbags."),
    Material("clay", "dirt", "Cracked clay of a dry wadi."),
    Material("gravel", "gravel", "Stones close together."),
    Material("painted_wood", "wood", "Planks with white paint: to be tinted. Along v."),
    Material("glass", "glass", "A dusty pane before a dark room, once over the picture."),
    Material("burnt", "metal", "Burnt-out steel, for wrecks."),
]

HEAD = """class_name SurfaceLayers
extends RefCounted
## The surfaces that blocks, terrain and props of all worlds are made of: layers of
## [code]assets/world/materials/layers_*[/code].
##
## Made by [code]tools/assets/world/layers.py[/code] from its table: change it there.

## Number of a surface's layer.
enum Layer {
"""
TAIL = """
## Colours.
const ALBEDO: String = "res://assets/world/materials/layers_albedo.jpg"
## Normals, Y up.
const NORMAL: String = "res://assets/world/materials/layers_normal.jpg"
## Occlusion, roughness, metal.
const ORM: String = "res://assets/world/materials/layers_orm.jpg"


## The key of a layer's sound and dust; of no layer &"stone".
static func key_of(p_layer: int) -> StringName:
	return KEY[p_layer] if p_layer >= 0 and p_layer < KEY.size() else &"stone"
"""


def script(averages, edges) -> str:
    """The text of surface_layers.gd."""
    lines = [HEAD]
    for row in MATERIALS:
        lines.append(f"\t## {row.meaning}\n\t{row.name.upper()},\n")
    lines.append("}\n\n## Length of a layer's edge, m.\nconst EDGE_M: Array[float] = [\n")
    lines += [f"\t{edges[row.name]:.1f},\n" for row in MATERIALS]
    lines.append("]\n## Average colour of a layer, linear.\nconst AVERAGE: Array[Color] = [\n")
    for row in MATERIALS:
        red, green, blue = averages[row.name]
        lines.append(f"\tColor({red:.3f}, {green:.3f}, {blue:.3f}),\n")
    lines.append("]\n## Key of a layer's sound and dust.\nconst KEY: Array[StringName] = [\n")
    lines += [f'\t&"{row.key}",\n' for row in MATERIALS]
    lines.append("]" + TAIL)
    return "".join(lines)
