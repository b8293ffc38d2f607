class_name BoneTransforms
extends RefCounted
## Where a ragdoll's bones are while its bodies move, read from the bodies.
##
## The engine moves a [Skeleton3D] with its physical bones only for as long as it updates it: asked
## at any other time, its bones rest. That update takes 16 µs a person in every frame.


## Where a bone is in the world. One without a body keeps its pose in its parent.
static func of(
	p_skeleton: Skeleton3D, p_simulator: PhysicalBoneSimulator3D, p_bone: int
) -> Transform3D:
	var in_body: Transform3D = Transform3D.IDENTITY
	var bone: int = p_bone
	while bone >= 0:
		var path: NodePath = NodePath(p_skeleton.get_bone_name(bone))
		var body: PhysicalBone3D = p_simulator.get_node_or_null(path) as PhysicalBone3D
		if body != null:
			return body.global_transform * body.body_offset.affine_inverse() * in_body
		in_body = p_skeleton.get_bone_pose(bone) * in_body
		bone = p_skeleton.get_bone_parent(bone)
	return p_skeleton.global_transform * in_body


## Has a skeleton not be updated any more, as nobody sees it. One that carries something
## ([BoneAttachment3D]) is. Returns whether it rests now.
static func rest(p_skeleton: Skeleton3D) -> bool:
	if not p_skeleton.find_children("*", "BoneAttachment3D", true, false).is_empty():
		return false
	p_skeleton.modifier_callback_mode_process = (Skeleton3D.MODIFIER_CALLBACK_MODE_PROCESS_MANUAL)
	return true
