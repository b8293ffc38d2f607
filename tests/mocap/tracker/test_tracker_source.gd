extends TestCase
## Motion goes out as a body tracker that avatars can wear, and comes in from one.

const NAME: StringName = &"/test/body_tracker"
const CLIP: String = "res://assets/motion/Boxing_Toes.bvh"

var _publisher: TrackerPublisher = null
var _clip: BvhSource = null


func before_each() -> void:
	_clip = BvhSource.new()
	_clip.open(CLIP)
	_publisher = TrackerPublisher.new(_clip.get_body(), NAME)


func after_each() -> void:
	_publisher.retire()


func test_there_and_back_again() -> void:
	var source: TrackerSource = TrackerSource.new(NAME)
	for step: int in 40:
		var pose: PoseSample = _clip.pose_at(step * 0.4)
		_publisher.publish(pose)
		source.advance(1000 + step)
		var again: PoseSample = source.sample(5)
		equal(source.error, "")
		equal(again.time_usec, 1000 + step)
		equal(again.id, step)
		for limb: int in Limbs.COUNT:
			var off: float = Rotations.between_deg(again.orientation(limb), pose.orientation(limb))
			is_true(off < 0.01, "%s is off by %f deg" % [Limbs.BONES[limb], off])
		almost_equal(again.root, pose.root, 1e-5)
	is_null(source.sample(6), "nothing new")
	almost_equal(source.get_hip_height(), _clip.get_hip_height(), 0.02)


func test_an_avatar_wears_it() -> void:
	var node: XRNode3D = XRNode3D.new()
	node.tracker = NAME
	var skeleton: Skeleton3D = _humanoid()
	var modifier: XRBodyModifier3D = XRBodyModifier3D.new()
	modifier.body_tracker = NAME
	skeleton.add_child(modifier)
	node.add_child(skeleton)
	add_child(node)
	var figure: BodySegments = BodySegments.new(_clip.get_body())
	for step: int in 5:
		var pose: PoseSample = _clip.pose_at(step * 1.3)
		_publisher.publish(pose)
		figure.solve(pose)
		await skeleton.skeleton_updated
		var places: Array[Vector3] = []
		var turns: Array[Quaternion] = []
		for limb: int in Limbs.COUNT:
			var bone: int = skeleton.find_bone(Limbs.BONES[limb])
			var at: Transform3D = node.transform * skeleton.get_bone_global_pose(bone)
			places.append(at.origin)
			turns.append(at.basis.get_rotation_quaternion())
		for limb: int in Limbs.COUNT:
			var wanted: Quaternion = pose.orientation(limb) * HumanoidAxes.of_limb(limb)
			almost_equal(turns[limb], wanted, 1e-3, Limbs.BONES[limb])
			almost_equal(places[limb], figure.bases[limb], 1e-3, Limbs.BONES[limb])
	node.queue_free()
	await process_frames(2)


func test_fingers_of_an_avatar() -> void:
	var skeleton: Skeleton3D = _humanoid()
	var modifier: XRBodyModifier3D = XRBodyModifier3D.new()
	modifier.body_tracker = NAME
	skeleton.add_child(modifier)
	add_child(skeleton)
	var pose: PoseSample = _clip.pose_at(1.0)
	pose.details = MotionDetails.new()
	var joints: PackedInt32Array = FingerJoints.of_hand(0) + FingerJoints.of_hand(1)
	equal(joints.size(), 30)
	for joint: int in joints:
		equal(FingerJoints.hand_of(joint), 0 if joint < XRBodyTracker.JOINT_RIGHT_HAND else 1)
		is_true(skeleton.find_bone(FingerJoints.bone_of(joint)) >= 0)
		pose.details.joints[joint] = Quaternion(Vector3.FORWARD, 0.05 * (joint % 20))
	_publisher.publish(pose)
	await skeleton.skeleton_updated
	var root: Transform3D = _publisher.tracker.get_joint_transform(XRBodyTracker.JOINT_ROOT)
	for joint: int in joints:
		var at: Transform3D = (
			root * skeleton.get_bone_global_pose(skeleton.find_bone(FingerJoints.bone_of(joint)))
		)
		var axes: Quaternion = HumanoidAxes.of_bone(FingerJoints.bone_of(joint))
		var note: String = FingerJoints.bone_of(joint)
		almost_equal(
			at.basis.get_rotation_quaternion(), pose.details.joints[joint] * axes, 1e-3, note
		)
		var above: Transform3D = _publisher.tracker.get_joint_transform(
			FingerJoints.parent_of(joint) as XRBodyTracker.Joint
		)
		var length: float = above.origin.distance_to(at.origin)
		is_true(length > 0.01 and length < 0.15, "%s is %f m away" % [note, length])
	var source: TrackerSource = TrackerSource.new(NAME)
	source.advance(1)
	var again: PoseSample = source.sample(1)
	for joint: int in joints:
		almost_equal(again.details.joints[joint], pose.details.joints[joint], 1e-4)
	skeleton.queue_free()
	await process_frames(2)


