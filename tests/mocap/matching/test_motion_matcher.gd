extends TestCase
## Walkers by the set that is shipped: a mover's state becomes a person's pose.

const DELTA: float = 1.0 / 60.0

var _set: MotionSet = null


func before_each() -> void:
	_set = MotionSet.new()
	equal(_set.load_file("res://assets/motion/walker.motionset"), "")


func test_a_walker_walks_and_stops() -> void:
	var matcher: MotionMatcher = _matcher()
	var place: Vector3 = Vector3.ZERO
	var clips: Dictionary[String, bool] = {}
	for tick: int in 240:
		var speed: float = 1.4 if tick < 160 else 0.0
		place.z += speed * DELTA
		var velocity: Vector3 = Vector3(0, 0, speed)
		matcher.advance(DELTA, place, velocity, 0.0, velocity, 0.0, MotionMatcher.STAND, true)
		var pose: PoseSample = PoseSample.new()
		pose.orientations = matcher.get_orientations()
		pose.root = matcher.get_root()
		equal(pose.find_fault(), "")
		clips[matcher.get_clip_name()] = true
		is_true(Vector2(pose.root.x - place.x, pose.root.z - place.z).length() < 0.1)
	is_true(clips.size() > 1)
	equal(matcher.get_clip_name().get_slice("|", 0), "stand")
	for sole: Vector3 in matcher.get_soles():
		is_true(absf(sole.y) < 0.02)


func test_a_copy_goes_on_alike() -> void:
	var matcher: MotionMatcher = _matcher()
	_walk(matcher, 50)
	var copy: MotionMatcher = matcher.copy()
	_walk(matcher, 50)
	_walk(copy, 50)
	equal(copy.get_orientations(), matcher.get_orientations())
	equal(copy.get_root(), matcher.get_root())


func test_all_stances_are_poses() -> void:
	for stance: int in [
		MotionMatcher.STAND,
		MotionMatcher.CROUCH,
		MotionMatcher.PRONE,
		MotionMatcher.LADDER,
		MotionMatcher.VAULT,
	]:
		var matcher: MotionMatcher = _matcher()
		for tick: int in 60:
			matcher.advance(DELTA, Vector3.ZERO, Vector3.ZERO, 0.0, Vector3.ZERO, 0.0, stance, true)
		var pose: PoseSample = PoseSample.new()
		pose.orientations = matcher.get_orientations()
		equal(pose.find_fault(), "")
		# No T-pose: both arms are nowhere near level and sideways.
		var left: Vector3 = pose.orientation(Limbs.LEFT_UPPER_ARM) * Vector3.RIGHT
		is_true(left.dot(Vector3.RIGHT) < 0.8)


func test_a_body_of_another_size_stands_on_the_ground() -> void:
	for hips: float in [0.7, 0.95, 1.15]:
		var matcher: MotionMatcher = MotionMatcher.new()
		matcher.set_motion_set(_set)
		matcher.set_body(hips, PackedFloat32Array())
		matcher.reset(Vector3(3, 1, -2), 1.0)
		for tick: int in 30:
			var place: Vector3 = Vector3(3, 1, -2)
			matcher.advance(DELTA, place, Vector3.ZERO, 1.0, Vector3.ZERO, 1.0, 0, true)
		is_true(absf(matcher.get_soles()[1].y - 1.0) < 0.01)
		is_true(absf(matcher.get_root().y - 1.0 - hips) < 0.06 * hips)


func test_hostile_files_are_refused() -> void:
	equal(_set.load_file("res://assets/motion/none.motionset").get_slice(" ", 0), "there")
	var frames: int = _set.get_frame_count()
	equal(_set.load_bytes(PackedByteArray()), "this is no motion set")
	equal(_set.load_bytes("DMMS_______".to_ascii_buffer()).get_slice(" ", 0), "this")
	# It stays what it was.
	equal(_set.get_frame_count(), frames)


func _matcher() -> MotionMatcher:
	var matcher: MotionMatcher = MotionMatcher.new()
	matcher.set_motion_set(_set)
	matcher.set_body(0.95, PackedFloat32Array())
	matcher.reset(Vector3.ZERO, 0.0)
	return matcher


func _walk(p_matcher: MotionMatcher, p_ticks: int) -> void:
	var velocity: Vector3 = Vector3(0.3, 0, 1.4)
	for tick: int in p_ticks:
		p_matcher.advance(DELTA, velocity * tick * DELTA, velocity, 0.2, velocity, 0.4, 0, true)
