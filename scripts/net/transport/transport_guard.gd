class_name TransportGuard
extends RefCounted
## Decides which packets of clients a server lets through, and how many.
##
## Godot's [SceneMultiplayer] reports an engine error for nearly every packet that it does not
## expect, so that any client could flood the log. It gets to see join requests of those who have
## not been admitted, and of those who have plain bytes and that they know a path, see
## [EnginePackets]. Nobody but the server calls, spawns or synchronizes by the engine's own packets.

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
const _COMMAND_RAW: int = 3
const _COMMAND_SYSTEM: int = 7
const _SYSTEM_AUTH: int = 0

## What a client may send. Set it before the thread begins.
var limits: TransportLimits = TransportLimits.new()
## Why the last packet was not let through.
var reason: String = ""
## The key of the complaint in the log.
var key: String = ""


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
		# Plain bytes without any would be an error of the engine's.
		var is_plain: bool = command == _COMMAND_RAW and p_bytes.size() > 1
		if is_plain or EnginePackets.is_confirmation(p_bytes):
			return Verdict.PASS
		return _drop("command", "sent %d bytes of no use (%d)" % [p_bytes.size(), command])
	if command != _COMMAND_SYSTEM or p_bytes.size() < 2 or p_bytes[1] != _SYSTEM_AUTH:
		return _drop("command", "sent %d bytes of no use (%d)" % [p_bytes.size(), command])
	if p_bytes.size() > 2:
		return Verdict.PASS
	# An empty join request says that the client has taken in that it is welcome.
	if p_from.stage != TransportConnection.Stage.WELCOMED:
		return _drop("command", "takes itself for welcome")
	p_from.stage = TransportConnection.Stage.ADMITTED
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
