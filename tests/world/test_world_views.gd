extends TestCase
## The three worlds and the keys that switch them.

var _views: WorldViews = null
var _changes: int = 0


func before_each() -> void:
	_views = WorldViews.new()
	for root: String in ["people", "props", "static_world", "physics_world"]:
		var node: Node3D = Node3D.new()
		_views.set(root, node)
		_views.add_child(node)
	add_child(_views)
	_changes = 0
	_views.changed.connect(_on_changed)


func after_each() -> void:
	_views.free()


func test_keys_switch_the_worlds() -> void:
	var keys: Dictionary[Key, StringName] = {
		KEY_1: &"mesh",
		KEY_2: &"static",
		KEY_3: &"physics",
		KEY_KP_1: &"mesh",
		KEY_KP_2: &"static",
		KEY_KP_3: &"physics",
	}
	for key: Key in keys:
		var others: Array = WorldViews.NAMES.filter(
			func(name: StringName) -> bool: return name != keys[key]
		)
		for shown: bool in [false, true]:
			_press(key)
			equal(_views.is_shown(keys[key]), shown, OS.get_keycode_string(key))
			for other: StringName in others:
				is_true(_views.is_shown(other), other)
	equal(_changes, 12)


func test_other_keys_echoes_and_releases_do_nothing() -> void:
	_press(KEY_4)
	_press(KEY_A)
	_press(KEY_1, true, true)
	_press(KEY_1, false)
	equal(_changes, 0)


func test_mesh_is_people_and_props() -> void:
	_views.set_shown(&"mesh", false)
	equal([_views.people.visible, _views.props.visible], [false, false])
	equal([_views.static_world.visible, _views.physics_world.visible], [true, true])
	_views.set_shown(&"static", false)
	is_false(_views.static_world.visible)
	_views.set_shown(&"physics", false)
	is_false(_views.physics_world.visible)


func test_lists() -> void:
	var cases: Dictionary[String, Array] = {
		"mesh": [true, false, false],
		"mesh,physics": [true, false, true],
		"physics,static,mesh": [true, true, true],
		"": [false, false, false],
	}
	for list: String in cases:
		_views.show_only(list)
		for i: int in 3:
			equal(_views.is_shown(WorldViews.NAMES[i]), cases[list][i], list)


func _on_changed() -> void:
	_changes += 1


func _press(p_key: Key, p_pressed: bool = true, p_echo: bool = false) -> void:
	var event: InputEventKey = InputEventKey.new()
	event.keycode = p_key
	event.pressed = p_pressed
	event.echo = p_echo
	get_viewport().push_input(event)
