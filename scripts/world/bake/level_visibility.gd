class_name LevelVisibility
extends Node
## Shows what can be seen from where the camera is, by the sets that were baked (thesis section
## 4.2.2): parts and props that are out of sight are not drawn, and shadows only where they can fall
## on what is drawn.

## How often props are looked at, s: they move.
const PROPS_S: float = 0.1
## A turn of the light by more than this is looked at, rad, and the room for it, m.
const TURN_RAD: float = 0.01
const ROOM_M: float = 1.0
## Light that is lower than this, as a sine, throws shadows without end.
const LOWEST: float = 0.08

## Whose parts are shown. Set before it enters the tree.
var surfaces: LevelSurfaces = null
## The sun; null where shadows are thrown by anything else too, or fall on anything that is no part
## of the surfaces, such as terrain: then all are thrown.
var sun: DirectionalLight3D = null
## Whether anything is hidden; for comparison.
var is_active: bool = true:
	set(p_value):
		is_active = p_value
		_is_known = false

## The small cells in which eyes are; empty where all is shown.
var _cells: PackedInt32Array = []
var _is_known: bool = false
## Towards the sun when shadows were looked at.
var _way: Vector3 = Vector3.ZERO
var _props: PropVisibility = null
var _until_props_s: float = 0.0


## The light by whose direction shadows may be left out, of a level that need not be in the tree.
static func find_sun(p_level: Node3D) -> DirectionalLight3D:
	var suns: Array[Node] = p_level.find_children("*", "DirectionalLight3D", true, false)
	for node: Node in p_level.find_children("*", "Node3D", true, false):
		var block: KitBlock = node as KitBlock
		if (
			node is Terrain
			or node is StageLight
			or (node is Light3D and not suns.has(node) and (node as Light3D).shadow_enabled)
			or (block != null and not block.is_merged())
			or (node is GeometryInstance3D and node.owner != null and not _is_prop(node, p_level))
		):
			return null
	return suns[0] as DirectionalLight3D if suns.size() == 1 else null


static func _is_prop(p_node: Node, p_level: Node3D) -> bool:
	var node: Node = p_node
	while node != null and node != p_level:
		if node.is_in_group(KitBlock.PROPS_GROUP):
			return true
		node = node.get_parent()
	return false


func _ready() -> void:
	_props = PropVisibility.new(surfaces.get_parent() as Node3D)


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
		_look_at_props(eyes, false)


## Shows what is seen from any of some points of the level. Where no cell is, all is shown.
func look_from(p_eyes: PackedVector3Array) -> void:
	var bake: LevelBake = surfaces.bake
	var cells: PackedInt32Array = []
	for eye: Vector3 in p_eyes if bake != null and is_active else PackedVector3Array():
		cells.append(bake.small_cell_at(eye))
	if cells.has(-1):
		cells.clear()
	var way: Vector3 = Vector3.UP
	if is_instance_valid(sun):
		way = surfaces.global_basis.inverse() * sun.global_basis.z
	var stays: bool = _is_known and cells == _cells
	if stays and way.angle_to(_way) < TURN_RAD:
		return
	_way = way
	_cells = cells
	_is_known = true
	if not stays:
		var count: int = surfaces.shown.size()
		for index: int in count:
			var is_seen: bool = cells.is_empty()
			for cell: int in cells:
				is_seen = is_seen or bake.seen_parts[cell * count + index] != 0
			surfaces.shown[index].visible = is_seen
		_look_at_props(p_eyes, true)
	_show_shadows()


## A shadow mesh is drawn if something that is drawn lies between it and where its shadow ends.
func _show_shadows() -> void:
	var is_all: bool = _cells.is_empty() or not is_instance_valid(sun) or _way.y < LOWEST
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


func _look_at_props(p_eyes: PackedVector3Array, p_is_other: bool) -> void:
	_until_props_s = PROPS_S
	if p_is_other:
		_props.tidy()
	_props.look(
		surfaces.bake, p_eyes if not _cells.is_empty() else PackedVector3Array(), p_is_other
	)
