extends TestCase
## What users read can be read: colours of the project's theme against their grounds.

const LEAST_OF_TEXT: float = 4.5
const LEAST_OF_MARKS: float = 3.0

var _theme: Theme = load("res://scenes/ui/theme.tres")


func test_contrast_is_as_the_standard_defines_it() -> void:
	almost_equal(UiStyle.contrast(Color.BLACK, Color.WHITE), 21.0, 0.01)
	almost_equal(UiStyle.contrast(Color("777777"), Color.WHITE), 4.48, 0.01)
	equal(UiStyle.contrast(Color.RED, Color.RED), 1.0)


func test_text_stands_out_from_every_ground() -> void:
	for ground: Color in [UiStyle.SCREEN, UiStyle.SURFACE, UiStyle.FIELD, UiStyle.RAISED]:
		for text: Color in [UiStyle.TEXT, UiStyle.DIM, UiStyle.WARN, UiStyle.BAD, UiStyle.GOOD]:
			is_true(UiStyle.contrast(text, ground) >= LEAST_OF_TEXT, "%s on %s" % [text, ground])
		for mark: Color in [UiStyle.ACCENT, UiStyle.EDGE]:
			is_true(UiStyle.contrast(mark, ground) >= LEAST_OF_MARKS, "%s on %s" % [mark, ground])
	is_true(UiStyle.contrast(UiStyle.TEXT, UiStyle.HOVER) >= LEAST_OF_TEXT)


func test_the_theme_has_these_colours() -> void:
	equal(ThemeDB.get_project_theme(), _theme)
	_same(_theme.get_color(&"font_color", &"Label"), UiStyle.TEXT)
	_same(_theme.get_color(&"font_color", &"Button"), UiStyle.TEXT)
	_same(_theme.get_color(&"font_color", UiStyle.WARNING), UiStyle.WARN)
	_same(_theme.get_color(&"font_color", UiStyle.HINT), UiStyle.DIM)
	_same(_ground(&"normal", &"Button"), UiStyle.RAISED)
	_same(_ground(&"hover", &"Button"), UiStyle.HOVER)
	_same(_ground(&"panel", &"Tree"), UiStyle.FIELD)
	_same(Color(_ground(&"panel", &"PanelContainer"), 1.0), UiStyle.SURFACE)
	equal(_theme.default_font_size, UiStyle.BODY_PX)
	equal(_theme.get_font_size(&"font_size", UiStyle.TITLE), UiStyle.TITLE_PX)


func _ground(p_name: StringName, p_type: StringName) -> Color:
	return (_theme.get_stylebox(p_name, p_type) as StyleBoxFlat).bg_color


## A file keeps fewer digits.
func _same(p_color: Color, p_expected: Color) -> void:
	is_true(p_color.is_equal_approx(p_expected), "%s is not %s" % [p_color, p_expected])
