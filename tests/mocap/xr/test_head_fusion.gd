extends TestCase
## A body fits the headset of its wearer, and nobody sees it being moved.

const Scene: GDScript = preload("headset_scene.gd")

var _scene: Scene = null
var _fusion: HeadFusion = null
var _worst_turn: float = 0.0
var _last_turn: float = NAN


func test_thirty_degrees_are_gone_in_a_minute_of_standing() -> void:
	for side: float in [1.0, -1.0]:
		_begin("Boxing_Toes.bvh")
		_scene.pace = 0.0
		_run(2.0)
		_scene.heading = deg_to_rad(30.0) * side
		_run(2.0)
		is_true(absf(_off_deg()) > 28.0, "not at once: %f deg" % _off_deg())
		_run(58.0)
		is_true(absf(_off_deg()) < 2.0, "still %f deg off" % _off_deg())
		is_true(_worst_turn < deg_to_rad(0.5 + 1e-3), "%f deg/s" % rad_to_deg(_worst_turn))
		_run(20.0)
		is_true(absf(_off_deg()) < 0.1, "in the end %f deg off" % _off_deg())


func test_ten_minutes_of_drift_stay_unseen() -> void:
	_begin("Boxing_Toes.bvh", 30.0)
	_scene.drift = deg_to_rad(3.0) / 60.0
	_scene.noise = deg_to_rad(0.5)
	var worst_m: float = 0.0
	var worst_deg: float = 0.0
	for _part: int in 60:
		_run(10.0)
		for hand: int in [Limbs.LEFT_HAND, Limbs.RIGHT_HAND]:
			var seen: Vector3 = _figure().bases[hand]
			worst_m = maxf(worst_m, seen.distance_to(_scene.figure.bases[hand]))
		worst_deg = maxf(worst_deg, absf(_off_deg()))
	is_true(worst_deg < 2.0, "%f deg" % worst_deg)
	is_true(worst_m < 0.05, "%f m" % worst_m)


func test_the_view_is_not_touched() -> void:
	_begin("01_01.bvh")
	_scene.heading = 0.5
	for _step: int in 60:
		_scene.advance()
		var before: Transform3D = _scene.frame.head
		_fusion.apply(_scene.suit, _scene.frame)
		equal(_scene.frame.head, before)


func test_the_first_sample_and_a_recentre_are_taken_at_once() -> void:
	_begin("01_01.bvh")
	_scene.heading = 2.0
	_run(0.05)
	is_true(absf(_off_deg()) < 0.5, "%f deg" % _off_deg())
	_scene.heading = -2.9
	_fusion.recentre()
	_run(0.05)
	is_true(absf(_off_deg()) < 0.5, "%f deg" % _off_deg())


func test_the_head_is_under_the_headset() -> void:
	_begin("01_01.bvh")
	_scene.heading = 1.0
	_scene.travels = false
	for _part: int in 20:
		_run(1.0)
		var head: int = Limbs.HEAD
		var off: float = _figure().bases[head].distance_to(_scene.figure.bases[head])
		is_true(off < 0.03, "the head is %f m off" % off)
		var turn: float = Rotations.between_deg(
			_scene.suit.orientation(head), _scene.truth.orientation(head)
		)
		is_true(turn < 0.1, "the head is turned by %f deg" % turn)


func test_a_lost_headset_is_no_jump_and_comes_back_without_one() -> void:
	for source: HeadFusion.Source in [HeadFusion.Source.HMD, HeadFusion.Source.BOTH]:
		_begin("01_01.bvh")
		_fusion.position = source
		_scene.travels = false
		_scene.heading = 1.0
		_run(3.0)
		var last: Vector3 = _scene.suit.root
		var last_head: Quaternion = _scene.suit.orientation(Limbs.HEAD)
		for step: int in 600:
			_scene.advance()
			if step < 300:
				_scene.frame.lose_all()
			_fusion.apply(_scene.suit, _scene.frame)
			var way: float = _scene.suit.root.distance_to(last)
			is_true(way < 0.1, "a step of %f m at %d" % [way, step])
			last = _scene.suit.root
			var turn: float = Rotations.between_deg(_scene.suit.orientation(3), last_head)
			is_true(turn < 12.0, "the head jumped by %f deg at %d" % [turn, step])
			last_head = _scene.suit.orientation(Limbs.HEAD)
		var off: Vector3 = _scene.suit.root - _scene.truth.root
		is_true(off.length() < 0.1, "back at its place: %s" % off)


