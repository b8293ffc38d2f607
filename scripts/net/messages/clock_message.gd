class_name ClockMessage
extends RefCounted
## The question for the server's time, and its answer. Both are made and answered in the transport's
## threads, so that frame rates do not matter.
##
## Little-endian. Question: u8 message, u64 client's time (µs). Answer: u8 message, u64 the
## client's time of the question, u64 server's time (µs), u32 the server's tick, u64 server's time
## at which this tick began (µs), u16 ticks per second. All times are of monotonic clocks.

## Size of a question, bytes.
const QUESTION_SIZE: int = 9
## Size of an answer, bytes.
const ANSWER_SIZE: int = 31

## When the question was sent, client's time, µs.
var asked_usec: int = 0
## The server's time, µs.
var server_usec: int = 0
## The server's tick.
var tick: int = 0
## When that tick began, server's time, µs.
var tick_usec: int = 0
## Ticks per second.
var tick_rate: int = 60


## The bytes of a question.
static func question(p_now_usec: int) -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(QUESTION_SIZE)
	bytes.encode_u8(0, Protocol.Message.CLOCK)
	bytes.encode_u64(1, p_now_usec)
	return bytes


## The answer to a question; no bytes if it is none.
static func answer(
	p_question: PackedByteArray, p_now_usec: int, p_tick: int, p_tick_usec: int, p_tick_rate: int
) -> PackedByteArray:
	if p_question.size() != QUESTION_SIZE:
		return PackedByteArray()
	var bytes: PackedByteArray = p_question.duplicate()
	bytes.resize(ANSWER_SIZE)
	bytes.encode_u64(9, p_now_usec)
	bytes.encode_u32(17, p_tick & 0xFFFFFFFF)
	bytes.encode_u64(21, p_tick_usec)
	bytes.encode_u16(29, p_tick_rate)
	return bytes


## What an answer says; null if it is none.
static func decode(p_bytes: PackedByteArray) -> ClockMessage:
	if p_bytes.size() != ANSWER_SIZE or p_bytes[0] != Protocol.Message.CLOCK:
		return null
	var packet: ClockMessage = ClockMessage.new()
	packet.asked_usec = p_bytes.decode_u64(1)
	packet.server_usec = p_bytes.decode_u64(9)
	packet.tick = p_bytes.decode_u32(17)
	packet.tick_usec = p_bytes.decode_u64(21)
	packet.tick_rate = p_bytes.decode_u16(29)
	var sane: bool = packet.server_usec >= 0 and packet.tick_usec >= 0 and packet.tick_rate > 0
	# Greatest distance of a tick's beginning from the server's time, µs.
	return packet if sane and absi(packet.server_usec - packet.tick_usec) < 3600000000 else null
