extends TestCase
## Steps are found in the motion of feet beside the hips.

const STEP_S: float = 1.0 / 60.0


func test_a_walk_has_two_steps_a_second() -> void:
	var walk: Callable = func(t: float) -> Vector3: return Vector3(0.0, 0.9, 1.4 * t)
	# The first foot is in the air already.
	equal(_steps_of(walk, 0.14, 6.2), 12)


func test_who_stands_makes_none() -> void:
	equal(_steps_of(func(_t: float) -> Vector3: return Vector3(0.0, 0.9, 0.0), 0.0, 4.0), 0)


func test_who_is_carried_up_and_down_makes_none() -> void:
	var carried: Callable = func(t: float) -> Vector3:
		return Vector3(0, 1.0 + 0.3 * sin(9.0 * t), t)
	var contacts: FootContacts = FootContacts.new()
	var found: int = 0
	for frame: int in 240:
		var hips: Vector3 = carried.call(frame * STEP_S)
		contacts.advance(hips, [hips + Vector3.DOWN * 0.5, hips + Vector3.DOWN * 0.5], STEP_S)
		found += 1 if contacts.landed[0] + contacts.landed[1] > 0.0 else 0
	equal(found, 0)


func test_a_teleport_is_no_step() -> void:
	var contacts: FootContacts = FootContacts.new()
	for frame: int in 60:
		var up: float = 50.0 if frame > 30 else 0.0
		contacts.advance(Vector3(0.0, 0.9, 0.0), [Vector3.UP * up, Vector3.UP * up], STEP_S)
		equal(contacts.landed[0], 0.0)


## Feet in turn swing in half a second and stand in half.
func _steps_of(p_hips: Callable, p_lift: float, p_seconds: float) -> int:
	var contacts: FootContacts = FootContacts.new()
	var found: int = 0
	for frame: int in roundi(p_seconds / STEP_S):
		var time: float = frame * STEP_S
		var hips: Vector3 = p_hips.call(time)
		var feet: PackedVector3Array = []
		for side: int in 2:
			var phase: float = fposmod(time + 0.5 * side, 1.0)
			var up: float = p_lift * sin(PI * phase / 0.5) if phase < 0.5 else 0.0
			feet.append(Vector3(hips.x, 0.09 + up, hips.z))
		contacts.advance(hips, feet, STEP_S)
		for side: int in 2:
			found += 1 if contacts.landed[side] > 0.0 else 0
	return found