func test_sources_can_be_chosen() -> void:
	_begin("Boxing_Toes.bvh")
	_fusion.orientation = HeadFusion.Source.SUIT
	_fusion.position = HeadFusion.Source.SUIT
	_fusion.reaches = false
	_scene.heading = 0.7
	for _step: int in 120:
		_scene.advance()
		var before: PackedFloat32Array = _scene.suit.orientations.duplicate()
		var root: Vector3 = _scene.suit.root
		_fusion.apply(_scene.suit, _scene.frame)
		equal(_scene.suit.orientations, before)
		almost_equal(_scene.suit.root, root, 1e-4)
	# A suit without a sensor on the head: the chest says where it faces, on the whole.
	_begin("01_01.bvh")
	_fusion.orientation = HeadFusion.Source.HMD
	_scene.pace = 0.0
	_scene.heading = 1.2
	_run(1.0)
	is_true(absf(_off_deg()) < 25.0, "%f deg" % _off_deg())
	almost_equal(_scene.suit.orientation(3), _scene.truth.orientation(3), 1e-4)


func test_a_place_from_the_suit_turns_about_the_wearer() -> void:
	_begin("Boxing_Toes.bvh")
	_fusion.position = HeadFusion.Source.SUIT
	_scene.pace = 0.0
	_run(1.0)
	var place: Vector3 = _scene.suit.root
	_scene.drift = deg_to_rad(1.0)
	_scene.travels = false
	_fusion.recentre()
	_run(0.1)
	place = _scene.suit.root
	_run(20.0)
	almost_equal(_scene.suit.root, place, 1e-4, "only turned")


func test_a_tracker_at_the_waist_gives_the_place_without_a_headset() -> void:
	for seen_before: bool in [false, true]:
		_begin("01_01.bvh")
		_scene.travels = false
		var worn: Transform3D = Transform3D(Basis(Vector3.RIGHT, 0.5), Vector3(0, 0.03, 0.0))
		for step: int in 600:
			_scene.advance()
			var hips: Basis = Basis(_scene.truth.orientation(0))
			_scene.frame.pins[XrFrame.Pin.WAIST] = Transform3D(hips, _scene.truth.root) * worn
			_scene.frame.has_pins[XrFrame.Pin.WAIST] = 1
			_scene.frame.has_place = seen_before and step < 120
			_fusion.apply(_scene.suit, _scene.frame)
			if step > 300:
				var off: float = _scene.suit.root.distance_to(_scene.truth.root)
				is_true(off < 0.08, "the hips are %f m off at %d" % [off, step])


func test_a_look_to_the_side_does_not_turn_a_suit_without_a_head() -> void:
	_begin("01_01.bvh")
	_fusion.orientation = HeadFusion.Source.HMD
	_scene.pace = 0.0
	_run(30.0)
	var before: float = _fusion.correction()
	for step: int in 60 * 5:
		_scene.advance()
		_scene.frame.head.basis = (
			Basis(Vector3.UP, minf(step * 0.03, 1.0)) * _scene.frame.head.basis
		)
		_fusion.apply(_scene.suit, _scene.frame)
	is_true(absf(angle_difference(before, _fusion.correction())) < deg_to_rad(5.0))


