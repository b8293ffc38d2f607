extends TestCase
## Who looks into the mirror sees the body that the session will show: its pose, its size, its
## avatar, the right hand on the right of the picture.

const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")
const RATE: float = 60.0

var _mirror: MirrorView = null
var _body: MirrorBody = null
var _source: BvhSource = BvhSource.new()
var _heights: Array[float] = []
var _now_usec: int = 0


func before_each() -> void:
	get_window().size = Vector2i(1280, 720)
	_heights.clear()
	_now_usec = Time.get_ticks_usec()
	_mirror = MirrorView.new()
	_mirror.size = Vector2(640.0, 480.0)
	add_child(_mirror)
	_body = MirrorBody.new(PERSON, RATE)
	_body.made.connect(
		func(height: float) -> void:
			_heights.append(height)
			_mirror.begin(height)
	)
	_mirror.stage.add_child(_body)
	_source.open("res://assets/motion/01_01.bvh")


func after_each() -> void:
	_mirror.free()


func test_every_limb_has_the_pose_of_the_source() -> void:
	var motion: ClientMotion = _motion_of(_source)
	for step: int in 120:
		var sample: PoseSample = _source.pose_at(step / RATE)
		_show(motion, sample)
		for limb: int in Limbs.COUNT if step % 20 == 19 else 0:
			# Shown between this sample and the one before.
			var off: float = _turn_of(limb).angle_to(sample.orientation(limb))
			is_true(off < deg_to_rad(4.0), "%s is off by %f rad" % [Limbs.BONES[limb], off])


func test_a_right_arm_that_is_raised_is_on_the_right_of_the_picture() -> void:
	var motion: ClientMotion = _motion_of(_source)
	for heading: float in [0.0, 2.0]:
		_mirror.begin(1.8)
		for step: int in 10:
			_show(motion, _pointing(heading))
		for from: MirrorView.Direction in [MirrorView.Direction.FRONT, MirrorView.Direction.BACK]:
			_mirror.show_from(from)
			var hand: Vector2 = _mirror.seen_at(_body.view.hands()[1])
			var head: Vector2 = _mirror.seen_at(_body.view.head_joint())
			is_true(hand.x > head.x + 20.0, "seen from %d: %s, head %s" % [from, hand, head])
			is_true(hand.y < head.y - 20.0, "the hand is above the head")
			is_true(Rect2(Vector2.ZERO, _mirror.size).has_point(hand), str(hand))


func test_feet_stand_on_the_floor() -> void:
	_source.open("res://assets/motion/Boxing_Toes.bvh")
	var motion: ClientMotion = _motion_of(_source)
	for step: int in 600:
		_show(motion, _source.pose_at(step / RATE))
		var lower: float = _lower_ankle()
		is_true(lower > 0.05 and lower < 0.2, "an ankle is %f m above the floor" % lower)


func test_a_jump_is_seen_and_whoever_goes_away_stays_in_the_picture() -> void:
	var motion: ClientMotion = _motion_of(_source)
	var highest: float = 0.0
	for step: int in 1200:
		_show(motion, _source.pose_at(step / RATE))
		highest = maxf(highest, _lower_ankle())
		var feet: PackedVector3Array = _body.view.feet()
		for point: Vector3 in [_body.view.head_joint(), feet[0], feet[1]]:
			var seen: Vector2 = _mirror.seen_at(point)
			# The highest of a jump may touch the edge.
			is_true(Rect2(Vector2.ZERO, _mirror.size).grow(8.0).has_point(seen), str(seen))
	is_true(highest > 0.3, "the highest is %f m" % highest)


func test_the_body_has_the_wearers_size_and_avatar() -> void:
	var motion: ClientMotion = _motion_of(_source)
	_body.show_motion(motion, "")
	var usual: float = _heights[0]
	var lengths: PackedFloat32Array = BodyScale.own_lengths(_body.view.node)
	for limb: int in Limbs.COUNT:
		lengths[limb] *= 0.85
	motion.card.take_size(0.85 * _body.view.node.get_hip_height(), lengths)
	_body.show_motion(motion, "")
	almost_equal(_heights[-1] / usual, 0.85, 0.02, "fitted as in the session")
	_body.show_motion(motion, "")
	equal(_heights.size(), 2, "nothing is made anew without need")
	var before: String = _body.view.node.scene_file_path
	_body.show_motion(motion, "raider")
	not_equal(_body.view.node.scene_file_path, before)
	equal(_body.get_child_count(), 1)


func test_without_a_motion_somebody_stands_there() -> void:
	_body.show_motion(null, "civilian_man")
	is_true(_body.advance(_now_usec, 0.02))
	is_true(_body.view.node.visible)
	for hand: Vector3 in _body.view.hands():
		is_true(hand.y < _body.view.hips().y, "the arms hang down")


func test_it_is_nobody_in_the_world() -> void:
	_body.show_motion(null, "")
	equal(get_tree().get_nodes_in_group(Ragdoll.PEOPLE).size(), 0)


func _lower_ankle() -> float:
	var feet: PackedVector3Array = _body.view.feet()
	return minf(feet[0].y, feet[1].y) - _body.floor_height


func _motion_of(p_source: MotionSource) -> ClientMotion:
	var motion: ClientMotion = ClientMotion.new()
	motion.source = p_source
	motion.card.take_size(p_source.get_hip_height(), p_source.get_limb_lengths())
	return motion


## One frame, at the end of which the sample is half a period old.
func _show(p_motion: ClientMotion, p_sample: PoseSample) -> void:
	_now_usec += roundi(1e6 / RATE)
	p_sample.time_usec = _now_usec + MotionSender.unix_ahead()
	p_motion.taken = [p_sample]
	p_motion.newest = p_sample
	_body.show_motion(p_motion, "")
	is_true(_body.advance(_now_usec, 1.0 / RATE))
	var view: ActorView = _body.view
	_mirror.follow(view.hips(), _body.floor_height, view.heading(), 1.0 / RATE)


## Somebody who faces somewhere (angle about the vertical, rad) and has the right arm up.
func _pointing(p_heading: float) -> PoseSample:
	var sample: PoseSample = CalibrationGuide.countdown(ResetPose.Kind.N).pose_at(0.0)
	sample.root = Vector3(0.0, _source.get_hip_height(), 0.0)
	for limb: int in [Limbs.RIGHT_UPPER_ARM, Limbs.RIGHT_LOWER_ARM, Limbs.RIGHT_HAND]:
		# In the reset pose it points to -X.
		sample.set_orientation(limb, Quaternion(Vector3.FORWARD, deg_to_rad(70.0)))
	for limb: int in Limbs.COUNT:
		var turn: Quaternion = Quaternion(Vector3.UP, p_heading) * sample.orientation(limb)
		sample.set_orientation(limb, turn)
	return sample


## How a limb's body is turned from the reset pose.
func _turn_of(p_limb: int) -> Quaternion:
	var node: Ragdoll = _body.view.node
	var bone: StringName = Limbs.BONES[p_limb]
	var body: PhysicalBone3D = node.get_simulator().get_node(NodePath(bone))
	var shown: Basis = (node.get_bone_transform(bone) * body.body_offset).basis
	var reset: Quaternion = node.profile.find(bone).reset_orientation
	return shown.get_rotation_quaternion() * reset.inverse()
