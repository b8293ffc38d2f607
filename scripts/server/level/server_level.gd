class_name ServerLevel
extends Node3D
## The level that a server simulates, and the entities that are part of it.

## The level is about to go, and everything with it.
signal leaving
## Another level is loaded; its entities are in the table.
signal changed
## The load that [method change_level] has begun is over: why it failed, or an empty text.
signal change_ended(p_fault: String)
## An entity of the level has come, with the node of its [Entity] (null for a plain prop) and its
## body (null without one).
signal entity_added(p_row: EntityRow, p_node: Entity, p_body: PhysicsBody3D)

## Type of a prop that has no [Entity] of its own.
const PROP_TYPE: StringName = &"prop"
## Type of the world's own entity where the level names none.
const WORLD_TYPE: StringName = &"bare_world"

## The table of entities.
var table: EntityTable = EntityTable.new()
## The level, or null before one is loaded.
var level: Level = null
## Its name.
var level_name: String = ""
## Its name on the wire: see [LevelReference].
var reference: String = ""
## The folder that it is from; null for one of the program's own.
var folder: LevelFolder = null
## The levels that the server offers beside the program's own.
var share: LevelShare = LevelShare.new("")
## The multiplayer API of its shared nodes; null for none.
var shared: SharedApi = null
## Its fingerprint.
var fingerprint: PackedByteArray = PackedByteArray()
## Longest part of a change of level in a tick, µs of processor time.
var longest_usec: int = 0
## Loads levels while the ticks go on.
var loader: LevelLoader = LevelLoader.new()
## Whether the last level has gone and the next one is not there as a whole.
var is_between: bool = false

# What is still to be put into the table, the first one last.
var _things: Array[Node] = []
var _prop_type: EntityType = _make_type(PROP_TYPE, EntityType.Body.RIGID)
var _world_type: EntityType = _make_type(WORLD_TYPE, EntityType.Body.NONE)


func _init() -> void:
	# Without a window a thread that reads corrupts the heap now and then, whatever the main thread
	# leaves undone meanwhile: the engine completes in its frames what the thread has begun.
	loader.has_thread = not RenderLock.is_needed()


func _exit_tree() -> void:
	loader.close()


## Replaces the present level and all its entities by another, at once. Returns an empty text, or
## why it cannot; then nothing has changed.
func load_level(p_name: String, p_tick: int = 0) -> String:
	var fault: String = find_fault(p_name)
	var fresh: Level = null
	var from: LevelFolder = null
	if fault == "" and share.has(p_name):
		from = LevelFolder.new(share.folder_of(p_name))
		fresh = from.build()
		fault = _name_fault(p_name, from.error)
	elif fault == "":
		fresh = LevelStore.instantiate(p_name)
		if fresh == null:
			fault = "the scene of world '%s' is broken: its root must be a Level" % p_name
	if fault != "":
		return fault
	_leave_level()
	if level != null:
		remove_child(level)
		level.queue_free()
	_take_over(fresh, p_name, from)
	add_child(level)
	fingerprint = LevelFingerprint.of(level)
	_spawn_world(p_tick)
	_list_things()
	_spawn_until(1 << 62, p_tick)
	_begin_level()
	return ""


## Begins to replace the present level by another, while the ticks go on: see [method advance].
## Until it is read the present one stays. Returns why it cannot, or an empty text.
func change_level(p_name: String) -> String:
	# A level that cannot be loaded is reported in the next tick.
	if is_changing():
		return "world '%s' is being loaded" % loader.name
	longest_usec = 0
	var fault: String = find_fault(p_name)
	if fault == "" and share.has(p_name):
		loader.begin_folder(p_name, share.folder_of(p_name))
	elif fault == "":
		loader.begin_own(p_name)
	return fault


## Whether a change is going on: another one can't begin.
func is_changing() -> bool:
	return loader.state != LevelLoader.State.IDLE or loader.is_leaving() or is_between


## Does a part of what [method change_level] has begun. Call it once a tick, before all else.
func advance(p_tick: int) -> void:
	if not is_changing():
		return
	var begin_usec: int = ThreadClock.get_usec()
	_go_on(p_tick)
	longest_usec = maxi(longest_usec, ThreadClock.get_usec() - begin_usec)


