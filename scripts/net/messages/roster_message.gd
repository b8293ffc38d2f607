class_name RosterMessage
extends RefCounted
## Who is here, lost or waiting: server to instructors, reliable, in parts.
##
## Little-endian: u8 message, u16 number of rows, of each: u16 session, u32 peer, u8 role, u8 state
## ([enum RosterRow.State]), u8 people, u16 round trip and u16 delay (0.1 ms), u16 tracking (0.01
## degrees), the three with 65535 for not known, texts name, address, suit.

## Longest name, address and text about a suit, bytes.
const MAX_TEXT: int = 400

const _UNKNOWN: int = 65535
const _MS_UNIT: float = 0.1
const _DEG_UNIT: float = 0.01

## The rows.
var rows: Array[RosterRow] = []


## The bytes for some rows.
static func encode(p_rows: Array[RosterRow]) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.ROSTER, 0, 0]
	bytes.encode_u16(1, p_rows.size())
	for row: RosterRow in p_rows:
		var head: PackedByteArray = []
		head.resize(15)
		head.encode_u16(0, row.session)
		head.encode_u32(2, row.peer)
		head.encode_u8(6, row.role)
		head.encode_u8(7, row.state)
		head.encode_u8(8, mini(row.people, 255))
		head.encode_u16(9, _steps(row.round_trip_ms, _MS_UNIT))
		head.encode_u16(11, _steps(row.delay_ms, _MS_UNIT))
		head.encode_u16(13, _steps(row.tracking_deg, _DEG_UNIT))
		bytes.append_array(head)
		for text: String in [row.name, row.address, row.suit]:
			bytes.append_array(ByteReader.text_bytes(text))
	return bytes


## The rows in a packet, or null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> RosterMessage:
	var message: RosterMessage = RosterMessage.new()
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	for _row: int in reader.read_u16():
		var row: RosterRow = RosterRow.new()
		row.session = reader.read_u16()
		row.peer = reader.read_u32()
		var role: int = reader.read_u8()
		var state: int = reader.read_u8()
		row.people = reader.read_u8()
		row.round_trip_ms = _value(reader.read_u16(), _MS_UNIT)
		row.delay_ms = _value(reader.read_u16(), _MS_UNIT)
		row.tracking_deg = _value(reader.read_u16(), _DEG_UNIT)
		row.name = reader.read_text(MAX_TEXT)
		row.address = reader.read_text(MAX_TEXT)
		row.suit = reader.read_text(MAX_TEXT)
		if reader.failed or not Roles.is_role(role) or not RosterRow.STATE_NAMES.has(state):
			return null
		row.role = role as Roles.Role
		row.state = state as RosterRow.State
		message.rows.append(row)
	return message if reader.is_complete() else null


static func _steps(p_value: float, p_unit: float) -> int:
	if p_value < 0.0 or not is_finite(p_value):
		return _UNKNOWN
	return clampi(roundi(p_value / p_unit), 0, _UNKNOWN - 1)


static func _value(p_steps: int, p_unit: float) -> float:
	return p_steps * p_unit if p_steps != _UNKNOWN else -1.0
