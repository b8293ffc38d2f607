@tool
@icon("res://scenes/world/icons/level.svg")
class_name Level
extends Node3D
## Root of a level: what never moves, props, where people start, triggers and cameras.
##
## A level is a scene [code]scenes/world/NAME/NAME.tscn[/code] whose root has this script. The
## server and all clients load the same one; [method fingerprint] shows whether they have.

## Group of the props, [RigidBody3D] nodes: each is an entity of its own.
const PROPS: StringName = &"props"
## Bytes of a fingerprint.
const FINGERPRINT_SIZE: int = 8
## Steps of lengths and of rotations in a fingerprint, per m and per 1.
const _STEPS: float = 10000.0

## What people call it.
@export var title: String = ""
## Holds what never moves: [StaticBody3D] nodes such as [Block], at any depth.
@export var static_root: Node3D:
	set(p_value):
		static_root = p_value
		update_configuration_warnings()
## Holds props and everything else that moves.
@export var props_root: Node3D:
	set(p_value):
		props_root = p_value
		update_configuration_warnings()
## Scenes that may be added while a session runs: a server can have clients make instances of these
## and of no others.
@export var spawnable: Array[PackedScene] = []
## The entity of the world itself, which has number 0: its fields are the variables of the level and
## of a scenario. May be empty.
@export var world: Entity:
	set(p_value):
		world = p_value
		update_configuration_warnings()


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if static_root == null:
		warnings.append("Choose the node that holds what never moves for 'Static Root'.")
	elif get_static_bodies().is_empty():
		warnings.append(
			"Nothing solid is below 'Static Root': people fall. Add a Block as a floor."
		)
	if props_root == null:
		warnings.append("Choose the node that holds what moves for 'Props Root'; it may be empty.")
	if get_spawn_points().is_empty():
		warnings.append("There is no SpawnPoint: people start at the origin. Add one or more.")
	for body: RigidBody3D in get_props():
		if not body.transform.basis.get_scale().is_equal_approx(Vector3.ONE):
			warnings.append("%s is scaled, bodies cannot be: scale its shape and mesh." % body.name)
	if world != null and world.type != null and world.type.body != EntityType.Body.NONE:
		warnings.append("The type of 'World' has a body: choose one with fields only.")
	return warnings


## What never moves, in the order of the tree.
func get_static_bodies() -> Array[StaticBody3D]:
	var found: Array[StaticBody3D] = []
	if static_root != null:
		for node: Node in static_root.find_children("*", "StaticBody3D", true, false):
			if node is not AnimatableBody3D:
				found.append(node)
	return found


## Props without an [Entity] of their own, in the order of the tree.
func get_props() -> Array[RigidBody3D]:
	var covered: Dictionary[Node, bool] = {}
	for entity: Entity in get_entities():
		covered[entity.get_body()] = true
	var found: Array[RigidBody3D] = []
	for node: Node in find_children("*", "RigidBody3D", true, false):
		if node.is_in_group(PROPS) and not covered.has(node):
			found.append(node)
	return found


## The scene of a path if it may be added while a session runs, or null.
func find_spawnable(p_path: String) -> PackedScene:
	for scene: PackedScene in spawnable:
		if scene != null and scene.resource_path == p_path:
			return scene
	return null


## The [Entity] nodes but for that of the world itself, in the order of the tree.
func get_entities() -> Array[Entity]:
	var found: Array[Entity] = []
	for node: Node in find_children("*", "Node", true, false):
		if node is Entity and node != world:
			found.append(node)
	return found


## Where people start, in the level's frame, in the order of the tree.
func get_spawn_points() -> Array[SpawnPoint]:
	var found: Array[SpawnPoint] = []
	for node: Node in find_children("*", "Marker3D", true, false):
		if node is SpawnPoint:
			found.append(node)
	return found


## A hash of the level that is the same on all machines: of shapes and positions of static bodies,
## of props and of entities. Visual nodes do not count, as a dedicated server has none. The level
## must be in the tree and nothing may have moved yet.
func fingerprint() -> PackedByteArray:
	var context: HashingContext = HashingContext.new()
	context.start(HashingContext.HASH_SHA256)
	for body: StaticBody3D in get_static_bodies():
		_hash_body(context, body)
	for body: RigidBody3D in get_props():
		context.update(str(get_path_to(body)).to_utf8_buffer())
		_hash_body(context, body)
	for entity: Entity in get_entities():
		context.update(str(get_path_to(entity)).to_utf8_buffer())
		if entity.type != null:
			context.update(entity.type.encode())
		if entity.get_body() != null:
			_hash_body(context, entity.get_body())
	var has_world: bool = world != null and world.type != null
	context.update(world.type.encode() if has_world else PackedByteArray([0]))
	return context.finish().slice(0, FINGERPRINT_SIZE)


func _hash_body(p_context: HashingContext, p_body: PhysicsBody3D) -> void:
	var to_level: Transform3D = global_transform.affine_inverse()
	for child: Node in p_body.get_children(true):
		var shape: CollisionShape3D = child as CollisionShape3D
		if shape == null or shape.shape == null or shape.disabled:
			continue
		p_context.update(shape.shape.get_class().to_ascii_buffer())
		p_context.update(_numbers_of(to_level * shape.global_transform, shape.shape))


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
	elif p_shape is ConcavePolygonShape3D:
		points.append_array((p_shape as ConcavePolygonShape3D).get_faces())
	elif p_shape is HeightMapShape3D:
		for height: float in (p_shape as HeightMapShape3D).map_data:
			points.append(Vector3(height, 0.0, 0.0))
	var numbers: PackedInt32Array = []
	for point: Vector3 in points:
		for axis: int in 3:
			numbers.append(roundi(clampf(point[axis], -1e5, 1e5) * _STEPS))
	return numbers.to_byte_array()
