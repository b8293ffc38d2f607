class_name UsbSuitFeed
extends SensorFeed
## The suit that is plugged in: all trackers of all masters on this machine's USB ports.
##
## Trackers keep their index in the list by their device ids, also when a master is plugged out
## and in again. Masters measure each in its own time: [DeviceJoin] makes frames of all.

## Time without samples after which a tracker counts as silent, s.
const SILENT_S: float = 0.5

const _FRAMES: Dictionary[SuitFrame.Axes, SourceFrames.Frame] = {
	SuitFrame.AXES_EAST_NORTH_UP: SourceFrames.Frame.XSENS_ENU,
	SuitFrame.AXES_NORTH_EAST_DOWN: SourceFrames.Frame.XSENS_NED,
	SuitFrame.AXES_NORTH_WEST_UP: SourceFrames.Frame.XSENS,
	SuitFrame.AXES_UNKNOWN: SourceFrames.Frame.XSENS,
}

## The devices as of the last [method advance].
var devices: Array[SuitDevice] = []

var _hub: SuitHub = SuitHub.new()
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _sensors: Array[SensorInfo] = []
var _indices: Dictionary[String, int] = {}
## For each device its number, and the indices of its trackers in the list.
var _trackers: Dictionary[int, PackedInt32Array] = {}
var _join: DeviceJoin = DeviceJoin.new()


## Looks for suits and sets them to measure so many times a second. [member error] says why it
## cannot.
func open(p_rate_hz: float) -> void:
	error = _hub.start(p_rate_hz)


## Records every byte of the suits that are opened from now on; null does not.
func record_to(p_recorder: RawRecorder) -> void:
	_hub.set_recorder(p_recorder)


## Gives all devices back.
func close() -> void:
	_hub.stop()


## Goes on, in the main thread: logs what happens, finds new trackers.
func advance() -> void:
	for message: SuitMessage in _hub.take_messages():
		if message.get_severity() == SuitMessage.SEVERITY_INFO:
			Log.info("suit", message.get_text())
		else:
			Log.warning("suit", message.get_text())
	var found: Array[SuitDevice] = _hub.get_devices()
	_mutex.lock()
	devices = found
	for device: SuitDevice in found:
		_take_device(device)
	_forget_absent()
	_mutex.unlock()


func list_sensors() -> Array[SensorInfo]:
	_mutex.lock()
	var sensors: Array[SensorInfo] = []
	for sensor: SensorInfo in _sensors:
		sensors.append(sensor.copy())
	_mutex.unlock()
	return sensors


func take_frames() -> Array[SensorFrame]:
	_mutex.lock()
	for number: int in _trackers:
		for raw: SuitFrame in _hub.take_frames(number):
			_join.push(number, _convert(number, raw))
	var frames: Array[SensorFrame] = _join.take()
	_mutex.unlock()
	return frames


func describe() -> String:
	var measuring: int = 0
	for device: SuitDevice in devices:
		measuring += 1 if device.is_measuring() else 0
	if measuring == 0:
		return "no suit on USB yet"
	return "%d trackers on USB" % _sensors.size()


## Whether every device that answers measures: none is still being set up.
func is_settled() -> bool:
	for device: SuitDevice in devices:
		var is_known: bool = device.is_open() and device.get_id() != 0
		var is_usable: bool = device.get_state() != SuitDevice.STATE_UNSUPPORTED
		if is_known and is_usable and not device.is_measuring():
			return false
	return true


## The devices in plain words, for a panel: name, state, detail and advice, texts all.
func list_devices() -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	for device: SuitDevice in devices:
		var details: PackedStringArray = []
		if device.get_id() != 0:
			details.append("%s %08X" % [device.get_kind_text(), device.get_id()])
		if device.is_measuring():
			details.append("%.0f Hz" % device.get_rate_hz())
		if device.get_baud() != 0:
			details.append("%d bit/s" % device.get_baud())
		if device.get_battery() >= 0.0:
			details.append("battery %.0f %%" % (100.0 * device.get_battery()))
		if device.get_malformed_bytes() != 0:
			details.append("%d bad bytes" % device.get_malformed_bytes())
		var row: Dictionary = {
			"name": "%s (%s)" % [device.get_name(), device.get_address()],
			"state": device.get_state_text(),
			"detail": ", ".join(details),
			"advice": device.get_problem(),
		}
		rows.append(row)
	return rows


