class_name OrderMessage
extends RefCounted
## What an instructor wants of the session: instructor to server, reliable.
##
## Little-endian: u8 message, u16 number, u8 [enum Kind], u32 whom (the peer of a client that waits,
## else its session; 0: nobody), u8 which of its people, u8 which calibration, text argument.

## What is wanted.
enum Kind {
	## The list of who is here, as [RosterMessage].
	WHO,
	## Admit a client that waits.
	ADMIT,
	## Send a client that waits away; the argument says why.
	REFUSE,
	## Dismiss a client; the argument says why.
	KICK,
	## Dismiss a client and ban its address; the argument says why.
	BAN,
	## Have one of a trainee's people calibrated: thesis 6.1's "Reset Pose" button.
	CALIBRATE,
	## Load the level that the argument names.
	LEVEL,
	## Set fields of the world's own entity: the argument has them as [code]NAME=NUMBER[/code], with
	## spaces between.
	FIELDS,
}

## Longest argument, characters.
const MAX_ARGUMENT: int = 120

## Number of the order, for its answers.
var number: int = 0
## What is wanted.
var kind: Kind = Kind.WHO
## Whom it is about: a peer or a session.
var target: int = 0
## Which of a trainee's people.
var index: int = 0
## Which calibration, one of those that clients know.
var pose: int = 0
## A reason, the name of a level, or fields.
var argument: String = ""


## The bytes.
func encode() -> PackedByteArray:
	var bytes: PackedByteArray = []
	bytes.resize(10)
	bytes.encode_u8(0, Protocol.Message.ORDER)
	bytes.encode_u16(1, number)
	bytes.encode_u8(3, kind)
	bytes.encode_u32(4, target)
	bytes.encode_u8(8, index)
	bytes.encode_u8(9, pose)
	return bytes + ByteReader.text_bytes(argument.left(MAX_ARGUMENT))


## Fields with their values as an argument.
static func write_fields(p_values: Dictionary[StringName, float]) -> String:
	var parts: PackedStringArray = []
	for name: StringName in p_values:
		parts.append("%s=%s" % [name, String.num(p_values[name], 6)])
	return " ".join(parts)


## The fields of an argument; empty if it has none or something else.
static func read_fields(p_argument: String) -> Dictionary[StringName, float]:
	var values: Dictionary[StringName, float] = {}
	for part: String in p_argument.split(" ", false):
		var ends: PackedStringArray = part.split("=")
		if ends.size() != 2 or ends[0] == "" or not _is_number(ends[1]):
			return {}
		values[StringName(ends[0])] = ends[1].to_float()
	return values


## The order in a packet, or null if it is invalid.
static func decode(p_bytes: PackedByteArray) -> OrderMessage:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var order: OrderMessage = OrderMessage.new()
	order.number = reader.read_u16()
	var wanted: int = reader.read_u8()
	order.target = reader.read_u32()
	order.index = reader.read_u8()
	order.pose = reader.read_u8()
	order.argument = reader.read_text(4 * MAX_ARGUMENT).left(MAX_ARGUMENT).strip_edges()
	if not reader.is_complete() or not Kind.values().has(wanted):
		return null
	order.kind = wanted as Kind
	return order


## Whether a text is a number without an exponent: the engine complains about large ones.
static func _is_number(p_text: String) -> bool:
	return p_text.length() < 16 and not p_text.containsn("e") and p_text.is_valid_float()
