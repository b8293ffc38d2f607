class_name ContactPerformer
extends RefCounted
## A body and a motion: the soldier, or the body that a motion file itself describes.

## What the report calls it.
var name: String = ""
## The motion file.
var source: BvhSource = null

var _is_soldier: bool = false
var _properties: Dictionary[StringName, float] = {}


## [param p_properties] are set on the [Ragdoll] before it starts.
func _init(
	p_source: BvhSource, p_is_soldier: bool, p_properties: Dictionary[StringName, float]
) -> void:
	source = p_source
	_is_soldier = p_is_soldier
	_properties = p_properties
	name = "soldier" if p_is_soldier else p_source.rig.clip.source_name.get_file()


## A person in a world who is not started yet. More properties may be given.
func enter(
	p_world: ContactWorld, p_root: RagdollMotor.RootMode, p_more: Dictionary[StringName, float] = {}
) -> ContactPerson:
	var ragdoll: Ragdoll = _make()
	ragdoll.root_mode = p_root
	for properties: Dictionary[StringName, float] in [_properties, p_more]:
		for property: StringName in properties:
			ragdoll.set(property, properties[property])
	p_world.add_child(ragdoll)
	return ContactPerson.new(ragdoll)


## What tells this body from another: two files of one person have the same.
func get_build() -> String:
	var builder: Ragdoll = _make()
	var build: String = ""
	for limb: RagdollLimb in builder.profile.limbs:
		build += "%.3v " % limb.anchor
	builder.free()
	return build


## Whether the motion file's skeleton describes a body.
func is_possible() -> bool:
	var builder: Ragdoll = _make()
	var is_whole: bool = builder.profile != null and builder.profile.find_fault() == ""
	builder.free()
	return is_whole


## Where the clip has the hips of this body at a time, s, the clip's ground at height 0.
func hips_at(p_time_s: float, p_person: ContactPerson) -> Vector3:
	var scale: float = p_person.ragdoll.get_hip_height() / source.get_hip_height()
	return source.pose_at(p_time_s).root * scale


## Seconds of the clip.
func duration() -> float:
	return maxf(source.rig.clip.duration() - BvhSource.BLEND_S, 0.1)


func _make() -> Ragdoll:
	return BenchBodies.soldier() if _is_soldier else BenchBodies.of_clip(source)
