extends Node3D
## What both eyes of a headset see of a white world while its wearer is moved and turned. Prints a
## line of JSON.

const _FRAMES: int = 25

var _display: HmdDisplay = HmdDisplay.new()
var _reader: RimReader = null
var _room: Transform3D = Transform3D.IDENTITY
var _found: Dictionary[String, Array] = {}
var _frames: int = -20


func _ready() -> void:
	var camera: Camera3D = Camera3D.new()
	add_child(camera)
	_display.camera = camera
	_display.set_mirror(HmdDisplay.Mirror.NONE)
	add_child(_display)
	var fault: String = _display.open()
	if fault != "":
		print("JSON ", JSON.stringify({"fault": fault}))
		get_tree().quit(1)
		return
	if not _display.is_worn():
		return
	_display.view().vignette.strength = 1.0
	var world: WorldEnvironment = WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color.WHITE
	world.compositor = Compositor.new()
	_reader = RimReader.new()
	world.compositor.compositor_effects = [_reader]
	add_child(world)


func _process(p_delta: float) -> void:
	if _reader == null or _reader.frame < 0:
		_display.place_room(_room)
		return
	_frames += 1
	match _frames / _FRAMES:
		0:
			_end_of("still")
		1:
			_room.origin.z -= 2.5 * p_delta
			_end_of("walking")
		3:
			_display.turning = StickTurn.parse("smooth:60")
			_display.stick = Vector2(1.0, 0.0)
			_end_of("turning")
		5:
			_step()
		6:
			print("JSON ", JSON.stringify(_found))
			get_tree().quit(0)
		_:
			_display.stick = Vector2.ZERO
	_display.place_room(_room)


## What was drawn of the frame before is the first one after the step.
func _step() -> void:
	_display.turning = StickTurn.parse("snap")
	var at: int = _frames % _FRAMES
	_display.stick = Vector2(1.0 if at == 5 else 0.0, 0.0)
	if at in [6, 7]:
		var darkest: Array = _found.get("step", _reader.bright.duplicate(true))
		if _reader.bright[0]["centre"] <= darkest[0]["centre"]:
			darkest = _reader.bright.duplicate(true)
		_found["step"] = darkest


func _end_of(p_name: String) -> void:
	if _frames % _FRAMES == _FRAMES - 1:
		_found[p_name] = _reader.bright.duplicate(true)
