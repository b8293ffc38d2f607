class_name WireClip
extends RefCounted
## A motion as the coding of people is measured on it: 60 poses a second, once through.

## Ticks a second.
const HZ: int = 60
## From the joint of a limb's parent to its own joint in the reset pose, m: a person of 1.8 m.
const OFFSETS: Array[Vector3] = [
	Vector3.ZERO,
	Vector3(0.0, 0.12, 0.0),
	Vector3(0.0, 0.2, 0.0),
	Vector3(0.0, 0.28, 0.0),
	Vector3(0.18, 0.2, 0.0),
	Vector3(0.29, 0.0, 0.0),
	Vector3(0.26, 0.0, 0.0),
	Vector3(-0.18, 0.2, 0.0),
	Vector3(-0.29, 0.0, 0.0),
	Vector3(-0.26, 0.0, 0.0),
	Vector3(0.1, -0.05, 0.0),
	Vector3(0.0, -0.43, 0.0),
	Vector3(0.0, -0.42, 0.0),
	Vector3(-0.1, -0.05, 0.0),
	Vector3(0.0, -0.43, 0.0),
	Vector3(0.0, -0.42, 0.0),
]
## The hands' places in the tables, and from their joints to the knuckles, m.
const HANDS: Dictionary[int, Vector3] = {
	6: Vector3(0.1, 0.0, 0.0),
	9: Vector3(-0.1, 0.0, 0.0),
}

## Name of the file.
var name: String = ""
## The poses, a tick apart.
var poses: Array[PoseSample] = []
## Why there are none, or an empty text.
var error: String = ""


## Reads a motion file.
static func from_file(p_path: String) -> WireClip:
	var clip: WireClip = WireClip.new()
	var source: BvhSource = BvhSource.new()
	source.open(p_path)
	clip.name = p_path.get_file().get_basename()
	clip.error = source.error
	if clip.error == "":
		for tick: int in floori(source.rig.clip.duration() * HZ):
			clip.poses.append(source.pose_at(tick / float(HZ)))
	if clip.error == "" and clip.poses.size() < 2 * HZ:
		clip.error = "%s: shorter than two seconds" % p_path
	return clip


## The motion, put on the lattice of a resolution.
func to_stream(p_resolution: int) -> PersonStream:
	var stream: PersonStream = PersonStream.new()
	stream.setup(PackedInt32Array(Limbs.PARENTS), p_resolution)
	for pose: PoseSample in poses:
		stream.push(pose.root, pose.orientations)
	return stream


## One limb's rotation out of 4 floats for each.
static func rotation_of(p_orientations: PackedFloat32Array, p_limb: int) -> Quaternion:
	var at: int = 4 * p_limb
	return (
		Quaternion(
			p_orientations[at],
			p_orientations[at + 1],
			p_orientations[at + 2],
			p_orientations[at + 3]
		)
		. normalized()
	)


## Where a person's limbs begin, m, by forward kinematics.
static func places(p_root: Vector3, p_orientations: PackedFloat32Array) -> PackedVector3Array:
	var found: PackedVector3Array = [p_root]
	for limb: int in range(1, Limbs.COUNT):
		var parent: int = Limbs.PARENTS[limb]
		found.append(found[parent] + rotation_of(p_orientations, parent) * OFFSETS[limb])
	return found


## The greatest angle between the limbs of two poses, degrees.
static func worst_angle(p_one: PackedFloat32Array, p_other: PackedFloat32Array) -> float:
	var worst: float = 0.0
	for limb: int in Limbs.COUNT:
		var one: Quaternion = rotation_of(p_one, limb)
		var other: Quaternion = rotation_of(p_other, limb)
		# angle_to() is coarse for small angles.
		var chord: float = minf((one - other).length(), (one + other).length())
		worst = maxf(worst, rad_to_deg(4.0 * asin(minf(chord / 2.0, 1.0))))
	return worst


## How far a hand is off, mm, if a pose is rebuilt by forward kinematics.
static func worst_hand(
	p_pose: PoseSample, p_root: Vector3, p_orientations: PackedFloat32Array
) -> float:
	var wanted: PackedVector3Array = places(p_pose.root, p_pose.orientations)
	var found: PackedVector3Array = places(p_root, p_orientations)
	var worst: float = 0.0
	for hand: int in HANDS:
		var place: Vector3 = wanted[hand] + p_pose.orientation(hand) * HANDS[hand]
		var shown: Vector3 = found[hand] + rotation_of(p_orientations, hand) * HANDS[hand]
		worst = maxf(worst, 1000.0 * place.distance_to(shown))
	return worst
