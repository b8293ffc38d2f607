class_name GroundObstacles
extends RefCounted
## What stands in somebody's way: boxes, and how deep limbs are in them.

const KINDS: Array[String] = ["wall", "corner", "table", "door"]
## Thickness of walls and door leaves, m: as thin as real ones.
const _THICKNESS: float = 0.1
## Width of the doorway, m, and how long its leaf takes to close, s: as in examples/01_door.
const _GAP: float = 1.4
const _CLOSING_S: float = 1.2
const _FAR: float = 8.0
## Points of a pill's axis, and of each edge of a box, that are looked at.
const _PILL_POINTS: int = 7
const _BOX_POINTS: int = 4

var _bodies: Array[Node3D] = []
var _sizes: Array[Vector3] = []
var _leaf: AnimatableBody3D = null
var _leaf_way: Vector3 = Vector3.ZERO
var _closed: float = 0.0
var _blocks_all: bool = true
var _plane: Plane = Plane()
## Whether somebody was through the door before it had closed.
var _has_passed: bool = false


## Puts one of [constant KINDS] across a level direction at a distance from the origin of it, m. A
## table's top is at a height, m.
func _init(
	p_world: ContactWorld, p_kind: String, p_frame: Transform3D, p_distance: float, p_height: float
) -> void:
	_plane = Plane(-p_frame.basis.z, p_frame * Vector3(0.0, 0.0, p_distance))
	var wall: Vector3 = Vector3(2.0 * _FAR, 4.0, _THICKNESS)
	var middle: Vector3 = Vector3(0.0, 2.0, p_distance + _THICKNESS / 2.0)
	match p_kind:
		"wall":
			_add(p_world, p_frame * Transform3D(Basis(), middle), wall)
		"corner":
			for side: float in [-1.0, 1.0]:
				var turn: Basis = Basis(Vector3.UP, side * PI / 4.0)
				_add(p_world, p_frame * Transform3D(turn, turn * middle), wall)
		"table":
			_blocks_all = false
			var top: Vector3 = Vector3(2.0 * _FAR, 0.06, 1.0)
			_add(
				p_world,
				p_frame * Transform3D(Basis(), Vector3(0.0, p_height, p_distance + 0.5)),
				top
			)
		"door":
			for side: float in [-1.0, 1.0]:
				var at: Vector3 = middle + Vector3.RIGHT * side * (_FAR + _GAP / 2.0)
				_add(p_world, p_frame * Transform3D(Basis(), at), wall)
			_add_leaf(p_world, p_frame * Transform3D(Basis(), middle + Vector3.RIGHT * _GAP))
			_leaf_way = -p_frame.basis.x * _GAP


## Moves the door's leaf in a step; it begins to close when somebody is about to be in it.
func advance(p_hips: Vector3, p_delta_s: float) -> void:
	if _leaf != null and _closed < 1.0 and _plane.distance_to(p_hips) < -_THICKNESS:
		_has_passed = true
	if _leaf != null and (_closed > 0.0 or _plane.distance_to(p_hips) < 1.6) and _closed < 1.0:
		var part: float = minf(p_delta_s / _CLOSING_S, 1.0 - _closed)
		_leaf.position += _leaf_way * part
		_closed += part


## How deep the deepest limb is in any of it, m; below 0: so far off.
func depth(p_person: ContactPerson, p_bodies: Array[Transform3D]) -> float:
	var deepest: float = -INF
	for i: int in _bodies.size():
		var back: Transform3D = _bodies[i].global_transform.affine_inverse()
		for limb: int in p_person.count:
			if _outside(back * p_bodies[limb].origin, _sizes[i]) < 0.6:
				deepest = maxf(deepest, _limb_depth(p_person, limb, back * p_bodies[limb], i))
	return deepest


## How many limbs are on the other side: the line from the limb that they hang on to their joint and
## on to their middle goes through, or they are behind what leaves no way. Without the joint, an arm
## that bends round a table's edge would count, though nothing of it is in there.
func tunnelled(p_person: ContactPerson, p_bodies: Array[Transform3D]) -> int:
	var found: int = 0
	for limb: int in p_person.count:
		var parent: int = maxi(p_person.parent_of(limb), 0)
		var from: Vector3 = p_bodies[parent].origin
		var is_through: bool = _is_behind(p_bodies[limb].origin)
		for i: int in _bodies.size():
			var back: Transform3D = _bodies[i].global_transform.affine_inverse()
			var box: AABB = AABB(-_sizes[i] / 2.0, _sizes[i])
			var joint: Vector3 = back * p_person.joint(limb, p_bodies)
			for end: Vector3 in [back * from, back * p_bodies[limb].origin]:
				var hit: Variant = box.intersects_segment(joint, end)
				is_through = is_through or (hit != null and parent != limb)
		found += 1 if is_through else 0
	return found


func _is_behind(p_at: Vector3) -> bool:
	if not _blocks_all or _has_passed or (_leaf != null and _closed < 1.0):
		return false
	for i: int in _bodies.size():
		var local: Vector3 = _bodies[i].global_transform.affine_inverse() * p_at
		if absf(local.x) < _sizes[i].x / 2.0 and local.z > 0.0 and local.z < 6.0:
			return true
	return false


func _limb_depth(p_person: ContactPerson, p_limb: int, p_local: Transform3D, p_box: int) -> float:
	var limb: RagdollLimb = p_person.shape_of(p_limb)
	var turn: Basis = Basis(limb.rest_orientation.inverse() * limb.orientation)
	var shape: Transform3D = p_local * Transform3D(turn, Vector3.ZERO)
	var deepest: float = -INF
	if limb.type == RagdollLimb.PILL:
		for i: int in _PILL_POINTS:
			var along: float = (float(i) / (_PILL_POINTS - 1) - 0.5) * limb.length
			var at: Vector3 = shape * Vector3(0.0, along, 0.0)
			deepest = maxf(deepest, limb.radius - _outside(at, _sizes[p_box]))
		return deepest
	for i: int in _BOX_POINTS ** 3:
		var step: Vector3i = Vector3i(i, i / _BOX_POINTS, i / _BOX_POINTS ** 2) % _BOX_POINTS
		var part: Vector3 = Vector3(step) / (_BOX_POINTS - 1) - Vector3.ONE / 2.0
		deepest = maxf(deepest, -_outside(shape * (part * limb.size), _sizes[p_box]))
	return deepest


func _add(p_world: ContactWorld, p_at: Transform3D, p_size: Vector3) -> void:
	_bodies.append(p_world.add_block(p_size, p_at, 0.6))
	_sizes.append(p_size)


func _add_leaf(p_world: ContactWorld, p_at: Transform3D) -> void:
	_leaf = AnimatableBody3D.new()
	_leaf.sync_to_physics = false
	_leaf.transform = p_at
	_leaf.collision_layer = PhysicsLayers.STATIC
	var size: Vector3 = Vector3(_GAP, 4.0, _THICKNESS)
	_leaf.add_child(BenchBodies.box(size))
	p_world.add_child(_leaf)
	_bodies.append(_leaf)
	_sizes.append(size)


## Distance of a point from a box about the origin, m; below 0 inside.
static func _outside(p_at: Vector3, p_size: Vector3) -> float:
	var off: Vector3 = p_at.abs() - p_size / 2.0
	return off.max(Vector3.ZERO).length() + minf(off[off.max_axis_index()], 0.0)
