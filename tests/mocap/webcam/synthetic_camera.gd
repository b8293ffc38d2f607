class_name SyntheticCamera
extends RefCounted
## What a camera sees of somebody whose pose is known: landmarks as the model gives them, with noise
## and dropouts.

## Directions of limbs in the reset pose.
const ALONG: Dictionary[int, Vector3] = {
	Limbs.LEFT_UPPER_ARM: Vector3.RIGHT,
	Limbs.LEFT_LOWER_ARM: Vector3.RIGHT,
	Limbs.RIGHT_UPPER_ARM: Vector3.LEFT,
	Limbs.RIGHT_LOWER_ARM: Vector3.LEFT,
	Limbs.LEFT_UPPER_LEG: Vector3.DOWN,
	Limbs.LEFT_LOWER_LEG: Vector3.DOWN,
	Limbs.RIGHT_UPPER_LEG: Vector3.DOWN,
	Limbs.RIGHT_LOWER_LEG: Vector3.DOWN,
}

## How far it looks down, rad, and how much it sees across, degrees.
var tilt: float = 0.0
var fov_deg: float = 65.0
## Height of its picture in widths.
var height: float = 9.0 / 16.0
## Where it is: the person's origin as seen from it, m, level.
var person: Vector3 = Vector3(0.0, -1.2, -3.0)
## Standard deviation of a landmark in the world, m, and in the picture, widths of it.
var noise_m: float = 0.0
var noise_picture: float = 0.0
## Share of the landmarks below the shoulders that are not seen in a picture.
var dropouts: float = 0.0

var _writer: WebcamWriter = WebcamWriter.new()
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func _init(p_seed: int = 1) -> void:
	_random.seed = p_seed


## The landmarks of a pose at a time, µs.
func see(p_pose: PoseSample, p_usec: int) -> LandmarkFrame:
	var frame: LandmarkFrame = LandmarkFrame.new()
	frame.usec = p_usec
	var look: Basis = Basis(Vector3.RIGHT, tilt)
	var points: PackedVector3Array = _writer.landmarks(p_pose)
	var ahead: Quaternion = Quaternion.IDENTITY
	var middle: Vector3 = look * (person + p_pose.root)
	# The model sees each person as if straight ahead.
	var neck: Vector3 = (points[LandmarkPose.SHOULDER] + points[LandmarkPose.SHOULDER + 1]) / 2.0
	var aim: Vector3 = middle + look * neck / 2.0
	ahead = Quaternion(aim.normalized(), Vector3.FORWARD)
	var per_width: float = 2.0 * tan(deg_to_rad(fov_deg) / 2.0)
	for number: int in points.size():
		var at: Vector3 = look * points[number]
		frame.places.append(ahead * at + _blur() * noise_m)
		at += middle
		var flat: Vector2 = Vector2(at.x, at.y) / -at.z / per_width
		flat += Vector2(_random.randfn(), _random.randfn()) * noise_picture
		var is_lost: bool = number > LandmarkPose.SHOULDER + 1 and _random.randf() < dropouts
		frame.seen.append(0.02 if is_lost else 0.98)
		if is_lost:
			frame.places[number] += _blur() * 0.3
		frame.in_picture.append(Vector3(flat.x + 0.5, height / 2.0 - flat.y, frame.seen[number]))
	frame.set_rays(height, fov_deg)
	return frame


func _blur() -> Vector3:
	return Vector3(_random.randfn(), _random.randfn(), _random.randfn())
