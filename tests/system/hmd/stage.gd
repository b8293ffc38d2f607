extends Node3D
## A small world with a headset in it, for tests: it prints what happens to it.

var _display: HmdDisplay = HmdDisplay.new()
var _camera: Camera3D = Camera3D.new()
var _menu: HmdMenu = null
var _frames: int = 0


func _ready() -> void:
	add_child(_camera)
	_camera.position = Vector3(0.0, 1.6, 2.0)
	var light: DirectionalLight3D = DirectionalLight3D.new()
	light.rotation = Vector3(-1.0, 0.5, 0.0)
	add_child(light)
	for i: int in 5:
		var box: MeshInstance3D = MeshInstance3D.new()
		box.mesh = BoxMesh.new()
		box.position = Vector3(-4.0 + 2.0 * i, 0.5, -3.0 - i)
		add_child(box)
	_display.camera = _camera
	_display.notified.connect(func(text: String) -> void: print("TOLD ", text))
	_display.pressed.connect(func(a: StringName, h: int) -> void: print("PRESSED ", a, " ", h))
	var mirror: String = OS.get_environment("MIRROR")
	_display.set_mirror(int(mirror) as HmdDisplay.Mirror)
	add_child(_display)
	var fault: String = _display.open()
	if _display.is_worn():
		_open_menu()
	print("OPEN ", fault, " pid ", OS.get_process_id())


func _open_menu() -> void:
	var button: Button = Button.new()
	button.text = "Press"
	button.pressed.connect(func() -> void: print("MENU pressed"))
	_menu = HmdMenu.new()
	_display.view().origin.add_child(_menu)
	print("LAYER ", _menu.use_layer(_display.view().origin))
	_menu.open(button, Transform3D(Basis.IDENTITY, Vector3(0.0, 1.6, 0.0)))


func _process(_delta: float) -> void:
	_frames += 1
	_display.place_room(Transform3D.IDENTITY)
	if _display.is_worn():
		_menu.point([_display.controller_pose(1)], [_trigger()])
	if _frames % 10 == 0:
		var report: Dictionary = _display.report()
		var guarded: String = "guarded" if report["guarded"] else "unguarded"
		print("FRAME %d worn %s, %s" % [_frames, report["worn"], guarded])
		print("HEAD %s" % _display.head_in_world().origin)
		print("HAND %s" % _display.controller_pose(1).origin)
		if _display.is_worn():
			print("TRIGGER %.1f" % _trigger())


func _trigger() -> float:
	return _display.view().hand(1).get_float(&"trigger")
