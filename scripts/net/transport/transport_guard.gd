class_name TransportGuard
extends RefCounted
## Decides which packets of clients a server lets through, and how many.
##
## Godot's [SceneMultiplayer] reports an engine error for nearly every packet that it does not
## expect, so that any client could flood the log. It gets to see join requests of those who have
## not been admitted, and plain bytes and remote calls of those who have. Nobody but the server
## spawns or synchronizes.

## What is done with a packet.
enum Verdict {
	## It is passed on.
	PASS,
	## It is dropped silently: its sender could not know better.
	IGNORE,
	## It is dropped, and [member reason] says why.
	DROP,
	## Its sender is disconnected, and [member reason] says why.
	THROW_OUT,
}

## The multiplayer API's first byte has the command in its low bits.
const _COMMAND_MASK: int = 7
## Remote calls, and what belongs to them, are up to here.
const _COMMAND_CONFIRM_PATH: int = 2
const _COMMAND_RAW: int = 3
const _COMMAND_SYSTEM: int = 7
const _SYSTEM_AUTH: int = 0

## What a client may send. Set it before the thread begins.
var limits: TransportLimits = TransportLimits.new()
## Why the last packet was not let through.
var reason: String = ""
## The key of the complaint in the log.
var key: String = ""


## Whether a packet is a remote call or belongs to one.
static func is_call(p_bytes: PackedByteArray) -> bool:
	return not p_bytes.is_empty() and p_bytes[0] & _COMMAND_MASK <= _COMMAND_CONFIRM_PATH


## Checks a datagram of the fast path.
func judge_fast(p_from: TransportConnection, p_bytes: PackedByteArray) -> Verdict:
	var rate: Verdict = _judge_rate(p_from, p_bytes.size())
	if rate != Verdict.PASS:
		return rate
	if p_from.stage != TransportConnection.Stage.ADMITTED:
		# It may have overtaken what says that the join request is complete.
		return Verdict.IGNORE
	if p_bytes.is_empty() or p_bytes.size() > limits.max_datagram:
		return _drop("size", "sent a fast datagram of %d bytes" % p_bytes.size())
	var is_high: bool = p_bytes[0] >= limits.high_from
	var kind: int = limits.high_kind if is_high else p_bytes[0]
	if limits.max_fast.has(kind):
		var count: int = p_from.fast.get(kind, 0) + 1
		p_from.fast[kind] = count
		if count > limits.max_fast[kind]:
			var parts: Array = [limits.max_fast[kind], kind]
			return _drop("rate", "sends more than %d datagrams of kind %d a second" % parts)
	return Verdict.PASS


## Checks a packet for the multiplayer API.
func judge(p_from: TransportConnection, p_bytes: PackedByteArray) -> Verdict:
	var rate: Verdict = _judge_rate(p_from, p_bytes.size())
	if rate != Verdict.PASS:
		return rate
	if p_from.waiting >= limits.max_waiting:
		return _say(Verdict.THROW_OUT, "waiting", "has sent more than can be taken in")
	if p_bytes.is_empty() or p_bytes.size() > limits.max_packet:
		return _drop("size", "sent a packet of %d bytes" % p_bytes.size())
	var command: int = p_bytes[0] & _COMMAND_MASK
	if p_from.stage == TransportConnection.Stage.ADMITTED:
		return _judge_admitted(p_from, p_bytes, command)
	if command != _COMMAND_SYSTEM or p_bytes.size() < 2 or p_bytes[1] != _SYSTEM_AUTH:
		return _drop("command", "sent %d bytes of no use (%d)" % [p_bytes.size(), command])
	if p_bytes.size() > 2:
		return Verdict.PASS
	# An empty join request says that the client has taken in that it is welcome.
	if p_from.stage != TransportConnection.Stage.WELCOMED:
		return _drop("command", "takes itself for welcome")
	p_from.stage = TransportConnection.Stage.ADMITTED
	return Verdict.PASS


func _judge_admitted(
	p_from: TransportConnection, p_bytes: PackedByteArray, p_command: int
) -> Verdict:
	if p_command == _COMMAND_RAW:
		return Verdict.PASS
	if p_command > _COMMAND_CONFIRM_PATH:
		return _drop("command", "sent %d bytes of no use (%d)" % [p_bytes.size(), p_command])
	if not p_from.may_call:
		return _drop("call", "may not call anything")
	p_from.calls += 1
	if p_from.calls > limits.max_calls:
		return _drop("calls", "calls more than %d times a second" % limits.max_calls)
	return Verdict.PASS


func _judge_rate(p_from: TransportConnection, p_size: int) -> Verdict:
	if p_from.stage == TransportConnection.Stage.LEAVING:
		return Verdict.IGNORE
	p_from.packets += 1
	p_from.bytes += p_size
	if p_from.packets > limits.flood_packets or p_from.bytes > limits.flood_bytes:
		var parts: Array = [p_from.packets, p_from.bytes]
		return _say(Verdict.THROW_OUT, "flood", "sent %d packets, %d bytes in a second" % parts)
	if p_from.packets > limits.max_packets:
		return _drop("rate", "sends more than %d packets a second" % limits.max_packets)
	if p_from.bytes > limits.max_bytes:
		return _drop("bytes", "sends more than %d bytes a second" % limits.max_bytes)
	return Verdict.PASS


func _drop(p_key: String, p_reason: String) -> Verdict:
	return _say(Verdict.DROP, p_key, p_reason)


func _say(p_verdict: Verdict, p_key: String, p_reason: String) -> Verdict:
	key = p_key
	reason = p_reason
	return p_verdict
