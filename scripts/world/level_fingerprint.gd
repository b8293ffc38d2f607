class_name LevelFingerprint
extends RefCounted
## Works out the fingerprint of a [Level], in one go ([method of]) or over several ticks.

## Bytes of a fingerprint.
const SIZE: int = 8

## Steps of lengths and of rotations, per m and per 1.
const _STEPS: float = 10000.0

var _level: Level = null
var _context: HashingContext = HashingContext.new()
# What is still to be hashed: nodes, and the bytes that go between them.
var _parts: Array = []
var _next: int = 0
# Searches that find them, one after the other: in a large level each takes milliseconds.
var _to_gather: Array[Callable] = []


## Begins with a level, which is in the tree and in which nothing has moved yet.
func _init(p_level: Level) -> void:
	_level = p_level
	_context.start(HashingContext.HASH_SHA256)
	_to_gather = [_gather_bodies, _gather_props, _gather_entities]


## A hash of the level that is the same on all machines: of shapes and positions of static bodies,
## of props and of entities. Visual nodes do not count, as a dedicated server has none. The level
## must be in the tree and nothing may have moved yet.
static func of(p_level: Level) -> PackedByteArray:
	var made: LevelFingerprint = LevelFingerprint.new(p_level)
	made.advance_until(1 << 62)
	return made.finish()


## Goes on until a moment of [method Time.get_ticks_usec]. Returns whether it is done.
func advance_until(p_usec: int) -> bool:
	while not is_done():
		if _next == _parts.size():
			_to_gather.pop_front().call()
		elif _parts[_next] is PhysicsBody3D:
			_hash_body(_parts[_next])
			_next += 1
		else:
			_context.update(_parts[_next])
			_next += 1
		if Time.get_ticks_usec() >= p_usec:
			break
	return is_done()


## Whether all has been hashed.
func is_done() -> bool:
	return _next == _parts.size() and _to_gather.is_empty()


## The fingerprint, once it is done.
func finish() -> PackedByteArray:
	return _context.finish().slice(0, SIZE)


func _gather_bodies() -> void:
	_parts.append_array(_level.get_static_bodies())


func _gather_props() -> void:
	for body: RigidBody3D in _level.get_props():
		_parts.append(_path_of(body))
		_parts.append(body)


func _gather_entities() -> void:
	for entity: Entity in _level.get_entities():
		_parts.append(_path_of(entity))
		if entity.type != null:
			_parts.append(entity.type.encode())
		if entity.get_body() != null:
			_parts.append(entity.get_body())
	var world: Entity = _level.world
	var has_world: bool = world != null and world.type != null
	_parts.append(world.type.encode() if has_world else PackedByteArray([0]))


func _path_of(p_node: Node) -> PackedByteArray:
	return str(_level.get_path_to(p_node)).to_utf8_buffer()


## The shapes of a body in any order: those of large terrain come later in some programs.
func _hash_body(p_body: PhysicsBody3D) -> void:
	var to_level: Transform3D = _level.global_transform.affine_inverse()
	var digests: PackedStringArray = []
	for child: Node in p_body.get_children(true):
		var shape: CollisionShape3D = child as CollisionShape3D
		if shape == null or shape.shape == null or shape.disabled:
			continue
		digests.append(_digest_of(to_level * shape.global_transform, shape.shape).hex_encode())
	digests.sort()
	for digest: String in digests:
		_context.update(digest.to_ascii_buffer())


static func _digest_of(p_transform: Transform3D, p_shape: Shape3D) -> PackedByteArray:
	var context: HashingContext = HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	context.update(p_shape.get_class().to_ascii_buffer())
	# What is large comes from a file, which is the same on all machines to the last bit.
	if p_shape is HeightMapShape3D:
		context.update((p_shape as HeightMapShape3D).map_data.to_byte_array())
	elif p_shape is ConcavePolygonShape3D:
		context.update((p_shape as ConcavePolygonShape3D).get_faces().to_byte_array())
	context.update(_numbers_of(p_transform, p_shape))
	return context.finish()


static func _numbers_of(p_transform: Transform3D, p_shape: Shape3D) -> PackedByteArray:
	var basis: Basis = p_transform.basis
	var points: PackedVector3Array = [basis.x, basis.y, basis.z, p_transform.origin]
	if p_shape is BoxShape3D:
		points.append((p_shape as BoxShape3D).size)
	elif p_shape is SphereShape3D:
		points.append(Vector3((p_shape as SphereShape3D).radius, 0.0, 0.0))
	elif p_shape is CapsuleShape3D or p_shape is CylinderShape3D:
		points.append(Vector3(p_shape.get(&"radius"), p_shape.get(&"height"), 0.0))
	elif p_shape is ConvexPolygonShape3D:
		points.append_array((p_shape as ConvexPolygonShape3D).points)
	var numbers: PackedInt32Array = []
	for point: Vector3 in points:
		for axis: int in 3:
			numbers.append(roundi(clampf(point[axis], -1e5, 1e5) * _STEPS))
	return numbers.to_byte_array()
