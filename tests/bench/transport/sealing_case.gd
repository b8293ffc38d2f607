extends RefCounted
## What sealing costs: bytes, processor time, and round trips of a join.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const UdpRelay: GDScript = preload("res://tests/net/transport/udp_relay.gd")

const _TOOL: String = "res://build/gdextension/transport/transport_measure_sealing"
## One way, µs.
const _DELAY_USEC: int = 50000
const _JOINS: int = 5
## A round trip more is what the handshake may cost; the rest is what threads take to wake up.
const _MAX_MORE: float = 1.1


## Adds its figures to a report.
static func run(r_report: BenchReport) -> void:
	for size: int in [200, 1200]:
		_measure(r_report, size)
	var sealed: float = _join_ms(true)
	var plain: float = _join_ms(false)
	var case: String = "join, 50 ms each way"
	r_report.add(case, "sealed", sealed, "ms")
	r_report.add(case, "not sealed", plain, "ms")
	var more: float = (sealed - plain) * 1000.0 / (2 * _DELAY_USEC)
	r_report.at_most(case, "round trips more", more, "", _MAX_MORE)


static func _measure(r_report: BenchReport, p_size: int) -> void:
	var output: Array = []
	var code: int = OS.execute(ProjectSettings.globalize_path(_TOOL), [str(p_size)], output)
	var found: Variant = JSON.parse_string(output[0]) if code == 0 else null
	if found == null:
		printerr("%s does not run" % _TOOL)
		return
	var case: String = "sealing, %d bytes" % p_size
	r_report.at_most(case, "seal", found["seal_ns"] / 1000.0, "us", 2.0)
	r_report.at_most(case, "open", found["open_ns"] / 1000.0, "us", 2.0)
	r_report.at_most(case, "bytes more", found["grown"], "bytes", 20.0)


## Median time from the first datagram until a client has joined.
static func _join_ms(p_seals: bool) -> float:
	var took: Statistics = Statistics.new()
	for _join: int in _JOINS:
		var pair: LinkPair = LinkPair.new()
		pair.rules.seals = p_seals
		pair.listen()
		var relay: UdpRelay = UdpRelay.new()
		relay.delay_usec = _DELAY_USEC
		relay.start(pair.port)
		var end: LinkPair.End = LinkPair.End.new()
		end.link.seals = p_seals
		pair.ends.append(end)
		var begin: int = Time.get_ticks_usec()
		end.link.open("127.0.0.1", relay.port, end.request)
		if pair.until(func() -> bool: return end.joined == 1, 10.0):
			took.add((Time.get_ticks_usec() - begin) / 1000.0)
		pair.close()
		relay.stop()
	return took.percentile(0.5)
