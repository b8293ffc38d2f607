extends SceneTree
## Takes pictures of a world from places, at times of day and in weathers, to look at:
##
## godot --path . -s tools/assets/worlds/look.gd -- --world=desert --out=DIR
##     [--eyes="-60,3,40>20,1,-30;..."] [--times=7,12] [--weathers=clear,rain] [--draws]
##
## An eye is a place and what it looks at; a height is above the ground of the place.

const SIZE_WAIT: int = 4


func _initialize() -> void:
	_take.call_deferred()


func _take() -> void:
	var world: String = _option("world", "desert")
	var folder: String = _option("out", "user://look")
	DirAccess.make_dir_recursive_absolute(folder)
	var began: int = Time.get_ticks_msec()
	var level: Node = (
		(load("res://scenes/world/%s/%s.tscn" % [world, world]) as PackedScene).instantiate()
	)
	root.add_child(level)
	await process_frame
	print("loaded and on screen after %d ms" % (Time.get_ticks_msec() - began))
	var camera: Camera3D = Camera3D.new()
	camera.fov = 60.0
	camera.far = 2500.0
	root.add_child(camera)
	camera.make_current()
	await physics_frame
	await physics_frame
	var sky: WorldSky = level.find_children("*", "WorldSky", true, false)[0]
	var eyes: PackedStringArray = _option("eyes", "0,2,0>10,1,0").split(";", false)
	for hours: String in _option("times", "10").split(",", false):
		for weather: String in _option("weathers", "clear").split(",", false):
			var values: Dictionary = WorldConditions.parse("weather", weather.replace("=", " "))
			sky.show_conditions(
				WorldConditions.parse_time(hours),
				int(values[WorldConditions.WEATHER]) as WorldConditions.Weather,
				values[WorldConditions.STRENGTH]
			)
			for number: int in eyes.size():
				_place(camera, eyes[number])
				for _frame: int in 30 if weather.begins_with("rain") else SIZE_WAIT:
					await RenderingServer.frame_post_draw
				var name: String = (
					"%s_%s_%s_%d.png" % [world, hours.replace(":", ""), weather, number]
				)
				root.get_texture().get_image().save_png(folder.path_join(name))
				print("%s: %d draws, %d primitives" % [name, _count(2), _count(1)])
	quit()


func _count(p_what: int) -> int:
	var kinds: Array[int] = [
		RenderingServer.RENDERING_INFO_TOTAL_OBJECTS_IN_FRAME,
		RenderingServer.RENDERING_INFO_TOTAL_PRIMITIVES_IN_FRAME,
		RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME,
	]
	return RenderingServer.get_rendering_info(kinds[p_what])


func _place(p_camera: Camera3D, p_eye: String) -> void:
	var ends: PackedStringArray = p_eye.split(">")
	p_camera.look_at_from_position(_point(ends[0]), _point(ends[1]))


func _point(p_text: String) -> Vector3:
	var numbers: PackedFloat64Array = p_text.split_floats(",")
	var place: Vector3 = Vector3(numbers[0], numbers[1], numbers[2])
	for node: Node in root.find_children("*", "StaticBody3D", true, false):
		if node is Terrain:
			place.y += (node as Terrain).height_at(place)
	return place


func _option(p_name: String, p_default: String) -> String:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--%s=" % p_name):
			return (
				argument.get_slice("=", 1)
				if argument.count("=") == 1
				else argument.split("=", true, 1)[1]
			)
	return p_default
