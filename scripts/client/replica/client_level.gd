class_name ClientLevel
extends Node3D
## The level as a client sees it, with the nodes of the entities in it.
##
## Its static bodies are in the client's physics space, for rays and queries. Whatever moves takes
## the server's transforms and is never simulated here.

## Another level is loaded; [param p_differs] if the server's is not the same.
signal changed(p_level: Level, p_differs: bool)
## The node of an entity is there; null for a plain prop. The body is null where it has none.
signal entity_added(p_row: EntityRow, p_node: Entity, p_body: PhysicsBody3D)
## The server's level is not on this machine.
signal missing(p_why: String)

## The level, or null.
var level: Level = null
## Its name.
var level_name: String = ""
## The multiplayer API of its shared nodes; null for none.
var shared: SharedApi = null
## Whether the server's level of the same name is another one.
var differs: bool = false
## Its fingerprint.
var fingerprint: PackedByteArray = PackedByteArray()
## The levels that servers have sent.
var store: ReceivedLevels = ReceivedLevels.new()

var _bodies: Dictionary[int, PhysicsBody3D] = {}
## Bodies that have not been put where the server has them.
var _unplaced: Dictionary[int, bool] = {}
var _instances: Dictionary[int, Node] = {}
## Whether the level has come by [method prepare].
var _is_prepared: bool = false


## Loads a level, always a new instance, in which everything is at its start. The entities
## of the last one must have been removed before.
func set_level(p_name: String, p_fingerprint: PackedByteArray) -> void:
	var reference: LevelReference = LevelReference.parse(p_name)
	if not _is_prepared and not _load(reference):
		return
	_is_prepared = false
	level_name = reference.name
	differs = fingerprint != p_fingerprint
	if differs:
		var text: String = "world '%s' is not the server's: what you see may be wrong; "
		Log.warning("client", text % level_name + "update this program or the server")
	ClientPhysics.note_added(level.get_static_bodies().size())
	changed.emit(level, differs)


## Lets the present level go, over the next frames.
func dismiss(p_loader: LevelLoader) -> void:
	_is_prepared = false
	if level != null:
		p_loader.dismiss(level)
	level = null


## The level that [method prepare] has taken over goes, as it is not wanted any more.
func forget() -> void:
	_is_prepared = false
	level = null


## Takes over a level that is about to enter the tree below this node; the next [method set_level]
## is about it.
func prepare(p_level: Level) -> void:
	level = p_level
	_is_prepared = true
	_freeze(level)
	if shared != null:
		shared.attach(self, level)


## Finds or makes the node of an entity.
func add_entity(p_row: EntityRow) -> void:
	var node: Node = _find_node(p_row)
	if node == null:
		return
	var entity: Entity = node as Entity
	var body: PhysicsBody3D = node as PhysicsBody3D
	if entity != null:
		body = entity.get_body() if p_row.type.body == EntityType.Body.RIGID else null
	if body != null:
		# Blocks make some of their own (a house its doors) only in the tree.
		_freeze_body(body as RigidBody3D)
		ClientPhysics.note_added(1)
		_bodies[p_row.id] = body
		_unplaced[p_row.id] = true
	entity_added.emit(p_row, entity, body)


## Takes the node of an entity away.
func remove_entity(p_row: EntityRow) -> void:
	_bodies.erase(p_row.id)
	_unplaced.erase(p_row.id)
	var instance: Node = _instances.get(p_row.id)
	if instance != null:
		instance.free()
		_instances.erase(p_row.id)


## Puts the bodies where a replica has them: those that move, as setting a transform costs more than
## all else.
func move_bodies(p_replica: WorldReplica) -> void:
	for id: int in p_replica.moved_bodies():
		if _bodies.has(id):
			_bodies[id].global_transform = p_replica.body_transform(id)
	for id: int in _unplaced.keys():
		if p_replica.has_body(id):
			_bodies[id].global_transform = p_replica.body_transform(id)
			_unplaced.erase(id)


## Numbers of the entities that have a body here.
func body_ids() -> Array[int]:
	return _bodies.keys()


## Loads a level at once, of the program or of those that servers have sent.
func _load(p_reference: LevelReference) -> bool:
	var fresh: Level = null
	if p_reference.content_hash == "":
		fresh = LevelStore.instantiate(p_reference.name)
		if fresh == null:
			missing.emit("%s: update this program" % LevelStore.describe_missing(p_reference.name))
	else:
		var folder: LevelFolder = LevelFolder.new(store.folder_of(p_reference.content_hash))
		fresh = folder.build()
		if fresh == null:
			missing.emit("world '%s' is not here: %s" % [p_reference.name, folder.error])
	if fresh == null:
		return false
	for sky: Sky in UntilDrawn.skies_of(fresh):
		UntilDrawn.keep(sky)
	if level != null:
		# At once: a server may send many levels between two frames.
		level.free()
	prepare(fresh)
	add_child(level)
	fingerprint = LevelFingerprint.of(level)
	return true


## The node of a row, or null. A path comes from the server: it must not reach nodes that the
## server may not move.
func _find_node(p_row: EntityRow) -> Node:
	var node: Node = null
	match p_row.source:
		EntityRow.Source.LEVEL:
			node = level.get_node_or_null(NodePath(p_row.path)) if level != null else null
			var is_ours: bool = node != null and level.is_ancestor_of(node)
			var is_meant: bool = (
				is_ours and (node is Entity or node.is_in_group(KitBlock.PROPS_GROUP))
			)
			if not is_meant:
				Log.limited("client", "node", "this level has no %s" % p_row.describe())
				return null
		EntityRow.Source.SCENE:
			node = _instantiate(p_row)
	return node


func _instantiate(p_row: EntityRow) -> Entity:
	var scene: PackedScene = level.find_spawnable(p_row.path) if level != null else null
	if scene == null:
		Log.limited("client", "scene", "this level spawns no %s" % p_row.describe())
		return null
	var instance: Node = scene.instantiate()
	var entity: Entity = Entity.find_in(instance)
	if entity == null:
		instance.free()
		return null
	if instance is Node3D:
		(instance as Node3D).transform = p_row.transform
	_freeze(instance)
	level.add_child(instance)
	_instances[p_row.id] = instance
	return entity


## Nothing that the server simulates moves by this machine's physics.
static func _freeze(p_branch: Node) -> void:
	for node: Node in [p_branch] + p_branch.find_children("*", "RigidBody3D", true, false):
		_freeze_body(node as RigidBody3D)


static func _freeze_body(p_body: RigidBody3D) -> void:
	if p_body != null:
		p_body.freeze_mode = RigidBody3D.FREEZE_MODE_KINEMATIC
		p_body.freeze = true
