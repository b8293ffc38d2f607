class_name UsbSuitFeed
extends SensorFeed
## The suit that is plugged in: all trackers of all masters on this machine's USB ports.
##
## Trackers keep their place in the list by their device ids, also when a master is plugged out and
## in again. Masters measure each in its own time: a frame is one of the leading master's (the one
## with the most trackers), and the others' orientations are carried on to its time by the turn
## between their last two.

## How far an orientation is carried on at most, s.
const MAX_AHEAD_S: float = 0.03
## A tracker that is silent for so long is called so, s.
const SILENT_S: float = 0.5

## What is said of the devices, for the screen: names, states, troubles; see
## [method SuitHub.get_devices].
var devices: Array[Dictionary] = []

var _hub: SuitHub = SuitHub.new()
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _sensors: Array[SensorInfo] = []
var _places: Dictionary[String, int] = {}
## For each device its number, and the places of its trackers in the list.
var _trackers: Dictionary[int, PackedInt32Array] = {}
var _leader: int = -1
## The newest two frames of each device that does not lead.
var _followers: Dictionary[int, Array] = {}


## Looks for suits, which are to measure so many times a second. [member error] tells why it cannot.
func open(p_rate_hz: float) -> void:
	error = _hub.start(p_rate_hz)


## Records every byte of the suits that are opened from now on; null does not.
func record_to(p_recorder: RawRecorder) -> void:
	_hub.set_recorder(p_recorder)


## Gives all devices back.
func close() -> void:
	_hub.stop()


## Goes on, in the main thread: tells the log what happens, finds new trackers.
func advance() -> void:
	for message: Dictionary in _hub.take_messages():
		if message["severity"] == 0:
			Log.info("suit", message["text"])
		else:
			Log.warning("suit", message["text"])
	var found: Array[Dictionary] = _hub.get_devices()
	_mutex.lock()
	devices = found
	for device: Dictionary in found:
		_take_device(device)
	_choose_leader()
	_mutex.unlock()


## Asks all trackers to take their present orientation anew: the object reset of the trackers
## themselves.
func reset_trackers(p_method: SuitHub.Reset) -> void:
	for device: Dictionary in devices:
		_hub.reset_orientation(device["number"], p_method)


func list_sensors() -> Array[SensorInfo]:
	_mutex.lock()
	var sensors: Array[SensorInfo] = []
	for sensor: SensorInfo in _sensors:
		sensors.append(sensor.copy())
	_mutex.unlock()
	return sensors


func take_frames() -> Array[SensorFrame]:
	var frames: Array[SensorFrame] = []
	_mutex.lock()
	for number: int in _trackers:
		if number == _leader:
			continue
		for raw: Dictionary in _hub.take_frames(number):
			_remember(number, _convert(number, raw))
	if _leader >= 0:
		for raw: Dictionary in _hub.take_frames(_leader):
			var frame: SensorFrame = _convert(_leader, raw)
			for number: int in _followers:
				_carry_on(number, frame)
			frames.append(frame)
	_mutex.unlock()
	return frames


func describe() -> String:
	var measuring: int = 0
	for device: Dictionary in devices:
		measuring += 1 if device["measures"] else 0
	if measuring == 0:
		return "no suit on USB yet"
	return "%d trackers on USB" % _sensors.size()


## Whether every device that answers measures: none is still being set up.
func is_settled() -> bool:
	for device: Dictionary in devices:
		var is_known: bool = device["is_open"] and device["id"] != 0
		if is_known and not device["measures"] and device["state"] != "not supported":
			return false
	return true


## The devices in plain words, for a panel: name, state, detail and advice, texts all.
func list_devices() -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	for device: Dictionary in devices:
		var details: PackedStringArray = []
		if device["id"] != 0:
			details.append("%s %08X" % [device["kind"], device["id"]])
		if device["measures"]:
			details.append("%.0f Hz" % device["rate_hz"])
		if device["baud"] != 0:
			details.append("%d bit/s" % device["baud"])
		if device["battery"] >= 0.0:
			details.append("battery %.0f %%" % (100.0 * device["battery"]))
		if device["malformed_bytes"] != 0:
			details.append("%d bad bytes" % device["malformed_bytes"])
		var row: Dictionary = {
			"name": "%s (%s)" % [device["name"], device["place"]],
			"state": device["state"],
			"detail": ", ".join(details),
			"advice": device["trouble"],
		}
		rows.append(row)
	return rows


## What is wrong with the devices, for people; empty if nothing is.
func trouble() -> String:
	var texts: PackedStringArray = []
	for device: Dictionary in devices:
		if device["trouble"] != "" and not device["measures"]:
			texts.append("%s: %s" % [device["name"], device["trouble"]])
	return "\n".join(texts)


func _take_device(p_device: Dictionary) -> void:
	var number: int = p_device["number"]
	var trackers: Array = p_device["trackers"]
	if trackers.is_empty():
		return
	var places: PackedInt32Array = []
	for tracker: Dictionary in trackers:
		var id: String = "%08X" % tracker["id"]
		if not _places.has(id):
			_places[id] = _sensors.size()
			var fresh: SensorInfo = SensorInfo.new()
			fresh.id = id
			_sensors.append(fresh)
			revision += 1
		places.append(_places[id])
		# One that has not been heard yet may be known by a device that was there before.
		if tracker["age_s"] >= 0.0 or not is_finite(_sensors[_places[id]].age_s):
			_describe(_sensors[_places[id]], tracker, p_device)
	_trackers[number] = places


