class_name WalkerPose
extends RefCounted
## The body of somebody who walks: poses out of a motion set ([MotionMatcher]) that go where the
## mover goes, and look where the eyes do.

## The motion set of everybody who has none of their own.
const DEFAULT_SET: String = "res://assets/motion/walker.motionset"
## How far a head turns from where the body faces, rad.
const MAX_NECK: float = 1.2

static var _default: MotionSet = null

## Height of the hips, m.
var hip_height: float = 0.95

var _matcher: MotionMatcher = MotionMatcher.new()


func _init() -> void:
	prepare()
	_matcher.set_motion_set(_default)


## Reads the set of everybody, which takes most of a tick: call it before nobody may wait for that.
static func prepare() -> void:
	if _default != null:
		return
	_default = MotionSet.new()
	var fault: String = _default.load_file(DEFAULT_SET)
	if fault != "":
		Log.error("walker", fault)


## Goes on by a set of the person's own, from the pose at hand; null: by that of everybody.
func use_set(p_set: WalkerSet) -> void:
	_matcher.change_motion_set(p_set.motion if p_set != null else _default)


## Takes the body that it moves: height of the hips, m, and the joints.
func set_body(p_hip_height: float, p_joints: PersonSkeleton) -> void:
	hip_height = p_hip_height
	_matcher.set_joints(p_hip_height, p_joints.joints_in_parent, p_joints.joints_in_limb)


## Begins where the mover is.
func restart(p_mover: WalkerMover) -> void:
	_matcher.reset(p_mover.get_position(), p_mover.get_heading())


## The pose after a tick, in the world: its root is where the hips are, m. A mover that was put
## elsewhere, by an offset, does not make it step: it stays that far from the mover. A drift, m/s,
## does: so much faster it goes.
func advance(
	p_mover: WalkerMover,
	p_input: WalkerInput,
	p_delta_s: float,
	p_offset: Vector3 = Vector3.ZERO,
	p_drift: Vector3 = Vector3.ZERO
) -> PoseSample:
	# Who is held back does not walk on, on the spot: that would throw the body back.
	var wish: Vector2 = p_mover.hold_back(p_input.wish)
	_matcher.advance(
		p_delta_s,
		p_mover.get_position() - p_offset + Vector3.DOWN * p_mover.get_lift(),
		p_mover.get_velocity() + p_drift,
		p_mover.get_heading(),
		Vector3(wish.x, 0.0, wish.y) + p_drift,
		p_input.heading,
		stance_of(p_mover),
		p_mover.is_grounded()
	)
	var sample: PoseSample = PoseSample.new()
	sample.orientations = _matcher.get_orientations()
	sample.root = _matcher.get_root()
	var neck: float = angle_difference(p_mover.get_heading(), p_input.heading)
	var face: float = p_mover.get_heading() + clampf(neck, -MAX_NECK, MAX_NECK)
	if stance_of(p_mover) < MotionMatcher.PRONE:
		var up: Quaternion = Quaternion(Vector3.RIGHT, -p_input.look * 0.7)
		sample.set_orientation(Limbs.HEAD, Rotations.yaw(face) * up)
	return sample


## How the body is held: one of [enum MotionMatcher.Stance], of which the first are a mover's.
static func stance_of(p_mover: WalkerMover) -> int:
	match p_mover.get_mode():
		WalkerMover.LADDER:
			return MotionMatcher.LADDER
		WalkerMover.VAULT:
			return MotionMatcher.VAULT
	return p_mover.get_stance()
