class_name LimbFiller
extends RefCounted
## Derives all limbs of [Limbs] from what is known at the mounts of [BodyMounts].
##
## Rotations are from the reset pose, in the world. What no sensor measures is taken from its
## neighbours so that it looks like a person and bends only the way joints bend:
## [br]- the chest from the shoulder blades, else from head and pelvis; the waist halfway between
## pelvis and chest; the head looks where the chest does;
## [br]- an upper arm from the forearm: the elbow bends the more, the further the forearm is from
## hanging, but not to the side; a forearm from the hand, or in line with the upper arm; hands
## follow;
## [br]- a thigh from the shank: the knee is straight while the shank swings ahead, and bends while
## it is behind; a shank hangs from a raised thigh; feet take the shank's heading and stay flat
## up to [constant ANKLE_DEG];
## [br]- whole arms hang, whole legs stand below the pelvis.

## How far an ankle bends before a foot tilts with its shank, degrees.
const ANKLE_DEG: float = 20.0
## Maximum bend of elbows and knees, degrees.
const MAX_BEND_DEG: float = 150.0
## Share of a forearm's turn out of hanging that the elbow makes.
const ELBOW_SHARE: float = 0.8
## Where a left upper arm points at ease, seen from the chest.
const HANGING: Vector3 = Vector3(0.15, -0.98, 0.1)
## Share of a shank's turn backwards by which the thigh comes ahead.
const KNEE_SHARE: float = 0.5

# What the pelvis' heading is taken from, best first, if not both thighs are known.
const _PELVIS_BY: Array[int] = [
	BodyMounts.STERNUM,
	BodyMounts.HEAD,
	BodyMounts.LEFT_THIGH,
	BodyMounts.RIGHT_THIGH,
	BodyMounts.LEFT_SHANK,
	BodyMounts.RIGHT_SHANK,
]

## Rotations of the mounts; those that are not known are filled by [method fill].
var rotations: Array[Quaternion] = []
## Which mounts are known: 1 or 0. [method fill] leaves it.
var known: PackedByteArray = PackedByteArray()
## Rotations of the limbs after [method fill].
var limbs: Array[Quaternion] = []
## Which limbs were measured: 1 or 0.
var measured: PackedByteArray = PackedByteArray()

var _has: PackedByteArray = PackedByteArray()


func _init() -> void:
	rotations.resize(BodyMounts.COUNT)
	known.resize(BodyMounts.COUNT)
	limbs.resize(Limbs.COUNT)
	measured.resize(Limbs.COUNT)
	clear()


## Forgets everything.
func clear() -> void:
	rotations.fill(Quaternion.IDENTITY)
	known.fill(0)


## Sets the rotation of a mount.
func set_mount(p_mount: int, p_rotation: Quaternion) -> void:
	rotations[p_mount] = p_rotation
	known[p_mount] = 1


## Fills what is missing, then [member limbs] and [member measured].
func fill() -> void:
	_has = known.duplicate()
	_fill_trunk()
	_fill_arm(BodyMounts.LEFT_UPPER_ARM, 1.0)
	_fill_arm(BodyMounts.RIGHT_UPPER_ARM, -1.0)
	_fill_leg(BodyMounts.LEFT_THIGH)
	_fill_leg(BodyMounts.RIGHT_THIGH)
	measured.fill(0)
	for mount: int in BodyMounts.COUNT:
		if mount == BodyMounts.LEFT_SHOULDER or mount == BodyMounts.RIGHT_SHOULDER:
			continue
		limbs[BodyMounts.LIMBS[mount]] = rotations[mount]
		measured[BodyMounts.LIMBS[mount]] = known[mount]
	limbs[Limbs.SPINE] = rotations[BodyMounts.PELVIS].slerp(rotations[BodyMounts.STERNUM], 0.5)


## The pose of [member limbs], with [member measured] in its details; to be placed by the caller.
func pose() -> PoseSample:
	var found: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		found.set_orientation(limb, limbs[limb])
	found.details = MotionDetails.new()
	found.details.measured = measured.duplicate()
	return found


func _fill_trunk() -> void:
	var pelvis: int = BodyMounts.PELVIS
	var chest: int = BodyMounts.STERNUM
	var head: int = BodyMounts.HEAD
	var left: int = BodyMounts.LEFT_SHOULDER
	var right: int = BodyMounts.RIGHT_SHOULDER
	if _has[chest] == 0:
		if _has[left] != 0 and _has[right] != 0:
			_put(chest, rotations[left].slerp(rotations[right], 0.5))
		elif _has[left] != 0 or _has[right] != 0:
			_put(chest, rotations[left] if _has[left] != 0 else rotations[right])
	if _has[pelvis] == 0:
		_put(pelvis, _pelvis_from_others())
	if _has[chest] == 0:
		# Heads turn further than chests do.
		var above: Quaternion = rotations[head] if _has[head] != 0 else rotations[pelvis]
		_put(chest, rotations[pelvis].slerp(above, 0.3))
	if _has[head] == 0:
		_put(head, rotations[chest])
	for blade: int in [left, right]:
		if _has[blade] == 0:
			_put(blade, rotations[chest])


