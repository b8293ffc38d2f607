class_name BenchCrowd
extends RefCounted
## Many people who are driven at once, everybody at another moment of a clip, three metres apart.

## Who is driven.
var ragdolls: Array[Ragdoll] = []

var _source: BvhSource = null
var _motors: Array[RagdollMotor] = []
var _times: PackedFloat64Array = PackedFloat64Array()
var _floor: Block = null


## Adds and starts soldiers below a node; who stands on the own feet gets a floor.
func _init(
	p_people: int,
	p_source: BvhSource,
	p_parent: Node,
	p_root: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT
) -> void:
	_source = p_source
	if p_root == RagdollMotor.ROOT_GROUNDED:
		_floor = BenchBodies.ground(200.0)
		p_parent.add_child(_floor)
	for i: int in p_people:
		var ragdoll: Ragdoll = BenchBodies.soldier(p_root)
		p_parent.add_child(ragdoll)
		ragdoll.start()
		ragdolls.append(ragdoll)
		_motors.append(ragdoll.motor)


## Hands out the samples of a tick. Making the motion is the trainees' work, not the server's.
func push(p_time_s: float) -> void:
	for i: int in ragdolls.size():
		var sample: PoseSample = _source.pose_at(p_time_s + i * 0.7)
		var place: Vector3 = Vector3(i % 16, 0.0, i / 16) * 3.0
		ragdolls[i].push_sample(p_time_s, sample, sample.root + place)


## Sets all motors for the next step.
func drive(p_time_s: float, p_delta_s: float) -> void:
	_times.resize(ragdolls.size())
	_times.fill(p_time_s)
	RagdollMotor.drive_all(_motors, _times, p_delta_s)


## Ends it.
func leave() -> void:
	for ragdoll: Ragdoll in ragdolls:
		ragdoll.queue_free()
	ragdolls.clear()
	if _floor != null:
		_floor.queue_free()
	_motors.clear()
