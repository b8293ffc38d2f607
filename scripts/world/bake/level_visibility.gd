class_name LevelVisibility
extends Node
## Shows what can be seen from where the camera is, by the sets that were baked (thesis section
## 4.2.2): parts and props that are out of sight are not drawn, and shadows only where they can fall
## on what is drawn.

## How long what props show is kept, s: they move.
const PROPS_S: float = 0.25
## A turn of the light by more than this is looked at, rad, and the room for it, m.
const TURN_RAD: float = 0.01
const ROOM_M: float = 1.0
## Light that is lower than this, as a sine, throws shadows without end.
const LOWEST: float = 0.08
const _UNKNOWN: int = -2

## Whose parts are shown. Set before it enters the tree.
var surfaces: LevelSurfaces = null
## Whether anything is hidden; for comparison.
var is_active: bool = true:
	set(p_value):
		is_active = p_value
		_cell = _UNKNOWN

var _cell: int = _UNKNOWN
var _sun: DirectionalLight3D = null
## Towards the sun when shadows were looked at.
var _way: Vector3 = Vector3.ZERO
## Ground that is no part of the surfaces takes shadows wherever it is.
var _has_terrain: bool = false
var _until_props_s: float = 0.0


func _ready() -> void:
	for node: Node in surfaces.get_parent().find_children("*", "Node3D", true, false):
		if node is DirectionalLight3D and (node as DirectionalLight3D).shadow_enabled:
			_sun = node as DirectionalLight3D
		elif node is Terrain:
			_has_terrain = true


func _process(p_delta: float) -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	if camera == null:
		return
	look_from(surfaces.to_local(camera.global_position))
	_until_props_s -= p_delta
	if _until_props_s <= 0.0:
		_show_props(surfaces.to_local(camera.global_position))


## Shows what is seen from a point of the level. Where no cell is, all is shown.
func look_from(p_point: Vector3) -> void:
	var bake: LevelBake = surfaces.bake
	var cell: int = bake.small_cell_at(p_point) if bake != null and is_active else -1
	var way: Vector3 = Vector3.UP
	if is_instance_valid(_sun):
		way = surfaces.global_basis.inverse() * _sun.global_basis.z
	if cell == _cell and way.angle_to(_way) < TURN_RAD:
		return
	_way = way
	if cell != _cell:
		_cell = cell
		var count: int = surfaces.shown.size()
		for index: int in count:
			surfaces.shown[index].visible = (cell < 0 or bake.seen_parts[cell * count + index] != 0)
		_show_props(p_point)
	_show_shadows()


## A shadow mesh is drawn if something that is drawn lies between it and where its shadow ends.
func _show_shadows() -> void:
	var is_all: bool = _cell < 0 or _has_terrain or _way.y < LOWEST
	var receivers: Array[AABB] = []
	for part: MeshInstance3D in surfaces.shown:
		if not is_all and part.visible:
			receivers.append(part.mesh.get_aabb().grow(ROOM_M))
	for shadow: MeshInstance3D in surfaces.shadows:
		shadow.visible = is_all or _falls_on(shadow.mesh.get_aabb(), receivers)


func _falls_on(p_caster: AABB, p_receivers: Array[AABB]) -> bool:
	for receiver: AABB in p_receivers:
		var rises: float = p_caster.end.y - receiver.position.y
		if rises <= 0.0:
			continue
		var towards: AABB = receiver
		towards.position += _way * (rises / _way.y)
		if receiver.merge(towards).intersects(p_caster):
			return true
	return false


## Props are where the server has them, or swing on hinges: they are shown if a cell in which they
## are is seen, by the same sets by which the server sends them.
func _show_props(p_point: Vector3) -> void:
	_until_props_s = PROPS_S
	var bake: LevelBake = surfaces.bake
	var from: int = bake.cell_at(p_point) if bake != null and _cell >= 0 else -1
	var count: int = bake.cell_counts.x * bake.cell_counts.y * bake.cell_counts.z
	for node: Node in get_tree().get_nodes_in_group(KitBlock.PROPS_GROUP):
		var prop: Node3D = node as Node3D
		if prop == null or not surfaces.get_parent().is_ancestor_of(prop):
			continue
		var is_seen: bool = from < 0
		# A prop may be in several cells: corners of a cube around it are looked at.
		for corner: int in 8 if not is_seen else 0:
			var aside: Vector3 = Vector3(corner & 1, corner >> 1 & 1, corner >> 2 & 1)
			var place: Vector3 = surfaces.to_local(prop.global_position)
			var cell: int = bake.cell_at(place + (aside * 2.0 - Vector3(1.0, 0.5, 1.0)))
			is_seen = is_seen or cell < 0 or bake.seen_cells[from * count + cell] != 0
		prop.visible = is_seen
