class_name WebcamReader
extends StreamReader
## Reads landmarks of a webcam as MediaPipe's pose landmarker gives them: 33 points in the world,
## metres, with the hips' middle at the origin, X to the picture's right, Y down and Z away from the
## camera; and perhaps where they are in the picture. A datagram is a JSON object (docs/sources.md):
## [codeblock]
## {"time": 12.34, "name": "Eve", "world_landmarks": [[x, y, z, visibility], ... 33 of them]}
## [/codeblock]
## Points may be objects with x, y, z and visibility too, and the list may be called
## "worldLandmarks", as MediaPipe's own JSON has it. All but the list may be missing.
##
## Our own helper ([WebcamHelper]) also tells how it goes, and sends small pictures: a datagram that
## begins as a JPEG does is one.
## [LandmarkSolver] makes poses of the points.

## Number of points.
const POINTS: int = 33
## Largest picture, px, so that a stranger's numbers stay numbers.
const _MAX_PX: float = 16384.0
const _MAX_FAULTS: int = 4
const _FAULT_LETTERS: int = 200

## What is seen, for the panel.
var picture: WebcamPicture = WebcamPicture.new()
## The process that sends, where it is ours.
var helper: WebcamHelper = null

var _settings: CameraSettings = CameraSettings.new()
var _json: StreamJson = StreamJson.new()
var _solvers: Dictionary[String, LandmarkSolver] = {}
var _camera: String = ""
# Of each sender what it says of how it goes, and what is wrong.
var _news: Dictionary[String, PackedStringArray] = {}


func title() -> String:
	return "Webcam"


## Says how its cameras see.
func use(p_settings: CameraSettings) -> void:
	_settings = p_settings


## Starts a helper of our own, which sends to a port of this machine: for a camera's number, or a
## film's path.
func start_helper(p_pictures: String, p_port: int) -> void:
	var is_camera: bool = p_pictures.is_valid_int()
	_camera = "camera %s" % p_pictures if is_camera else p_pictures.get_file()
	helper = WebcamHelper.new()
	helper.want(p_pictures, p_port, _settings.people)


func talk(p_now_usec: int) -> Array[StreamPort.Parcel]:
	if helper != null:
		helper.advance(p_now_usec / 1e6)
	return []


func close() -> void:
	if helper != null:
		helper.stop()


func place() -> String:
	return _camera


func obstacle() -> String:
	return helper.fault if helper != null else ""


func detail(p_sender: String) -> String:
	return _news[p_sender][0] if _news.has(p_sender) else ""


func trouble(p_sender: String) -> String:
	return _news[p_sender][1] if _news.has(p_sender) else ""


func read(p_bytes: PackedByteArray, p_sender: String) -> Array[StreamSample]:
	var none: Array[StreamSample] = []
	if helper != null and WebcamPicture.is_jpeg(p_bytes):
		picture.take_picture(p_bytes)
		return none
	var message: Dictionary = _json.read(p_bytes)
	if _json.fault != "":
		return refuse(_json.fault)
	if message.has("status"):
		_take_news(StreamJson.child(message, "status"), p_sender)
		return none
	var points: Array = StreamJson.list(message, "world_landmarks")
	if points.is_empty():
		points = StreamJson.list(message, "worldLandmarks")
	# MediaPipe's result has a list for each person; one person's is enough.
	if points.size() > 0 and points[0] is Array and points[0].size() == POINTS:
		points = points[0]
	if points.size() != POINTS:
		return refuse("%d landmarks instead of %d" % [points.size(), POINTS])
	return _read_person(points, message, p_sender)


func _read_person(p_points: Array, p_message: Dictionary, p_sender: String) -> Array[StreamSample]:
	var frame: LandmarkFrame = LandmarkFrame.new()
	for point: Variant in p_points:
		var numbers: PackedFloat64Array = _numbers(point)
		if numbers.is_empty():
			return refuse("a landmark is no [x, y, z, visibility] of finite numbers")
		# A half turn about X: Y up, and who faces the camera faces +Z.
		frame.places.append(Vector3(numbers[0], -numbers[1], -numbers[2]))
		frame.seen.append(clampf(numbers[3], 0.0, 1.0))
	var why: String = _read_picture(p_message, frame)
	if why != "":
		return refuse(why)
	var sample: StreamSample = StreamSample.new()
	sample.name = StreamJson.text(p_message, "name")
	sample.person = str(p_message.get("person", 0)).left(20)
	var time_s: float = StreamJson.number(p_message, "time")
	sample.source_usec = roundi(time_s * 1e6) if time_s >= 0.0 and time_s < 1e11 else -1
	frame.usec = sample.source_usec if sample.source_usec >= 0 else now_usec
	if not frame.rays.is_empty():
		picture.take_person(p_sender + sample.person, frame.in_picture, now_usec)
	var solver: LandmarkSolver = _solver_of(p_sender + " " + sample.person)
	sample.pose = solver.solve(frame)
	if sample.pose == null:
		return refuse("hips and shoulders are not seen")
	sample.hip_height = solver.hip_height()
	return [sample] as Array[StreamSample]


## Reads where points are in the picture, if the message says so. Returns what is wrong, or an empty
## text.
func _read_picture(p_message: Dictionary, r_frame: LandmarkFrame) -> String:
	var size: Array = StreamJson.list(p_message, "picture")
	var points: Array = StreamJson.list(p_message, "landmarks")
	if size.size() != 2 or points.size() != POINTS:
		return ""
	for value: Variant in size:
		if not (value is float and value >= 1.0 and value <= _MAX_PX):
			return "a picture's size is two numbers of pixels"
	for point: Variant in points:
		var numbers: PackedFloat64Array = _numbers(point)
		if numbers.is_empty():
			return "a landmark in the picture is no [x, y, z, visibility] of finite numbers"
		r_frame.in_picture.append(Vector3(numbers[0], numbers[1], numbers[3]))
	r_frame.set_rays(float(size[1]) / float(size[0]), _settings.fov_deg)
	return ""


func _solver_of(p_key: String) -> LandmarkSolver:
	if not _solvers.has(p_key):
		if _solvers.size() >= PoseStream.MAX_PEOPLE:
			_solvers.erase(_solvers.keys()[0])
		_solvers[p_key] = LandmarkSolver.new(_settings)
	return _solvers[p_key]


func _take_news(p_status: Dictionary, p_sender: String) -> void:
	var faults: PackedStringArray = []
	for fault: Variant in StreamJson.list(p_status, "faults").slice(0, _MAX_FAULTS):
		faults.append(ByteReader.clean(str(fault)).left(_FAULT_LETTERS))
	var rate: float = StreamJson.number(p_status, "rate_hz")
	var work: float = StreamJson.number(p_status, "work_ms")
	var detail: String = ""
	if absf(rate) < 1e4 and absf(work) < 1e5:
		detail = "%.0f pictures/s, %.0f ms each" % [rate, work]
	if _news.size() >= PoseStream.MAX_SENDERS:
		_news.clear()
	_news[p_sender] = PackedStringArray([detail, "; ".join(faults)])


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
