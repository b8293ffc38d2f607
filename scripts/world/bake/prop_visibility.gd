class_name PropVisibility
extends RefCounted
## Hides the props of a level that no eye can see, by the sets by which the server sends them, and
## shows them again: none that somebody else has hidden.

## Room around a prop, m: for its shadow, and for how far it moves until it is looked at again.
const ROOM_M: float = 1.0
## A prop that has moved by less than this counts as unmoved, m.
const MOVED_M: float = 0.2


## A prop that was looked at.
class Known:
	## What is drawn of it, in its own frame.
	var box: AABB = AABB()
	## The same in the level's frame.
	var at: AABB = AABB()
	## Where it was.
	var place: Vector3 = Vector3.INF
	## Whether it is hidden by this class.
	var is_hidden: bool = false
	## What is drawn of it and throws shadows.
	var throwing: Array[GeometryInstance3D] = []
	## Whether its shadow is thrown.
	var throws: bool = true


var _level: Node3D = null
## By the instance ids of the props: these outlive them.
var _known: Dictionary[int, Known] = {}


## Takes the level whose props are meant.
func _init(p_level: Node3D) -> void:
	_level = p_level


## Looks at all props after eyes have come to other cells, else at those that have moved. The eyes
## are in the level's frame; without any, all props are shown. Returns whether any was looked at.
func look(p_bake: LevelBake, p_eyes: PackedVector3Array, p_is_other: bool) -> bool:
	var has_looked: bool = false
	for node: Node in _level.get_tree().get_nodes_in_group(KitBlock.PROPS_GROUP):
		var prop: Node3D = node as Node3D
		if prop == null or not _level.is_ancestor_of(prop):
			continue
		var known: Known = _known.get(prop.get_instance_id())
		if known == null:
			known = Known.new()
			known.box = _box_of(prop)
			_find_throwing(prop, known)
			_known[prop.get_instance_id()] = known
		var place: Vector3 = prop.global_position
		if not p_is_other and place.distance_squared_to(known.place) < MOVED_M * MOVED_M:
			continue
		has_looked = true
		known.place = place
		var to_level: Transform3D = _level.global_transform.affine_inverse() * prop.global_transform
		known.at = to_level * known.box
		_show(prop, known, _is_seen(p_bake, p_eyes, known.at.grow(ROOM_M)))
	return has_looked


## Lets only those throw shadows whose shadow may reach what a camera sees: see [method
## ShadowReach.find_inside]. Without bounds all throw them. The sun's light comes from the direction
## [param p_way] and ends at the height [param p_floor].
func look_at_shadows(
	p_reach: ShadowReach, p_bounds: PackedVector4Array, p_way: Vector3, p_floor: float
) -> void:
	var corners: PackedVector3Array = []
	for known: Known in _known.values():
		var box: AABB = known.at
		if not p_bounds.is_empty():
			var shadow: AABB = box
			shadow.position -= p_way * (maxf(box.end.y - p_floor, 0.0) / p_way.y)
			box = box.merge(shadow)
		corners.append(box.position)
		corners.append(box.end)
	var is_inside: PackedByteArray = p_reach.find_inside(corners, p_bounds)
	var number: int = 0
	for known: Known in _known.values():
		_throw(known, is_inside[number] != 0)
		number += 1


## Forgets props that are gone.
func tidy() -> void:
	for id: int in _known.keys():
		if not is_instance_id_valid(id):
			_known.erase(id)


static func _find_throwing(p_prop: Node3D, p_known: Known) -> void:
	for node: Node in p_prop.find_children("*", "GeometryInstance3D", true, false):
		var shown: GeometryInstance3D = node as GeometryInstance3D
		if shown.cast_shadow == GeometryInstance3D.SHADOW_CASTING_SETTING_ON:
			p_known.throwing.append(shown)


static func _throw(p_known: Known, p_throws: bool) -> void:
	if p_known.throws == p_throws:
		return
	p_known.throws = p_throws
	for shown: Variant in p_known.throwing:
		if is_instance_valid(shown):
			(shown as GeometryInstance3D).cast_shadow = (
				GeometryInstance3D.SHADOW_CASTING_SETTING_ON
				if p_throws
				else GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
			)


static func _show(p_prop: Node3D, p_known: Known, p_is_seen: bool) -> void:
	if p_is_seen and p_known.is_hidden:
		p_prop.visible = true
		p_known.is_hidden = false
	elif not p_is_seen and p_prop.visible:
		p_prop.visible = false
		p_known.is_hidden = true


static func _is_seen(p_bake: LevelBake, p_eyes: PackedVector3Array, p_box: AABB) -> bool:
	if p_eyes.is_empty():
		return true
	var count: int = p_bake.cell_counts.x * p_bake.cell_counts.y * p_bake.cell_counts.z
	var low: Vector3i = Vector3i(((p_box.position - p_bake.cell_origin) / p_bake.cell_size).floor())
	var high: Vector3i = Vector3i(((p_box.end - p_bake.cell_origin) / p_bake.cell_size).floor())
	# Below the floors nobody looks; of what else is outside of the cells nothing is known.
	low.y = maxi(low.y, 0)
	if low.clamp(Vector3i.ZERO, p_bake.cell_counts - Vector3i.ONE) != low:
		return true
	if high.clamp(Vector3i.ZERO, p_bake.cell_counts - Vector3i.ONE) != high:
		return true
	for eye: Vector3 in p_eyes:
		var from: int = p_bake.cell_at(eye)
		if from < 0:
			return true
		for x: int in range(low.x, high.x + 1):
			for z: int in range(low.z, high.z + 1):
				for y: int in range(low.y, high.y + 1):
					var cell: int = (x * p_bake.cell_counts.z + z) * p_bake.cell_counts.y + y
					if p_bake.seen_cells[from * count + cell] != 0:
						return true
	return false


## What is drawn of a prop, in its own frame.
static func _box_of(p_prop: Node3D) -> AABB:
	var box: AABB = AABB()
	for node: Node in p_prop.find_children("*", "VisualInstance3D", true, false):
		var shown: VisualInstance3D = node as VisualInstance3D
		var to_prop: Transform3D = p_prop.global_transform.affine_inverse() * shown.global_transform
		box = box.merge(to_prop * shown.get_aabb())
	return box
