extends TestCase
## A source with a headset is a source as any other, also in a thread of its own.

const Scene: GDScript = preload("headset_scene.gd")


## The suit of a scene.
class SceneSuit:
	extends MotionSource
	var scene: Scene = null

	func get_body() -> BodySize:
		return scene.size()

	func _read(_p_time_usec: int) -> PoseSample:
		return scene.suit


func test_samples_fit_the_headset_at_their_own_moment() -> void:
	var suit: SceneSuit = SceneSuit.new()
	suit.scene = Scene.new("01_01.bvh")
	suit.scene.heading = 1.0
	var source: FusedSource = FusedSource.new(suit)
	contains(source.describe(), "with a headset")
	for step: int in 300:
		suit.scene.advance()
		# The headset is a little ahead, and comes at a rate of its own.
		var frame: XrFrame = XrFrame.new()
		frame.copy(suit.scene.frame)
		source.push(frame)
		var sample: PoseSample = source.sample(suit.scene.now_usec())
		equal(sample.id, step)
		almost_equal(sample.orientation(3), suit.scene.truth.orientation(3), 1e-3)
	almost_equal(source.correction(), -1.0, 0.02)
	suit.scene.heading = -1.0
	source.recentre()
	suit.scene.advance()
	source.push(suit.scene.frame)
	source.sample(suit.scene.now_usec())
	almost_equal(source.correction(), 1.0, 0.05)


func test_a_source_keeps_its_own_pose() -> void:
	# A suit blends from its last pose into another calibration.
	var suit: SceneSuit = SceneSuit.new()
	suit.scene = Scene.new("01_01.bvh")
	suit.scene.heading = 1.0
	var source: FusedSource = FusedSource.new(suit)
	suit.scene.advance()
	suit.scene.suit.details = MotionDetails.new()
	suit.scene.suit.details.joints[XRBodyTracker.JOINT_NECK] = Quaternion.IDENTITY
	var before: PackedFloat32Array = suit.scene.suit.orientations.duplicate()
	source.push(suit.scene.frame)
	var sample: PoseSample = source.sample(suit.scene.now_usec())
	not_equal(sample.orientations, before)
	equal(suit.scene.suit.orientations, before)
	equal(suit.scene.suit.details.joints[XRBodyTracker.JOINT_NECK], Quaternion.IDENTITY)
	not_equal(sample.details.joints[XRBodyTracker.JOINT_NECK], Quaternion.IDENTITY)


func test_it_runs_in_a_sampler() -> void:
	var clip: BvhSource = BvhSource.new()
	clip.open("res://assets/motion/01_01.bvh")
	var source: FusedSource = FusedSource.new(clip)
	var sampler: MotionSampler = MotionSampler.new()
	sampler.add_source(0, source)
	sampler.start(60.0, func(_p_samples: Array[PoseSample]) -> void: pass)
	var taken: Array[PoseSample] = []
	var end: int = Time.get_ticks_msec() + 20_000
	var frame: XrFrame = XrFrame.new()
	frame.has_head = true
	frame.has_place = true
	var is_there: bool = false
	# A busy machine may let the sampler run for a while without frames of the headset.
	while (taken.size() < 20 or not is_there) and Time.get_ticks_msec() < end:
		frame.time_usec = roundi(Time.get_unix_time_from_system() * 1e6)
		frame.head.origin = Vector3(5.0, 1.6, 2.0)
		source.push(frame)
		taken.append_array(sampler.take_samples(0))
		if not taken.is_empty():
			var root: Vector3 = taken[-1].root
			is_there = Vector2(root.x - 5.0, root.z - 2.0).length() < 1.0
		await get_tree().process_frame
	sampler.stop()
	is_true(taken.size() >= 20)
	equal(taken[-1].find_fault(), "")
	is_true(is_there, str(taken[-1].root))


func test_without_motion_there_is_none() -> void:
	var nothing: MotionSource = MotionSource.new()
	nothing.error = "no suit"
	var source: FusedSource = FusedSource.new(nothing)
	is_null(source.sample(5))
	equal(source.error, "no suit")
