class_name WorldDescription
extends RefCounted
## Which bodies a server simulates: sent reliably at joining and whenever it changes.
##
## A client needs it to know whose limb or which prop a body id means, and to draw the server's
## actual shapes in the physics world (thesis section 4.2.3).


## One body.
class Body:
	## Number of the body in snapshots, 0 to 65535.
	var id: int = 0
	## Id of the person it belongs to, or [constant PROP] or [constant FIXED].
	var actor: int = PROP
	## Name of the limb's bone, or path of the prop below the world's scene.
	var part: String = ""
	## Shapes, each [type, size, transform in the body] with [enum ShapeType] and a [Vector3].
	var shapes: Array = []


## How a shape is described.
enum ShapeType {
	## Size is the edge lengths, m.
	BOX,
	## Size is radius, height with caps, 0, m.
	CAPSULE,
	## Size is radius, 0, 0, m.
	SPHERE,
}

## In place of an actor: a prop that may move.
const PROP: int = -1
## In place of an actor: part of the static world. Its shapes are placed in the world.
const FIXED: int = -2
## Most people in a description.
const MAX_PEOPLE: int = 1024

## Errors of poses that can be, degrees.
const MIN_ERROR_DEG: float = 0.02
const MAX_ERROR_DEG: float = 5.0

const _LONGEST_TEXT: int = 1024
const _LARGEST: float = 1e5

## How far a limb's orientation in snapshots may be off, degrees: client and server need the same.
var pose_error_deg: float = Protocol.POSE_ERROR_DEG
## The bodies, by id.
var bodies: Dictionary[int, Body] = {}
## Names of the people, by actor id.
var names: Dictionary[int, String] = {}
## Number of the session that each person belongs to, by actor id.
var owners: Dictionary[int, int] = {}
## Which of its session's people each person is, by actor id.
var places: Dictionary[int, int] = {}
## How each person's limbs hang together, by actor id; the limbs are the person's bodies in order.
var skeletons: Dictionary[int, PersonSkeleton] = {}


## Adds a body and returns it.
func add(p_id: int, p_actor: int, p_part: String, p_shapes: Array) -> Body:
	var body: Body = Body.new()
	body.id = p_id
	body.actor = p_actor
	body.part = p_part
	body.shapes = p_shapes
	bodies[p_id] = body
	return body


## Adds a person. The skeleton is sound, or empty where nobody needs it.
func add_person(
	p_actor: int, p_owner: int, p_name: String, p_skeleton: PersonSkeleton, p_place: int = 0
) -> void:
	names[p_actor] = p_name
	owners[p_actor] = p_owner
	places[p_actor] = p_place
	skeletons[p_actor] = p_skeleton


## The bodies of a person, by place of the limb.
func bodies_of(p_actor: int) -> Array[Body]:
	var found: Array[Body] = []
	for id: int in bodies:
		if bodies[id].actor == p_actor:
			found.append(bodies[id])
	found.sort_custom(func(p_a: Body, p_b: Body) -> bool: return p_a.id < p_b.id)
	return found


## The packet that carries the description. Little-endian: u8 message; f32 error of poses
## (degrees); u16 number of people, for each s32 actor id, s32 session, u8 which of its people,
## name, u8 number of limbs (0 or all), for each limb 3 f32 joint in the parent's frame, 3 f32 in
## its own (m), 4 f32 x, y, z, w of the body in the reset pose; u16 number of bodies, for each u16
## id, s32 actor, part, u8 number of shapes, for each u8 type, 3 f32 size (m), 12 f32 transform
## (columns of the basis, origin). Texts are u16 length and UTF-8.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray([Protocol.Message.WORLD])
	bytes.append_array(PackedFloat32Array([pose_error_deg]).to_byte_array())
	_append(bytes, 2, names.size())
	for actor: int in names:
		_append(bytes, 4, actor)
		_append(bytes, 4, owners.get(actor, 0))
		_append(bytes, 1, places.get(actor, 0))
		bytes.append_array(ByteReader.text_bytes(names[actor]))
		_append_skeleton(bytes, skeletons.get(actor, PersonSkeleton.new()))
	_append(bytes, 2, bodies.size())
	for id: int in bodies:
		var body: Body = bodies[id]
		_append(bytes, 2, id)
		_append(bytes, 4, body.actor)
		bytes.append_array(ByteReader.text_bytes(body.part))
		_append(bytes, 1, body.shapes.size())
		for shape: Array in body.shapes:
			var size: Vector3 = shape[1]
			_append(bytes, 1, shape[0])
			bytes.append_array(PackedFloat32Array([size.x, size.y, size.z]).to_byte_array())
			bytes.append_array(ByteReader.transform_bytes(shape[2]))
	return bytes


