extends Node3D
## A character whose bodies follow a motion file. It gets its bodies as the button "Make bodies"
## makes them; in a game of your own press the button once, and the scene keeps them.

## The motion, a BVH file.
@export_file("*.bvh") var clip: String = ""

var _source: BvhSource = BvhSource.new()
## Seconds of the motion that were played.
var _time_s: float = 0.0

@onready var _ragdoll: Ragdoll = $Ragdoll


func _ready() -> void:
	_source.open(clip)
	if _source.error != "":
		push_error(_source.error)
		return
	_ragdoll.make_bodies()
	_ragdoll.start()


func _physics_process(p_delta: float) -> void:
	if _ragdoll.motor == null:
		return
	if _time_s > 0.0:
		_ragdoll.motor.measure(_time_s)
	var pose: PoseSample = _source.pose_at(_time_s)
	_ragdoll.push_sample(_time_s, pose, _hips_of(pose))
	_ragdoll.drive(_time_s, p_delta)
	_time_s += p_delta


## How well the body follows, see [method RagdollMotor.get_tracking].
func get_tracking() -> Dictionary:
	return _ragdoll.motor.get_tracking()


## Where the character's hips are to be: it may be smaller than who made the motion, and begins at
## its node.
func _hips_of(p_pose: PoseSample) -> Vector3:
	var begin: Vector3 = _source.pose_at(0.0).root * Vector3(1.0, 0.0, 1.0)
	var scale_to_character: float = _ragdoll.get_hip_height() / _source.get_hip_height()
	return _ragdoll.global_position + (p_pose.root - begin) * scale_to_character
