extends SceneTree
## Looks at the screen of the stage in a window: a line of JSON with how many of its pixels differ
## while nobody is there, when somebody comes, and when he moves.

const PERSON: String = "res://scenes/actor/people/show.tscn"
## Two seconds of frames of fixed length: by then a camera has come to rest.
const SETTLE_FRAMES: int = 20
const DIFFERENCE: float = 0.08


func _initialize() -> void:
	_look.call_deferred()


func _look() -> void:
	Quality.use(QualityTier.low(), root)
	var level: Level = LevelStore.instantiate("stage")
	root.add_child(level)
	var camera: Camera3D = Camera3D.new()
	root.add_child(camera)
	camera.look_at_from_position(Vector3(0.0, 2.2, -2.0), Vector3(0.0, 3.5, -12.0))
	camera.make_current()
	var screen: CameraScreen = level.get_node(^"Static/CameraScreen1")
	var found: Dictionary = {}
	var empty: Image = await _picture(screen)
	found["still"] = _difference(empty, await _picture(screen))
	var person: Ragdoll = (load(PERSON) as PackedScene).instantiate()
	root.add_child(person)
	person.get_simulator().active = false
	person.position = level.get_spawn_points()[0].global_position
	var here: Image = await _picture(screen)
	found["comes"] = _difference(empty, here)
	var arm: int = person.get_skeleton().find_bone(&"LeftUpperArm")
	var up: Quaternion = Quaternion(Vector3.BACK, 1.2)
	person.get_skeleton().set_bone_pose_rotation(arm, up)
	found["moves"] = _difference(here, await _picture(screen))
	# A camera that does not look at the screen gets no pictures taken for it.
	camera.look_at_from_position(Vector3(0.0, 2.2, 0.0), Vector3(0.0, 2.2, 20.0))
	await _picture(screen)
	var before: Image = await _picture(screen)
	person.position.x += 1.0
	found["unseen"] = _difference(before, await _picture(screen))
	print(JSON.stringify(found))
	quit()


## The screen's picture after the camera has come to rest.
func _picture(p_screen: CameraScreen) -> Image:
	for _frame: int in SETTLE_FRAMES:
		await RenderingServer.frame_post_draw
	return p_screen.get_picture().get_image()


## How many pixels differ clearly.
static func _difference(p_one: Image, p_other: Image) -> int:
	var count: int = 0
	for y: int in p_one.get_height():
		for x: int in p_one.get_width():
			var one: Color = p_one.get_pixel(x, y)
			var other: Color = p_other.get_pixel(x, y)
			if absf(one.get_luminance() - other.get_luminance()) > DIFFERENCE:
				count += 1
	return count