func test_flags_and_names() -> void:
	equal(XRServer.get_tracker(NAME), _publisher.tracker)
	is_false(_publisher.tracker.has_tracking_data)
	_publisher.publish(_clip.pose_at(0.0))
	is_true(_publisher.tracker.has_tracking_data)
	for joint: XRBodyTracker.Joint in HumanoidAxes.JOINTS:
		equal(int(_publisher.tracker.get_joint_flags(joint)), 15)
	equal(int(_publisher.tracker.get_joint_flags(XRBodyTracker.JOINT_ROOT)), 15)
	contains(TrackerSource.list(), String(NAME))
	equal(TrackerPublisher.name_for(0), &"/dismount/body_tracker")
	equal(TrackerPublisher.name_for(1), &"/dismount/body_tracker_2")
	_publisher.pause()
	is_false(_publisher.tracker.has_tracking_data)
	_publisher.retire()
	is_null(XRServer.get_tracker(NAME))


func test_joints_that_nothing_is_known_of_have_no_flags() -> void:
	_publisher.publish(_clip.pose_at(0.0))
	var set_joints: int = 0
	for joint: int in XRBodyTracker.JOINT_MAX:
		var flags: int = _publisher.tracker.get_joint_flags(joint as XRBodyTracker.Joint)
		is_true(flags == 0 or flags == 15, "joint %d has flags %x" % [joint, flags])
		set_joints += 1 if flags == 15 else 0
		if FingerJoints.hand_of(joint) >= 0:
			equal(flags, 0)
	equal(set_joints, Limbs.COUNT + HumanoidAxes.OTHERS.size() + 2, "root and top of the head too")


func test_fingers_that_are_lost_lose_their_flags() -> void:
	var pose: PoseSample = _clip.pose_at(0.0)
	pose.details = MotionDetails.new()
	for joint: int in FingerJoints.of_hand(1):
		pose.details.joints[joint] = Quaternion.IDENTITY
	_publisher.publish(pose)
	var finger: XRBodyTracker.Joint = FingerJoints.of_hand(1)[3] as XRBodyTracker.Joint
	var hands: XRBodyTracker.BodyFlags = XRBodyTracker.BODY_FLAG_HANDS_SUPPORTED
	equal(int(_publisher.tracker.get_joint_flags(finger)), 15)
	not_equal(_publisher.tracker.body_flags & hands, 0)
	_publisher.publish(_clip.pose_at(0.1))
	equal(int(_publisher.tracker.get_joint_flags(finger)), 0)
	equal(_publisher.tracker.body_flags & hands, 0)


func test_the_root_is_as_in_the_engine_s_plugins() -> void:
	for heading: float in [0.0, 1.0, -2.5]:
		var pose: PoseSample = PoseSample.new()
		for limb: int in Limbs.COUNT:
			pose.set_orientation(limb, Rotations.yaw(heading))
		_publisher.publish(pose)
		var hips: Transform3D = _publisher.tracker.get_joint_transform(XRBodyTracker.JOINT_HIPS)
		# As OpenXR's and the VMC plugin form it from the hips.
		var back: Vector3 = -hips.basis.x.cross(Vector3.UP)
		var root: Transform3D = _publisher.tracker.get_joint_transform(XRBodyTracker.JOINT_ROOT)
		almost_equal(root.basis.z, back, 1e-5)
		almost_equal(-root.basis.z, Rotations.yaw(heading) * Vector3.BACK, 1e-5, "-Z is ahead")
		almost_equal(root.basis.y, Vector3.UP, 1e-5)


func test_flags_that_no_plugin_has_set_say_nothing() -> void:
	var tracker: XRBodyTracker = _publisher.tracker
	var clip_pose: PoseSample = _clip.pose_at(1.0)
	_publisher.publish(clip_pose)
	# As memory happens to be: any bits, or some that look like flags under the engine's identity.
	for hand: int in 2:
		for joint: int in FingerJoints.of_hand(hand):
			var bits: int = 0x5557 if joint % 2 == 0 else 3
			tracker.set_joint_flags(joint as XRBodyTracker.Joint, bits)
	tracker.set_joint_flags(XRBodyTracker.JOINT_LEFT_HAND, 0x7FFF00000001)
	var source: TrackerSource = TrackerSource.new(NAME)
	source.advance(1)
	var pose: PoseSample = source.sample(1)
	for joint: int in pose.details.joints:
		is_true(FingerJoints.hand_of(joint) < 0, "finger %d was never set" % joint)
	equal(pose.details.measured[6], 0, "the hand follows its forearm")
	var fore: Quaternion = clip_pose.orientation(5)
	is_true(Rotations.between_deg(pose.orientation(6), fore) < 0.01)


