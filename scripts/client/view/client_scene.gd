class_name ClientScene
extends Node3D
## What a client shows: the level, its people and everything else where the snapshots have them, and
## a camera.

## What the user should know of the level; empty: nothing.
signal level_noted(p_text: String)
## A notice about what has happened, which screens show for a while.
signal notified(p_text: String)
## The server's level is not on this machine.
signal level_missing(p_why: String)

## The scene of a person; its root is a [Ragdoll].
@export var person_scene: PackedScene
@export var _level: ClientLevel
@export var _people: Node3D
@export var _physics: PhysicsWorld
@export var _views: WorldViews
@export var _camera: OrbitCamera
@export var _names: NameTags

## Where everything is.
var replica: WorldReplica = WorldReplica.new()
## Fields, commands and events of what is there.
var entities: ClientEntities = ClientEntities.new(replica)
## How the window looks at it.
var view: SceneView = null
## Avatars on their way.
var avatars: AvatarArrival = AvatarArrival.new()

var _actors: Dictionary[int, ActorView] = {}
## The views of other viewports.
var _others: Array[SceneView] = []
var _has_warmed_up: bool = false


func _ready() -> void:
	view = SceneView.new(_camera, _actors)
	view.hides_head = true
	replica.level_named.connect(_level.set_level)
	replica.table.spawned.connect(_on_spawned)
	replica.table.despawned.connect(_on_despawned)
	_level.changed.connect(_on_level_changed)
	_level.entity_added.connect(_on_entity_added)
	_level.missing.connect(level_missing.emit)


func _exit_tree() -> void:
	avatars.finish()


## Asks the server to switch the torch of the own person, if there is one.
func switch_torch() -> void:
	if _actors.has(view.own()):
		var torch: Torch = _actors[view.own()].node.get_node_or_null(^"Torch") as Torch
		if torch != null:
			torch.ask()


## Goes to the next of the level's own views, and after the last one back to the followed person.
func next_camera() -> void:
	var level: Level = _level.level
	var views: Array[ObserverCamera] = [] if level == null else level.get_cameras()
	notified.emit(view.look_through_next(views))


## Sets the visible worlds and the camera; returns what is wrong, or an empty text.
func apply(p_views: String, p_camera: String) -> String:
	_views.show_only(p_views)
	return _camera.set_from_text(p_camera) if p_camera != "" else ""


## Fades the physics world at a time, s after the start.
func fade_physics(p_fade: PhysicsFade, p_time_s: float) -> void:
	if not p_fade.is_due(p_time_s):
		return
	var opacity: float = p_fade.opacity_at(p_time_s)
	var is_over: bool = opacity == 0.0 and _views.is_shown(&"physics")
	if _views.is_shown(&"physics") != (opacity > 0.0):
		_views.set_shown(&"physics", opacity > 0.0)
	_physics.opacity = 1.0 if is_over else opacity
	if is_over:
		p_fade.end()


## Adds another look at the world, in a viewport of its own, which shows the same world: its
## [member Viewport.world_3d] is set. It follows people as the window's camera does, until
## [method remove_view].
func add_view(p_viewport: Viewport) -> SceneView:
	var camera_here: OrbitCamera = OrbitCamera.new()
	camera_here.obstacles = _camera.obstacles
	camera_here.fov = _camera.fov
	camera_here.takes_keys = false
	# What it sees is not hidden as the window does not see it.
	camera_here.add_to_group(KitBlock.EYES_GROUP)
	p_viewport.world_3d = get_world_3d()
	p_viewport.add_child(camera_here)
	camera_here.make_current()
	var other: SceneView = SceneView.new(camera_here, _actors)
	_others.append(other)
	return other


## Takes back what [method add_view] has added.
func remove_view(p_view: SceneView) -> void:
	_others.erase(p_view)
	p_view.camera.queue_free()


## Forgets a world whose server is gone: people and things leave, the level stays.
func clear() -> void:
	replica.clear()
	entities.restart()


## Applies the state at a time of the stream, s. The bodies of the client's own people are taken
## from these floats, by person: see [method WorldReplica.person_floats].
## A valid [param p_agreement] says which tick of the server is shown instead of the one that fits
## the time: [code]func(tick: float) -> float[/code].
func update(
	p_now_s: float,
	p_own: Dictionary[int, PackedFloat32Array] = {},
	p_agreement: Callable = Callable()
) -> void:
	for row: EntityRow in avatars.take_ready():
		_add_person(row)
	if not replica.is_ready() or replica.newest_tick < 0:
		return
	replica.evaluate(p_now_s)
	if p_agreement.is_valid() and replica.shown_tick() >= 0.0:
		replica.smoother.show_tick(p_agreement.call(replica.shown_tick()), p_now_s)
	_level.move_bodies(replica)
	for actor: int in _actors:
		if replica.has_person(actor):
			var own: PackedFloat32Array = p_own.get(actor, PackedFloat32Array())
			_pose_person(_actors[actor], actor, own)
	entities.advance()
	if _physics.visible:
		_move_wires()
	_names.choose(_camera.global_position, view.aim())
	for other: SceneView in _others:
		other.aim()


