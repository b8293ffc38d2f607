extends RefCounted
## What somebody does all day in a suit: clips, standing about, walking, arm work, sitting, holding
## a rifle; each for a while, with another posture and another front each time.

## Poses a second of which clips are kept.
const RATE_HZ: float = 25.0
## Time in which one posture goes over into the next, s.
const PASSAGE_S: float = 1.5
## How long something is done, s.
const SHORTEST_S: float = 15.0
const LONGEST_S: float = 60.0
## How far postures differ from time to time, degrees (standard deviation of each axis).
const HABIT_DEG: float = 4.0
## How far somebody turns from time to time, degrees.
const TURNS_DEG: float = 60.0
## Height of the pelvis of who sits, m.
const SEAT_M: float = 0.5
## What is done by whoever does all.
const ALL: PackedStringArray = ["clip", "stand", "work", "sit", "still", "twisted", "rifle"]

## How each joint is bent in a posture, by mount: rotation vectors in the frame of the mount above,
## degrees.
const _POSTURES: Dictionary[String, Dictionary] = {
	"stand": {4: Vector3(0, 0, -80), 8: Vector3(0, 0, 80)},
	"still": {4: Vector3(0, 0, -80), 8: Vector3(0, 0, 80)},
	"work":
	{
		1: Vector3(15, 0, 0),
		4: Vector3(-30, 0, -65),
		5: Vector3(0, -70, 0),
		8: Vector3(-30, 0, 65),
		9: Vector3(0, 70, 0),
	},
	"sit":
	{
		4: Vector3(0, 0, -75),
		5: Vector3(0, -60, 0),
		8: Vector3(0, 0, 75),
		9: Vector3(0, 60, 0),
		11: Vector3(-85, 5, 0),
		12: Vector3(85, 0, 0),
		14: Vector3(-85, -5, 0),
		15: Vector3(85, 0, 0),
	},
	"twisted":
	{
		1: Vector3(5, 30, 0),
		2: Vector3(0, 20, 0),
		4: Vector3(0, 0, -75),
		8: Vector3(0, 0, 75),
		11: Vector3(-85, 10, 0),
		12: Vector3(85, 0, 0),
		14: Vector3(-85, 20, 0),
		15: Vector3(85, 0, 0),
	},
	"rifle":
	{
		0: Vector3(0, -35, 0),
		1: Vector3(5, 15, 0),
		2: Vector3(10, 20, -10),
		4: Vector3(0, -60, -30),
		5: Vector3(0, -40, 0),
		8: Vector3(0, 20, 50),
		9: Vector3(0, 110, 0),
		11: Vector3(-10, 30, 0),
		12: Vector3(15, 0, 0),
		14: Vector3(5, -10, 0),
		15: Vector3(10, 0, 0),
	},
}
## How far joints sway in them, degrees: all, and those of arms.
const _SWAYS: Dictionary[String, Vector2] = {
	"stand": Vector2(1.5, 6.0),
	"still": Vector2(0.2, 0.3),
	"work": Vector2(4.0, 25.0),
	"sit": Vector2(1.0, 8.0),
	"twisted": Vector2(0.5, 2.0),
	"rifle": Vector2(0.8, 0.8),
}

var _random: RandomNumberGenerator = null
var _clips: Array[Array] = []
var _choice: PackedStringArray = []
var _name: String = ""
var _begin_s: float = 0.0
var _end_s: float = -1.0
var _clip: int = 0
var _front: float = 0.0
var _bends: PackedVector3Array = PackedVector3Array()
# Three frequencies and phases a mount.
var _waves: PackedVector2Array = PackedVector2Array()
var _left: Array[Quaternion] = []
var _now: Array[Quaternion] = []
# Since when the pose goes over into another one, s, and which poses of a clip
# are the present one and the one that it began with.
var _passes_s: float = 0.0
var _at: int = -1
var _first: int = 0
# Where the pelvis is and was when that began; where the middle between both ankles stays, m.
var _root: Vector3 = Vector3(0.0, 0.95, 0.0)
var _left_root: Vector3 = _root
var _feet: Vector3 = Vector3.ZERO


## [param p_clips] are clips, each an array of poses; [param p_choice] what is done.
func _init(
	p_random: RandomNumberGenerator, p_clips: Array[Array], p_choice: PackedStringArray
) -> void:
	_random = p_random
	_clips = p_clips
	_choice = p_choice
	_now.resize(BodyMounts.COUNT)
	_now.fill(Quaternion.IDENTITY)
	_left = _now.duplicate()
	for _wave: int in BodyMounts.COUNT * 3:
		_waves.append(Vector2(_random.randf_range(0.05, 0.6), _random.randf_range(0.0, TAU)))


## The poses of a clip for one round.
static func keep(p_source: BvhSource) -> Array[PoseSample]:
	var poses: Array[PoseSample] = []
	for at: int in floori(p_source.get_period() * RATE_HZ):
		poses.append(p_source.pose_at(p_source.get_period() + at / RATE_HZ))
	return poses


