class_name SurfaceLayers
extends RefCounted
## The surfaces that blocks, terrain and props of all worlds are made of: layers of
## [code]assets/world/materials/layers_*[/code].
##
## Made by [code]tools/assets/world/layers.py[/code] from its table: change it there.

## Number of a surface's layer.
enum Layer {
	## Lime plaster, ochre.
	PLASTER,
	## Whitewashed plaster.
	PLASTER_PALE,
	## Cast concrete.
	CONCRETE,
	## Fired clay bricks.
	BRICK,
	## Old brown planks, along v.
	WOOD,
	## Sheet metal with green paint and rust.
	METAL,
	## Red and white stripes along v.
	FABRIC,
	## Trodden earth.
	DIRT,
	## Sand with ripples.
	SAND,
	## An old road.
	ASPHALT,
	## Layered sandstone, layers along u.
	ROCK,
	## Cement floor tiles of 0.3 m.
	TILES,
	## Corrugated sheet, pale: to be tinted. Waves along v.
	CORRUGATED,
	## Tread plate.
	STEEL,
	## A carpet of 2 x 2 m, once over the picture.
	CARPET,
	## A palm's trunk, upwards along -v.
	BARK,
	## Leaflets of a palm, along v.
	LEAF,
	## Sackcloth of sandbags.
	BURLAP,
	## Cracked clay of a dry wadi.
	CLAY,
	## Stones close together.
	GRAVEL,
	## Planks with white paint: to be tinted. Along v.
	PAINTED_WOOD,
	## A dusty pane before a dark room, once over the picture.
	GLASS,
	## Burnt-out steel, for wrecks.
	BURNT,
}

## Length of a layer's edge, m.
const EDGE_M: Array[float] = [
	2.5,
	2.5,
	2.5,
	1.6,
	1.2,
	2.0,
	1.5,
	3.0,
	3.0,
	2.5,
	3.0,
	2.4,
	2.4,
	0.9,
	2.0,
	1.2,
	1.0,
	0.6,
	3.0,
	2.5,
	1.2,
	1.0,
	2.0,
]
## Average colour of a layer, linear.
const AVERAGE: Array[Color] = [
	Color(0.644, 0.455, 0.262),
	Color(0.694, 0.592, 0.425),
	Color(0.337, 0.314, 0.271),
	Color(0.376, 0.206, 0.103),
	Color(0.226, 0.113, 0.043),
	Color(0.156, 0.189, 0.132),
	Color(0.458, 0.283, 0.196),
	Color(0.429, 0.272, 0.139),
	Color(0.588, 0.373, 0.166),
	Color(0.135, 0.103, 0.071),
	Color(0.350, 0.200, 0.091),
	Color(0.403, 0.297, 0.193),
	Color(0.391, 0.400, 0.379),
	Color(0.177, 0.176, 0.180),
	Color(0.206, 0.102, 0.061),
	Color(0.186, 0.122, 0.064),
	Color(0.123, 0.133, 0.049),
	Color(0.317, 0.215, 0.100),
	Color(0.450, 0.301, 0.161),
	Color(0.335, 0.214, 0.111),
	Color(0.594, 0.567, 0.509),
	Color(0.089, 0.081, 0.060),
	Color(0.106, 0.043, 0.020),
]
## Key of a layer's sound and dust.
const KEY: Array[StringName] = [
	&"plaster",
	&"plaster",
	&"concrete",
	&"brick",
	&"wood",
	&"metal",
	&"cloth",
	&"dirt",
	&"sand",
	&"asphalt",
	&"rock",
	&"concrete",
	&"metal",
	&"metal",
	&"cloth",
	&"wood",
	&"leaf",
	&"cloth",
	&"dirt",
	&"gravel",
	&"wood",
	&"glass",
	&"metal",
]
## Colours.
const ALBEDO: String = "res://assets/world/materials/layers_albedo.jpg"
## Normals, Y up.
const NORMAL: String = "res://assets/world/materials/layers_normal.jpg"
## Occlusion, roughness, metal.
const ORM: String = "res://assets/world/materials/layers_orm.jpg"


## The key of a layer's sound and dust; of no layer &"stone".
static func key_of(p_layer: int) -> StringName:
	return KEY[p_layer] if p_layer >= 0 and p_layer < KEY.size() else &"stone"