func test_a_head_turned_beyond_the_neck_takes_the_chest_along() -> void:
	_begin("01_01.bvh")
	_scene.pace = 0.0
	_run(0.5)
	for _step: int in 30:
		_scene.advance()
		_scene.frame.head.basis = Basis(Vector3.UP, 2.4) * _scene.frame.head.basis
		_fusion.apply(_scene.suit, _scene.frame)
	var neck: float = Rotations.between_deg(
		_scene.suit.orientation(Limbs.HEAD), _scene.suit.orientation(Limbs.CHEST)
	)
	is_true(neck < 76.0, "a neck of %f deg" % neck)
	equal(_scene.suit.find_fault(), "")


func test_a_controller_that_lies_on_a_table_is_not_reached_for() -> void:
	_begin("01_01.bvh")
	_scene.pace = 0.0
	_run(1.0)
	for _step: int in 60:
		_scene.advance()
		_scene.frame.hands[0].origin = Vector3(3.0, 0.8, 1.0)
		_fusion.apply(_scene.suit, _scene.frame)
	var hand: Vector3 = _figure().bases[Limbs.LEFT_HAND]
	var off: float = hand.distance_to(_scene.figure.bases[Limbs.LEFT_HAND])
	is_true(off < 0.03, "%f m from where the suit has it" % off)


func test_a_wrong_size_is_made_up_by_the_arms() -> void:
	_begin("Boxing_Toes.bvh", 60.0, 0.96)
	var worst: float = 0.0
	for _part: int in 20:
		_run(0.7)
		for hand: int in [Limbs.LEFT_HAND, Limbs.RIGHT_HAND]:
			var seen: Vector3 = _figure().bases[hand]
			worst = maxf(worst, seen.distance_to(_scene.figure.bases[hand]))
	is_true(worst < 0.05, "%f m" % worst)


func test_a_headset_worn_askew_is_found_by_nods_and_turns() -> void:
	_begin("01_01.bvh")
	_scene.pace = 0.0
	_scene.mount = Quaternion.from_euler(Vector3(0.15, 0.1, 0.0))
	_scene.heading = 0.8
	var looks: Quaternion = Quaternion.IDENTITY
	for step: int in 60 * 14:
		_scene.advance()
		looks = Quaternion.from_euler(Vector3(sin(step * 0.03) * 0.4, sin(step * 0.02) * 0.7, 0.0))
		_scene.nod(looks)
		_fusion.apply(_scene.suit, _scene.frame)
	is_true(_fusion.mount.is_solved)
	var off: float = Rotations.between_deg(_fusion.mount.turn, _scene.mount)
	is_true(off < 1.0, "%f deg" % off)


func test_nothing_known_changes_nothing() -> void:
	_begin("01_01.bvh")
	for _step: int in 60:
		_scene.advance()
		var before: PackedFloat32Array = _scene.suit.orientations.duplicate()
		_scene.frame.lose_all()
		_fusion.apply(_scene.suit, _scene.frame)
		equal(_scene.suit.orientations, before)


func _begin(p_clip: String, p_rate: float = 60.0, p_ratio: float = 1.0) -> void:
	_scene = Scene.new(p_clip)
	_scene.rate = p_rate
	_scene.length_ratio = p_ratio
	_fusion = HeadFusion.new(_scene.size())
	_worst_turn = 0.0
	_last_turn = NAN


func _run(p_seconds: float) -> void:
	for _step: int in roundi(p_seconds * _scene.rate):
		_scene.advance()
		_fusion.apply(_scene.suit, _scene.frame)
		if is_finite(_last_turn):
			var turn: float = absf(angle_difference(_last_turn, _fusion.correction()))
			_worst_turn = maxf(_worst_turn, turn * _scene.rate)
		_last_turn = _fusion.correction()


## How far the hips are turned from the truth, deg.
func _off_deg() -> float:
	var off: Quaternion = _scene.suit.orientation(0) * _scene.truth.orientation(0).inverse()
	return rad_to_deg(Rotations.yaw_of(off))


func _figure() -> BodySegments:
	var figure: BodySegments = BodySegments.new(_scene.size())
	figure.solve(_scene.suit)
	return figure
