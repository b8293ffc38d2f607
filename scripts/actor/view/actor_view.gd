class_name ActorView
extends RefCounted
## Shows a person on a client: puts the bones of the visible skeleton where the server's bodies are.
##
## Thesis section 6.3: a body's transform is that of the middle of a limb; the bone's follows from
## the offset between the two. Between the limbs (neck, shoulders, fingers) bones keep their rest
## pose, but the neck shares the turn of the head.

## The scene that is shown.
var node: Ragdoll = null

var _skeleton: Skeleton3D = null
var _bones: Dictionary[StringName, int] = {}
var _offsets: Dictionary[StringName, Transform3D] = {}
var _neck: int = -1
var _meshes: Array[MeshInstance3D] = []
## No point of the person is further from the hips, m.
var _reach: float = 2.0


func _init(p_node: Ragdoll) -> void:
	node = p_node
	_skeleton = p_node.get_skeleton()
	var simulator: PhysicalBoneSimulator3D = p_node.get_simulator()
	simulator.active = false
	for child: Node in simulator.get_children():
		var bone: PhysicalBone3D = child as PhysicalBone3D
		if bone != null and _skeleton.find_bone(bone.bone_name) >= 0:
			_bones[bone.bone_name] = _skeleton.find_bone(bone.bone_name)
			_offsets[bone.bone_name] = bone.body_offset.affine_inverse()
	_neck = _skeleton.find_bone(&"Neck")
	_meshes = SkinnedSurface.find_meshes(_skeleton)
	_reach = 1.5 * RestSkeleton.new(_skeleton).height()


## Shows the bodies' transforms in the world, by name of the limb's bone; parents come first.
func show(p_bodies: Dictionary[StringName, Transform3D]) -> void:
	var to_skeleton: Transform3D = _skeleton.global_transform.affine_inverse()
	for limb: StringName in p_bodies:
		if not _bones.has(limb):
			continue
		if limb == &"Head" and _neck >= 0:
			_turn_neck(to_skeleton * p_bodies[limb] * _offsets[limb])
		var pose: Transform3D = to_skeleton * p_bodies[limb] * _offsets[limb]
		_skeleton.set_bone_global_pose(_bones[limb], pose)
	_bound()


## Where the hips are in the world, m.
func hips() -> Vector3:
	var bone: int = _bones.get(&"Hips", 0)
	return _skeleton.global_transform * _skeleton.get_bone_global_pose(bone).origin


## Says where the person can be seen: the engine would take the box of the rest pose at the node,
## and leave out who is elsewhere.
func _bound() -> void:
	for mesh: MeshInstance3D in _meshes:
		var middle: Vector3 = mesh.global_transform.affine_inverse() * hips()
		var unit: float = maxf(mesh.global_basis.get_scale().x, 1e-4)
		mesh.custom_aabb = AABB(middle, Vector3.ZERO).grow(_reach / unit)


func _turn_neck(p_head: Transform3D) -> void:
	_skeleton.reset_bone_pose(_neck)
	var rest: Transform3D = _skeleton.get_bone_global_pose(_neck)
	var head: int = _bones[&"Head"]
	var head_rest: Quaternion = _skeleton.get_bone_rest(head).basis.get_rotation_quaternion()
	var straight: Quaternion = rest.basis.get_rotation_quaternion()
	var bent: Quaternion = p_head.basis.get_rotation_quaternion() * head_rest.inverse()
	rest.basis = Basis(straight.slerp(bent, 0.5))
	_skeleton.set_bone_global_pose(_neck, rest)