func _describe(p_sensor: SensorInfo, p_tracker: Dictionary, p_device: Dictionary) -> void:
	p_sensor.where = "%s %08X / %d" % [p_device["kind"], p_device["id"], p_tracker["bus_id"]]
	p_sensor.rate_hz = p_tracker["rate_hz"]
	p_sensor.age_s = p_tracker["age_s"] if p_tracker["age_s"] >= 0.0 else INF
	p_sensor.battery = p_device["battery"]
	p_sensor.trouble = p_device["trouble"]
	var counted: int = p_tracker["received"] + p_tracker["lost"]
	p_sensor.loss = float(p_tracker["lost"]) / counted if counted > 0 else 0.0
	p_sensor.state = SensorInfo.State.WAITING
	if p_sensor.age_s < SILENT_S:
		p_sensor.state = SensorInfo.State.MEASURING
	elif is_finite(p_sensor.age_s):
		p_sensor.state = SensorInfo.State.SILENT


func _choose_leader() -> void:
	var most: int = 0
	_leader = -1
	for device: Dictionary in devices:
		var count: int = (device["trackers"] as Array).size()
		if count > most and device["measures"] and _is_heard(device):
			most = count
			_leader = device["number"]
	# Those that are gone are forgotten; their trackers stay in the list, silent.
	var here: Array = devices.map(func(device: Dictionary) -> int: return device["number"])
	for number: int in _trackers.keys():
		if not here.has(number):
			for place: int in _trackers[number]:
				_sensors[place].state = SensorInfo.State.SILENT
			_trackers.erase(number)
			_followers.erase(number)
	_followers.erase(_leader)


## Whether something has come of a device lately: one that is silent can't lead.
static func _is_heard(p_device: Dictionary) -> bool:
	for tracker: Dictionary in p_device["trackers"]:
		if tracker["age_s"] >= 0.0 and tracker["age_s"] < SILENT_S:
			return true
	return false


func _convert(p_number: int, p_raw: Dictionary) -> SensorFrame:
	var axes: Array[SourceFrames.Frame] = [
		SourceFrames.Frame.XSENS_ENU, SourceFrames.Frame.XSENS_NED, SourceFrames.Frame.XSENS
	]
	var turns: PackedFloat32Array = SourceFrames.rotations(
		p_raw["orientations"], axes[mini(p_raw["axes"], 2)]
	)
	var rates: PackedVector3Array = SourceFrames.sensor_vectors(p_raw["rates"])
	var accelerations: PackedVector3Array = SourceFrames.sensor_vectors(p_raw["accelerations"])
	var present: PackedByteArray = p_raw["present"]
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(_sensors.size(), not rates.is_empty(), not accelerations.is_empty())
	frame.time_usec = p_raw["time_usec"]
	frame.counter = p_raw["counter"]
	var places: PackedInt32Array = _trackers[p_number]
	for tracker: int in mini(present.size(), places.size()):
		if present[tracker] == 0:
			continue
		var at: int = tracker * 4
		var turn: Quaternion = Quaternion(turns[at], turns[at + 1], turns[at + 2], turns[at + 3])
		frame.set_orientation(places[tracker], turn)
		if not rates.is_empty():
			frame.rates[places[tracker]] = rates[tracker]
		if not accelerations.is_empty():
			frame.accelerations[places[tracker]] = accelerations[tracker]
	return frame


func _remember(p_number: int, p_frame: SensorFrame) -> void:
	var last: Array = _followers.get_or_add(p_number, [])
	last.append(p_frame)
	if last.size() > 2:
		last.pop_front()


## Puts what a device said last into a frame of the leader, as of the leader's time.
func _carry_on(p_number: int, p_frame: SensorFrame) -> void:
	var last: Array = _followers[p_number]
	var newest: SensorFrame = last[last.size() - 1]
	var ahead: float = (p_frame.time_usec - newest.time_usec) / 1e6
	if absf(ahead) > SILENT_S:
		return
	var before: SensorFrame = last[0]
	var step: float = (newest.time_usec - before.time_usec) / 1e6
	ahead = clampf(ahead, -MAX_AHEAD_S, MAX_AHEAD_S)
	for place: int in mini(newest.count(), p_frame.count()):
		if newest.present[place] == 0 or p_frame.present[place] != 0:
			continue
		var turn: Quaternion = newest.orientation(place)
		if step > 0.0 and place < before.count() and before.present[place] != 0:
			var turned: Vector3 = Rotations.vector(turn * before.orientation(place).inverse())
			turn = Rotations.from_vector(turned * (ahead / step)) * turn
		p_frame.set_orientation(place, turn.normalized())
		if not p_frame.rates.is_empty() and place < newest.rates.size():
			p_frame.rates[place] = newest.rates[place]