## What is done, and the pose, after so many seconds; times only grow.
func pose_at(p_time_s: float) -> PoseSample:
	if p_time_s >= _end_s:
		_choose(p_time_s)
	if _name == "clip":
		_play(p_time_s)
	for mount: int in BodyMounts.COUNT:
		_now[mount] = _wanted(mount, p_time_s)
	var part: float = smoothstep(_passes_s, _passes_s + PASSAGE_S, p_time_s)
	var pose: PoseSample = PoseSample.new()
	pose.details = MotionDetails.new()
	for mount: int in BodyMounts.COUNT:
		var turned: Quaternion = _now[mount]
		if part < 1.0:
			turned = _left[mount].slerp(turned, part)
			_now[mount] = turned
		if WornSensorFeed.BLADES.has(mount):
			pose.details.joints[WornSensorFeed.BLADES[mount]] = turned
		else:
			pose.set_orientation(BodyMounts.LIMBS[mount], turned)
	pose.set_orientation(1, pose.orientation(0).slerp(pose.orientation(2), 0.5))
	_root = _root_of(part)
	pose.root = _root
	return pose


## Where the pelvis is: as the clip moves it, or where feet that stand leave it; who sits does not
## move it.
func _root_of(p_part: float) -> Vector3:
	if _name == "clip":
		var poses: Array = _clips[_clip]
		var begin: PoseSample = poses[_first]
		var pose: PoseSample = poses[_at]
		return _left_root + Rotations.yaw(_front) * (pose.root - begin.root) * p_part
	if _name == "sit" or _name == "twisted":
		var seat: Vector3 = _left_root
		seat.y = SEAT_M
		return _left_root.lerp(seat, p_part)
	return _feet - _ankles()


## The middle between both ankles, from the pelvis, m.
func _ankles() -> Vector3:
	var sum: Vector3 = Vector3.ZERO
	for thigh: int in [BodyMounts.LEFT_THIGH, BodyMounts.RIGHT_THIGH]:
		sum += _now[0] * WornSensorFeed.OFFSETS[thigh]
		sum += _now[thigh] * WornSensorFeed.OFFSETS[thigh + 1]
		sum += _now[thigh + 1] * WornSensorFeed.OFFSETS[thigh + 2]
	return sum / 2.0


## Goes on in a clip; where it begins again the pose goes over into its first one.
func _play(p_time_s: float) -> void:
	var poses: Array = _clips[_clip]
	var at: int = roundi(p_time_s * RATE_HZ) % poses.size()
	if _at < 0 or at < _at:
		_leave(p_time_s)
		_first = at
	_at = at


func _leave(p_time_s: float) -> void:
	_left = _now.duplicate()
	_left_root = _root
	_feet = _root + _ankles()
	_passes_s = p_time_s


func _choose(p_time_s: float) -> void:
	_leave(p_time_s)
	_at = -1
	_name = _choice[_random.randi() % _choice.size()]
	_begin_s = p_time_s
	_end_s = p_time_s + _random.randf_range(SHORTEST_S, LONGEST_S)
	if _choice.size() == 1:
		_end_s = INF
	else:
		_front = clampf(_front + deg_to_rad(_random.randfn() * TURNS_DEG), -PI, PI)
	_clip = _random.randi() % maxi(_clips.size(), 1)
	_bends.resize(BodyMounts.COUNT)
	for mount: int in BodyMounts.COUNT:
		var off: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn())
		_bends[mount] = _POSTURES.get(_name, {}).get(mount, Vector3.ZERO)
		_bends[mount] += off * HABIT_DEG * _freedom(mount)


func _wanted(p_mount: int, p_time_s: float) -> Quaternion:
	if _name == "clip":
		var poses: Array = _clips[_clip]
		var pose: PoseSample = poses[_at]
		return Rotations.yaw(_front) * pose.orientation(BodyMounts.LIMBS[p_mount])
	var sways: Vector2 = _SWAYS[_name]
	var sway_deg: float = sways.y if BodyMounts.is_arm(p_mount) else sways.x
	var swayed: Vector3 = Vector3.ZERO
	for axis: int in 3:
		var wave: Vector2 = _waves[p_mount * 3 + axis]
		swayed[axis] = sin(TAU * wave.x * p_time_s + wave.y) * sway_deg
	swayed *= _freedom(p_mount)
	var bent: Quaternion = Rotations.from_vector((_bends[p_mount] + swayed) * (PI / 180.0))
	var parent: int = BodyMounts.PARENTS[p_mount]
	# Feet that stand do not sway: the ankle takes what the leg does.
	if p_mount == BodyMounts.LEFT_FOOT or p_mount == BodyMounts.RIGHT_FOOT:
		var heading_deg: float = _bends[0].y + _bends[p_mount - 2].y + _bends[p_mount].y
		return Rotations.yaw(_front + deg_to_rad(heading_deg))
	return (Rotations.yaw(_front) if parent < 0 else _now[parent]) * bent


## About which axes a joint moves: knees and ankles are hinges.
static func _freedom(p_mount: int) -> Vector3:
	var is_hinge: bool = p_mount > BodyMounts.RIGHT_HAND and p_mount % 3 != 2
	return Vector3.RIGHT if is_hinge else Vector3.ONE
