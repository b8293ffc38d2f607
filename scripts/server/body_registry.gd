class_name BodyRegistry
extends RefCounted
## Numbers the server's bodies for the wire: props of the world and limbs of people.
##
## A body keeps its number while it exists; numbers of people that left are used again.

## Group of the props, [RigidBody3D] nodes below the world's scene.
const PROPS: StringName = &"props"
## Numbers that a person takes.
const PER_PERSON: int = 32
## Where the numbers of what never moves begin.
const FIRST_FIXED: int = 2048
## Where people's numbers begin.
const FIRST_PERSON: int = 4096
## People whose numbers differ by less than this have bodies of different numbers.
const MAX_PEOPLE: int = 1024

var _props: Dictionary[int, RigidBody3D] = {}
var _paths: Dictionary[int, String] = {}
var _fixed: Array[StaticBody3D] = []


## Numbers all props of a world, and what never moves in it.
func add_world(p_world: Node) -> void:
	for node: Node in p_world.get_tree().get_nodes_in_group(PROPS):
		if node is RigidBody3D and p_world.is_ancestor_of(node):
			var id: int = _props.size()
			_props[id] = node
			_paths[id] = str(p_world.get_path_to(node))
	for node: Node in p_world.find_children("*", "StaticBody3D", true, false):
		_fixed.append(node)


## The description of all bodies, with these people.
func describe(p_people: Array[ServerPeople.Person]) -> WorldDescription:
	var world: WorldDescription = WorldDescription.new()
	for id: int in _props:
		var prop: int = WorldDescription.PROP
		world.add(id, prop, _paths[id], _describe_shapes(_props[id], Transform3D.IDENTITY))
	for i: int in _fixed.size():
		var shapes: Array = _describe_shapes(_fixed[i], _fixed[i].global_transform)
		world.add(FIRST_FIXED + i, WorldDescription.FIXED, _fixed[i].name, shapes)
	for person: ServerPeople.Person in p_people:
		var joints: PersonSkeleton = person.ragdoll.get_joints()
		world.add_person(person.id, person.session, person.name, joints, person.card.index)
		var first: int = FIRST_PERSON + person.id % MAX_PEOPLE * PER_PERSON
		for slot: int in Limbs.COUNT:
			var limb: StringName = Limbs.BONES[slot]
			var bone: Node = person.ragdoll.get_simulator().get_node(NodePath(limb))
			var shapes: Array = _describe_shapes(bone, Transform3D.IDENTITY)
			world.add(first + slot, person.id, limb, shapes)
	return world


## Lets an encoder read all bodies of the world.
func watch_world(p_encoder: SnapshotEncoder) -> void:
	p_encoder.clear_bodies()
	for id: int in _props:
		p_encoder.add_body(id, _props[id].get_rid())


## Lets an encoder read a person's limbs, in the order of [constant Limbs.BONES].
static func watch_person(p_encoder: SnapshotEncoder, p_person: ServerPeople.Person) -> void:
	var bodies: Array[RID] = []
	var resets: PackedFloat32Array = []
	var joints: PersonSkeleton = p_person.ragdoll.get_joints()
	var order: PackedInt32Array = p_person.ragdoll.get_limb_order()
	for slot: int in Limbs.COUNT:
		bodies.append(p_person.ragdoll.get_bodies()[order[slot]])
		var reset: Quaternion = joints.reset_orientations[slot]
		resets.append_array([reset.x, reset.y, reset.z, reset.w])
	p_encoder.add_person(p_person.id, bodies, resets)


static func _describe_shapes(p_body: Node, p_place: Transform3D) -> Array:
	var shapes: Array = []
	for child: Node in p_body.get_children(true):
		if child is CollisionShape3D:
			var shape: CollisionShape3D = child
			var entry: Array = WorldDescription.describe_shape(
				shape.shape, p_place * shape.transform
			)
			if not entry.is_empty():
				shapes.append(entry)
	return shapes
