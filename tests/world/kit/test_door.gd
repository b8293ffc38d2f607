extends TestCase
## Doors: who pushes them opens them, to the sides to which they open and no further, and they come
## to rest.

var _door: Door = null


func after_each() -> void:
	if _door != null:
		_door.free()
		_door = null


func test_it_stands_as_far_open_as_it_is_reported() -> void:
	for right: bool in [false, true]:
		for ajar: float in [-60.0, 0.0, 45.0]:
			_door = Door.new()
			_door.right_hinge = right
			_door.ajar = ajar
			await _stand()
			almost_equal(_door.angle(), ajar, 0.01)
			await _wait(20)
			almost_equal(_door.angle(), ajar, 0.5, "it moves by itself")
			after_each()


func test_a_push_swings_it_to_both_sides_and_no_further() -> void:
	for right: bool in [false, true]:
		for push: float in [-60.0, 60.0]:
			_door = Door.new()
			_door.right_hinge = right
			await _stand()
			_door.apply_impulse(Vector3(0, 0, push), _leaf_end())
			await _wait(120)
			# Towards -Z is inwards.
			var wanted: float = -signf(push) * _door.widest
			almost_equal(_door.angle(), wanted, 3.0, "right %s, push %s" % [right, push])
			after_each()


func test_it_opens_to_one_side_only_if_it_shall() -> void:
	for opens: Door.Way in [Door.Way.OUT, Door.Way.IN] as Array[Door.Way]:
		for push: float in [-60.0, 60.0]:
			_door = Door.new()
			_door.opens = opens
			await _stand()
			_door.apply_impulse(Vector3(0, 0, push), _leaf_end())
			await _wait(120)
			var may: bool = (push < 0.0) == (opens == Door.Way.IN)
			var wanted: float = -signf(push) * _door.widest if may else 0.0
			# It swings back from the frame by a part of its speed.
			is_true(absf(_door.angle() - wanted) < (3.0 if may else 25.0), "%s %s" % [opens, push])
			after_each()


func test_its_hinge_stays_where_it_is_under_blows() -> void:
	_door = Door.new()
	_door.position = Vector3(3.0, 0.5, -2.0)
	_door.rotation.y = 0.7
	await _stand()
	for blow: int in 10:
		_door.apply_impulse(Vector3(80, 40, 80) * (-1.0 if blow % 2 else 1.0), _leaf_end())
		await _wait(12)
		is_true(_door.position.distance_to(Vector3(3.0, 0.5, -2.0)) < 0.03, "it comes off")
		is_true(absf(_door.angle()) < _door.widest + 4.0, "%.1f degrees" % _door.angle())


func test_it_sleeps_when_nobody_touches_it() -> void:
	_door = Door.new()
	_door.ajar = 30.0
	await _stand()
	_door.apply_impulse(Vector3(0, 0, -10), _leaf_end())
	await _wait(400)
	is_true(_door.sleeping)


func test_warnings_say_how_to_mend_it() -> void:
	_door = Door.new()
	_door.ajar = 30.0
	_door.opens = Door.Way.OUT
	_door.rotation.x = 0.5
	await _stand()
	var warnings: String = "\n".join(_door._get_configuration_warnings())
	contains(warnings, "upright")
	contains(warnings, "Ajar")


func _stand() -> void:
	add_child(_door)
	await get_tree().physics_frame


func _leaf_end() -> Vector3:
	return _door.global_basis * Vector3(-0.8 if _door.right_hinge else 0.8, 1.0, 0.0)


func _wait(p_frames: int) -> void:
	for frame: int in p_frames:
		await get_tree().physics_frame
