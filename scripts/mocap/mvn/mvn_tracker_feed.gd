class_name MvnTrackerFeed
extends SensorFeed
## The trackers of one person of MVN's stream (type 23), for those who calibrate here rather than in
## MVN.

## Time without samples after which a tracker counts as silent, s.
const SILENT_S: float = 0.5

## The character's number in the stream.
var character: int = 0

var _receiver: MvnReceiver = null
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _sensors: Array[SensorInfo] = []
var _positions: Dictionary[int, int] = {}
var _heard_usec: PackedInt64Array = PackedInt64Array()
var _stats: Dictionary = {}


func _init(p_receiver: MvnReceiver = null, p_character: int = 0) -> void:
	_receiver = p_receiver
	character = p_character


## Takes the stats of this person's stream, see [method MvnReceiver.get_characters].
func note(p_stats: Dictionary) -> void:
	_mutex.lock()
	_stats = p_stats
	_mutex.unlock()


func list_sensors() -> Array[SensorInfo]:
	var now: int = Time.get_ticks_usec()
	var sensors: Array[SensorInfo] = []
	_mutex.lock()
	for at: int in _sensors.size():
		var info: SensorInfo = _sensors[at].copy()
		info.age_s = (now - _heard_usec[at]) / 1e6
		info.state = SensorInfo.State.SILENT
		if info.age_s < SILENT_S:
			info.state = SensorInfo.State.MEASURING
		info.rate_hz = _stats.get("rate_hz", 0.0)
		info.trouble = _stats.get("trouble", "")
		var counted: int = _stats.get("samples", 0) + _stats.get("lost", 0)
		info.loss = float(_stats.get("lost", 0)) / counted if counted > 0 else 0.0
		sensors.append(info)
	_mutex.unlock()
	return sensors


func take_frames() -> Array[SensorFrame]:
	var frames: Array[SensorFrame] = []
	_mutex.lock()
	for sample: Dictionary in _receiver.take_trackers(character):
		frames.append(_convert(sample))
	_mutex.unlock()
	return frames


func describe() -> String:
	return "%d trackers of MVN at %s" % [_sensors.size(), _stats.get("sender", "nobody yet")]


func _convert(p_sample: Dictionary) -> SensorFrame:
	var segments: PackedInt32Array = p_sample["segments"]
	var present: PackedByteArray = p_sample["present"]
	for item: int in segments.size():
		if present[item] != 0 and not _positions.has(segments[item]):
			_add_sensor(segments[item])
	var turns: PackedFloat32Array = SourceFrames.rotations(p_sample["orientations"])
	var rates: PackedVector3Array = SourceFrames.sensor_vectors(p_sample["rates"])
	var accelerations: PackedVector3Array = SourceFrames.sensor_vectors(p_sample["accelerations"])
	var magnetics: PackedVector3Array = SourceFrames.sensor_vectors(p_sample["magnetic_fields"])
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(
		_sensors.size(),
		not rates.is_empty(),
		not accelerations.is_empty(),
		not magnetics.is_empty()
	)
	frame.time_usec = p_sample["time_usec"]
	frame.counter = p_sample["sample"]
	var now: int = Time.get_ticks_usec()
	for item: int in segments.size():
		if present[item] == 0:
			continue
		var position: int = _positions[segments[item]]
		var at: int = item * 4
		var turn: Quaternion = Quaternion(turns[at], turns[at + 1], turns[at + 2], turns[at + 3])
		frame.set_orientation(position, turn.normalized())
		_heard_usec[position] = now
		if not rates.is_empty():
			frame.rates[position] = rates[item]
		if not accelerations.is_empty():
			frame.accelerations[position] = accelerations[item]
		if not magnetics.is_empty():
			frame.magnetics[position] = magnetics[item]
	return frame


func _add_sensor(p_segment: int) -> void:
	var info: SensorInfo = SensorInfo.new()
	var names: PackedStringArray = MvnEncoder.get_segment_names()
	var number: int = p_segment - 1
	info.id = "segment %d" % p_segment
	if number >= 0 and number < names.size():
		info.id = names[number]
		info.mount = MvnSegments.MOUNTS[number]
	info.where = "MVN %d / %d" % [character, p_segment]
	_positions[p_segment] = _sensors.size()
	_sensors.append(info)
	_heard_usec.append(0)
	revision += 1
