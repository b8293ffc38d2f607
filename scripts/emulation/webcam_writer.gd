class_name WebcamWriter
extends StreamWriter
## Writes somebody's poses as landmarks of a webcam: see [WebcamReader].

## The person's name.
var name: String = "Dismount"

var _began_usec: int = -1


func write(p_pose: PoseSample) -> Array[PackedByteArray]:
	if _began_usec < 0:
		_began_usec = p_pose.time_usec
	var rows: Array = []
	for point: Vector3 in landmarks(p_pose):
		rows.append([point.x, -point.y, -point.z, 0.99])
	var time_s: float = (p_pose.time_usec - _began_usec) / 1e6
	var message: Dictionary = {"time": time_s, "name": name, "world_landmarks": rows}
	return [JSON.stringify(message, "", false, true).to_utf8_buffer()]


## The 33 points of a pose in Godot's frame, m, with the hips' middle at the origin.
func landmarks(p_pose: PoseSample) -> PackedVector3Array:
	var centred: PoseSample = PoseSample.new()
	centred.orientations = p_pose.orientations
	_figure.solve(centred)
	var points: PackedVector3Array = []
	points.resize(WebcamReader.POINTS)
	var head: Quaternion = p_pose.orientation(Limbs.HEAD)
	var ears: Vector3 = _figure.bases[Limbs.HEAD] + head * Vector3(0.0, 0.08, 0.02)
	for point: int in 11:
		points[point] = ears + head * Vector3(0.0, 0.0, 0.09)
	var nose: Vector3 = Vector3(0.0, 0.0, 0.11).rotated(Vector3.RIGHT, LandmarkPose.NOSE_PITCH)
	points[LandmarkPose.NOSE] = ears + head * nose
	for side: int in 2:
		var mirror: float = 1.0 - 2.0 * side
		var arm: int = Limbs.LEFT_UPPER_ARM + 3 * side
		var leg: int = Limbs.LEFT_UPPER_LEG + 3 * side
		points[LandmarkPose.EAR + side] = ears + head * Vector3(0.075 * mirror, 0.0, 0.0)
		points[LandmarkPose.SHOULDER + side] = _figure.bases[arm]
		points[LandmarkPose.ELBOW + side] = _figure.bases[arm + 1]
		points[LandmarkPose.WRIST + side] = _figure.bases[arm + 2]
		var hand: Quaternion = p_pose.orientation(arm + 2)
		var knuckles: Vector3 = _figure.tails[arm + 2]
		var wide: float = _size.length(&"hand") * 0.2
		points[LandmarkPose.PINKY + side] = knuckles + hand * Vector3(0.0, 0.0, -wide)
		points[LandmarkPose.INDEX + side] = knuckles + hand * Vector3(0.0, 0.0, wide)
		points[LandmarkPose.INDEX + 2 + side] = knuckles + hand * Vector3(0.0, 0.0, 2.0 * wide)
		points[LandmarkPose.HIP + side] = _figure.bases[leg]
		points[LandmarkPose.KNEE + side] = _figure.bases[leg + 1]
		points[LandmarkPose.ANKLE + side] = _figure.bases[leg + 2]
		var foot: Quaternion = p_pose.orientation(leg + 2)
		var low: float = -_size.length(&"foot_height")
		var long: float = _size.length(&"foot_length")
		points[LandmarkPose.HEEL + side] = (
			_figure.bases[leg + 2] + foot * Vector3(0.0, low, -0.2 * long)
		)
		points[LandmarkPose.TOE + side] = (
			_figure.bases[leg + 2] + foot * Vector3(0.0, low, 0.7 * long)
		)
	return points