## What is wrong with the devices, for people; empty if nothing is.
func trouble() -> String:
	var texts: PackedStringArray = []
	for device: SuitDevice in devices:
		if device.get_problem() != "" and not device.is_measuring():
			texts.append("%s: %s" % [device.get_name(), device.get_problem()])
	return "\n".join(texts)


func _take_device(p_device: SuitDevice) -> void:
	var number: int = p_device.get_number()
	var trackers: Array[SuitTracker] = p_device.get_trackers()
	if trackers.is_empty():
		return
	var indices: PackedInt32Array = []
	for tracker: SuitTracker in trackers:
		var id: String = "%08X" % tracker.get_id()
		if not _indices.has(id):
			_indices[id] = _sensors.size()
			var fresh: SensorInfo = SensorInfo.new()
			fresh.id = id
			_sensors.append(fresh)
			revision += 1
		indices.append(_indices[id])
		# One that has not been heard yet may be known by a device that was there before.
		if tracker.get_age_s() >= 0.0 or not is_finite(_sensors[_indices[id]].age_s):
			_describe(_sensors[_indices[id]], tracker, p_device)
	_trackers[number] = indices


func _describe(p_sensor: SensorInfo, p_tracker: SuitTracker, p_device: SuitDevice) -> void:
	var parts: Array = [p_device.get_kind_text(), p_device.get_id(), p_tracker.get_bus_id()]
	p_sensor.where = "%s %08X / %d" % parts
	p_sensor.rate_hz = p_tracker.get_rate_hz()
	p_sensor.age_s = p_tracker.get_age_s() if p_tracker.get_age_s() >= 0.0 else INF
	p_sensor.battery = p_device.get_battery()
	p_sensor.trouble = p_device.get_problem()
	var counted: int = p_tracker.get_received() + p_tracker.get_lost()
	p_sensor.loss = float(p_tracker.get_lost()) / counted if counted > 0 else 0.0
	p_sensor.state = SensorInfo.State.WAITING
	if p_sensor.age_s < SILENT_S:
		p_sensor.state = SensorInfo.State.MEASURING
	elif is_finite(p_sensor.age_s):
		p_sensor.state = SensorInfo.State.SILENT


## Forgets devices that are gone; their trackers stay in the list, silent.
func _forget_absent() -> void:
	var here: Array = devices.map(func(device: SuitDevice) -> int: return device.get_number())
	for number: int in _trackers.keys():
		if not here.has(number):
			for index: int in _trackers[number]:
				_sensors[index].state = SensorInfo.State.SILENT
			_trackers.erase(number)
			_join.forget(number)


func _convert(p_number: int, p_raw: SuitFrame) -> SensorFrame:
	var turns: PackedFloat32Array = SourceFrames.rotations(
		p_raw.get_orientations(), _FRAMES[p_raw.get_axes()]
	)
	var rates: PackedVector3Array = SourceFrames.sensor_vectors(p_raw.get_rates())
	var accelerations: PackedVector3Array = SourceFrames.sensor_vectors(p_raw.get_accelerations())
	var magnetics: PackedVector3Array = SourceFrames.sensor_vectors(p_raw.get_magnetics())
	var present: PackedByteArray = p_raw.get_present()
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(
		_sensors.size(),
		not rates.is_empty(),
		not accelerations.is_empty(),
		not magnetics.is_empty()
	)
	frame.time_usec = p_raw.get_time_usec()
	frame.counter = p_raw.get_counter()
	var indices: PackedInt32Array = _trackers[p_number]
	for tracker: int in mini(present.size(), indices.size()):
		if present[tracker] == 0:
			continue
		var at: int = tracker * 4
		var turn: Quaternion = Quaternion(turns[at], turns[at + 1], turns[at + 2], turns[at + 3])
		frame.set_orientation(indices[tracker], turn)
		if not rates.is_empty():
			frame.rates[indices[tracker]] = rates[tracker]
		if not accelerations.is_empty():
			frame.accelerations[indices[tracker]] = accelerations[tracker]
		if not magnetics.is_empty():
			frame.magnetics[indices[tracker]] = magnetics[tracker]
	return frame
