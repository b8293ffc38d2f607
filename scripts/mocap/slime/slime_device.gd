class_name SlimeDevice
extends RefCounted
## One SlimeVR tracker: a board on the network with one or more sensors.

## Packets of trackers, and of the server.
enum Packet {
	HEARTBEAT_REPLY = 0,
	## From the server a sign of life; from old trackers the rotation of their first sensor.
	HEARTBEAT = 1,
	HANDSHAKE = 3,
	ACCELERATION = 4,
	PING = 10,
	BATTERY = 12,
	ERROR = 14,
	SENSOR_INFO = 15,
	## The rotation of an old tracker's second sensor.
	ROTATION_2 = 16,
	ROTATION = 17,
	SIGNAL = 19,
	FEATURES = 22,
	ROTATION_AND_ACCELERATION = 23,
	BUNDLE = 100,
}

## What SlimeVR says of where a tracker is worn, by its numbers.
const MOUNTS: Array[StringName] = [
	&"",
	&"head",
	&"",
	&"sternum",
	&"sternum",
	&"pelvis",
	&"pelvis",
	&"left_thigh",
	&"right_thigh",
	&"left_shank",
	&"right_shank",
	&"left_foot",
	&"right_foot",
	&"left_forearm",
	&"right_forearm",
	&"left_upper_arm",
	&"right_upper_arm",
	&"left_hand",
	&"right_hand",
	&"left_shoulder",
	&"right_shoulder",
]
## A tracker's sensors.
const MAX_SENSORS: int = 16
## Silence after which a device may number its packets anew, µs.
const RESTART_USEC: int = 3000000
## Distance behind the newest packet beyond which a packet is not late: the device counts anew.
const RESTART_PACKETS: int = 1000
## From this version of the protocol on accelerations are in the axes of the rotation (SlimeVR's
## pull request 480).
const ACCELERATION_VERSION: int = 22

## Its hardware address, or its address on the network where it has none.
var id: String = ""
## Where it is: an IPv4 address and a UDP port.
var address: String = ""
var port: int = 0
## Firmware, and version of the protocol.
var firmware: String = ""
var version: int = 0
## How full its battery is, 0 to 1, -1 where that is not known, and the radio's strength, dBm, or 0.
var battery: float = -1.0
var signal_dbm: int = 0
## How long a datagram needs there and back, s; -1 where that is not known.
var ping_s: float = -1.0
## When something came last, and when something was sent, µs of Unix time.
var heard_usec: int = 0
var reported_usec: int = 0
## Number and time of the last ping.
var ping_number: int = 0
var ping_usec: int = 0
## Its sensors by number.
var sensors: Dictionary[int, SlimeSensor] = {}
## Packets that came, that got lost, and that came twice or late.
var packets: int = 0
var lost: int = 0
var twice: int = 0

## Sensors that have come since somebody looked, and whether one is worn elsewhere now.
var fresh: Array[SlimeSensor] = []
var is_moved: bool = false
## What is to be sent to it.
var answers: Array[PackedByteArray] = []

var _buffer: StreamPeerBuffer = null
var _number: int = -1


## Whether a packet's number is newer than the last one's; others came twice or too late.
func is_fresh(p_number: int, p_usec: int) -> bool:
	var steps: int = p_number - _number
	var is_anew: bool = _number < 0 or p_usec - heard_usec > RESTART_USEC
	if not is_anew and steps <= 0 and steps > -RESTART_PACKETS:
		twice += 1
		return false
	if not is_anew and steps > 1 and steps < RESTART_PACKETS:
		lost += steps - 1
	_number = p_number
	packets += 1
	return true


## It has introduced itself: packets are numbered anew.
func restart() -> void:
	_number = -1


## Share of the packets that got lost, 0 to 1.
func loss() -> float:
	return float(lost) / (lost + packets) if packets > 0 else 0.0


