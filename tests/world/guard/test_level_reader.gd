extends TestCase
## The reader of received levels: what it makes of sound ones, and that hostile ones do nothing.

## Mutated levels that are read here; the benchmark reads more.
const MUTATIONS: int = 3000


func before_each() -> void:
	HostileLevels.clean_up()
	HostileLevels.write_bait()


func after_each() -> void:
	HostileLevels.clean_up()


func test_the_attacks_act_where_the_engine_loads_them() -> void:
	var scene: PackedScene = ResourceLoader.load(
		"user://evil.tscn", "", ResourceLoader.CACHE_MODE_IGNORE
	)
	not_null(scene)
	is_true(HostileLevels.marks().size() > 0, "the bait is none")


func test_hostile_levels_are_refused_by_line_and_reason_and_nothing_acts() -> void:
	var kinds: Dictionary[String, Array] = HostileLevels.all()
	is_true(kinds.size() >= 40, "%d kinds" % kinds.size())
	for kind: String in kinds:
		var reader: LevelReader = LevelReader.new()
		var level: Level = reader.build(kinds[kind][0], "evil.tscn")
		is_null(level, kind)
		contains(reader.refusal, kinds[kind][1], kind)
		is_true(reader.refusal.begins_with("evil.tscn"), "%s: %s" % [kind, reader.refusal])
		is_true(reader.refusal.length() < 300, kind)
	equal(HostileLevels.marks(), PackedStringArray())


func test_the_line_of_a_fault_is_named() -> void:
	var text: String = LevelTexts.level({"ground": "process_mode = 3"})
	var line: int = text.left(text.find("process_mode")).count("\n") + 1
	var reader: LevelReader = LevelReader.new()
	is_null(reader.build(text.to_utf8_buffer(), "evil.tscn"))
	contains(reader.refusal, "evil.tscn, line %d: 'process_mode'" % line)


func test_all_faults_are_named_if_that_is_wanted() -> void:
	var parts: Dictionary[String, String] = {
		"ground": "process_mode = 3\nmetadata/evil = 1",
		"end": '\n[node name="T" type="Timer" parent="."]'
	}
	var reader: LevelReader = LevelReader.new()
	reader.most_faults = 50
	is_null(reader.build(LevelTexts.level(parts).to_utf8_buffer(), "evil.tscn"))
	equal(reader.faults.size(), 3)
	contains(reader.faults[2], "Timer")


func test_a_sound_level_is_what_the_file_says() -> void:
	var level: Level = _read(LevelTexts.level())
	equal(level._get_configuration_warnings(), PackedStringArray())
	equal(level.title, "Sound")
	equal(level.get_static_bodies().size(), 1)
	var ground: Block = level.static_root.get_node(^"Ground") as Block
	equal(ground.size, Vector3(40.0, 0.5, 40.0))
	almost_equal(ground.position, Vector3(0.0, -0.25, 0.0), 1e-6)
	equal((ground.material as StandardMaterial3D).albedo_color, Color(0.5, 0.4, 0.3))
	is_false(ground.has_meta(&"_edit_lock_"))
	equal(level.get_props().size(), 1)
	equal(level.get_spawn_points().size(), 1)
	equal(level.spawnable.size(), 0)
	level.free()


func test_it_reads_what_the_engine_reads() -> void:
	var ours: Level = _read(FileAccess.get_file_as_string("res://scenes/world/hall/hall.tscn"))
	var theirs: Level = LevelStore.instantiate("hall")
	add_child(theirs)
	equal(LevelFingerprint.of(ours), LevelFingerprint.of(theirs))
	equal(
		ours.find_children("*", "", true, false).size(),
		theirs.find_children("*", "", true, false).size()
	)
	ours.free()
	theirs.free()


