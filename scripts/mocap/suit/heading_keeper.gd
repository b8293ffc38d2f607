class_name HeadingKeeper
extends RefCounted
## Takes the drift off the headings of a suit's sensors, slowly and all the time, as [HeadingDrift]
## finds it.
##
## A new calibration begins with none. A suit whose list of sensors changes keeps what is known of
## those that stay where they were. For one thread.

## What finds the drift, by mount.
var drift: HeadingDrift = HeadingDrift.new()

var _calibration: Calibration = null
var _mounts: PackedInt32Array = PackedInt32Array()


## Forgets all drift.
func clear() -> void:
	drift.reset()
	_calibration = null


## Takes a frame and corrects the table that turns it into poses.
func add(p_frame: SensorFrame, p_table: SuitTable) -> void:
	if not p_table.is_calibrated:
		return
	if p_table.calibration != _calibration or p_table.mounts != _mounts:
		_follow(p_table)
	drift.add(p_frame.time_usec, p_frame.present, p_frame.orientations)
	p_table.correct(corrections())


## What is taken off the heading of each sensor, rad.
func corrections() -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	found.resize(_mounts.size())
	for sensor: int in _mounts.size():
		if _mounts[sensor] >= 0:
			found[sensor] = drift.get_correction(_mounts[sensor])
	return found


func _follow(p_table: SuitTable) -> void:
	if p_table.calibration != _calibration:
		drift.reset()
	_calibration = p_table.calibration
	_mounts = p_table.mounts.duplicate()
	for sensor: int in _mounts.size():
		var entry: Calibration.Entry = p_table.entry(sensor)
		if entry != null:
			drift.set_sensor(sensor, _mounts[sensor], entry.heading, entry.mounting)
