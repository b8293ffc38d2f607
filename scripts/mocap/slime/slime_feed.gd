class_name SlimeFeed
extends SensorFeed
## SlimeVR trackers, spoken to directly, in the place of SlimeVR's server: they look for it by
## broadcasts on UDP port 6969, and appear one by one. Facts of the protocol are from SlimeVR's
## firmware (src/network) and server (UDPPacket.kt); numbers are big-endian.
##
## A sensor's rotation is from its axes to a frame with Z up. Trackers measure each in its own time:
## a frame has all of them at one moment a little back.

## What the server answers to a tracker that looks for it.
const ANSWER: String = "Hey OVR =D 5"
## Trackers that are taken.
const MAX_DEVICES: int = 32
## Period of signs of life (trackers look for another server after 3 s without) and of pings, µs.
const ALIVE_USEC: int = 1000000
const PING_USEC: int = 3000000
## Period of frames, and how far back they are, µs.
const FRAME_USEC: int = 10000
const BACK_USEC: int = 15000
## Frames that are made at once at most.
const _MAX_FRAMES: int = 32
## Silence after which a tracker that has sent only its name may be forgotten, µs.
const _IDLE_USEC: int = 5000000
## Silence after which a tracker that measured makes room for others, if there is none, µs.
const _LOST_USEC: int = 60000000
## Time for which a fault is shown, µs.
const _TOLD_USEC: int = 10000000
## Sensors in the list at most, those of trackers that are gone too.
const _MAX_SENSORS: int = 256
const _HEADER: int = 12

var _port: StreamPort = StreamPort.new()
var _buffer: StreamPeerBuffer = StreamPeerBuffer.new()
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _devices: Dictionary[String, SlimeDevice] = {}
var _by_sender: Dictionary[String, SlimeDevice] = {}
var _sensors: Array[SlimeSensor] = []
var _refused: int = 0
var _why: String = ""
var _why_usec: int = 0
var _frame_usec: int = 0


func _init() -> void:
	_buffer.big_endian = true


## Opens the UDP port; 0 takes any that is free. [member error] says why it can't.
func open(p_port: int) -> void:
	error = _port.open_udp(p_port, take)
	if error != "":
		error = "SlimeVR: " + error
		return
	Log.info("mocap", "waits for SlimeVR trackers on %s" % _port.describe())


## Closes the port.
func close() -> void:
	_port.close()


## The UDP port that is open, 0 if none is.
func get_port() -> int:
	return _port.get_port()


## Goes on, in the main thread: tells trackers that somebody is there.
func advance() -> void:
	for parcel: StreamPort.Parcel in talk(roundi(Time.get_unix_time_from_system() * 1e6)):
		_port.send(parcel.bytes, parcel.address, parcel.port)


## What is to be sent to trackers now, at a time in µs of Unix time.
func talk(p_now_usec: int) -> Array[StreamPort.Parcel]:
	var parcels: Array[StreamPort.Parcel] = []
	_mutex.lock()
	for device: SlimeDevice in _devices.values():
		if p_now_usec - device.reported_usec >= ALIVE_USEC:
			device.reported_usec = p_now_usec
			parcels.append(
				_parcel(device, SlimeDevice.packet(SlimeDevice.Packet.HEARTBEAT, PackedByteArray()))
			)
		if p_now_usec - device.ping_usec >= PING_USEC:
			device.ping_usec = p_now_usec
			device.ping_number += 1
			var number: PackedByteArray = [0, 0, 0, device.ping_number & 0x7F]
			parcels.append(_parcel(device, SlimeDevice.packet(SlimeDevice.Packet.PING, number)))
	_mutex.unlock()
	return parcels


func list_sensors() -> Array[SensorInfo]:
	var now: int = roundi(Time.get_unix_time_from_system() * 1e6)
	var found: Array[SensorInfo] = []
	_mutex.lock()
	for device: SlimeDevice in _devices.values():
		for sensor: SlimeSensor in device.sensors.values():
			sensor.info.battery = device.battery
			sensor.info.loss = device.loss()
	for sensor: SlimeSensor in _sensors:
		var info: SensorInfo = sensor.info.copy()
		if sensor.heard_usec > 0:
			info.age_s = (now - sensor.heard_usec) / 1e6
			if not sensor.is_heard(now) and info.state == SensorInfo.State.MEASURING:
				info.state = SensorInfo.State.SILENT
		found.append(info)
	_mutex.unlock()
	return found


