class_name LevelVisibility
extends Node
## Shows what can be seen from where the camera is, by the sets that were baked (thesis section
## 4.2.2): parts and props that are out of sight are not drawn, and shadows only where they can fall
## on what is drawn.

## How often props are looked at, s: they move.
const PROPS_S: float = 0.1
## The light's direction counts as changed beyond this angle, rad.
const TURN_RAD: float = 0.01
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
## A byte for each part: 1 if it is shown.
var _seen: PackedByteArray = []
## When shadows were looked at: towards the sun, what the camera saw, whether all were thrown.
var _way: Vector3 = Vector3.ZERO
var _bounds: PackedVector4Array = []
var _has_all_shadows: bool = false
var _props: PropVisibility = null
var _until_props_s: float = 0.0
## Whether props have moved since shadows were looked at.
var _have_props_moved: bool = false


## Hides what cannot be seen of a level's surfaces from now on; null where nothing was baked of
## that. The level need not be in the tree.
static func begin(p_surfaces: LevelSurfaces, p_level: Node3D) -> LevelVisibility:
	if p_surfaces.bake == null or p_surfaces.bake.seen_parts.is_empty():
		return null
	var made: LevelVisibility = LevelVisibility.new()
	made.surfaces = p_surfaces
	# Now, as the loader takes a level apart before it enters the tree.
	made.sun = find_sun(p_level)
	p_surfaces.add_child(made)
	return made


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


func _ready() -> void:
	# After those that move cameras.
	process_priority = 100
	_props = PropVisibility.new(surfaces.get_parent() as Node3D)


func _process(p_delta: float) -> void:
	var camera: Camera3D = get_viewport().get_camera_3d()
	if camera == null:
		return
	var eyes: PackedVector3Array = [surfaces.to_local(camera.global_position)]
	for node: Node in get_tree().get_nodes_in_group(KitBlock.EYES_GROUP):
		if surfaces.get_parent().is_ancestor_of(node):
			eyes.append(surfaces.to_local((node as Camera3D).global_position))
	_until_props_s -= p_delta
	if _until_props_s <= 0.0:
		_look_at_props(eyes, false)
	look_from(eyes, camera if eyes.size() == 1 else null)


## Shows what is seen from any of some points of the level. Where no cell is, all is shown. Of the
## shadows only those that fall on what a camera sees, if all eyes are that of one camera.
func look_from(p_eyes: PackedVector3Array, p_camera: Camera3D = null) -> void:
	var bake: LevelBake = surfaces.bake
	var cells: PackedInt32Array = []
	for eye: Vector3 in p_eyes if bake != null and is_active else PackedVector3Array():
		cells.append(bake.small_cell_at(eye))
	if cells.has(-1):
		cells.clear()
	var stays: bool = _is_known and cells == _cells
	_cells = cells
	_is_known = true
	if not stays:
		_show_parts()
		_look_at_props(p_eyes, true)
	_show_shadows(not stays, _bounds_of(p_camera))


static func _is_prop(p_node: Node, p_level: Node3D) -> bool:
	var node: Node = p_node
	while node != null and node != p_level:
		if node.is_in_group(KitBlock.PROPS_GROUP):
			return true
		node = node.get_parent()
	return false


func _show_parts() -> void:
	var count: int = surfaces.shown.size()
	_seen.resize(count)
	for index: int in count:
		var is_seen: bool = _cells.is_empty()
		for cell: int in _cells:
			is_seen = is_seen or surfaces.bake.seen_parts[cell * count + index] != 0
		surfaces.shown[index].visible = is_seen
		_seen[index] = 1 if is_seen else 0


## The planes between which a camera sees things on which shadows fall, in the level's frame, with
## normals that point outwards; none without a camera.
func _bounds_of(p_camera: Camera3D) -> PackedVector4Array:
	var bounds: PackedVector4Array = []
	if p_camera == null or not is_instance_valid(sun):
		return bounds
	var planes: Array[Plane] = p_camera.get_frustum()
	var ahead: Vector3 = -p_camera.global_basis.z.normalized()
	var farthest: float = sun.directional_shadow_max_distance
	planes.append(Plane(ahead, p_camera.global_position + ahead * farthest))
	var to_level: Transform3D = surfaces.global_transform.affine_inverse()
	for plane: Plane in planes:
		var moved: Plane = to_level * plane
		bounds.append(Vector4(moved.normal.x, moved.normal.y, moved.normal.z, moved.d))
	return bounds


## A shadow mesh is drawn if its shadow can fall on something that is drawn.
func _show_shadows(p_is_other: bool, p_bounds: PackedVector4Array) -> void:
	var is_all: bool = _cells.is_empty() or not is_instance_valid(sun)
	var has_turned: bool = false
	if not is_all:
		var way: Vector3 = surfaces.global_basis.inverse() * sun.global_basis.z
		is_all = way.y < LOWEST
		has_turned = not is_all and (_way == Vector3.ZERO or way.angle_to(_way) > TURN_RAD)
		if has_turned:
			_way = way
			surfaces.reach.set_light(way)
	var is_unchanged: bool = is_all == _has_all_shadows and p_bounds == _bounds
	if is_unchanged and not (p_is_other or has_turned or _have_props_moved):
		return
	_have_props_moved = false
	_has_all_shadows = is_all
	_bounds = p_bounds
	_props.look_at_shadows(
		surfaces.reach,
		PackedVector4Array() if is_all else p_bounds,
		_way,
		surfaces.bake.cell_origin.y if surfaces.bake != null else 0.0
	)
	var needed: PackedByteArray = []
	if not is_all:
		needed = surfaces.reach.look(_seen, p_bounds)
	for index: int in surfaces.shadows.size():
		surfaces.shadows[index].visible = is_all or needed[index] != 0


func _look_at_props(p_eyes: PackedVector3Array, p_is_other: bool) -> void:
	_until_props_s = PROPS_S
	if p_is_other:
		_props.tidy()
	var eyes: PackedVector3Array = p_eyes if not _cells.is_empty() else PackedVector3Array()
	if _props.look(surfaces.bake, eyes, p_is_other):
		_have_props_moved = true
