extends TestCase
## The panel for wheels and pedals: what it watches is kept.

const PATH: String = "user://test_axis_panel.cfg"
const SCENE: PackedScene = preload("res://scenes/vehicle/controls/axis_panel.tscn")

var _panel: AxisPanel = null


func before_each() -> void:
	_panel = SCENE.instantiate()
	add_child(_panel)
	_panel.show_panel(ControlSettings.new(PATH))


func after_each() -> void:
	_panel.free()
	DirAccess.remove_absolute(PATH)


func test_a_pedal_is_watched_and_kept() -> void:
	_panel.begin(AxisCalibrator.Kind.BRAKE)
	for raw: float in [0.0, 0.4, 1.0, 0.3, 0.0]:
		_move(3, raw)
	is_true(_panel.finish())
	var kept: AxisCalibration = ControlSettings.new(PATH).find(
		Input.get_joy_name(0), AxisCalibrator.Kind.BRAKE
	)
	equal([kept.axis, kept.rest, kept.high], [3, 0.0, 1.0])


func test_nothing_is_kept_where_nothing_moves() -> void:
	is_false(_panel.finish(), "nothing was begun")
	_panel.begin(AxisCalibrator.Kind.STEER)
	_move(0, 0.02)
	is_false(_panel.finish())
	is_false(FileAccess.file_exists(PATH))


func test_escape_closes_it() -> void:
	var event: InputEventAction = InputEventAction.new()
	event.action = &"ui_cancel"
	event.pressed = true
	_panel._input(event)
	is_false(_panel.visible)


func _move(p_axis: int, p_raw: float) -> void:
	var event: InputEventJoypadMotion = InputEventJoypadMotion.new()
	event.axis = p_axis as JoyAxis
	event.axis_value = p_raw
	_panel._input(event)