## For the panel, see [constant DeviceList.KEYS].
func row(p_now_usec: int) -> Dictionary:
	var notes: PackedStringArray = ["%d sensors" % sensors.size()]
	var rate: float = 0.0
	var magnetometers: PackedStringArray = []
	for sensor: SlimeSensor in sensors.values():
		rate = maxf(rate, sensor.info.rate_hz)
		var state: String = SlimeSensor.MAGNETOMETERS[sensor.magnetometer]
		if state != "" and not magnetometers.has(state):
			magnetometers.append(state)
	notes.append("%.0f Hz" % rate)
	notes.append_array(magnetometers)
	if battery >= 0.0:
		notes.append("battery %.0f %%" % (100.0 * battery))
	if signal_dbm != 0:
		notes.append("%d dBm" % signal_dbm)
	if ping_s >= 0.0:
		notes.append("ping %.0f ms" % (1000.0 * ping_s))
	if lost > 0:
		notes.append("%.1f %% lost" % (100.0 * loss()))
	if firmware != "":
		notes.append("firmware " + firmware)
	var is_silent: bool = p_now_usec - heard_usec > 1000000
	return {
		"name": title(),
		"state": "silent" if is_silent else "streams",
		"detail": ", ".join(notes),
		"advice": trouble(),
	}


## The tracker's name for people.
func title() -> String:
	return "SlimeVR %s (%s)" % [id, address]


## What is wrong with the first of its sensors with which something is; empty if all is well.
func trouble() -> String:
	for sensor: SlimeSensor in sensors.values():
		if sensor.info.trouble != "":
			return sensor.info.trouble
	return ""


## A packet of the server: its type, a number that nobody looks at, and what is in it.
static func packet(p_type: Packet, p_content: PackedByteArray) -> PackedByteArray:
	var bytes: PackedByteArray = [0, 0, 0, p_type, 0, 0, 0, 0, 0, 0, 0, 0]
	bytes.append_array(p_content)
	return bytes


## Reads the content of a packet from one place in a big-endian buffer to another. Returns what is
## wrong with it, or an empty text.
func read(p_buffer: StreamPeerBuffer, p_type: int, p_begin: int, p_end: int, p_usec: int) -> String:
	var size: int = p_end - p_begin
	_buffer = p_buffer
	_buffer.seek(p_begin)
	match p_type:
		Packet.ROTATION:
			if size < 18:
				return "a rotation of %d bytes" % size
			var number: int = _buffer.get_u8()
			# 1 is a rotation, 2 a correction that SlimeVR's server does not use either.
			if _buffer.get_u8() == 1:
				return _take_turn(number, _floats(), p_usec)
		Packet.HEARTBEAT, Packet.ROTATION_2:
			if size >= 16:
				return _take_turn(p_type / 16, _floats(), p_usec)
		Packet.ROTATION_AND_ACCELERATION:
			if size < 15:
				return "a rotation with acceleration of %d bytes" % size
			return _take_short(p_usec)
		Packet.ACCELERATION:
			if size < 12:
				return "an acceleration of %d bytes" % size
			var felt: Vector3 = Vector3(
				_buffer.get_float(), _buffer.get_float(), _buffer.get_float()
			)
			_take_acceleration(_buffer.get_u8() if size > 12 else 0, felt)
		Packet.BUNDLE:
			return _read_bundle(p_begin, p_end, p_usec)
		_:
			_read_state(p_type, size, p_usec)
	return ""


func _read_bundle(p_begin: int, p_end: int, p_usec: int) -> String:
	var at: int = p_begin
	while at + 2 <= p_end:
		_buffer.seek(at)
		var size: int = _buffer.get_u16()
		at += 2
		if size < 4 or size > p_end - at:
			return "a part of %d bytes in a bundle that has %d left" % [size, p_end - at]
		_buffer.seek(at)
		var type: int = _buffer.get_32()
		if type != Packet.BUNDLE:
			var fault: String = read(_buffer, type, at + 4, at + size, p_usec)
			if fault != "":
				return fault
		at += size
	return ""


## Reads packets that say how a tracker is.
func _read_state(p_type: int, p_size: int, p_usec: int) -> void:
	match p_type:
		Packet.PING:
			if p_size >= 4 and _buffer.get_32() == ping_number & 0x7F:
				ping_s = (p_usec - ping_usec) / 1e6
		Packet.BATTERY:
			if p_size >= 8:
				_buffer.get_float()
			if p_size >= 4:
				var level: float = _buffer.get_float()
				battery = clampf(level, 0.0, 1.0) if is_finite(level) else -1.0
		Packet.SIGNAL:
			if p_size >= 2:
				_buffer.get_u8()
				signal_dbm = _buffer.get_8()
		Packet.ERROR:
			if p_size >= 2:
				var sensor: SlimeSensor = _sensor(_buffer.get_u8())
				if sensor != null:
					sensor.info.trouble = "the sensor reports error %d" % _buffer.get_u8()
		Packet.SENSOR_INFO:
			if p_size >= 2:
				_read_sensor(p_size)
		Packet.FEATURES:
			# We understand bundles.
			var features: PackedByteArray = packet(Packet.FEATURES, PackedByteArray([1]))
			answers.append(features)