## The description in a packet, or null if it is none.
static func decode(p_bytes: PackedByteArray) -> WorldDescription:
	var reader: ByteReader = ByteReader.new(p_bytes)
	if reader.read_u8() != Protocol.Message.WORLD:
		return null
	var description: WorldDescription = WorldDescription.new()
	# As exact as the number was before it went as f32.
	description.pose_error_deg = snappedf(reader.read_float(), 0.001)
	var people: int = reader.read_u16()
	var error: float = description.pose_error_deg
	if people > MAX_PEOPLE or error < MIN_ERROR_DEG or error > MAX_ERROR_DEG:
		return null
	for _person: int in people:
		var actor: int = reader.read_s32()
		var owner: int = reader.read_s32()
		var place: int = reader.read_u8()
		var name: String = reader.read_text(_LONGEST_TEXT)
		description.add_person(actor, owner, name, _read_skeleton(reader), place)
		if reader.failed or actor < 0:
			return null
	for _body: int in reader.read_u16():
		_read_body(reader, description)
		if reader.failed:
			return null
	return description if reader.is_complete() else null


## The shape of an entry of [member Body.shapes].
static func make_shape(p_entry: Array) -> Shape3D:
	var size: Vector3 = p_entry[1]
	match p_entry[0]:
		ShapeType.BOX:
			var box: BoxShape3D = BoxShape3D.new()
			box.size = size
			return box
		ShapeType.CAPSULE:
			var capsule: CapsuleShape3D = CapsuleShape3D.new()
			capsule.radius = size.x
			capsule.height = size.y
			return capsule
	var sphere: SphereShape3D = SphereShape3D.new()
	sphere.radius = size.x
	return sphere


## An entry of [member Body.shapes] for a shape, or an empty list for a kind that is not known.
static func describe_shape(p_shape: Shape3D, p_transform: Transform3D) -> Array:
	if p_shape is BoxShape3D:
		return [ShapeType.BOX, (p_shape as BoxShape3D).size, p_transform]
	if p_shape is CapsuleShape3D:
		var capsule: CapsuleShape3D = p_shape
		return [ShapeType.CAPSULE, Vector3(capsule.radius, capsule.height, 0.0), p_transform]
	if p_shape is SphereShape3D:
		return [ShapeType.SPHERE, Vector3((p_shape as SphereShape3D).radius, 0.0, 0.0), p_transform]
	return []


static func _append_skeleton(p_bytes: PackedByteArray, p_skeleton: PersonSkeleton) -> void:
	_append(p_bytes, 1, p_skeleton.joints_in_limb.size())
	for limb: int in p_skeleton.joints_in_limb.size():
		var outer: Vector3 = p_skeleton.joints_in_parent[limb]
		var inner: Vector3 = p_skeleton.joints_in_limb[limb]
		var reset: Quaternion = p_skeleton.reset_orientations[limb]
		var numbers: PackedFloat32Array = [outer.x, outer.y, outer.z, inner.x, inner.y, inner.z]
		numbers.append_array([reset.x, reset.y, reset.z, reset.w])
		p_bytes.append_array(numbers.to_byte_array())


static func _read_skeleton(p_reader: ByteReader) -> PersonSkeleton:
	var skeleton: PersonSkeleton = PersonSkeleton.new()
	for _limb: int in p_reader.read_u8():
		var outer: Vector3 = p_reader.read_vector()
		var inner: Vector3 = p_reader.read_vector()
		skeleton.add(outer, inner, p_reader.read_rotation())
		if p_reader.failed:
			return skeleton
	if not skeleton.joints_in_limb.is_empty() and not skeleton.is_sound():
		p_reader.failed = true
	return skeleton


static func _read_body(p_reader: ByteReader, p_description: WorldDescription) -> void:
	var id: int = p_reader.read_u16()
	var actor: int = p_reader.read_s32()
	var part: String = p_reader.read_text(_LONGEST_TEXT)
	var shapes: Array = []
	for _shape: int in p_reader.read_u8():
		var type: int = p_reader.read_u8()
		var size: Vector3 = p_reader.read_vector()
		shapes.append([type, size, p_reader.read_transform()])
		var smallest: float = minf(size.x, minf(size.y, size.z))
		if type >= ShapeType.size() or smallest < 0.0 or size.length() > _LARGEST:
			p_reader.failed = true
		if p_reader.failed:
			return
	if actor < FIXED or p_description.bodies.has(id):
		p_reader.failed = true
	p_description.add(id, actor, part, shapes)


static func _append(p_bytes: PackedByteArray, p_size: int, p_number: int) -> void:
	var at: int = p_bytes.size()
	p_bytes.resize(at + p_size)
	match p_size:
		1:
			p_bytes.encode_u8(at, p_number)
		2:
			p_bytes.encode_u16(at, p_number)
		4:
			p_bytes.encode_s32(at, p_number)
