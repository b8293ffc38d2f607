extends TestCase
## What received levels may be made of.


func test_every_preset_of_a_vehicle_may_be_in_a_level() -> void:
	var found: PackedStringArray = []
	for folder: String in DirAccess.get_directories_at(LevelKit.VEHICLE_FOLDER):
		var path: String = LevelKit.VEHICLE_FOLDER.path_join(folder).path_join(folder + ".tscn")
		if ResourceLoader.exists(path):
			found.append(folder)
			not_null(LevelKit.find_scene(path), path)
	found.sort()
	var listed: PackedStringArray = LevelKit.VEHICLES.duplicate()
	listed.sort()
	equal(found, listed)


func test_a_level_sets_nothing_inside_of_a_vehicle() -> void:
	for name: String in LevelKit.VEHICLES:
		var path: String = LevelKit.VEHICLE_FOLDER.path_join(name).path_join(name + ".tscn")
		equal(LevelKit.find_scene(path).rules.has("parameters"), false)
		is_false(LevelKit.allows_file("Resource", path.get_base_dir().path_join("x.tres")))
