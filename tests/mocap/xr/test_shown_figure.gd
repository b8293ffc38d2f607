extends TestCase
## Hands are where the wearer has them on the body that is shown, too.

const Scene: GDScript = preload("headset_scene.gd")


func test_a_skeleton_has_the_joints_that_it_was_made_of() -> void:
	var joints: PackedVector3Array = BodySize.of_height(1.8).joints()
	var skeleton: PersonSkeleton = _skeleton(joints)
	var figure: ShownFigure = ShownFigure.of_skeleton(skeleton, joints[0].y, joints[0].y)
	almost_equal(figure.joints, joints, 1e-5)
	almost_equal(figure.eye_height, 1.8 * BodySize.EYE_HEIGHT, 1e-4)
	var smaller: ShownFigure = ShownFigure.of_skeleton(skeleton, joints[0].y, joints[0].y / 2.0)
	almost_equal(smaller.joints[6], joints[6] / 2.0, 1e-5)
	is_null(ShownFigure.of_skeleton(PersonSkeleton.new(), 1.0, 1.0))
	is_null(ShownFigure.of_skeleton(skeleton, NAN, 1.0))


func test_a_source_reaches_with_the_arms_that_are_shown() -> void:
	# An avatar whose shoulders are narrower and whose arms are longer than the wearer's usual ones.
	var scene: Scene = Scene.new("01_01.bvh")
	var joints: PackedVector3Array = scene.size().joints()
	for side: int in 2:
		for limb: int in range(4 + 3 * side, 7 + 3 * side):
			joints[limb].x *= 1.04
			joints[limb].y -= 0.03
	var body: XrBodySource = XrBodySource.new(scene.size().height)
	var fused: FusedSource = FusedSource.new(SceneSuit.new(scene))
	for source: MotionSource in [body, fused]:
		equal(source.call("show_on", _skeleton(joints), joints[0].y), "")
		contains(source.call("show_on", PersonSkeleton.new(), 1.0), "no joints of a person")
	for step: int in 120:
		scene.advance()
		body.push(scene.frame)
		fused.push(scene.frame)
		for source: MotionSource in [body, fused]:
			var sample: PoseSample = source.sample(scene.now_usec())
			var hand: Vector3 = _hand(sample, joints)
			if step > 60:
				var off: float = hand.distance_to(scene.frame.hands[0].origin)
				is_true(off < 0.03, "%s: a hand is off by %f m" % [source.describe(), off])


## Where the left hand of a body with joints is in a pose.
static func _hand(p_pose: PoseSample, p_joints: PackedVector3Array) -> Vector3:
	var at: Vector3 = p_pose.root
	var chain: PackedInt32Array = [0, 1, 2, 4, 5, 6]
	for link: int in chain.size() - 1:
		var along: Vector3 = p_joints[chain[link + 1]] - p_joints[chain[link]]
		at += p_pose.orientation(chain[link]) * along
	return at


## A skeleton whose limbs' frames are in the middle of the limbs.
static func _skeleton(p_joints: PackedVector3Array) -> PersonSkeleton:
	var skeleton: PersonSkeleton = PersonSkeleton.new()
	for limb: int in Limbs.COUNT:
		var inner: Vector3 = Vector3(0.01 * limb, -0.02, 0.03)
		var parent: int = Limbs.PARENTS[limb]
		var outer: Vector3 = Vector3.ZERO
		if parent >= 0:
			outer = p_joints[limb] - p_joints[parent] + Vector3(0.01 * parent, -0.02, 0.03)
		skeleton.add(outer, inner, Quaternion.IDENTITY)
	return skeleton


## The suit of a scene.
class SceneSuit:
	extends MotionSource
	var scene: Scene = null

	func _init(p_scene: Scene) -> void:
		scene = p_scene

	func get_body() -> BodySize:
		return scene.size()

	func get_hip_height() -> float:
		return scene.size().length(&"hip_height")

	func _read(_p_time_usec: int) -> PoseSample:
		return scene.suit