func test_filled_limbs_are_not_called_tracked() -> void:
	var pose: PoseSample = _clip.pose_at(0.0)
	pose.details = MotionDetails.new()
	pose.details.measured.resize(Limbs.COUNT)
	_publisher.publish(pose)
	var flags: int = _publisher.tracker.get_joint_flags(XRBodyTracker.JOINT_LEFT_HAND)
	equal(flags & XRBodyTracker.JOINT_FLAG_ORIENTATION_TRACKED, 0)
	not_equal(flags & XRBodyTracker.JOINT_FLAG_ORIENTATION_VALID, 0)


func test_a_tracker_of_the_upper_body_only() -> void:
	_publisher.publish(_clip.pose_at(2.0))
	var upper: Array[XRBodyTracker.Joint] = HumanoidAxes.JOINTS.slice(0, 10)
	for joint: int in XRBodyTracker.JOINT_MAX:
		if not upper.has(joint as XRBodyTracker.Joint):
			_publisher.tracker.set_joint_flags(joint as XRBodyTracker.Joint, 0)
	var source: TrackerSource = TrackerSource.new(NAME)
	source.advance(1)
	var pose: PoseSample = source.sample(2)
	equal(pose.find_fault(), "")
	equal(pose.details.measured[6], 1)
	equal(pose.details.measured[12], 0)
	var down: Vector3 = pose.orientation(11) * Vector3.DOWN
	is_true(down.y < -0.95, "legs of which nothing is known stand")


func test_missing_and_broken_trackers() -> void:
	var source: TrackerSource = TrackerSource.new(&"/nobody")
	source.advance(1)
	contains(source.error, "there is no body tracker '/nobody', only: ")
	contains(source.error, String(NAME))
	is_null(source.sample(1))
	source = TrackerSource.new(NAME)
	source.advance(1)
	is_null(source.sample(1), "no data yet")
	_publisher.publish(_clip.pose_at(0.0))
	var broken: Transform3D = Transform3D(Basis.IDENTITY.scaled(Vector3.ZERO), Vector3.INF)
	for joint: XRBodyTracker.Joint in HumanoidAxes.JOINTS:
		_publisher.tracker.set_joint_transform(joint, broken)
	source.advance(1)
	var pose: PoseSample = source.sample(1)
	equal("" if pose == null else pose.find_fault(), "")


func test_body_trackers_of_any_name_are_found_and_are_sources() -> void:
	var other: TrackerPublisher = TrackerPublisher.new(_clip.get_body(), &"/user/body_tracker/fb")
	var own: TrackerPublisher = TrackerPublisher.new(_clip.get_body())
	other.publish(_clip.pose_at(1.0))
	is_true(TrackerSource.list_others().has("/user/body_tracker/fb"))
	is_false(TrackerSource.list_others().has(String(TrackerPublisher.NAME)))
	var source: TrackerSource = TrackerSource.new(&"/user/body_tracker/fb")
	source.advance(5)
	var limb: Quaternion = _clip.pose_at(1.0).orientation(4)
	is_true(Rotations.between_deg(source.sample(5).orientation(4), limb) < 0.01)
	other.retire()
	own.retire()


## A skeleton with the bones of the humanoid profile, and those that the modifier would miss.
func _humanoid() -> Skeleton3D:
	var skeleton: Skeleton3D = Skeleton3D.new()
	var profile: SkeletonProfileHumanoid = SkeletonProfileHumanoid.new()
	for bone: int in profile.bone_size:
		skeleton.add_bone(profile.get_bone_name(bone))
		skeleton.set_bone_rest(bone, profile.get_reference_pose(bone))
		skeleton.set_bone_pose(bone, profile.get_reference_pose(bone))
	for bone: int in profile.bone_size:
		var parent: StringName = profile.get_bone_parent(bone)
		if parent != &"":
			skeleton.set_bone_parent(bone, skeleton.find_bone(parent))
	for name: String in ["HeadTip", "LowerChest"]:
		skeleton.add_bone(name)
	for side: String in ["Left", "Right"]:
		for finger: String in ["Index", "Middle", "Ring", "Little"]:
			skeleton.add_bone(side + finger + "Metacarpal")
			skeleton.add_bone(side + finger + "Tip")
		for name: String in ["Palm", "Wrist", "ThumbTip", "Scapula", "WristTwist", "FootTwist"]:
			skeleton.add_bone(side + name)
		for name: String in ["Heel", "MiddleFoot"]:
			skeleton.add_bone(side + name)
	return skeleton
