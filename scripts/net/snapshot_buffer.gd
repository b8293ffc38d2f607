class_name SnapshotBuffer
extends RefCounted
## Keeps recent snapshots and tells where each body is at any moment in between.
##
## The server's clock is estimated from the quickest arrivals; display runs a little behind it, so
## that there is usually a snapshot on either side to interpolate between (linear in position,
## spherical in orientation; thesis section 7.1). When the next one is late, bodies stop instead of
## guessing.

## How far display runs behind the newest possible snapshot.
const DELAY_S: float = 0.04
## Snapshots that are kept per body.
const _KEPT: int = 16

## The newest tick that has arrived, or -1.
var newest_tick: int = -1

var _tracks: Dictionary[int, Track] = {}
var _marks: Dictionary[int, Array] = {}
var _rate: int = 60
var _offset: ClockOffset = ClockOffset.new()


## What is known of one body.
class Track:
	var ticks: PackedInt64Array = PackedInt64Array()
	var transforms: Array[Transform3D] = []


## Takes a snapshot (or part of one) that arrived at a local time, s.
func push(p_snapshot: Snapshot, p_now_s: float) -> void:
	_rate = p_snapshot.tick_rate
	var sent: float = float(p_snapshot.tick) / _rate
	if absf(p_now_s - sent - _offset.value_s) > 5.0:
		clear()  # Another server, or a long sleep: begin anew.
	_offset.arrived(sent, p_now_s)
	newest_tick = maxi(newest_tick, p_snapshot.tick)
	for id: int in p_snapshot.bodies:
		_insert(id, p_snapshot.tick, p_snapshot.bodies[id])
	for actor: int in p_snapshot.samples:
		_insert_mark(_marks.get_or_add(actor, []), p_snapshot.tick, p_snapshot.samples[actor])


## Forgets everything.
func clear() -> void:
	_tracks.clear()
	_marks.clear()
	newest_tick = -1
	_offset.clear()


## The tick (with its fraction) that is to be shown at a local time, s.
func shown_tick(p_now_s: float) -> float:
	return minf((p_now_s - _offset.value_s - DELAY_S) * _rate, float(newest_tick))


## Whether anything is known of a body.
func has_body(p_id: int) -> bool:
	return _tracks.has(p_id)


## Where a body is at a tick, which may lie between two.
func transform_at(p_id: int, p_tick: float) -> Transform3D:
	var track: Track = _tracks[p_id]
	var last: int = track.ticks.size() - 1
	var after: int = last
	while after > 0 and track.ticks[after - 1] >= p_tick:
		after -= 1
	if after == 0 or track.ticks[after] <= p_tick:
		return track.transforms[after]
	var before: int = after - 1
	var span: float = track.ticks[after] - track.ticks[before]
	return track.transforms[before].interpolate_with(
		track.transforms[after], (p_tick - track.ticks[before]) / span
	)


## The newest that is known of a body, without any smoothing.
func newest_transform(p_id: int) -> Transform3D:
	return _tracks[p_id].transforms.back()


## When the sample was taken that is behind what a person shows at a tick, Unix time in µs, or -1.
func sample_time_at(p_actor: int, p_tick: float) -> int:
	var found: int = -1
	for mark: Array in _marks.get(p_actor, []):
		if mark[0] <= ceili(p_tick):
			found = (mark[1] as Snapshot.SampleMark).time_usec
	return found


## Every datagram of a snapshot carries the same marks: they are kept once.
static func _insert_mark(p_marks: Array, p_tick: int, p_mark: Snapshot.SampleMark) -> void:
	var at: int = p_marks.size()
	while at > 0 and p_marks[at - 1][0] > p_tick:
		at -= 1
	if at > 0 and p_marks[at - 1][0] == p_tick:
		return
	p_marks.insert(at, [p_tick, p_mark])
	if p_marks.size() > _KEPT:
		p_marks.pop_front()


func _insert(p_id: int, p_tick: int, p_transform: Transform3D) -> void:
	var track: Track = _tracks.get(p_id)
	if track == null:
		track = Track.new()
		_tracks[p_id] = track
	var at: int = track.ticks.size()
	while at > 0 and track.ticks[at - 1] > p_tick:
		at -= 1
	if at > 0 and track.ticks[at - 1] == p_tick:
		return
	track.ticks.insert(at, p_tick)
	track.transforms.insert(at, p_transform)
	if track.ticks.size() > _KEPT:
		track.ticks.remove_at(0)
		track.transforms.remove_at(0)
