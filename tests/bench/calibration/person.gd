extends "res://tests/mocap/calibration/wearer.gd"
## Somebody who is not perfect: norths apart, poses held badly, soft tissue, movements that are
## larger, smaller and more askew than asked. All is drawn from [member random].

const _NOISE_DEG: float = 0.5
const _RATE_HZ: float = 25.0

## How far a movement's axis is off, degrees (standard deviation of each direction).
var askew_deg: float = 2.0
## How far norths are spread, degrees.
var norths_deg: float = 0.0
## How far poses are off at most, degrees.
var poses_deg: float = 0.0
## Whether a pose that is held again is off anew.
var is_anew: bool = false
## Whether norths are spread normally.
var is_normal: bool = false
## Which way the wearer faces in the frame that the sensors have in common, rad.
var front: float = 0.0


## Puts sensors on mounts. Norths are spread by so many degrees, evenly to either side or normally
## (standard deviation).
func dress(p_mounts: PackedInt32Array, p_norths_deg: float, p_normal: bool) -> void:
	mounts = p_mounts
	rate_hz = _RATE_HZ
	feed.noise_deg = _NOISE_DEG
	motion.facing = random.randf_range(-PI, PI)
	norths_deg = p_norths_deg
	is_normal = p_normal
	var common: float = random.randf_range(-PI, PI)
	front = common + motion.facing
	for mount: int in p_mounts:
		var own: float = random.randfn() if p_normal else random.randf_range(-1.0, 1.0)
		feed.add_sensor(mount, any_rotation(), common + own * deg_to_rad(p_norths_deg))


## Poses are off by up to so many degrees, each mount on its own, T and N apart; a pose that is held
## again is off as before, or anew.
func hold_badly(p_deg: float, p_anew: bool) -> void:
	poses_deg = p_deg
	is_anew = p_anew
	motion.hold_faults.clear()
	for _hold: int in 4:
		var faults: Dictionary = {}
		for mount: int in BodyMounts.COUNT:
			var off: float = deg_to_rad(random.randf_range(-p_deg, p_deg))
			faults[mount] = Quaternion(any_axis(), off)
		motion.hold_faults.append(faults)
	if not p_anew:
		motion.hold_faults[2] = motion.hold_faults[1]
		motion.hold_faults[3] = motion.hold_faults[0]


## Movements are larger or smaller by up to a part, and askew.
func move_badly(p_efforts: float) -> void:
	for movement: GuideMovements.Movement in GuideMovements.Movement.values():
		if movement != GuideMovements.Movement.ARMS:
			motion.efforts[movement] = 1.0 + random.randf_range(-p_efforts, p_efforts)
		var off: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn())
		motion.askew[movement] = Rotations.from_vector(off * deg_to_rad(askew_deg))


## How far each sensor's limb is off in the mean over poses, degrees, without noise and soft tissue;
## the headings count from the wearer's front.
func errors_deg(p_calibration: Calibration, p_poses: Array[PoseSample]) -> PackedFloat64Array:
	var noise: float = feed.noise_deg
	var soft: float = feed.soft_tissue_deg
	feed.noise_deg = 0.0
	feed.soft_tissue_deg = 0.0
	var sums: PackedFloat64Array = PackedFloat64Array()
	sums.resize(mounts.size())
	for pose: PoseSample in p_poses:
		var got: Array[Quaternion] = rotations(p_calibration, pose)
		for sensor: int in mounts.size():
			var limb: Quaternion = WornSensorFeed.limb_rotation(pose, mounts[sensor])
			var wanted: Quaternion = Rotations.yaw(-motion.facing) * limb
			sums[sensor] += Rotations.between_deg(got[sensor], wanted) / p_poses.size()
	feed.noise_deg = noise
	feed.soft_tissue_deg = soft
	return sums


## The mean of numbers.
static func mean(p_numbers: PackedFloat64Array) -> float:
	var sum: float = 0.0
	for number: float in p_numbers:
		sum += number
	return sum / maxi(p_numbers.size(), 1)
