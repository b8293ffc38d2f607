class_name DeviceJoin
extends RefCounted
## Joins the frames of several devices that measure each in its own time into frames of all sensors.
##
## A frame comes out for every moment at which any device measured, as soon as all devices have said
## something newer: what the others measured before and after is interpolated, nothing is guessed.
## A device that is late is not waited for any longer than [constant WAIT_PERIODS]; then its sensors
## are carried on by their rates of turn, for at most [constant AHEAD_S].

## Periods of its own that a device may be behind the newest one before it is not waited for.
const WAIT_PERIODS: float = 2.5
## Maximum time over which an orientation is extrapolated, s.
const AHEAD_S: float = 0.03
## Time without samples after which a device counts as silent, s.
const SILENT_S: float = 0.5
## Frames of a device that are kept: a quarter of a second at the highest rate of a suit.
const _KEPT: int = 128
## Period to assume of a device of which only one frame is known, µs.
const _USUAL_PERIOD_USEC: float = 10000.0
## Distance below which moments are one, µs.
const _SAME_USEC: int = 200

# The newest frames of each device, by its number.
var _frames: Dictionary[int, Array] = {}
# What came since the last call of take, of any device.
var _fresh: Array[SensorFrame] = []
# The moment of the last frame that came out, µs.
var _joined_usec: int = 0


## Takes a frame of one device: only that device's sensors are present in it.
func push(p_device: int, p_frame: SensorFrame) -> void:
	var frames: Array = _frames.get_or_add(p_device, [])
	if not frames.is_empty():
		var step: int = p_frame.time_usec - frames[frames.size() - 1].time_usec
		if step <= 0:
			# A clock that was set, or a device that began anew.
			frames.clear()
			_joined_usec = mini(_joined_usec, p_frame.time_usec - 1)
		elif step > SILENT_S * 1e6:
			frames.clear()  # Nothing lies between.
	frames.append(p_frame)
	_fresh.append(p_frame)
	if frames.size() > _KEPT:
		frames.pop_front()


## Forgets a device that is gone.
func forget(p_device: int) -> void:
	_frames.erase(p_device)


## The frames of all sensors up to the moment that all devices have reached, oldest first. Those of
## a single device are passed on as they are.
func take() -> Array[SensorFrame]:
	var joined: Array[SensorFrame] = _fresh
	_fresh = []
	if _frames.size() < 2:
		for frame: SensorFrame in joined:
			_joined_usec = frame.time_usec
		return joined
	joined.clear()
	var slowest: float = 0.0
	for device: int in _frames:
		slowest = maxf(slowest, _period_usec(device))
	for moment: int in _moments(_horizon_usec()):
		var frame: SensorFrame = _join(moment)
		frame.period_s = slowest / 1e6
		joined.append(frame)
		_joined_usec = moment
	return joined


## The moment up to which every device that is waited for has measured, µs.
func _horizon_usec() -> int:
	var newest: int = 0
	for device: int in _frames:
		newest = maxi(newest, _newest(device).time_usec)
	var horizon: int = newest
	for device: int in _frames:
		var behind: int = newest - _newest(device).time_usec
		if behind <= WAIT_PERIODS * _period_usec(device):
			horizon = mini(horizon, _newest(device).time_usec)
	return horizon


## When anything was measured since the last frame that came out, µs, in order.
func _moments(p_until_usec: int) -> PackedInt64Array:
	var all: PackedInt64Array = PackedInt64Array()
	for device: int in _frames:
		for frame: SensorFrame in _frames[device]:
			if frame.time_usec > _joined_usec and frame.time_usec <= p_until_usec:
				all.append(frame.time_usec)
	all.sort()
	var moments: PackedInt64Array = PackedInt64Array()
	for moment: int in all:
		if moments.is_empty() or moment - moments[moments.size() - 1] > _SAME_USEC:
			moments.append(moment)
		else:
			moments[moments.size() - 1] = moment
	return moments


func _newest(p_device: int) -> SensorFrame:
	return _frames[p_device][_frames[p_device].size() - 1]


func _period_usec(p_device: int) -> float:
	var frames: Array = _frames[p_device]
	if frames.size() < 2:
		return _USUAL_PERIOD_USEC
	var span: float = _newest(p_device).time_usec - frames[0].time_usec
	return span / (frames.size() - 1)


func _join(p_time_usec: int) -> SensorFrame:
	var joined: SensorFrame = SensorFrame.new()
	joined.time_usec = p_time_usec
	var most: int = 0
	for device: int in _frames:
		var frames: Array = _frames[device]
		var later: int = frames.size() - 1
		while later > 1 and frames[later - 1].time_usec >= p_time_usec:
			later -= 1
		var after: SensorFrame = frames[later]
		var before: SensorFrame = frames[maxi(later - 1, 0)]
		if after.time_usec < p_time_usec:
			before = frames[LivePoses.base_of(frames, _period_usec(device) / 1e6)]
		if p_time_usec - after.time_usec > SILENT_S * 1e6:
			continue
		_make_room(joined, after)
		_read(joined, before, after)
		var sensors: int = after.present.count(1)
		if sensors > most:
			most = sensors
			# The count of the device with most sensors.
			joined.counter = after.counter if after.time_usec <= p_time_usec else before.counter
	return joined


static func _make_room(r_joined: SensorFrame, p_frame: SensorFrame) -> void:
	if r_joined.count() < p_frame.count():
		r_joined.resize(p_frame.count())
	if not p_frame.rates.is_empty():
		r_joined.rates.resize(r_joined.count())
	if not p_frame.accelerations.is_empty():
		r_joined.accelerations.resize(r_joined.count())
	if not p_frame.magnetics.is_empty():
		r_joined.magnetics.resize(r_joined.count())


## Puts a device's sensors into a frame, as of its moment.
static func _read(r_joined: SensorFrame, p_before: SensorFrame, p_after: SensorFrame) -> void:
	var span: float = p_after.time_usec - p_before.time_usec
	var part: float = 1.0
	if span > 0.0:
		part = maxf((r_joined.time_usec - p_before.time_usec) / span, 0.0)
		part = minf(part, 1.0 + AHEAD_S * 1e6 / span)
	# Vectors are never carried on: a blow would be.
	var within: float = minf(part, 1.0)
	for sensor: int in p_after.count():
		if p_after.present[sensor] == 0:
			continue
		var turn: Quaternion = p_after.orientation(sensor)
		var from: SensorFrame = p_after
		if span > 0.0 and sensor < p_before.count() and p_before.present[sensor] != 0:
			from = p_before
			var turned: Vector3 = Rotations.vector(turn * from.orientation(sensor).inverse())
			turn = Rotations.from_vector(turned * part) * from.orientation(sensor)
		r_joined.set_orientation(sensor, turn.normalized())
		if sensor < mini(from.rates.size(), p_after.rates.size()):
			r_joined.rates[sensor] = from.rates[sensor].lerp(p_after.rates[sensor], within)
		if sensor < mini(from.accelerations.size(), p_after.accelerations.size()):
			var acceleration: Vector3 = from.accelerations[sensor]
			r_joined.accelerations[sensor] = acceleration.lerp(
				p_after.accelerations[sensor], within
			)
		if sensor < mini(from.magnetics.size(), p_after.magnetics.size()):
			r_joined.magnetics[sensor] = from.magnetics[sensor].lerp(
				p_after.magnetics[sensor], within
			)
