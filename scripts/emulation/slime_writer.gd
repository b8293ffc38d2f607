class_name SlimeWriter
extends StreamWriter
## A SlimeVR tracker with a sensor on each of some limbs, for trying without one: looks for a
## server, introduces its sensors, and sends rotations and accelerations in bundles. See
## [SlimeFeed].

## What it says of itself.
const FIRMWARE: String = "0.7.2"
const VERSION: int = 22
## Number of a mount in SlimeVR's list, for each mount of [BodyMounts].
const PLACES: PackedInt32Array = [6, 4, 1, 19, 15, 13, 17, 20, 16, 14, 18, 7, 9, 11, 8, 10, 12]
const _ASK_USEC: int = 1000000

## Mounts that have a sensor.
var mounts: PackedInt32Array = [0, 1, 4, 5, 8, 9, 11, 12, 13, 14, 15, 16]
## The hardware address.
var mac: PackedByteArray = [0x02, 0, 0, 0, 0, 0x01]

var _number: int = 0
var _is_connected: bool = false
var _asked_usec: int = -_ASK_USEC
var _told_usec: int = -_ASK_USEC
var _acked: Dictionary[int, bool] = {}


func set_person(p_number: int, _p_name: String) -> void:
	mac[5] = (p_number + 1) & 0xFF


func write(p_pose: PoseSample) -> Array[PackedByteArray]:
	if not _is_connected:
		if p_pose.time_usec - _asked_usec < _ASK_USEC:
			return []
		_asked_usec = p_pose.time_usec
		return [_packet(SlimeDevice.Packet.HANDSHAKE, _introduction())]
	var datagrams: Array[PackedByteArray] = []
	if p_pose.time_usec - _told_usec >= _ASK_USEC:
		_told_usec = p_pose.time_usec
		datagrams.append(_packet(SlimeDevice.Packet.FEATURES, PackedByteArray([6])))
		datagrams.append(_packet(SlimeDevice.Packet.BATTERY, _floats([3.9, 0.8])))
		for sensor: int in mounts.size():
			if not _acked.has(sensor):
				datagrams.append(_packet(SlimeDevice.Packet.SENSOR_INFO, _sensor_info(sensor)))
	var bundle: PackedByteArray = PackedByteArray()
	for sensor: int in mounts.size():
		var turn: Quaternion = p_pose.orientation(BodyMounts.LIMBS[mounts[sensor]]).normalized()
		# Z up, as the sensor has it.
		var content: PackedByteArray = [sensor, 1]
		content.append_array(_floats([turn.x, -turn.z, turn.y, turn.w]))
		content.append(0)
		_put(bundle, SlimeDevice.Packet.ROTATION, content)
		var felt: PackedByteArray = _floats([0.0, 0.0, 0.0])
		felt.append(sensor)
		_put(bundle, SlimeDevice.Packet.ACCELERATION, felt)
	datagrams.append(_packet(SlimeDevice.Packet.BUNDLE, bundle))
	return datagrams


func answer(p_bytes: PackedByteArray) -> Array[PackedByteArray]:
	if p_bytes.size() >= 13 and p_bytes[0] == SlimeDevice.Packet.HANDSHAKE:
		_is_connected = p_bytes.slice(1, 13).get_string_from_ascii() == SlimeFeed.ANSWER
		return []
	if p_bytes.size() < 6:
		return []
	match p_bytes[3]:
		SlimeDevice.Packet.HEARTBEAT:
			return [_packet(SlimeDevice.Packet.HEARTBEAT_REPLY, PackedByteArray())]
		SlimeDevice.Packet.PING:
			# Given back as it came, with a number of our own.
			return [_packet(SlimeDevice.Packet.PING, p_bytes.slice(12))]
		SlimeDevice.Packet.SENSOR_INFO:
			_acked[p_bytes[4]] = true
	return []


func _introduction() -> PackedByteArray:
	var content: PackedByteArray = PackedByteArray()
	content.resize(28)
	content[3] = 4
	content[7] = 4
	content[11] = 2
	content[27] = VERSION
	content.append(FIRMWARE.length())
	content.append_array(FIRMWARE.to_ascii_buffer())
	content.append_array(mac)
	return content


## Number, state, type, settings (a magnetometer that is off), calibrated, place, kind of data.
func _sensor_info(p_sensor: int) -> PackedByteArray:
	return [p_sensor, 1, 4, 0, 2, 1, PLACES[mounts[p_sensor]], 0]


func _packet(p_type: int, p_content: PackedByteArray) -> PackedByteArray:
	var buffer: StreamPeerBuffer = StreamPeerBuffer.new()
	buffer.big_endian = true
	buffer.put_32(p_type)
	buffer.put_64(_number)
	buffer.put_data(p_content)
	_number += 1
	return buffer.data_array


static func _put(r_bundle: PackedByteArray, p_type: int, p_content: PackedByteArray) -> void:
	var size: int = p_content.size() + 4
	r_bundle.append_array([size >> 8, size & 0xFF, 0, 0, 0, p_type])
	r_bundle.append_array(p_content)


static func _floats(p_values: PackedFloat32Array) -> PackedByteArray:
	var buffer: StreamPeerBuffer = StreamPeerBuffer.new()
	buffer.big_endian = true
	for value: float in p_values:
		buffer.put_float(value)
	return buffer.data_array
