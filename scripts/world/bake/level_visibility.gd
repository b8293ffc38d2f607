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

## Whose parts are shown. Set before it enters the tree.
var surfaces: LevelSurfaces = null
## Whether anything is hidden; for comparison.
var is_active: bool = true:
	set(p_value):
		is_active = p_value
		_is_known = false

## The small cells in which eyes are; empty where all is shown.
var _cells: PackedInt32Array = []
var _is_known: bool = false
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
	var eyes: PackedVector3Array = [surfaces.to_local(camera.global_position)]
	for node: Node in get_tree().get_nodes_in_group(KitBlock.EYES_GROUP):
		if surfaces.get_parent().is_ancestor_of(node):
			eyes.append(surfaces.to_local((node as Camera3D).global_position))
	look_from(eyes)
	_until_props_s -= p_delta
	if _until_props_s <= 0.0:
		_show_props(eyes)


## Shows what is seen from any of some points of the level. Where no cell is, all is shown.
func look_from(p_eyes: PackedVector3Array) -> void:
	var bake: LevelBake = surfaces.bake
	var cells: PackedInt32Array = []
	for eye: Vector3 in p_eyes if bake != null and is_active else PackedVector3Array():
		cells.append(bake.small_cell_at(eye))
	if cells.has(-1):
		cells.clear()
	var way: Vector3 = Vector3.UP
	if is_instance_valid(_sun):
		way = surfaces.global_basis.inverse() * _sun.global_basis.z
	var is_same: bool = _is_known and cells == _cells
	if is_same and way.angle_to(_way) < TURN_RAD:
		return
	_way = way
	_cells = cells
	_is_known = true
	if not is_same:
		var count: int = surfaces.shown.size()
		for index: int in count:
			var is_seen: bool = cells.is_empty()
			for cell: int in cells:
				is_seen = is_seen or bake.seen_parts[cell * count + index] != 0
			surfaces.shown[index].visible = is_seen
		_show_props(p_eyes)
	_show_shadows()


## A shadow mesh is drawn if something that is drawn lies between it and where its shadow ends.
func _show_shadows() -> void:
	var is_all: bool = _cells.is_empty() or _has_terrain or _way.y < LOWEST
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
func _show_props(p_eyes: PackedVector3Array) -> void:
	_until_props_s = PROPS_S
	for node: Node in get_tree().get_nodes_in_group(KitBlock.PROPS_GROUP):
		var prop: Node3D = node as Node3D
		if prop != null and surfaces.get_parent().is_ancestor_of(prop):
			prop.visible = _is_near_seen(p_eyes, surfaces.to_local(prop.global_position))


## A prop may be in several cells: corners of a cube around it are looked at.
func _is_near_seen(p_eyes: PackedVector3Array, p_place: Vector3) -> bool:
	if _cells.is_empty():
		return true
	var bake: LevelBake = surfaces.bake
	var count: int = bake.cell_counts.x * bake.cell_counts.y * bake.cell_counts.z
	for corner: int in 8:
		var aside: Vector3 = Vector3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) * 2.0
		var cell: int = bake.cell_at(p_place + aside - Vector3(1.0, 0.5, 1.0))
		for eye: Vector3 in p_eyes:
			var from: int = bake.cell_at(eye)
			if cell < 0 or from < 0 or bake.seen_cells[from * count + cell] != 0:
				return true
	return false