func take_frames() -> Array[SensorFrame]:
	return frames_until(roundi(Time.get_unix_time_from_system() * 1e6))


## The frames that are due at a time, µs of Unix time.
func frames_until(p_now_usec: int) -> Array[SensorFrame]:
	var frames: Array[SensorFrame] = []
	_mutex.lock()
	var newest: int = 0
	for sensor: SlimeSensor in _sensors:
		newest = maxi(newest, sensor.heard_usec)
	var due: int = mini(p_now_usec, newest + FRAME_USEC) - BACK_USEC
	if due - _frame_usec > _MAX_FRAMES * FRAME_USEC or due < _frame_usec - 1000000:
		_frame_usec = due - FRAME_USEC
	while newest > 0 and _frame_usec + FRAME_USEC <= due:
		_frame_usec += FRAME_USEC
		frames.append(_frame(_frame_usec))
	_mutex.unlock()
	return frames


func describe() -> String:
	_mutex.lock()
	var trackers: int = _devices.size()
	var sensors: int = _sensors.size()
	_mutex.unlock()
	if trackers == 0:
		return "no SlimeVR trackers on %s yet" % _port.describe()
	return "%d SlimeVR trackers with %d sensors" % [trackers, sensors]


## For the panel: the port and every tracker, see [constant DeviceList.KEYS].
func list_devices() -> Array[Dictionary]:
	var now: int = roundi(Time.get_unix_time_from_system() * 1e6)
	_mutex.lock()
	var rows: Array[Dictionary] = [
		{
			"name": _title(),
			"state": "waits" if _devices.is_empty() else "receives",
			"detail": "%d bad packets" % _refused if _refused > 0 else "",
			"advice": _trouble_at_port(now),
		}
	]
	for device: SlimeDevice in _devices.values():
		rows.append(device.row(now))
	_mutex.unlock()
	return rows


## What is wrong, for the screen; empty if nothing is.
func trouble() -> String:
	var texts: PackedStringArray = []
	_mutex.lock()
	var at_port: String = _trouble_at_port(roundi(Time.get_unix_time_from_system() * 1e6))
	if at_port != "":
		texts.append("%s: %s" % [_title(), at_port])
	for device: SlimeDevice in _devices.values():
		var text: String = device.trouble()
		if text != "":
			texts.append("%s: %s" % [device.title(), text])
	_mutex.unlock()
	return "\n".join(texts)


## Whether any sensor has been heard of.
func has_sensors() -> bool:
	_mutex.lock()
	var has_any: bool = not _sensors.is_empty()
	_mutex.unlock()
	return has_any


## Takes a datagram of a tracker that came at a time, µs of Unix time.
func take(p_bytes: PackedByteArray, p_sender: String, p_usec: int) -> void:
	var fault: String = ""
	_mutex.lock()
	if p_bytes.size() < 4 or p_bytes[0] != 0 or p_bytes[1] != 0 or p_bytes[2] != 0:
		fault = "%d bytes are no SlimeVR packet" % p_bytes.size()
	elif p_bytes[3] == SlimeDevice.Packet.HANDSHAKE:
		fault = _introduce(p_bytes, p_sender, p_usec)
	elif _by_sender.has(p_sender) and p_bytes.size() >= _HEADER:
		var device: SlimeDevice = _by_sender[p_sender]
		_buffer.data_array = p_bytes
		_buffer.seek(4)
		if device.is_fresh(_buffer.get_64(), p_usec):
			device.heard_usec = p_usec
			fault = device.read(_buffer, p_bytes[3], _HEADER, p_bytes.size(), p_usec)
			_follow(device)
	if fault != "":
		_refused += 1
		_why = fault
		_why_usec = roundi(Time.get_unix_time_from_system() * 1e6)
	_mutex.unlock()
	if fault != "":
		Log.limited("mocap", "slime " + p_sender, "SlimeVR from %s: %s" % [p_sender, fault])


func _title() -> String:
	return "SlimeVR (%s)" % _port.describe()


