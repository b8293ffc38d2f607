extends TestCase
## A slider says what it means, what the user did, and when it settles.

var _moved: Array[float] = []
var _settled: Array[float] = []
var _row: UiSlider = null


func before_each() -> void:
	_moved.clear()
	_settled.clear()
	_row = UiSlider.new("Strength", Vector3(0.0, 4.0, 0.05), "x", "none")
	_row.moved.connect(func(value: float) -> void: _moved.append(value))
	_row.settled.connect(func(value: float) -> void: _settled.append(value))
	add_child(_row)


func after_each() -> void:
	_row.free()


func test_a_value_is_read_with_its_unit_and_the_digits_of_the_step() -> void:
	equal(_row.text(), "none")
	_row.show_value(1.0)
	equal(_row.text(), "1.00 x")
	for step: Array in [[1.0, "2 x"], [0.5, "2.0 x"], [0.1, "2.0 x"], [0.001, "2.000 x"]]:
		_row.set_range(Vector3(0.0, 4.0, step[0]))
		_row.show_value(2.0)
		equal(_row.text(), step[1])


func test_only_the_users_moves_are_reported() -> void:
	_row.show_value(3.0)
	_row.set_range(Vector3(0.0, 2.0, 0.5))
	equal(_moved, [] as Array[float])
	_row.slider.value = 1.5
	equal(_moved, [1.5] as Array[float])


func test_it_settles_once_when_it_is_let_go_or_left() -> void:
	_row.settle()
	_row.slider.value = 1.0
	equal(_settled, [] as Array[float])
	_row.slider.drag_ended.emit(true)
	_row.settle()
	equal(_settled, [1.0] as Array[float])
	_row.slider.value = 2.0
	remove_child(_row)
	equal(_settled, [1.0, 2.0] as Array[float])
	add_child(_row)


func test_a_typed_number_may_be_more_than_the_slider_reaches() -> void:
	_row.let_type(Vector2(-1.0, 100.0))
	var edit: LineEdit = _row.find_children("*", "LineEdit", true, false)[0]
	for text: String in ["50", "nonsense", "1000"]:
		edit.text_submitted.emit(text)
	equal(_moved, [50.0, 100.0] as Array[float])


func test_the_name_lights_up_with_the_keyboard() -> void:
	_row.slider.grab_focus()
	equal(_row.title.get_theme_color(&"font_color"), UiStyle.ACCENT)
	_row.slider.release_focus()
	is_true(_row.title.get_theme_color(&"font_color") != UiStyle.ACCENT)
