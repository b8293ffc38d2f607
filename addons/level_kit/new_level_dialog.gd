@tool
extends ConfirmationDialog
## Asks for what a new level needs, makes it and opens it.

const LevelTemplate: GDScript = preload("level_template.gd")

var _name: LineEdit = LineEdit.new()
var _title: LineEdit = LineEdit.new()
var _size: SpinBox = SpinBox.new()
var _surface: OptionButton = OptionButton.new()
var _points: SpinBox = SpinBox.new()
var _time: SpinBox = SpinBox.new()
var _fault: Label = Label.new()


func _init() -> void:
	title = "New level"
	ok_button_text = "Create"
	confirmed.connect(_create)
	canceled.connect(queue_free)


func _ready() -> void:
	var rows: GridContainer = GridContainer.new()
	rows.columns = 2
	_name.placeholder_text = "shooting_range"
	_name.custom_minimum_size.x = 220.0
	_title.placeholder_text = "Shooting range"
	_set_range(_size, 10.0, 500.0, 40.0, "m")
	_set_range(_points, 1.0, 32.0, 4.0, "")
	_set_range(_time, 0.0, 24.0, 10.0, "h")
	for layer: String in SurfaceLayers.Layer:
		_surface.add_item(layer.capitalize(), SurfaceLayers.Layer[layer])
	_surface.select(_surface.get_item_index(SurfaceLayers.Layer.CONCRETE))
	var fields: Dictionary[String, Control] = {
		"Name of the folder": _name,
		"Title": _title,
		"Edge of the ground": _size,
		"Ground": _surface,
		"Spawn points": _points,
		"Time of day": _time,
	}
	for text: String in fields:
		var label: Label = Label.new()
		label.text = text
		rows.add_child(label)
		rows.add_child(fields[text])
	var all: VBoxContainer = VBoxContainer.new()
	all.add_child(rows)
	all.add_child(_fault)
	add_child(all)
	_name.text_changed.connect(_judge)
	register_text_enter(_name)
	_judge("")
	_name.grab_focus.call_deferred()


func _judge(p_name: String) -> void:
	_fault.text = LevelTemplate.find_fault(p_name)
	get_ok_button().disabled = _fault.text != ""


func _create() -> void:
	var template: RefCounted = LevelTemplate.new()
	template.title = _title.text if _title.text != "" else _name.text.capitalize()
	template.size = _size.value
	template.surface = _surface.get_selected_id()
	template.spawn_points = int(_points.value)
	template.time_of_day = _time.value
	var path: String = LevelStore.path_of(_name.text)
	var error: Error = template.save(path)
	if error != OK:
		EditorInterface.get_editor_toaster().push_toast(
			"%s: %s" % [path, error_string(error)], EditorToaster.SEVERITY_ERROR
		)
	else:
		# The file list gets it when the editor looks through the files by itself the next time. To
		# have it look now, while a scene is opened, has ended the editor (4.6.3).
		EditorInterface.open_scene_from_path(path)
		EditorInterface.set_main_screen_editor("3D")
	queue_free()


static func _set_range(
	p_box: SpinBox, p_least: float, p_most: float, p_value: float, p_suffix: String
) -> void:
	p_box.min_value = p_least
	p_box.max_value = p_most
	p_box.value = p_value
	p_box.suffix = p_suffix
