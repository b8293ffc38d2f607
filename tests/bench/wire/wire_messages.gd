class_name WireMessages
extends RefCounted
## A motion coded in one way: a message for each moment, and what a receiver makes of it.

## Name of the coding.
var name: String = ""
## What is sent, a message a moment.
var messages: Array[PackedByteArray] = []
## The greatest error of a limb, degrees.
var worst_deg: float = 0.0
## The greatest error of a hand, mm.
var worst_mm: float = 0.0


static func named(p_name: String) -> WireMessages:
	var result: WireMessages = WireMessages.new()
	result.name = p_name
	return result


## Notes what a receiver has of a pose.
func note(p_pose: PoseSample, p_root: Vector3, p_orientations: PackedFloat32Array) -> void:
	worst_deg = maxf(worst_deg, WireClip.worst_angle(p_pose.orientations, p_orientations))
	worst_mm = maxf(worst_mm, WireClip.worst_hand(p_pose, p_root, p_orientations))


## Bytes of all messages.
func size() -> int:
	var sum: int = 0
	for message: PackedByteArray in messages:
		sum += message.size()
	return sum


## The same messages, each compressed alone.
func compressed(p_mode: FileAccess.CompressionMode, p_name: String) -> WireMessages:
	var result: WireMessages = _like(p_name)
	for message: PackedByteArray in messages:
		result.messages.append(message.compress(p_mode))
	return result


## The same messages in one stream: one dictionary over all of them.
func compressed_whole(p_mode: FileAccess.CompressionMode, p_name: String) -> WireMessages:
	var result: WireMessages = _like(p_name)
	var all: PackedByteArray = PackedByteArray()
	for message: PackedByteArray in messages:
		all.append_array(message)
	result.messages.append(all.compress(p_mode))
	return result


## The same messages, each byte as the difference from the message before.
func differences(p_name: String) -> WireMessages:
	var result: WireMessages = _like(p_name)
	var last: PackedByteArray = PackedByteArray()
	for message: PackedByteArray in messages:
		var delta: PackedByteArray = message.duplicate()
		for i: int in mini(last.size(), delta.size()):
			delta[i] = (delta[i] - last[i]) & 0xFF
		result.messages.append(delta)
		last = message
	return result


func _like(p_name: String) -> WireMessages:
	var result: WireMessages = named(p_name)
	result.worst_deg = worst_deg
	result.worst_mm = worst_mm
	return result
