class_name LevelVisibility
extends Node
## Shows what can be seen from where the camera is, by the sets that were baked (thesis section
## 4.2.2): the rest is not drawn, or throws its shadow only, as far as that is seen.

## Light that is so near to another sector of the horizon counts as from there too, rad.
const NEAR_RAD: float = 0.15
const _UNKNOWN: int = -2

## Whose parts are shown. Set before it enters the tree.
var surfaces: LevelSurfaces = null
## Whether anything is hidden; for comparison.
var is_active: bool = true:
	set(p_value):
		is_active = p_value
		_cell = _UNKNOWN

var _cell: int = _UNKNOWN
## The bit of shadows for where the light comes from now.
var _shadow: int = 0
var _sun: DirectionalLight3D = null


func _ready() -> void:
	for node: Node in surfaces.get_parent().find_children("*", "DirectionalLight3D", true, false):
		if (node as DirectionalLight3D).shadow_enabled:
			_sun = node as DirectionalLight3D


func _process(_p_delta: float) -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	if camera != null:
		look_from(surfaces.to_local(camera.global_position))


## Shows what is seen from a point of the level. Where no cell is, all is shown.
func look_from(p_point: Vector3) -> void:
	var bake: LevelBake = surfaces.bake
	var cell: int = bake.small_cell_at(p_point) if bake != null and is_active else -1
	var shadow: int = LevelBake.SHADOWS
	if is_instance_valid(_sun):
		shadow = 0
		for turn: float in [-NEAR_RAD, 0.0, NEAR_RAD]:
			shadow |= LevelBake.shadow_bit(_sun.global_basis.z.rotated(Vector3.UP, turn))
	if cell == _cell and shadow == _shadow:
		return
	_cell = cell
	_shadow = shadow
	var count: int = surfaces.shown.size()
	for index: int in count:
		var bits: int = LevelBake.SEEN | shadow
		if cell >= 0:
			bits = bake.seen_parts[cell * count + index] & bits
		var part: MeshInstance3D = surfaces.shown[index]
		part.visible = bits != 0
		part.cast_shadow = (
			GeometryInstance3D.SHADOW_CASTING_SETTING_ON
			if bits & LevelBake.SEEN != 0
			else GeometryInstance3D.SHADOW_CASTING_SETTING_SHADOWS_ONLY
		)
