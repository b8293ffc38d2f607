extends TestCase
## Names over heads: who has one, and what it costs.

const _PEOPLE: int = 64

var _names: NameTags = null


func before_each() -> void:
	_names = NameTags.new()
	add_child(_names)
	for person: int in _PEOPLE:
		_names.add(person, "Person %d" % person)


func after_each() -> void:
	_names.free()


func test_the_nearest_have_names() -> void:
	_play(30, Vector3.ZERO)
	equal(_shown(), range(NameTags.MAX_SHOWN))
	_play(30, Vector3(63.0, 0.0, 0.0))
	equal(_shown(), range(_PEOPLE - NameTags.MAX_SHOWN, _PEOPLE))


func test_names_fade_and_end_with_the_distance() -> void:
	_play(30, Vector3(-22.0, 0.0, 0.0))
	equal(_shown(), range(8), "the eighth is 29 m away")
	var nearest: Label3D = _names.get_child(0)
	var farthest: Label3D = _names.get_child(7)
	is_true(nearest.modulate.a > farthest.modulate.a + 0.5)
	_play(30, Vector3(-40.0, 0.0, 0.0))
	equal(_shown(), [])


func test_a_name_stays_with_its_head_in_every_frame() -> void:
	_play(30, Vector3.ZERO)
	for frame: int in 30:
		_play(1, Vector3.ZERO, Vector3.BACK * frame)
		for person: int in _shown():
			var label: Label3D = _names.get_child(person)
			almost_equal(label.position.z, float(frame), 1e-5, "%d in frame %d" % [person, frame])


func test_the_eyes_that_look_have_no_name() -> void:
	_play(30, Vector3.ZERO, Vector3.ZERO, 3)
	is_false(_shown().has(3))
	equal(_shown().size(), NameTags.MAX_SHOWN)
	_play(1, Vector3.ZERO, Vector3.ZERO, 5)
	is_false(_shown().has(5), "at once")


func test_who_comes_has_a_name_in_the_next_frame() -> void:
	_play(3, Vector3(-10.0, 0.0, 0.0))
	_names.add(_PEOPLE, "Ada")
	_names.put(_PEOPLE, Vector3(-9.0, 0.0, 0.0))
	_names.choose(Vector3(-10.0, 0.0, 0.0), -1)
	is_true(_shown().has(_PEOPLE))
	_names.remove(_PEOPLE)
	_play(30, Vector3(-10.0, 0.0, 0.0))


func test_few_heads_are_asked_for() -> void:
	_play(30, Vector3.ZERO)
	var asked: int = 0
	for _frame: int in 60:
		asked += _play(1, Vector3.ZERO)
	is_true(asked < 60 * NameTags.MAX_SHOWN * 1.5, "%d heads in 60 frames" % asked)
	_names.visible = false
	equal(_play(1, Vector3.ZERO), 0)


## Shows frames of people 1 m apart along X, moved by some way; returns how many heads it
## asked for.
func _play(
	p_frames: int, p_camera: Vector3, p_way: Vector3 = Vector3.ZERO, p_eyes: int = -1
) -> int:
	var asked: int = 0
	for _frame: int in p_frames:
		for person: int in _PEOPLE:
			if _names.wants(person):
				asked += 1
				_names.put(person, Vector3(person, 0.0, 0.0) + p_way)
		_names.choose(p_camera, p_eyes)
	return asked


func _shown() -> Array:
	var shown: Array = []
	for index: int in _names.get_child_count():
		if (_names.get_child(index) as Label3D).visible:
			shown.append(index)
	return shown
