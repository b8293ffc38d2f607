extends TestCase
## New levels from the template: they can be saved, loaded, played in, and have no fault.

const LevelTemplate: GDScript = preload("res://addons/level_kit/level_template.gd")
const PATH: String = "user://test_level_template.tscn"


func after_each() -> void:
	if FileAccess.file_exists(PATH):
		DirAccess.remove_absolute(PATH)


func test_names() -> void:
	equal(LevelTemplate.find_fault("my_range"), "")
	contains(LevelTemplate.find_fault("My range"), "lower-case letters")
	contains(LevelTemplate.find_fault(""), "lower-case letters")
	contains(LevelTemplate.find_fault("town"), "There is a level 'town'")


func test_what_is_saved_is_a_level_without_a_fault() -> void:
	var template: RefCounted = LevelTemplate.new()
	template.title = "Shooting range"
	template.spawn_points = 6
	template.time_of_day = 18.0
	equal(template.save(PATH), OK)
	var scene: PackedScene = ResourceLoader.load(PATH, "", ResourceLoader.CACHE_MODE_IGNORE)
	var level: Level = scene.instantiate()
	add_child(level)
	await physics_frames(2)
	equal([level.name, level.title], [&"ShootingRange", "Shooting range"])
	equal(level._get_configuration_warnings(), PackedStringArray())
	equal(level.get_spawn_points().size(), 6)
	not_null(level.world)
	var check: LevelCheck = LevelCheck.new(level)
	check.run()
	equal(check.count_faults(), 0)
	level.free()
