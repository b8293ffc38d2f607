class_name ClientFigures
extends RefCounted
## What a client measures of its own session: frames, snapshots, traffic, and the delay from a
## sample
## in the wearer's suit to its display here (both machines' clocks must agree: thesis section 7.4).

## Snapshots (datagrams) that have arrived.
var snapshots: int = 0

var _frames: int = 0
var _begin_usec: int = Time.get_ticks_usec()
var _latency: Statistics = Statistics.new()
var _shown_sample_usec: int = -1
var _latest_ms: float = 0.0


## Notes a frame that is about to be drawn, or that counts as shown where nothing is drawn.
func frame(p_scene: ClientScene, p_headless: bool) -> void:
	_frames += 1
	_shown_sample_usec = p_scene.shown_sample_usec()
	if p_headless:
		drawn()


## Notes that the frame was drawn.
func drawn() -> void:
	if _shown_sample_usec > 0:
		_latest_ms = (Time.get_unix_time_from_system() * 1e6 - _shown_sample_usec) / 1000.0
		# What is older is a stream that has stopped, not a delay.
		if _latest_ms < 2000.0:
			_latency.add(_latest_ms)
		_shown_sample_usec = -1


## Seconds since the start.
func seconds() -> float:
	return (Time.get_ticks_usec() - _begin_usec) / 1e6


## A few words for the screen.
func describe(p_role: String, p_traffic: TrafficMeter) -> String:
	if p_role == "replay":
		return p_role
	var parts: Array = [
		p_role,
		Engine.get_frames_per_second(),
		p_traffic.received_per_second() / 1000.0,
		p_traffic.sent_per_second() / 1000.0,
		_latest_ms,
	]
	return "%s   %d fps   %.1f kB/s in   %.1f kB/s out   sample to display %.0f ms" % parts


## The figures for a report.
func report(p_role: String, p_traffic: TrafficMeter) -> Dictionary:
	return {
		"role": p_role,
		"seconds": seconds(),
		"frames_per_second": _frames / maxf(seconds(), 0.001),
		"snapshots": snapshots,
		"latency_count": _latency.count(),
		"latency_ms_mean": _latency.mean(),
		"latency_ms_p50": _latency.percentile(0.5),
		"latency_ms_p95": _latency.percentile(0.95),
		"sent_bytes_per_second": p_traffic.sent_per_second(),
		"received_bytes_per_second": p_traffic.received_per_second(),
	}
