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
const MOST_PEOPLE: int = 1024

var _props: Dictionary[int, RigidBody3D] = {}
var _paths: Dictionary[int, String] = {}
var _fixed: Array[StaticBody3D] = []
var _limbs: Dictionary[int, RID] = {}


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
func describe(p_people: Array[ServerActors.Person]) -> WorldDescription:
	var world: WorldDescription = WorldDescription.new()
	for id: int in _props:
		var prop: int = WorldDescription.PROP
		world.add(id, prop, _paths[id], _describe_shapes(_props[id], Transform3D.IDENTITY))
	for i: int in _fixed.size():
		var shapes: Array = _describe_shapes(_fixed[i], _fixed[i].global_transform)
		world.add(FIRST_FIXED + i, WorldDescription.FIXED, _fixed[i].name, shapes)
	_limbs.clear()
	for person: ServerActors.Person in p_people:
		world.names[person.id] = person.name
		var bodies: Array[RID] = person.ragdoll.get_bodies()
		var first: int = FIRST_PERSON + person.id % MOST_PEOPLE * PER_PERSON
		for i: int in bodies.size():
			var limb: RagdollLimb = person.ragdoll.profile.limbs[i]
			var bone: Node = person.ragdoll.get_simulator().get_node(NodePath(limb.bone))
			var shapes: Array = _describe_shapes(bone, Transform3D.IDENTITY)
			world.add(first + i, person.id, limb.bone, shapes)
			_limbs[first + i] = bodies[i]
	return world


## Writes where all bodies are into a snapshot.
func read(p_snapshot: Snapshot) -> void:
	for id: int in _props:
		p_snapshot.bodies[id] = _transform(_props[id].get_rid())
	for id: int in _limbs:
		p_snapshot.bodies[id] = _transform(_limbs[id])


static func _transform(p_body: RID) -> Transform3D:
	return PhysicsServer3D.body_get_state(p_body, PhysicsServer3D.BODY_STATE_TRANSFORM)


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