func _read_sensor(p_size: int) -> void:
	var number: int = _buffer.get_u8()
	var state: int = _buffer.get_u8()
	var sensor: SlimeSensor = _sensor(number)
	if sensor == null:
		return
	# 0 is not there, 1 works, 2 has failed.
	sensor.info.trouble = (
		"the sensor has failed: switch the tracker off and on" if state == 2 else ""
	)
	if state == 2:
		sensor.info.state = SensorInfo.State.FAILED
	elif sensor.info.state == SensorInfo.State.FAILED:
		sensor.info.state = SensorInfo.State.WAITING
	if p_size >= 5:
		_buffer.get_u8()
		# The lowest bit: a magnetometer is used; the next one: there is one.
		var settings: int = _buffer.get_u16()
		sensor.magnetometer = SlimeSensor.Magnetometer.NONE
		if settings & 3 != 0:
			var is_used: bool = settings & 1 != 0
			sensor.magnetometer = (
				SlimeSensor.Magnetometer.ON if is_used else SlimeSensor.Magnetometer.OFF
			)
	if p_size >= 7:
		_buffer.get_u8()
		var place: int = _buffer.get_u8()
		var mount: StringName = MOUNTS[place] if place < MOUNTS.size() else &""
		if mount != sensor.info.mount:
			sensor.info.mount = mount
			is_moved = true
	var answer: PackedByteArray = [0, 0, 0, Packet.SENSOR_INFO, number, state]
	answers.append(answer)


## The sensor of a number, a new one if there is none yet; null beyond the limits.
func _sensor(p_number: int) -> SlimeSensor:
	if sensors.has(p_number):
		return sensors[p_number]
	if p_number >= MAX_SENSORS:
		return null
	var sensor: SlimeSensor = SlimeSensor.new()
	sensor.info.id = "%s-%d" % [id, p_number]
	sensor.info.where = "SlimeVR %s / %d" % [id, p_number]
	sensors[p_number] = sensor
	fresh.append(sensor)
	return sensor


func _floats() -> Quaternion:
	return Quaternion(
		_buffer.get_float(), _buffer.get_float(), _buffer.get_float(), _buffer.get_float()
	)


func _take_turn(p_number: int, p_turn: Quaternion, p_usec: int) -> String:
	# A comparison that NaN fails, too.
	if not absf(p_turn.length() - 1.0) < 0.1:
		return "sensor %d has a rotation of length %.2f" % [p_number, p_turn.length()]
	var sensor: SlimeSensor = _sensor(p_number)
	if sensor == null:
		return "a sensor of number %d" % p_number
	var turn: Quaternion = SourceFrames.rotation(
		p_turn.w, p_turn.x, p_turn.y, p_turn.z, SourceFrames.Frame.BVH_Z_UP
	)
	sensor.take_turn(turn.normalized(), p_usec)
	return ""


## Numbers of 16 bits: the rotation's are parts of 2^15, the acceleration's of 2^7.
func _take_short(p_usec: int) -> String:
	var number: int = _buffer.get_u8()
	var turn: Quaternion = Quaternion(
		_buffer.get_16() / 32768.0,
		_buffer.get_16() / 32768.0,
		_buffer.get_16() / 32768.0,
		_buffer.get_16() / 32768.0
	)
	var felt: Vector3 = Vector3(
		_buffer.get_16() / 128.0, _buffer.get_16() / 128.0, _buffer.get_16() / 128.0
	)
	_take_acceleration(number, felt)
	return _take_turn(number, turn, p_usec)


func _take_acceleration(p_number: int, p_felt: Vector3) -> void:
	var sensor: SlimeSensor = _sensor(p_number)
	if sensor == null or version < ACCELERATION_VERSION:
		return
	if p_felt.is_finite() and p_felt.length() < 400.0:
		sensor.take_acceleration(SourceFrames.vector(p_felt, SourceFrames.Frame.BVH_Z_UP))
