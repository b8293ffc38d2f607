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
## Most bodies in a description.
const MOST_BODIES: int = 65536

## The bodies, by id.
var bodies: Dictionary[int, Body] = {}
## Names of the people, by actor id.
var names: Dictionary[int, String] = {}


## Adds a body and returns it.
func add(p_id: int, p_actor: int, p_part: String, p_shapes: Array) -> Body:
	var body: Body = Body.new()
	body.id = p_id
	body.actor = p_actor
	body.part = p_part
	body.shapes = p_shapes
	bodies[p_id] = body
	return body


## The packet that carries the description.
func encode() -> PackedByteArray:
	var list: Array = []
	for id: int in bodies:
		var body: Body = bodies[id]
		list.append([id, body.actor, body.part, body.shapes])
	var bytes: PackedByteArray = PackedByteArray([Protocol.Message.WORLD])
	bytes.append_array(var_to_bytes({"bodies": list, "names": Dictionary(names)}))
	return bytes


## The description in a packet, or null if it is none.
static func decode(p_bytes: PackedByteArray) -> WorldDescription:
	if p_bytes.size() < 8 or p_bytes.decode_u32(1) != TYPE_DICTIONARY:
		return null
	var data: Variant = bytes_to_var(p_bytes.slice(1))
	if data is not Dictionary or data.get("bodies") is not Array or data.get("names") is not Dictionary:
		return null
	var description: WorldDescription = WorldDescription.new()
	for entry: Variant in data["bodies"]:
		if not _is_body(entry):
			return null
		description.add(entry[0], entry[1], entry[2], entry[3])
	for actor: Variant in data["names"]:
		if actor is not int or data["names"][actor] is not String:
			return null
		description.names[actor] = data["names"][actor]
	return description


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


static func _is_body(p_entry: Variant) -> bool:
	if p_entry is not Array or p_entry.size() != 4 or p_entry[3] is not Array:
		return false
	if p_entry[0] is not int or p_entry[0] < 0 or p_entry[0] >= MOST_BODIES:
		return false
	if p_entry[1] is not int or p_entry[2] is not String:
		return false
	for shape: Variant in p_entry[3]:
		if shape is not Array or shape.size() != 3 or shape[0] is not int:
			return false
		if shape[1] is not Vector3 or shape[2] is not Transform3D:
			return false
		if not (shape[1] as Vector3).is_finite() or shape[0] < 0 or shape[0] >= ShapeType.size():
			return false
	return true
