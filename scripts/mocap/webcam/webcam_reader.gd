class_name WebcamReader
extends StreamReader
## Reads landmarks of a webcam as MediaPipe's pose landmarker gives them in the world: 33 points,
## metres, with the hips' middle at the origin, X to the picture's right, Y down and Z away from the
## camera. A datagram is a JSON object:
## [codeblock]
## {"time": 12.34, "name": "Eve", "world_landmarks": [[x, y, z, visibility], ... 33 of them]}
## [/codeblock]
## Points may be objects with x, y, z and visibility too, and the list may be called
## "worldLandmarks", as MediaPipe's own JSON has it. "time" (s), "name" and "person" may be missing.
##
## Points say where limbs point, and elbows and knees how they are turned; [LandmarkPose] makes
## rotations of them.

## Number of points.
const POINTS: int = 33

var _json: StreamJson = StreamJson.new()
var _poses: Dictionary[String, LandmarkPose] = {}


func title() -> String:
	return "Webcam"


func read(p_bytes: PackedByteArray, p_sender: String) -> Array[StreamSample]:
	var message: Dictionary = _json.read(p_bytes)
	if _json.fault != "":
		return refuse(_json.fault)
	var points: Array = StreamJson.list(message, "world_landmarks")
	if points.is_empty():
		points = StreamJson.list(message, "worldLandmarks")
	# MediaPipe's result has a list for each person; one person's is enough.
	if points.size() > 0 and points[0] is Array and points[0].size() == POINTS:
		points = points[0]
	if points.size() != POINTS:
		return refuse("%d landmarks instead of %d" % [points.size(), POINTS])
	var places: PackedVector3Array = []
	var seen: PackedFloat32Array = []
	for point: Variant in points:
		var numbers: PackedFloat64Array = _numbers(point)
		if numbers.is_empty():
			return refuse("a landmark is no [x, y, z, visibility] of finite numbers")
		# A half turn about X: Y up, and who faces the camera faces +Z.
		places.append(Vector3(numbers[0], -numbers[1], -numbers[2]))
		seen.append(numbers[3])
	var sample: StreamSample = StreamSample.new()
	sample.name = StreamJson.text(message, "name")
	sample.person = str(message.get("person", 0)).left(20)
	var key: String = p_sender + " " + sample.person
	if not _poses.has(key):
		if _poses.size() >= PoseStream.MAX_PEOPLE:
			_poses.erase(_poses.keys()[0])
		_poses[key] = LandmarkPose.new()
	sample.pose = _poses[key].make(places, seen)
	if sample.pose == null:
		return refuse("hips and shoulders are not seen")
	var time_s: float = StreamJson.number(message, "time")
	sample.source_usec = roundi(time_s * 1e6) if time_s >= 0.0 and time_s < 1e11 else -1
	return [sample] as Array[StreamSample]


## x, y, z and visibility of a point; empty where it is none.
static func _numbers(p_point: Variant) -> PackedFloat64Array:
	var numbers: PackedFloat64Array = []
	if p_point is Array and (p_point as Array).size() >= 3:
		for value: Variant in (p_point as Array).slice(0, 4):
			numbers.append(float(value) if value is float or value is int else NAN)
	elif p_point is Dictionary:
		for key: String in ["x", "y", "z"]:
			numbers.append(StreamJson.number(p_point, key))
		if (p_point as Dictionary).has("visibility"):
			numbers.append(StreamJson.number(p_point, "visibility"))
	if numbers.size() == 3:
		numbers.append(1.0)
	for value: float in numbers:
		# A comparison that NaN fails, too.
		if not absf(value) < 100.0:
			return PackedFloat64Array()
	return numbers
