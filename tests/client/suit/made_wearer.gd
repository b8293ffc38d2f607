extends MotionSource
## Somebody who does what a [GuidedRecording] asks for: a plain mover, shown by a motion set.

const PlainMover: GDScript = preload("res://tests/bench/motion_set/plain_mover.gd")
const _DELTA: float = 1.0 / 60.0
## Speeds of the phases that have one, m/s.
const SPEEDS: Dictionary[String, float] = {
	"walk": 1.4,
	"slow-walk": 0.7,
	"fast-walk": 1.9,
	"curve-left": 1.2,
	"curve-right": 1.2,
	"back": 0.9,
	"left": 0.9,
	"right": 0.9,
	"run": 3.5,
	"crouched-walk": 0.9,
}
const _DIRECTIONS: Dictionary[String, float] = {"back": PI, "left": PI / 2.0, "right": -PI / 2.0}
## Turns, rad/s.
const _TURNS: Dictionary[String, float] = {
	"turn-left": 1.5, "turn-right": -1.5, "curve-left": 0.9, "curve-right": -0.9
}

## Who leads.
var guide: GuidedRecording = null
## Does nothing that is asked for.
var is_lazy: bool = false
## Gives no motion.
var is_dead: bool = false
## Does not know where it is, as a suit of sensors.
var is_placeless: bool = false
## Where it is, m.
var place: Vector3 = Vector3.ZERO

var _mover: PlainMover = PlainMover.new()
var _matcher: MotionMatcher = MotionMatcher.new()
var _heading: float = 0.0
var _ticks: int = 0


func _init(p_set: String = "res://assets/motion/walker.motionset") -> void:
	var motion: MotionSet = MotionSet.new()
	error = motion.load_file(p_set)
	_matcher.set_motion_set(motion)
	_matcher.set_joints(get_hip_height(), _joints_in_parent(), _zeroes())
	_matcher.reset(Vector3.ZERO, 0.0)


func describe() -> String:
	return "a made wearer"


func _read(_time_usec: int) -> PoseSample:
	_wish()
	_mover.advance(_DELTA)
	_mover.show(_matcher, _DELTA)
	_ticks += 1
	if is_dead:
		return null
	var pose: PoseSample = PoseSample.new()
	pose.orientations = _matcher.get_orientations()
	pose.root = _matcher.get_root()
	place = pose.root
	if is_placeless:
		pose.root.x = 0.0
		pose.root.z = 0.0
	return pose


## A body of the size that it says it has.
func _joints_in_parent() -> PackedVector3Array:
	var joints: PackedVector3Array = get_body().joints()
	var found: PackedVector3Array = _zeroes()
	for limb: int in range(1, Limbs.COUNT):
		found[limb] = joints[limb] - joints[Limbs.PARENTS[limb]]
	return found


static func _zeroes() -> PackedVector3Array:
	var found: PackedVector3Array = PackedVector3Array()
	found.resize(Limbs.COUNT)
	return found


func _wish() -> void:
	var name: String = ""
	if guide.phase() != null and not is_lazy:
		name = guide.phase().name
	var speed: float = SPEEDS.get(name, 0.0)
	if name == "starts" and _ticks % 240 >= 120:
		speed = 1.3
	_heading += _TURNS.get(name, 0.0) * _DELTA
	_mover.stance = MotionMatcher.CROUCH if "crouch" in name else MotionMatcher.STAND
	_mover.wish(speed, _DIRECTIONS.get(name, 0.0), _heading)
