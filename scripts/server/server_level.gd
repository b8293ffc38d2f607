class_name ServerLevel
extends Node3D
## The level that a server simulates, and the entities that are part of it.

## The level is about to go, and everything with it.
signal leaving
## Another level is loaded; its entities are in the table.
signal changed
## An entity of the level has come, with the node of its [Entity] (null for a plain prop) and its
## body (null without one).
signal entity_added(p_row: EntityRow, p_node: Entity, p_body: PhysicsBody3D)

## Type of a prop that has no [Entity] of its own.
const PROP_TYPE: StringName = &"prop"
## Type of the world's own entity where the level names none.
const WORLD_TYPE: StringName = &"world"

## The table of entities.
var table: EntityTable = EntityTable.new()
## The level, or null before one is loaded.
var level: Level = null
## Its name.
var level_name: String = ""
## The multiplayer API of its shared nodes; null for none.
var shared: SharedApi = null
## Its fingerprint.
var fingerprint: PackedByteArray = PackedByteArray()

var _prop_type: EntityType = _make_type(PROP_TYPE, EntityType.Body.RIGID)
var _world_type: EntityType = _make_type(WORLD_TYPE, EntityType.Body.NONE)


## Replaces the present level and all its entities by another. Returns an empty text, or why it
## cannot; then nothing has changed.
func load_level(p_name: String, p_tick: int = 0) -> String:
	if not LevelStore.has(p_name):
		return LevelStore.describe_missing(p_name)
	var fresh: Level = LevelStore.instantiate(p_name)
	if fresh == null:
		return "the scene of world '%s' is broken: its root must be a Level" % p_name
	leaving.emit()
	table.clear_rows()
	if level != null:
		remove_child(level)
		level.queue_free()
	level = fresh
	level_name = p_name
	if shared != null:
		shared.attach(self, level)
	add_child(level)
	fingerprint = level.fingerprint()
	_spawn_all(p_tick)
	changed.emit()
	if shared != null:
		shared.release()
	return ""


## The message that names the level.
func message() -> PackedByteArray:
	return LevelMessage.encode(level_name, fingerprint)


## Adds an instance of a scene to the running level. Its root, or a node below it, is an [Entity].
## Returns the entity, or null if that is not possible.
func add_instance(
	p_path: String, p_transform: Transform3D, p_tick: int, p_owner: int = 0
) -> Entity:
	var scene: PackedScene = level.find_spawnable(p_path)
	var node: Node = scene.instantiate() if scene != null else null
	var entity: Entity = Entity.find_in(node)
	if entity == null or entity.type == null:
		Log.warning("server", "%s is not spawnable here, or holds no Entity with a type" % p_path)
		if node != null:
			node.free()
		return null
	if node is Node3D:
		(node as Node3D).transform = p_transform
	level.add_child(node)
	var row: EntityRow = _make_row(entity.type, EntityRow.Source.SCENE, p_path, p_tick)
	row.owner = p_owner
	row.transform = p_transform
	_add(row, entity, entity.get_body())
	if not entity.is_started():
		node.queue_free()
		return null
	return entity


func _spawn_all(p_tick: int) -> void:
	_spawn_world(p_tick)
	for body: RigidBody3D in level.get_props():
		var path: String = str(level.get_path_to(body))
		_add(_make_row(_prop_type, EntityRow.Source.LEVEL, path, p_tick), null, body)
	for entity: Entity in level.get_entities():
		if entity.type == null or entity.type.body == EntityType.Body.PERSON:
			Log.warning("server", "%s: no type, or that of a person: left out" % entity.get_path())
			continue
		var path: String = str(level.get_path_to(entity))
		_add(
			_make_row(entity.type, EntityRow.Source.LEVEL, path, p_tick), entity, entity.get_body()
		)


func _spawn_world(p_tick: int) -> void:
	if level.world == null or level.world.type == null:
		table.spawn(_make_row(_world_type, EntityRow.Source.NONE, "", p_tick), true)
		return
	var path: String = str(level.get_path_to(level.world))
	var row: EntityRow = _make_row(level.world.type, EntityRow.Source.LEVEL, path, p_tick)
	if table.spawn(row, true) != null:
		entity_added.emit(row, level.world, null)


func _add(p_row: EntityRow, p_node: Entity, p_body: PhysicsBody3D) -> void:
	if table.spawn(p_row) != null:
		# A script may free it; a row without a node would be met by the next command.
		var watched: Node = p_body
		if p_node != null:
			watched = p_node
		watched.tree_exiting.connect(table.despawn.bind(p_row.id), CONNECT_ONE_SHOT)
		var has_body: bool = p_row.type.body == EntityType.Body.RIGID
		entity_added.emit(p_row, p_node, p_body if has_body else null)


static func _make_row(
	p_type: EntityType, p_source: EntityRow.Source, p_path: String, p_tick: int
) -> EntityRow:
	var row: EntityRow = EntityRow.new()
	row.type = p_type
	row.source = p_source
	row.path = p_path
	row.tick = p_tick
	return row


static func _make_type(p_name: StringName, p_body: EntityType.Body) -> EntityType:
	var type: EntityType = EntityType.new()
	type.name = p_name
	type.body = p_body
	return type
