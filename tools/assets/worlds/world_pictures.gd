extends SceneTree
## Takes the picture of each level that the start screen shows, scenes/world/NAME/NAME.jpg, by the
## level's own camera for observers. Needs a display (Xvfb will do):
##   godot --path . --resolution 800x450 -s tools/assets/worlds/world_pictures.gd [-- NAME...]

const _SIZE: Vector2i = Vector2i(480, 270)
const _QUALITY: float = 0.85
## Frames until light, sky and shadows are there.
const _FRAMES: int = 12


func _initialize() -> void:
	Quality.use(QualityTier.high(), root)
	var names: PackedStringArray = OS.get_cmdline_user_args()
	_take.call_deferred(names if not names.is_empty() else LevelStore.names())


func _take(p_names: PackedStringArray) -> void:
	for name: String in p_names:
		var level: Level = LevelStore.instantiate(name)
		root.add_child(level)
		var camera: Camera3D = Camera3D.new()
		root.add_child(camera)
		var places: Array[Node] = level.find_children("*", "ObserverCamera", true, false)
		if not places.is_empty():
			camera.global_transform = (places[0] as Node3D).global_transform
		else:
			camera.look_at_from_position(Vector3(6.0, 3.0, 9.0), Vector3(0.0, 1.0, 0.0))
		camera.make_current()
		for frame: int in _FRAMES:
			await process_frame
		await RenderingServer.frame_post_draw
		var picture: Image = root.get_texture().get_image()
		picture.resize(_SIZE.x, _SIZE.y, Image.INTERPOLATE_LANCZOS)
		picture.save_jpg("res://scenes/world/%s/%s.jpg" % [name, name], _QUALITY)
		camera.free()
		level.free()
	quit()
