extends SceneTree
## Takes pictures of vehicles in a world, to look at:
##
## godot --path . -s tools/assets/vehicle/look.gd -- --vehicle=tank --out=DIR [--world=desert]
##     [--at=0,0] [--turn=0] [--eyes="-5,2,-6>0,1,0;..."] [--time=10]
##     [--fov=50] [--speed=0] [--seconds=0.5]
##     [--set=turret_yaw:0.3,hatch:1,...]
##
## An eye is a place and what it looks at, in the vehicle's own axes. [code]--set[/code] sets
## members
## of the vehicle's state; with a speed it drives straight on for the seconds, m/s.

const _STEP: float = 1.0 / 30.0

var _vehicle: Node3D = null
var _camera: Camera3D = null


func _initialize() -> void:
	_take.call_deferred()


func _take() -> void:
	var world: String = _option("world", "desert")
	var folder: String = _option("out", "user://look")
	DirAccess.make_dir_recursive_absolute(folder)
	var scene: String = "res://scenes/world/%s/%s.tscn" % [world, world]
	root.add_child((load(scene) as PackedScene).instantiate())
	await process_frame
	_camera = Camera3D.new()
	_camera.fov = float(_option("fov", "50"))
	_camera.far = 2500.0
	root.add_child(_camera)
	_camera.make_current()
	await physics_frame
	await physics_frame
	var sky: WorldSky = root.find_children("*", "WorldSky", true, false)[0]
	sky.show_conditions(
		WorldConditions.parse_time(_option("time", "10")), WorldConditions.Weather.CLEAR, 0.0
	)
	_place()
	await _drive()
	var eyes: PackedStringArray = _option("eyes", "-5,2.2,-6>0,1,0").split(";", false)
	for number: int in eyes.size():
		_look_from(eyes[number])
		for _frame: int in 4:
			await RenderingServer.frame_post_draw
		var name: String = (
			"%s_%s_%d.png" % [_option("vehicle", "tank"), _option("name", "x"), number]
		)
		root.get_texture().get_image().save_png(folder.path_join(name))
		print(
			(
				"%s: %d draws, %d primitives"
				% [
					name,
					RenderingServer.get_rendering_info(
						RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME
					),
					RenderingServer.get_rendering_info(
						RenderingServer.RENDERING_INFO_TOTAL_PRIMITIVES_IN_FRAME
					)
				]
			)
		)
	quit()


func _place() -> void:
	var vehicle: String = _option("vehicle", "tank")
	var file: String = "res://scenes/vehicle/%s/%s_view.tscn" % [vehicle, vehicle]
	if not ResourceLoader.exists(file):
		file = "res://assets/vehicle/%s.glb" % vehicle
	_vehicle = (load(file) as PackedScene).instantiate()
	root.add_child(_vehicle)
	_vehicle.rotation.y = deg_to_rad(float(_option("turn", "0")))
	var at: PackedFloat64Array = _option("at", "0,0").split_floats(",")
	_stand(Vector3(at[0], 0.0, at[1]))
	if not _vehicle is VehicleView:
		return
	for setting: String in _option("set", "").split(",", false):
		var state: VehicleState = (_vehicle as VehicleView).state
		var value: Variant = str_to_var(setting.get_slice(":", 1))
		state.set(setting.get_slice(":", 0), value)


## Stands on the ground as a vehicle of 5 m length and 2.8 m track does.
func _stand(p_place: Vector3) -> void:
	var ahead: Vector3 = -_vehicle.basis.z
	ahead = Vector3(ahead.x, 0.0, ahead.z).normalized()
	var aside: Vector3 = ahead.cross(Vector3.UP)
	var front: Vector3 = _on_ground(p_place + ahead * 2.5)
	var rear: Vector3 = _on_ground(p_place - ahead * 2.5)
	var right: Vector3 = _on_ground(p_place + aside * 1.4)
	var left: Vector3 = _on_ground(p_place - aside * 1.4)
	var way: Vector3 = (front - rear).normalized()
	var up: Vector3 = (right - left).normalized().cross(way).normalized()
	_vehicle.basis = Basis.looking_at(way, up)
	_vehicle.position = (front + rear + left + right) / 4.0


func _on_ground(p_place: Vector3) -> Vector3:
	for node: Node in root.find_children("*", "StaticBody3D", true, false):
		if node is Terrain:
			p_place.y = (node as Terrain).height_at(p_place)
	return p_place


func _drive() -> void:
	var speed: float = float(_option("speed", "0"))
	var seconds: float = float(_option("seconds", "0.5"))
	for _step: int in roundi(seconds / _STEP):
		if speed != 0.0 and _vehicle is VehicleView:
			(_vehicle as VehicleView).state.left_speed = speed
			(_vehicle as VehicleView).state.right_speed = speed
			_stand(_vehicle.position - _vehicle.basis.z * speed * _STEP)
		# Particles move only where they are seen.
		_look_from(_option("eyes", "-5,2.2,-6>0,1,0").get_slice(";", 0))
		await process_frame


func _look_from(p_eye: String) -> void:
	var ends: PackedStringArray = p_eye.split(">")
	_camera.look_at_from_position(
		_vehicle.to_global(_point(ends[0])), _vehicle.to_global(_point(ends[1]))
	)


func _point(p_text: String) -> Vector3:
	var numbers: PackedFloat64Array = p_text.split_floats(",")
	return Vector3(numbers[0], numbers[1], numbers[2])


func _option(p_name: String, p_default: String) -> String:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--%s=" % p_name):
			return argument.split("=", true, 1)[1]
	return p_default
