extends TestCase
## The motion that emulated suits are worn with.

const HEAD_BYTES: int = 32

var _motion: SuitMotion = SuitMotion.new()


func _init() -> void:
	_motion.calibration.kind = CalibrationGuide.Kind.FULL
	_motion.clip = BvhSource.new()
	_motion.clip.open("res://assets/motion/01_01.bvh")


func test_no_clip_is_no_motion() -> void:
	is_true(SuitMotion.new().encode().is_empty())
	_motion.clip = BvhSource.new()
	_motion.clip.open("res://nothing.bvh")
	is_true(_motion.encode().is_empty())


func test_the_file_is_as_long_as_it_says() -> void:
	var bytes: PackedByteArray = _motion.encode()
	equal(bytes.slice(0, 8).get_string_from_ascii(), "XBMOTION")
	var limbs: int = bytes.decode_u32(12)
	var frames: int = bytes.decode_u32(24)
	equal(limbs, BodyMounts.COUNT)
	equal(bytes.size(), HEAD_BYTES + limbs * 32 + frames * limbs * 28)
	equal(bytes.slice(HEAD_BYTES, HEAD_BYTES + 32).get_string_from_ascii(), "pelvis")
	var lead_s: float = bytes.decode_u32(28) / 100.0
	almost_equal(lead_s, _motion.calibration_s() + SuitMotion.PASSAGE_S, 0.011)


func test_the_wearer_begins_in_the_t_pose_and_faces_north() -> void:
	var pose: PoseSample = _motion.pose_at(0.0)
	for limb: int in BodyMounts.LIMBS:
		almost_equal(pose.orientation(limb).angle_to(Quaternion.IDENTITY), 0.0, 1e-3)


func test_nothing_jumps() -> void:
	var begin: float = _motion.calibration_s()
	var period: float = _motion.clip.get_period()
	var before: PoseSample = null
	# Across the passage into the clip, and across the seam of its loop.
	for step: int in 60:
		var time: float = begin - 0.1 + step * 0.02
		var pose: PoseSample = _motion.pose_at(time)
		for limb: int in BodyMounts.LIMBS if before != null else [] as Array[int]:
			is_true(pose.orientation(limb).angle_to(before.orientation(limb)) < 0.3)
		before = pose
	var first: PoseSample = _motion.pose_at(begin + SuitMotion.PASSAGE_S)
	var last: PoseSample = _motion.pose_at(begin + SuitMotion.PASSAGE_S + period)
	for limb: int in BodyMounts.LIMBS:
		is_true(first.orientation(limb).angle_to(last.orientation(limb)) < 0.02)


func test_axes_are_those_of_the_suit() -> void:
	# The bow: the trunk turns about Godot's X, which is the suit's Y (to the left).
	var bytes: PackedByteArray = _motion.encode()
	var limbs: int = BodyMounts.COUNT
	var largest: float = 0.0
	for frame: int in roundi(_motion.calibration_s() * _motion.rate_hz):
		var at: int = HEAD_BYTES + limbs * 32 + (frame * limbs + BodyMounts.STERNUM) * 28
		var turn: Quaternion = Quaternion(
			bytes.decode_float(at + 4),
			bytes.decode_float(at + 8),
			bytes.decode_float(at + 12),
			bytes.decode_float(at)
		)
		almost_equal(turn.length(), 1.0, 1e-4)
		is_true(absf(turn.y) >= absf(turn.x) - 1e-5)
		is_true(absf(turn.y) >= absf(turn.z) - 1e-5)
		largest = maxf(largest, absf(turn.get_angle()))
	is_true(largest > deg_to_rad(15.0))