## The people who are displayed, by their numbers.
func people() -> Dictionary[int, ActorView]:
	return _actors


## The level and what moves in it.
func get_level() -> ClientLevel:
	return _level


## How far a person's body is from its motion, for the screen; empty if it is where that is.
func describe_tether(p_actor: int) -> String:
	if not _actors.has(p_actor):
		return ""
	var type: EntityType = replica.table.find(p_actor).type
	var fields: PackedInt32Array = [
		type.find_field(EntityType.TETHER_X), type.find_field(EntityType.TETHER_Z)
	]
	if fields.has(-1):
		return ""
	var tether: Vector2 = Vector2(
		replica.field(p_actor, fields[0]), replica.field(p_actor, fields[1])
	)
	return TetherNote.describe(tether, _actors[p_actor].heading())


## The worlds and their keys, for the screen.
func describe_views() -> String:
	var words: PackedStringArray = []
	for i: int in WorldViews.NAMES.size():
		var world: StringName = WorldViews.NAMES[i]
		words.append("%d %s %s" % [i + 1, world, "on" if _views.is_shown(world) else "off"])
	return "   ".join(words)


func _on_level_changed(p_level: Level, p_differs: bool) -> void:
	_views.props = p_level.props_root
	_views.static_world = p_level.static_root
	_views.refresh()
	for each: SceneView in [view] + _others:
		each.look_through(null)
	if not _has_warmed_up:
		_has_warmed_up = true
		_level.add_child(EffectWarmUp.new())
	_physics.set_level(p_level, p_differs)
	var text: String = "This machine's world '%s' is not the server's."
	level_noted.emit(text % _level.level_name if p_differs else "")


func _on_spawned(p_row: EntityRow) -> void:
	if not p_row.is_person():
		_level.add_entity(p_row)
	elif not avatars.holds_up(p_row):
		_add_person(p_row)


func _on_despawned(p_row: EntityRow) -> void:
	_physics.remove(p_row.id)
	avatars.forget(p_row.id)
	if _actors.has(p_row.id):
		# At once: a server may send many tables between two frames.
		for each: SceneView in [view] + _others:
			each.forget(p_row.id)
		_actors[p_row.id].node.free()
		_actors.erase(p_row.id)
		_names.remove(p_row.id)
	_level.remove_entity(p_row)


func _on_entity_added(p_row: EntityRow, p_node: Entity, p_body: PhysicsBody3D) -> void:
	if p_body != null:
		_physics.add_body(p_row.id, p_body)
	if p_node != null:
		entities.bind(p_row, p_node)
		var zone: TriggerZone = p_node.get_parent() as TriggerZone
		if zone != null and not zone.notified.is_connected(notified.emit):
			zone.notified.connect(notified.emit)


func _add_person(p_row: EntityRow) -> void:
	var node: Ragdoll = AvatarStore.scene_of(p_row.path, person_scene).instantiate()
	node.visible = false
	if p_row.skeleton.is_sound():
		node.fit_to(p_row.skeleton)
	_people.add_child(node)
	ClientPhysics.note_added(Limbs.COUNT)
	_actors[p_row.id] = ActorView.new(node, p_row.skeleton)
	_names.add(p_row.id, p_row.person_name)
	_physics.add_person(p_row.id, node.get_limb_nodes())
	var entity: Entity = Entity.find_in(node)
	if entity != null:
		entities.bind(p_row, entity)


func _pose_person(p_view: ActorView, p_actor: int, p_own: PackedFloat32Array) -> void:
	if replica.pose(p_view, p_actor) if p_own.is_empty() else p_view.pose_floats(p_own):
		p_view.node.visible = true
		if _names.wants(p_actor):
			_names.put(p_actor, p_view.head_joint())


func _move_wires() -> void:
	for id: int in _level.body_ids():
		if replica.has_body(id):
			_physics.set_transforms(id, [replica.body_transform(id, true)])
	for actor: int in _actors:
		if replica.has_person(actor):
			var floats: PackedFloat32Array = replica.person_floats(actor, true)
			_physics.set_transforms(actor, replica.limbs_of(actor, floats))
