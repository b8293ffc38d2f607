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

var _buffer: SnapshotBuffer = SnapshotBuffer.new()
var _world: WorldDescription = null
var _actors: Dictionary[int, ActorView] = {}
var _props: Dictionary[int, Node3D] = {}
var _shown_tick: float = -1.0
var _aimed: bool = false


## Sets which worlds are shown and where the camera is; returns what is wrong, or an empty text.
func apply(p_views: String, p_camera: String) -> String:
	var fault: String = _views.show_only(p_views)
	if fault == "" and p_camera != "":
		fault = _camera.set_from_text(p_camera)
	return fault


## Whether a server has told which bodies there are.
func has_world() -> bool:
	return _world != null


## Takes over a new description of the world.
func describe(p_world: WorldDescription) -> void:
	_world = p_world
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
		if not p_world.names.has(actor):
			_actors[actor].node.queue_free()
			_actors.erase(actor)
	for actor: int in p_world.names:
		if not _actors.has(actor):
			var node: Ragdoll = person_scene.instantiate()
			node.visible = false
			_people.add_child(node)
			_actors[actor] = ActorView.new(node)


## Takes a snapshot that arrived at a local time, s.
func push(p_snapshot: Snapshot, p_now_s: float) -> void:
	_buffer.push(p_snapshot, p_now_s)


## Forgets a world whose server is gone; what is on the screen stays as it is.
func clear() -> void:
	_buffer.clear()
	_shown_tick = -1.0


## Puts everything where it is at a local time, s.
func update(p_now_s: float) -> void:
	if _world == null or _buffer.newest_tick < 0:
		return
	_shown_tick = _buffer.shown_tick(p_now_s)
	var limbs: Dictionary[int, Dictionary] = {}
	for id: int in _world.bodies:
		if not _buffer.has_body(id):
			continue
		var body: WorldDescription.Body = _world.bodies[id]
		var place: Transform3D = _buffer.transform_at(id, _shown_tick)
		if body.actor >= 0:
			var parts: Dictionary[StringName, Transform3D] = {}
			limbs.get_or_add(body.actor, parts)[StringName(body.part)] = place
		elif _props.has(id):
			_props[id].global_transform = place
		if _physics.visible:
			_physics.place(id, _buffer.newest_transform(id))
	for actor: int in limbs:
		if _actors.has(actor):
			_actors[actor].show(limbs[actor])
			_actors[actor].node.visible = true
	_aim()


## The server's tick that is shown, with its fraction, or -1.
func shown_tick() -> float:
	return _shown_tick


## When the sample was taken that the first person shows now, Unix time in µs, or -1.
func shown_sample_usec() -> int:
	if _actors.is_empty() or _shown_tick < 0.0:
		return -1
	return _buffer.sample_time_at(_actors.keys()[0], _shown_tick)


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
