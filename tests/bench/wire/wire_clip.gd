class_name WireClip
extends RefCounted
## A motion as the coding of people is measured on it: 60 poses a second, once through.

## Ticks a second.
const HZ: int = 60

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
