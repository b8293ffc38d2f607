extends TestCase
## What received levels may be made of.


func test_every_preset_of_a_vehicle_may_be_in_a_level() -> void:
	var found: PackedStringArray = []
	for folder: String in DirAccess.get_directories_at(VehicleKit.FOLDER):
		var path: String = VehicleKit.FOLDER.path_join(folder).path_join(folder + ".tscn")
		if ResourceLoader.exists(path):
			found.append(folder)
			not_null(LevelKit.find_scene(path), path)
	found.sort()
	var listed: PackedStringArray = VehicleKit.NAMES.duplicate()
	listed.sort()
	equal(found, listed)


func test_a_level_sets_nothing_inside_of_a_vehicle() -> void:
	for name: String in VehicleKit.NAMES:
		var path: String = VehicleKit.scene_of(name)
		equal(LevelKit.find_scene(path).rules.has("parameters"), false)
		is_false(LevelKit.allows_file("Resource", path.get_base_dir().path_join("x.tres")))
