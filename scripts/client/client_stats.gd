class_name ClientStats
extends RefCounted
## What a client measures of its own session: frames, snapshots, traffic, and the delay from a
## sample in the wearer's suit to its display here (thesis section 7.4).

## Snapshots (datagrams) that have arrived.
var snapshots: int = 0
## The delays, stage by stage.
var probe: LatencyProbe = LatencyProbe.new()
## The delay from a wearer's motion to the display of the own body, in local feedback.
var own: LatencyHistogram = LatencyHistogram.new()

## Where the time of frames goes.
var times: FrameTimes = FrameTimes.new()

## Frames that have shown a world.
var shown_frames: int = 0
## How far the display is behind the quickest arrivals, s.
var smoothing_delay_s: float = 0.0

var _frames: int = 0
var _begin_usec: int = Time.get_ticks_usec()
var _own_moment_usec: int = -1
var _motion_tick: float = -1.0
var _tick_rate: float = 0.0


## Records that a frame of the world, as a replica has it, is about to be drawn, or counts as shown
## without a display. The time is the server's, µs.
func frame(p_replica: WorldReplica, p_server_usec: int, p_headless: bool) -> void:
	_frames += 1
	shown_frames += 1 if p_replica.shown_tick() >= 0.0 else 0
	smoothing_delay_s = p_replica.delay()
	_motion_tick = p_replica.motion_tick()
	_tick_rate = p_replica.tick_rate()
	probe.shows(p_replica.shown_tick())
	if p_headless:
		drawn(p_server_usec)


## Records that the frame was drawn, at a time of the server, µs.
func drawn(p_server_usec: int) -> void:
	probe.drawn(p_server_usec)
	probe.frames.drawn(_motion_tick, _tick_rate, p_server_usec)
	if _own_moment_usec >= 0:
		own.add((Time.get_unix_time_from_system() * 1e6 - _own_moment_usec) / 1000.0)
		_own_moment_usec = -1


## Records which moment of the wearer's motion the own body shows in the next frame, µs of this
## machine's Unix time.
func own_shown(p_moment_usec: int) -> void:
	_own_moment_usec = p_moment_usec


## How old people's motion is when the light of a frame is seen, ms: measured until the frame is
## drawn, and what the screen adds is estimated ([ScreenDelay]).
func motion_to_photon_ms() -> float:
	return probe.frames.recent_ms + ScreenDelay.of_window_ms()


## Seconds since the start.
func seconds() -> float:
	return (Time.get_ticks_usec() - _begin_usec) / 1e6


## A short text for the screen.
func describe(p_role: String, p_traffic: TrafficMeter, p_security: String) -> String:
	if p_role == "replay":
		return p_role
	var parts: Array = [
		p_role,
		Engine.get_frames_per_second(),
		p_traffic.received_per_second() / 1000.0,
		p_traffic.sent_per_second() / 1000.0,
		p_security,
		probe.frames.recent_ms,
	]
	return "%s   %d fps   %.1f kB/s in   %.1f kB/s out   %s   motion is %.0f ms old" % parts


## The stats for the server's status.
func packet() -> PackedByteArray:
	return StatsMessage.encode(
		probe.total.percentile(0.5),
		probe.total.percentile(0.95),
		smoothing_delay_s * 1000.0,
		Engine.get_frames_per_second()
	)


## What the screen adds to the delays of [method describe].
func describe_screen() -> String:
	return ScreenDelay.describe() + "; " + times.describe()


## The stats for a report; [param p_people] are those of [method ClientPeople.stats].
func report(
	p_role: String, p_traffic: TrafficMeter, p_people: Array[Dictionary] = []
) -> Dictionary:
	return {
		"role": p_role,
		"people": p_people,
		"seconds": seconds(),
		# What draws: "llvmpipe (...)" is the processor. Empty without a window.
		"renderer": RenderingServer.get_video_adapter_name(),
		"frames_per_second": _frames / maxf(seconds(), 0.001),
		"snapshots": snapshots,
		"shown_frames": shown_frames,
		"smoothing_delay_ms": smoothing_delay_s * 1000.0,
		"latency_count": probe.total.count(),
		"latency_ms_mean": probe.total.mean(),
		"latency_ms_sd": probe.total.deviation(),
		"latency_ms_p50": probe.total.percentile(0.5),
		"latency_ms_p95": probe.total.percentile(0.95),
		"latency_ms_p99": probe.total.percentile(0.99),
		"latency": probe.stats(),
		"frame_age": probe.frames.ages.stats(),
		"frame_times": times.stats(),
		# Of the motion of people who are shown, as far as it can be estimated.
		"motion_to_photon_ms": motion_to_photon_ms(),
		"own_latency": own.stats(),
		"sent_bytes_per_second": p_traffic.sent_per_second(),
		"received_bytes_per_second": p_traffic.received_per_second(),
	}