## Why there can be no level of a name, or an empty text.
func find_fault(p_name: String) -> String:
	if share.has(p_name) or LevelStore.has(p_name):
		return ""
	return LevelStore.describe_missing(p_name, share.names())


## The level and what is being loaded, for a report.
func report() -> Dictionary:
	return {
		"name": level_name,
		"reference": reference,
		"loading": loader.name if loader.is_busy() else "",
		"progress": loader.progress(),
		"longest_ms": longest_usec / 1000.0,
	}


## The message that names the level.
func message() -> PackedByteArray:
	return LevelMessage.encode(reference, fingerprint)


## Adds an instance of a scene to the running level. Its root, or a node below it, is an [Entity].
## Returns the entity, or null if that is not possible, as while another level is being loaded.
func add_instance(
	p_path: String, p_transform: Transform3D, p_tick: int, p_owner: int = 0
) -> Entity:
	var scene: PackedScene = level.find_spawnable(p_path)
	if not RenderLock.try_hold():
		Log.warning("server", "%s is not added: a level is being loaded" % p_path)
		return null
	var node: Node = scene.instantiate() if scene != null else null
	RenderLock.release()
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


func _go_on(p_tick: int) -> void:
	loader.advance()
	match loader.state:
		LevelLoader.State.FAILED:
			loader.state = LevelLoader.State.IDLE
			change_ended.emit(_name_fault(loader.name, loader.fault))
		LevelLoader.State.READ:
			_leave_level()
			if level != null:
				loader.dismiss(level)
			_take_over(loader.level, loader.name, loader.folder())
			loader.enter(self)
			is_between = true
		LevelLoader.State.DONE:
			fingerprint = loader.fingerprint
			loader.state = LevelLoader.State.IDLE
			_spawn_world(p_tick)
			_list_things()
		LevelLoader.State.IDLE:
			var until: int = Time.get_ticks_usec() + LevelLoader.BUDGET_USEC
			if is_between and _spawn_until(until, p_tick):
				is_between = false
				_begin_level()
				change_ended.emit("")


static func _name_fault(p_name: String, p_fault: String) -> String:
	return "world '%s' is refused: %s" % [p_name, p_fault] if p_fault != "" else ""


func _leave_level() -> void:
	leaving.emit()
	table.clear_rows()


func _take_over(p_level: Level, p_name: String, p_folder: LevelFolder) -> void:
	level = p_level
	level_name = p_name
	folder = p_folder
	var content_hash: String = p_folder.manifest.content_hash() if p_folder != null else ""
	reference = LevelReference.text_of(p_name, content_hash)
	if shared != null:
		shared.attach(self, level)


## The level is in the tree as a whole, and in the table.
func _begin_level() -> void:
	changed.emit()
	if shared != null:
		shared.release()


## Lists what the level has besides the world: its props and its entities, each with its node.
func _list_things() -> void:
	_things.append_array(level.get_props())
	_things.append_array(level.get_entities())
	_things.reverse()


## Puts the level's things into the table, until a moment of [method Time.get_ticks_usec]. Returns
## whether all are in it.
func _spawn_until(p_usec: int, p_tick: int) -> bool:
	while not _things.is_empty():
		var thing: Node = _things.pop_back()
		var path: String = str(level.get_path_to(thing))
		var entity: Entity = thing as Entity
		if entity == null:
			var row: EntityRow = _make_row(_prop_type, EntityRow.Source.LEVEL, path, p_tick)
			_add(row, null, thing as RigidBody3D)
		elif entity.type == null or entity.type.body == EntityType.Body.PERSON:
			Log.warning("server", "%s: no type, or that of a person: left out" % entity.get_path())
		else:
			var row: EntityRow = _make_row(entity.type, EntityRow.Source.LEVEL, path, p_tick)
			_add(row, entity, entity.get_body())
		if Time.get_ticks_usec() >= p_usec:
			break
	return _things.is_empty()


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