## Why nothing that came at the port was of use, not long before a time, µs. The mutex is held.
func _trouble_at_port(p_now_usec: int) -> String:
	return _why if _devices.is_empty() and p_now_usec - _why_usec < _TOLD_USEC else ""


## Answers a tracker, and lists sensors of it that are new. The mutex is held, here and below.
func _follow(p_device: SlimeDevice) -> void:
	for answer: PackedByteArray in p_device.answers:
		_port.send(answer, p_device.address, p_device.port)
	p_device.answers.clear()
	for sensor: SlimeSensor in p_device.fresh:
		if _sensors.size() < _MAX_SENSORS:
			_sensors.append(sensor)
	if not p_device.fresh.is_empty() or p_device.is_moved:
		revision += 1
	p_device.fresh.clear()
	p_device.is_moved = false


## A tracker looks for a server.
func _introduce(p_bytes: PackedByteArray, p_sender: String, p_usec: int) -> String:
	if p_bytes.size() < _HEADER:
		return "a handshake of %d bytes" % p_bytes.size()
	var id: String = p_sender.get_slice(":", 0)
	var version: int = 0
	var firmware: String = ""
	# Board, sensor, processor, three that are not used, version, firmware's name, hardware address.
	if p_bytes.size() >= 41:
		_buffer.data_array = p_bytes
		_buffer.seek(36)
		version = _buffer.get_32()
		var length: int = p_bytes[40]
		if p_bytes.size() >= 41 + length:
			firmware = ByteReader.clean(p_bytes.slice(41, 41 + length).get_string_from_ascii())
		if p_bytes.size() >= 47 + length:
			var mac: String = p_bytes.slice(41 + length, 47 + length).hex_encode().to_upper()
			id = mac if mac != "000000000000" else id
	if not _devices.has(id):
		_forget_idle(p_usec)
		if _devices.size() >= MAX_DEVICES:
			return "more than %d trackers" % MAX_DEVICES
		_devices[id] = SlimeDevice.new()
		Log.info("mocap", "SlimeVR tracker %s at %s has come" % [id, p_sender])
	var device: SlimeDevice = _devices[id]
	_by_sender.erase("%s:%d" % [device.address, device.port])
	device.id = id
	device.address = p_sender.get_slice(":", 0)
	device.port = p_sender.get_slice(":", 1).to_int()
	device.firmware = firmware.left(32)
	device.version = version
	device.heard_usec = p_usec
	device.restart()
	_by_sender[p_sender] = device
	var answer: PackedByteArray = [SlimeDevice.Packet.HANDSHAKE]
	answer.append_array(ANSWER.to_ascii_buffer())
	answer.append(0)
	_port.send(answer, device.address, device.port)
	return ""


## Those that introduced themselves and never said more make room, at last also those that were
## silent for long; their sensors stay in the list.
func _forget_idle(p_usec: int) -> void:
	for id: String in _devices.keys():
		var device: SlimeDevice = _devices[id]
		var silent_usec: int = p_usec - device.heard_usec
		var is_full: bool = _devices.size() >= MAX_DEVICES
		var limit_usec: int = _IDLE_USEC if device.sensors.is_empty() else _LOST_USEC
		if silent_usec > limit_usec and (is_full or device.sensors.is_empty()):
			_by_sender.erase("%s:%d" % [device.address, device.port])
			_devices.erase(id)


func _frame(p_usec: int) -> SensorFrame:
	var has_accelerations: bool = true
	for sensor: SlimeSensor in _sensors:
		has_accelerations = has_accelerations and sensor.has_acceleration()
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(_sensors.size(), false, has_accelerations)
	frame.time_usec = p_usec
	frame.period_s = FRAME_USEC / 1e6
	for at: int in _sensors.size():
		if _sensors[at].is_heard(p_usec):
			var turn: Quaternion = _sensors[at].turn_at(p_usec)
			frame.set_orientation(at, turn)
			if has_accelerations:
				frame.accelerations[at] = _sensors[at].felt_acceleration(turn)
	return frame


static func _parcel(p_device: SlimeDevice, p_bytes: PackedByteArray) -> StreamPort.Parcel:
	return StreamPort.Parcel.new(p_bytes, p_device.address, p_device.port)
