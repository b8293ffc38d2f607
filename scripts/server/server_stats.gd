class_name ServerStats
extends RefCounted
## A server's stats for its operator's report file, status endpoint and log.

## Ticks that count in the report's "recent".
const RECENT_TICKS: int = 600

## Time of our own work before a step, s.
var script_time: Statistics = Statistics.recent()
## Time of reading, encoding and handing over snapshots, s.
var send_time: Statistics = Statistics.recent()
## Processor time that the main thread spends on the network in a tick, s: processing what has
## arrived, reading, encoding and handing over snapshots.
var network_time: Statistics = Statistics.recent()
## All of it so far, µs.
var network_usec: int = 0
## Processor time of the main thread from a tick's beginning until its state has been sent, s: with
## the main thread's part of the physics.
var work_time: Statistics = Statistics.recent()
## Ticks whose state was sent.
var sent_ticks: int = 0
## From the beginning of a tick to that of the next, s.
var gaps: Statistics = Statistics.recent()
## Whether the world keeps up with the clock.
var watch: TickWatch = null
## Ticks so far.
var ticks: int = 0

var _began_usec: int = Time.get_ticks_usec()
var _work_usec: int = 0
var _settled_usec: int = 0
var _tick_usec: int = 0
var _settled_tick: int = 0
var _status_usec: int = _began_usec
var _status_tick: int = 0


func _init(p_tick_rate: float) -> void:
	watch = TickWatch.new(p_tick_rate)


## Records the beginning of a tick, at a time in µs. Returns whether [member watch] has just found
## that the world has become slow, or normal again.
func begin_tick(p_now_usec: int) -> bool:
	if _tick_usec > 0:
		gaps.add((p_now_usec - _tick_usec) / 1e6)
	_tick_usec = p_now_usec
	return watch.ticked(p_now_usec / 1e6)


## Begins to count a tick's processor time, of the calling thread.
func begin_work() -> void:
	_work_usec = ThreadClock.get_usec()


## Ends it: the tick's state has been sent.
func end_work() -> void:
	sent_ticks += 1
	work_time.add((ThreadClock.get_usec() - _work_usec) / 1e6)


## Records a frame, at a time in µs.
func frame(p_now_usec: int) -> void:
	# A loaded machine catches up with its start in the first second.
	if _settled_usec == 0 and p_now_usec - _began_usec > 1000000:
		_settled_usec = p_now_usec
		_settled_tick = ticks
		_status_usec = p_now_usec
		_status_tick = ticks


## Records processor time of a tick's network work in the main thread, µs.
func networked(p_usec: int) -> void:
	network_usec += p_usec
	network_time.add(p_usec / 1e6)


## Seconds since the start.
func seconds() -> float:
	return (Time.get_ticks_usec() - _began_usec) / 1e6


## Ticks per second since the first second.
func ticks_per_second() -> float:
	if _settled_usec == 0:
		return 0.0
	var span: float = (Time.get_ticks_usec() - _settled_usec) / 1e6
	return (ticks - _settled_tick) / maxf(span, 0.001)


## A line for the log, about the time since the last one.
func describe(p_clients: int, p_people: int) -> String:
	var now: int = Time.get_ticks_usec()
	var rate: float = (ticks - _status_tick) / maxf((now - _status_usec) / 1e6, 0.001)
	_status_usec = now
	_status_tick = ticks
	return "%.1f ticks/s, %d clients, %d people" % [rate, p_clients, p_people]


## Seconds since the last line.
func since_status() -> float:
	return (Time.get_ticks_usec() - _status_usec) / 1e6


## The stats for report and status.
func report() -> Dictionary:
	return {
		"role": "server",
		"version": ProjectSettings.get_setting("application/config/version"),
		"protocol": Protocol.VERSION,
		"seconds": seconds(),
		"ticks": ticks,
		"ticks_per_second": ticks_per_second(),
		"speed": watch.speed,
		"is_slow": watch.is_slow,
		"slow_seconds": watch.slow_windows,
		"script_ms_p50": script_time.percentile(0.5) * 1000.0,
		"script_ms_p99": script_time.percentile(0.99) * 1000.0,
		"send_ms_p50": send_time.percentile(0.5) * 1000.0,
		"send_ms_p99": send_time.percentile(0.99) * 1000.0,
		"network_ms_p50": network_time.percentile(0.5) * 1000.0,
		"network_ms_p99": network_time.percentile(0.99) * 1000.0,
		"network_cpu_usec": network_usec,
		"work_ms_p50": work_time.percentile(0.5) * 1000.0,
		"work_ms_p99": work_time.percentile(0.99) * 1000.0,
		"work_ms_max": work_time.percentile(1.0) * 1000.0,
		"sent_ticks": sent_ticks,
		"recent": _recent(),
		"memory_bytes": ProcessMemory.resident_bytes(),
		"longest_tick_ms": gaps.percentile(1.0) * 1000.0,
	}


## The same for the last seconds only, without the time when everybody joined.
func _recent() -> Dictionary:
	var result: Dictionary = {"ticks": mini(RECENT_TICKS, script_time.count())}
	for pair: Array in [[0.5, "p50"], [0.99, "p99"]]:
		result["script_ms_" + pair[1]] = script_time.percentile(pair[0], RECENT_TICKS) * 1000.0
		result["send_ms_" + pair[1]] = send_time.percentile(pair[0], RECENT_TICKS) * 1000.0
		result["network_ms_" + pair[1]] = network_time.percentile(pair[0], RECENT_TICKS) * 1000.0
		result["work_ms_" + pair[1]] = work_time.percentile(pair[0], RECENT_TICKS) * 1000.0
	return result
