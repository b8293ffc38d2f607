class_name SuitMotion
extends RefCounted
## The motion of an emulated suit's wearer: a calibration, then a clip in a loop.
##
## Written as a motion stream for the emulator of suits, which knows no engine and no BVH files; its
## layout is described in [code]gdextension/xbus/emulator/suit/motion_stream.hpp[/code]. Limbs are
## the mounts of [BodyMounts]. Frame: Xsens' (X north, Y west, Z up, metres); in the reset pose the
## wearer faces north.

const MAGIC: String = "XBMOTION"
const VERSION: int = 1
const NAME_BYTES: int = 32
## Seconds in which the wearer goes from the calibration's last pose to the clip's first.
const PASSAGE_S: float = 1.0

## Frames a second.
var rate_hz: float = 100.0
## What the wearer does before the clip.
var calibration: CalibrationMotion = CalibrationMotion.new()
## The clip; must be opened.
var clip: BvhSource = null


## The whole stream; empty if there is no clip.
func encode() -> PackedByteArray:
	if clip == null or clip.error != "" or clip.rig == null:
		return PackedByteArray()
	var lead_s: float = calibration_s() + PASSAGE_S
	var lead: int = roundi(lead_s * rate_hz)
	var count: int = lead + maxi(roundi(clip.get_period() * rate_hz), 1)
	var writer: StreamPeerBuffer = StreamPeerBuffer.new()
	writer.put_data(MAGIC.to_ascii_buffer())
	writer.put_u32(VERSION)
	writer.put_u32(BodyMounts.COUNT)
	writer.put_double(rate_hz)
	writer.put_u32(count)
	writer.put_u32(lead)
	for mount: StringName in BodyMounts.NAMES:
		var bytes: PackedByteArray = String(mount).to_ascii_buffer()
		bytes.resize(NAME_BYTES)
		writer.put_data(bytes)
	var values: PackedFloat32Array = PackedFloat32Array()
	for frame: int in count:
		_append(pose_at(frame / rate_hz), values)
	return writer.data_array + values.to_byte_array()


## How long the calibration takes, s.
func calibration_s() -> float:
	var total: float = 0.0
	for step: CalibrationGuide.Step in CalibrationGuide.steps(calibration.kind):
		total += step.duration_s
	return total


## The pose after so many seconds, in Godot's frame.
func pose_at(p_time_s: float) -> PoseSample:
	var begin: float = calibration_s()
	if p_time_s < begin:
		return calibration.pose_at(p_time_s)
	var passed: float = p_time_s - begin
	# The second round of the clip: its beginning is what its end passes into.
	var round_s: float = clip.get_period()
	if passed >= PASSAGE_S:
		return clip.pose_at(round_s + passed - PASSAGE_S)
	var from: PoseSample = calibration.pose_at(begin)
	var to: PoseSample = clip.pose_at(round_s)
	var part: float = smoothstep(0.0, PASSAGE_S, passed)
	var pose: PoseSample = PoseSample.new()
	for limb: int in BodyMounts.LIMBS:
		pose.set_orientation(limb, from.orientation(limb).slerp(to.orientation(limb), part))
	pose.root = from.root.lerp(to.root, part)
	return pose


func _append(p_pose: PoseSample, r_values: PackedFloat32Array) -> void:
	var joints: PackedVector3Array = PackedVector3Array()
	for mount: int in BodyMounts.COUNT:
		var rotation: Quaternion = WornSensorFeed.limb_rotation(p_pose, mount)
		var parent: int = BodyMounts.PARENTS[mount]
		var joint: Vector3 = p_pose.root
		if parent >= 0:
			joint = (
				joints[parent]
				+ WornSensorFeed.limb_rotation(p_pose, parent) * WornSensorFeed.OFFSETS[mount]
			)
		joints.append(joint)
		# Godot's x, y, z are Xsens' y, z, x.
		var numbers: Array[float] = [rotation.w, rotation.z, rotation.x, rotation.y]
		numbers.append_array([joint.z, joint.x, joint.y])
		r_values.append_array(PackedFloat32Array(numbers))
