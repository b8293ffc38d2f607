class_name Calibration
extends RefCounted
## Mounting and heading of each sensor: they turn the sensors' orientations into limbs' rotations
## from the reset pose (thesis 6.1).
##
## A sensor measures s = H r M: r is the limb's rotation from the reset pose, M the sensor's
## mounting on the limb, H the heading: which way the wearer's front at the reset is turned in the
## sensor's global frame, about the vertical. So r = H^-1 s M^-1. The thesis' one-sided r = s s0^-1,
## s0 being measured in the reset pose, is the same for H = 1 (facing north), since then M = s0.

## What is known of each sensor, by its id.
var entries: Dictionary[String, Entry] = {}
## The kind of calibration that it comes from.
var kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_POSE
## The pose that was the reference.
var pose: ResetPose.Kind = ResetPose.Kind.T
## When it was made, s of Unix time.
var made_s: float = 0.0


## One sensor.
class Entry:
	## Index in [BodyMounts] of the mount on which it was worn.
	var mount: int = -1
	## Heading H, rad about the vertical.
	var heading: float = 0.0
	## How far the heading is off, rad (standard deviation), NAN if that is not known.
	var heading_error: float = NAN
	## Mounting M: from the sensor's axes to the limb's.
	var mounting: Quaternion = Quaternion.IDENTITY

	## The limb's rotation from the reset pose, from the sensor's orientation.
	func rotation(p_said: Quaternion) -> Quaternion:
		return Rotations.yaw(-heading) * p_said * mounting.inverse()


## Sets what is known of a sensor: its mount of [BodyMounts], heading (rad), mounting, and how far
## the heading is off (rad).
func set_entry(
	p_id: String,
	p_mount: int,
	p_heading: float,
	p_mounting: Quaternion,
	p_heading_error: float = NAN
) -> void:
	var entry: Entry = Entry.new()
	entry.mount = p_mount
	entry.heading = p_heading
	entry.mounting = p_mounting.normalized()
	entry.heading_error = p_heading_error
	entries[p_id] = entry


## The entry of a sensor if it is still worn where it was calibrated, or null.
func entry_for(p_id: String, p_mount: int) -> Entry:
	var entry: Entry = entries.get(p_id)
	return entry if entry != null and entry.mount == p_mount else null


## Turns everything that comes out about the vertical, rad: whoever stood as in the reset pose then
## faces that way.
func turn(p_angle: float) -> void:
	for id: String in entries:
		entries[id].heading -= p_angle
