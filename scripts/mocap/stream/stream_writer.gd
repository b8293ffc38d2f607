class_name StreamWriter
extends RefCounted
## Writes somebody's poses as a protocol's own programs do: in place of such a program. Each
## protocol derives from it.

# Whose poses they are.
var _size: BodySize = null
var _figure: BodySegments = null


## For somebody of a size.
func _init(p_size: BodySize = BodySize.new()) -> void:
	_size = p_size
	_figure = BodySegments.new(p_size)


## Says who it is of the people that one program sends: a number from 0, and a name.
func set_person(_p_number: int, _p_name: String) -> void:
	pass


## What is to be sent for a pose that was taken at [member PoseSample.time_usec]: datagrams, or
## pieces of a TCP stream, in their order.
func write(_p_pose: PoseSample) -> Array[PackedByteArray]:
	return []


## What is to be sent back for a datagram that came from the receiver.
func answer(_p_bytes: PackedByteArray) -> Array[PackedByteArray]:
	return []