func _pelvis_from_others() -> Quaternion:
	var left: int = BodyMounts.LEFT_THIGH
	var right: int = BodyMounts.RIGHT_THIGH
	if _has[left] != 0 and _has[right] != 0:
		# Between the thighs, upright: thighs swing, the pelvis hardly does.
		return Rotations.yaw(Rotations.yaw_of(rotations[left].slerp(rotations[right], 0.5)))
	for mount: int in _PELVIS_BY:
		if _has[mount] != 0:
			return Rotations.yaw(Rotations.yaw_of(rotations[mount]))
	return Quaternion.IDENTITY


func _fill_arm(p_upper: int, p_side: float) -> void:
	var fore: int = p_upper + 1
	var hand: int = p_upper + 2
	if _has[fore] == 0 and _has[hand] != 0:
		_put(fore, rotations[hand])
	if _has[p_upper] == 0:
		if _has[fore] != 0:
			_put(p_upper, _upper_arm(rotations[fore], p_side))
		else:
			var front: float = Rotations.yaw_of(rotations[BodyMounts.STERNUM])
			_put(p_upper, Rotations.yaw(front) * Quaternion(Vector3.BACK, -PI / 2.0 * p_side))
	if _has[fore] == 0:
		_put(fore, rotations[p_upper])
	if _has[hand] == 0:
		_put(hand, rotations[fore])


## An upper arm above a forearm; the side is 1 for left, -1 for right.
func _upper_arm(p_fore: Quaternion, p_side: float) -> Quaternion:
	var chest: Quaternion = rotations[BodyMounts.STERNUM]
	var along: Vector3 = p_fore * Vector3(p_side, 0.0, 0.0)
	var hanging: Vector3 = chest * (HANGING * Vector3(p_side, 1.0, 1.0))
	var hinge: Vector3 = hanging.cross(along)
	if hinge.length() < 1e-3:
		return p_fore
	# Forearms turn about themselves, so that the elbow may bend about any axis across. One that
	# points to the side or to the back is held out by a straight arm.
	var seen: Vector3 = chest.inverse() * along
	var straight: float = maxf(maxf(seen.x * p_side, -seen.z), 0.0)
	var out: float = along.angle_to(hanging)
	var bend: float = ELBOW_SHARE * out * (1.0 - straight * straight)
	return Quaternion(hinge.normalized(), -minf(bend, deg_to_rad(MAX_BEND_DEG))) * p_fore


func _fill_leg(p_thigh: int) -> void:
	var shank: int = p_thigh + 1
	var foot: int = p_thigh + 2
	if _has[shank] == 0 and _has[foot] != 0 and _has[p_thigh] == 0:
		# A foot that tilts is off the ground, half of it by the ankle.
		_put(shank, _less_tilted(rotations[foot], Rotations.angle(_tilt(rotations[foot])) / 2.0))
	if _has[p_thigh] == 0:
		if _has[shank] != 0:
			_put(p_thigh, _thigh(rotations[shank]))
		else:
			_put(p_thigh, Rotations.yaw(Rotations.yaw_of(rotations[BodyMounts.PELVIS])))
	if _has[shank] == 0:
		_put(shank, _shank(rotations[p_thigh]))
	if _has[foot] == 0:
		_put(foot, _less_tilted(rotations[shank], deg_to_rad(ANKLE_DEG)))


## A thigh above a shank.
func _thigh(p_shank: Quaternion) -> Quaternion:
	var back: float = _pitch(p_shank)
	var ahead: float = back
	if back > 0.0:
		ahead = -KNEE_SHARE * back * maxf(cos(back), 0.0)
	var bend: float = minf(back - ahead, deg_to_rad(MAX_BEND_DEG))
	return Quaternion(p_shank * Vector3.RIGHT, -bend) * p_shank


## A shank below a thigh: it hangs if the thigh is raised, else the knee is straight.
func _shank(p_thigh: Quaternion) -> Quaternion:
	var raised: float = -_pitch(p_thigh)
	if raised <= 0.0:
		return p_thigh
	var bend: float = minf(raised, deg_to_rad(MAX_BEND_DEG))
	return Quaternion(p_thigh * Vector3.RIGHT, bend) * p_thigh


## How far a leg's part points backwards, seen from the pelvis, rad.
func _pitch(p_part: Quaternion) -> float:
	var along: Vector3 = rotations[BodyMounts.PELVIS].inverse() * (p_part * Vector3.DOWN)
	return atan2(-along.z, maxf(-along.y, 0.0) if absf(along.z) > 1e-6 else 1.0)


## A rotation whose tilt is smaller by an angle, rad, its heading the same.
static func _less_tilted(p_rotation: Quaternion, p_angle: float) -> Quaternion:
	var tilt: Vector3 = Rotations.vector(_tilt(p_rotation))
	var left: float = maxf(tilt.length() - p_angle, 0.0)
	var heading: Quaternion = Rotations.yaw(Rotations.yaw_of(p_rotation))
	return Rotations.from_vector(tilt.normalized() * left) * heading


## What a rotation does beyond turning about the vertical.
static func _tilt(p_rotation: Quaternion) -> Quaternion:
	return p_rotation * Rotations.yaw(-Rotations.yaw_of(p_rotation))


func _put(p_mount: int, p_rotation: Quaternion) -> void:
	rotations[p_mount] = p_rotation
	_has[p_mount] = 1
