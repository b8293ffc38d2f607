extends TestCase
## How a headset sits on a head is found from nods and turns.

var _mount: HeadMount = HeadMount.new()
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 4


func test_nods_and_turns_give_turn_and_lever() -> void:
	var worn: Quaternion = Quaternion.from_euler(Vector3(0.12, -0.05, 0.03))
	for heading: float in [0.0, 1.0, -2.8]:
		_mount = HeadMount.new()
		var lever: Vector3 = HeadMount.USUAL_LEVER + Vector3(0.004, -0.02, 0.015)
		_move(worn, lever, heading, 0.0)
		equal(_mount.solve(), "")
		is_true(_mount.is_solved)
		is_true(Rotations.between_deg(_mount.turn, worn) < 0.3)
		almost_equal(_mount.lever, lever, 0.004)
	_mount = HeadMount.new()
	_move(worn, HeadMount.USUAL_LEVER, 1.0, 0.01)
	equal(_mount.solve(), "")
	var off: float = Rotations.between_deg(_mount.turn, worn)
	is_true(off < 1.0, "with noise: %f deg" % off)


func test_what_does_not_suffice_says_so() -> void:
	contains(_mount.solve(), "nodded 0 and turned 0 degrees: nod by 20 and look to both sides")
	_move(Quaternion(Vector3.UP, 1.0), HeadMount.USUAL_LEVER, 0.0, 0.0)
	contains(_mount.solve(), "put it on straight")
	_mount.clear()
	for at: int in 60:
		var turn: Quaternion = _turn(at)
		_mount.add(turn, Vector3(at * 0.05, 1.6, 0.0), turn)
	contains(_mount.solve(), "nod and turn only the head")
	is_false(_mount.is_solved)
	equal(_mount.lever, HeadMount.USUAL_LEVER)


func test_it_can_be_kept() -> void:
	_move(Quaternion.from_euler(Vector3(0.1, 0, 0)), HeadMount.USUAL_LEVER, 0.5, 0.0)
	equal(_mount.solve(), "")
	var again: HeadMount = HeadMount.new()
	var kept: Variant = JSON.parse_string(JSON.stringify(_mount.to_dictionary()))
	equal(again.read_dictionary(kept), "")
	almost_equal(again.turn, _mount.turn, 1e-5)
	almost_equal(again.lever, _mount.lever, 1e-5)
	for wrong: Dictionary in [
		{},
		{"turn": [0, 0, 0], "lever_m": [0, 0, 0]},
		{"turn": [0, 0, 0, "x"], "lever_m": [0, 0, 0]},
		{"turn": [0, 0, 0, NAN], "lever_m": [0, 0, 0]},
		{"turn": [0, 0, 0, 3], "lever_m": [0, -0.07, -0.08]},
		{"turn": [0, 0, 0, 1], "lever_m": [0, 2, 0]},
	]:
		not_equal(again.read_dictionary(wrong), "", str(wrong))
	almost_equal(again.turn, _mount.turn, 1e-5, "nothing has changed")


func _move(p_worn: Quaternion, p_lever: Vector3, p_heading: float, p_noise: float) -> void:
	for at: int in 120:
		var head: Quaternion = _turn(at)
		var headset: Quaternion = (head * p_worn).normalized()
		var eyes: Vector3 = Vector3(0.3, 1.5, -1.0) - headset * p_lever
		var off: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn())
		var suit: Quaternion = Rotations.yaw(-p_heading) * head
		suit = (Rotations.from_vector(off * p_noise) * suit).normalized()
		_mount.add(headset, eyes, suit)


func _turn(p_at: int) -> Quaternion:
	var turn: Vector3 = Vector3(sin(p_at * 0.21) * 0.4, sin(p_at * 0.13) * 0.7, 0.0)
	return Quaternion.from_euler(turn)