func test_it_reads_what_the_editor_saves() -> void:
	var level: Level = _read(LevelTexts.level())
	var lamp: OmniLight3D = OmniLight3D.new()
	lamp.name = "Lämpchen"
	lamp.light_energy = 3.5
	level.add_child(lamp)
	level.get_node(^"Props/Crate").free()
	var scene: PackedScene = load("res://scenes/world/props/crate.tscn")
	# As the editor makes instances: what is as in their scene is not saved again.
	var crate: RigidBody3D = scene.instantiate(PackedScene.GEN_EDIT_STATE_INSTANCE)
	crate.mass = 20.0
	level.props_root.add_child(crate)
	for node: Node in level.find_children("*", "", true, false):
		var is_inner: bool = node.get_parent().scene_file_path != ""
		# What a block makes of itself is not saved.
		if not node.name.begins_with("@") and not is_inner:
			node.owner = level
	var packed: PackedScene = PackedScene.new()
	equal(packed.pack(level), OK)
	equal(ResourceSaver.save(packed, "user://saved_level.tscn"), OK)
	var wanted: PackedByteArray = LevelFingerprint.of(level)
	level.free()
	var again: Level = _read(FileAccess.get_file_as_string("user://saved_level.tscn"))
	DirAccess.remove_absolute("user://saved_level.tscn")
	equal(LevelFingerprint.of(again), wanted)
	equal((again.get_node(^"Lämpchen") as OmniLight3D).light_energy, 3.5)
	equal((again.get_node(^"Props/Crate") as RigidBody3D).mass, 20.0)
	again.free()


func test_files_are_those_of_the_folder() -> void:
	var folder: Dictionary[String, String] = {"a.height": "user://levels/x/a.height"}
	for file: String in ["../a.height", "b.height", "a.tscn", "/etc/passwd", "res://b.height"]:
		var reader: LevelReader = LevelReader.new()
		is_null(reader.build(_terrain(file), "x.tscn", folder), file)
		contains(reader.refusal, "no *.height of the level's folder")
	for file: String in ["a.height", "res://scenes/world/x/a.height"]:
		var reader: LevelReader = LevelReader.new()
		var level: Level = reader.build(_terrain(file), "x.tscn", folder)
		equal(reader.refusal, "")
		equal((level.get_node(^"Static/M") as Terrain).height_file, folder["a.height"])
		level.free()


func test_a_path_leads_into_an_instance_where_its_row_allows_it() -> void:
	var path: String = "res://scenes/world/sky/world_sky.tscn"
	var parts: Dictionary[String, String] = {
		"files": '\n[ext_resource type="PackedScene" path="%s" id="sky"]\n' % path,
		"root": 'world = NodePath("Sky/World")\n',
		"end": '\n[node name="Sky" parent="." instance=ExtResource("sky")]\ntime_of_day = 18.5\n',
	}
	var level: Level = _read(LevelTexts.level(parts))
	equal(level.world, level.get_node(^"Sky/World"))
	equal(level.get_node(^"Sky").get(&"time_of_day"), 18.5)
	level.free()


func test_mutated_levels_are_refused_or_harmless() -> void:
	var mutations: LevelMutations = LevelMutations.new(5)
	var refused: int = 0
	for _count: int in MUTATIONS:
		var reader: LevelReader = LevelReader.new()
		var level: Level = reader.build(mutations.next(), "m.tscn")
		if level == null:
			refused += 1
			if not reader.refusal.begins_with("m.tscn"):
				fail("no reason: %s" % reader.refusal)
		else:
			var fault: String = LevelMutations.find_stranger(level)
			if fault != "":
				fail(fault)
			level.free()
	is_true(refused > MUTATIONS / 2, "%d refused" % refused)
	is_true(refused < MUTATIONS, "all refused")
	equal(HostileLevels.marks(), PackedStringArray())


func _terrain(p_file: String) -> PackedByteArray:
	var script: String = (Terrain as GDScript).resource_path
	var node: String = '\n[node name="M" type="StaticBody3D" parent="Static"]\n'
	var parts: Dictionary[String, String] = {
		"files": '\n[ext_resource type="Script" path="%s" id="t"]\n' % script,
		"end": node + 'script = ExtResource("t")\nheight_file = "%s"\n' % p_file,
	}
	return LevelTexts.level(parts).to_utf8_buffer()


func _read(p_text: String) -> Level:
	var reader: LevelReader = LevelReader.new()
	var level: Level = reader.build(p_text.to_utf8_buffer(), "level.tscn")
	equal(reader.refusal, "")
	add_child(level)
	return level
