class_name ClientScene
extends Node3D
## What a client shows: the world, its people and props where the snapshots have them, and a camera.

## The scene of a person.
@export var person_scene: PackedScene
@export var _hall: Node3D
@export var _people: Node3D
@export var _physics: PhysicsWorld
@export var _views: WorldViews
@export var _camera: OrbitCamera

## Where everything is.
var replica: WorldReplica = WorldReplica.new()

var _actors: Dictionary[int, ActorView] = {}
var _sizes: Dictionary[int, PersonSkeleton] = {}
var _props: Dictionary[int, Node3D] = {}
var _aimed: bool = false


## Sets which worlds are shown and where the camera is; returns what is wrong, or an empty text.
func apply(p_views: String, p_camera: String) -> String:
	var fault: String = _views.show_only(p_views)
	if fault == "" and p_camera != "":
		fault = _camera.set_from_text(p_camera)
	return fault


## Whether a server has told which bodies there are.
func has_world() -> bool:
	return replica.world != null


## Takes over a new description of the world.
func describe(p_world: WorldDescription) -> void:
	replica.describe(p_world)
	_physics.describe(p_world)
	_props.clear()
	for id: int in p_world.bodies:
		var body: WorldDescription.Body = p_world.bodies[id]
		if body.actor == WorldDescription.PROP:
			var prop: Node3D = _hall.get_node_or_null(NodePath(body.part)) as Node3D
			# The path is the server's word: it must not reach what is not its to move.
			if prop != null and prop.is_in_group(BodyRegistry.PROPS) and _hall.is_ancestor_of(prop):
				_props[id] = prop
	for actor: int in _actors.keys():
		if not p_world.names.has(actor) or not _is_as_big(actor, p_world.skeletons.get(actor)):
			_actors[actor].node.queue_free()
			_actors.erase(actor)
	for actor: int in p_world.names:
		if not _actors.has(actor):
			var node: Ragdoll = person_scene.instantiate()
			node.visible = false
			_sizes[actor] = p_world.skeletons.get(actor)
			if _sizes[actor] != null and _sizes[actor].is_sound():
				node.fit_to(_sizes[actor])
			_people.add_child(node)
			_actors[actor] = ActorView.new(node)


## Forgets a world whose server is gone; what is on the screen stays as it is.
func clear() -> void:
	replica.clear()


## Puts everything where it is at a local time, s. The bodies of the client's own people are where
## these floats have them, by person: see [method WorldReplica.person_floats].
func update(p_now_s: float, p_own: Dictionary[int, PackedFloat32Array] = {}) -> void:
	if replica.world == null or replica.newest_tick < 0:
		return
	replica.show(p_now_s)
	for actor: int in _actors:
		if replica.has_person(actor):
			var own: PackedFloat32Array = p_own.get(actor, PackedFloat32Array())
			_show_person(actor, own if not own.is_empty() else replica.person_floats(actor))
	for id: int in _props:
		if replica.has_body(id):
			_props[id].global_transform = replica.body_transform(id)
	if _physics.visible:
		_place_wires()
	_aim()


## One of the people of a session, or -1.
func person_of(p_session: int, p_place: int = 0) -> int:
	var world: WorldDescription = replica.world
	if world != null:
		for actor: int in world.owners:
			if world.owners[actor] == p_session and world.places[actor] == p_place:
				return actor
	return -1


## From where the client looks, m.
func viewpoint() -> Vector3:
	return _camera.global_position


## Height of the hips of a person's body when standing, m.
func hips_of(p_actor: int) -> float:
	return _actors[p_actor].node.get_hip_height() if _actors.has(p_actor) else 0.0


## Whether a person still has the size that is shown.
func _is_as_big(p_actor: int, p_joints: PersonSkeleton) -> bool:
	var shown: PersonSkeleton = _sizes.get(p_actor)
	if shown == null or p_joints == null:
		return shown == p_joints
	return (
		shown.joints_in_limb == p_joints.joints_in_limb
		and shown.joints_in_parent == p_joints.joints_in_parent
	)


func _show_person(p_actor: int, p_floats: PackedFloat32Array) -> void:
	var limbs: Array[Transform3D] = replica.limbs_of(p_actor, p_floats)
	if limbs.is_empty():
		return
	var parts: Dictionary[StringName, Transform3D] = {}
	for limb: int in Limbs.COUNT:
		parts[Limbs.BONES[limb]] = limbs[limb]
	_actors[p_actor].show(parts)
	_actors[p_actor].node.visible = true


func _place_wires() -> void:
	for id: int in _props:
		if replica.has_body(id):
			_physics.place(id, replica.body_transform(id, true))
	for actor: int in _actors:
		if not replica.has_person(actor):
			continue
		var limbs: Array[Transform3D] = replica.limbs_of(actor, replica.person_floats(actor, true))
		for body: WorldDescription.Body in replica.world.bodies_of(actor):
			var limb: int = Limbs.find(StringName(body.part))
			if limb >= 0 and limb < limbs.size():
				_physics.place(body.id, limbs[limb])


## The worlds and their keys, for the screen.
func describe_views() -> String:
	var words: PackedStringArray = []
	for i: int in WorldViews.NAMES.size():
		var world: StringName = WorldViews.NAMES[i]
		words.append("%d %s %s" % [i + 1, world, "on" if _views.is_shown(world) else "off"])
	return "   ".join(words)


func _aim() -> void:
	for actor: int in _actors:
		if _actors[actor].node.visible:
			_camera.target = _actors[actor].hips()
			if not _aimed:
				_camera.snap()
				_aimed = true
			return
