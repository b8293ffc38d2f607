extends TestCase
## All that the level kit's dock offers can be sent: a level of it is packed and read, and is the
## same; values out of range are refused.

const LevelTemplate: GDScript = preload("res://addons/level_kit/level_template.gd")
const FOLDER: String = "user://test_kit_level"
const OUT: String = "user://test_kit_packed"


func after_each() -> void:
	for folder: String in [OUT.path_join("kitlevel"), OUT, FOLDER]:
		if not DirAccess.dir_exists_absolute(folder):
			continue
		for file: String in DirAccess.get_files_at(folder):
			DirAccess.remove_absolute(folder.path_join(file))
		DirAccess.remove_absolute(folder)


func test_a_level_of_all_that_the_dock_offers() -> void:
	equal(_save(""), OK)
	var archive: LevelArchive = LevelArchive.new()
	is_true(archive.pack("kitlevel", FOLDER, OUT))
	equal(archive.faults, PackedStringArray())
	var folder: LevelFolder = LevelFolder.new(OUT.path_join("kitlevel"))
	var read: Level = folder.build()
	equal(folder.error, "")
	var scene: PackedScene = load(FOLDER.path_join("kitlevel.tscn"))
	var saved: Level = scene.instantiate()
	add_child(saved)
	add_child(read)
	for item: RefCounted in KitCatalogue.items():
		var name: String = item.title.to_pascal_case()
		for property: StringName in item.values:
			equal(read.get_node(name).get(property), item.values[property], item.title)
	equal(read.fingerprint(), saved.fingerprint())
	read.free()
	saved.free()


func test_values_out_of_range() -> void:
	for wrong: String in [
		"size = Vector3(4, 2000, 0.3)",
		"openings = Array[Rect2]([Rect2(0, 0, 1, -2)])",
		"openings = Array[Rect2]([Rect2(0, 0, 1e8, 2)])",
		"openings = Array[Rect2]([Rect2(0, 0, 1)])",
		"openings = Array[Rect2]([Rect2(0, 0, 1, 2), 5])",
		"openings = Array[Rect2]([Rect2(0, 0, nan, 2)])",
		"openings = [Rect2(0, 0, 1, 2)%s]" % ", Rect2(0, 0, 1, 2)".repeat(200),
		'openings = "Rect2(0, 0, 1, 2)"',
		"tint = 999",
		"ruin = 2.0",
		"points = PackedVector3Array(0, 0, 0)",
	]:
		equal(_save('script = ExtResource("%s")\n' + wrong), OK)
		var archive: LevelArchive = LevelArchive.new()
		is_false(archive.pack("kitlevel", FOLDER, OUT), wrong)


## Saves a level of all items; [param p_more] goes to its wall.
func _save(p_more: String) -> Error:
	var template: RefCounted = LevelTemplate.new()
	var level: Level = template.make()
	for item: RefCounted in KitCatalogue.items():
		var node: Node3D = item.make()
		level.add_child(node)
		node.owner = level
	var scene: PackedScene = PackedScene.new()
	scene.pack(level)
	level.free()
	DirAccess.make_dir_recursive_absolute(FOLDER)
	var path: String = FOLDER.path_join("kitlevel.tscn")
	var error: Error = ResourceSaver.save(scene, path)
	if error == OK and p_more != "":
		var text: String = FileAccess.get_file_as_string(path)
		var at: int = text.find('[node name="Wall"')
		var id: String = text.substr(text.find("script = ", at)).get_slice('"', 1)
		var line: String = text.substr(text.find("script = ", at)).get_slice("\n", 0)
		text = text.substr(0, at) + text.substr(at).replace(line, p_more % id)
		var file: FileAccess = FileAccess.open(path, FileAccess.WRITE)
		file.store_string(text)
	return error
