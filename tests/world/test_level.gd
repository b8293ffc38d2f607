extends TestCase
## Levels: what is in them, what their fingerprint tells, and which there are.


func test_every_level_can_be_used() -> void:
	for known: String in ["hall", "yard"]:
		is_true(LevelStore.names().has(known), known)
	for name: String in LevelStore.names():
		var level: Level = LevelStore.instantiate(name)
		add_child(level)
		equal(level._get_configuration_warnings(), PackedStringArray(), name)
		is_true(level.get_static_bodies().size() >= 5)
		is_true(level.get_spawn_points().size() >= 1)
		is_true(level.get_props().size() >= 1)
		for entity: Entity in level.get_entities():
			equal(entity._get_configuration_warnings(), PackedStringArray(), str(entity.get_path()))
		level.free()


func test_a_fingerprint_is_the_same_again_and_another_for_other_shapes() -> void:
	var prints: Dictionary[PackedByteArray, bool] = {}
	for _time: int in 2:
		prints[_fingerprint(func(_level: Level) -> void: pass)] = true
	equal(prints.size(), 1)
	var changes: Array[Callable] = [
		func(level: Level) -> void: level.get_static_bodies()[0].position.x += 0.01,
		func(level: Level) -> void: (level.get_static_bodies()[1] as Block).size.y += 0.01,
		func(level: Level) -> void: level.get_props()[0].position.y += 0.01,
		func(level: Level) -> void: level.get_entities()[0].type = EntityType.person(),
		func(level: Level) -> void: level.get_static_bodies()[2].free(),
	]
	for change: Callable in changes:
		prints[_fingerprint(change)] = true
	equal(prints.size(), 1 + changes.size())


func test_the_order_of_shapes_does_not_count() -> void:
	var plain: PackedByteArray = _fingerprint(func(_level: Level) -> void: pass)
	var other: Callable = func(level: Level) -> void:
		for body: PhysicsBody3D in level.get_static_bodies():
			for shape: Node in body.find_children("*", "CollisionShape3D", false, false):
				body.move_child(shape, 0)
	equal(_fingerprint(other), plain)


func test_what_is_only_seen_does_not_count() -> void:
	var plain: PackedByteArray = _fingerprint(func(_level: Level) -> void: pass)
	var dark: Callable = func(level: Level) -> void: level.get_node(^"Sun").free()
	equal(_fingerprint(dark), plain)


func test_names_lead_nowhere_else() -> void:
	for name: String in [
		"", "..", "../hall", "Hall", "hall/hall", "hall.tscn", "a b", "x".repeat(99)
	]:
		is_false(LevelStore.has(name), name)
		is_null(LevelStore.instantiate(name))
	contains(
		LevelStore.describe_missing("atlantis"),
		"no world 'atlantis' here: " + ", ".join(LevelStore.names())
	)


func test_warnings_say_how_to_mend_a_level() -> void:
	var level: Level = Level.new()
	var text: String = " ".join(level._get_configuration_warnings())
	for word: String in ["Static Root", "Props Root", "SpawnPoint"]:
		contains(text, word)
	level.free()


func _fingerprint(p_change: Callable) -> PackedByteArray:
	var level: Level = LevelStore.instantiate("yard")
	add_child(level)
	p_change.call(level)
	var found: PackedByteArray = LevelFingerprint.of(level)
	level.free()
	return found
