class_name ActorView
extends RefCounted
## Shows a person on a client: puts the bones of the visible skeleton where the server's bodies are.
##
## Thesis section 6.3: a body's transform is that of the middle of a limb; the bone's follows from
## the offset between the two. Between the limbs (neck, shoulders, fingers) bones keep their rest
## pose, but the neck shares the turn of the head. [SkeletonPoser] does it.

## The visible box follows when the hips are this far from its middle, m.
const _SLACK: float = 0.25

## The scene that is shown.
var node: Ragdoll = null
## Where its mesh is.
var hull: BodyHull = null

var _skeleton: Skeleton3D = null
var _poser: SkeletonPoser = SkeletonPoser.new()
var _meshes: Array[MeshInstance3D] = []
## Maximum distance of the person's points from the hips, m.
var _reach: float = 2.0
var _middle: Vector3 = Vector3.INF
# The bones, or -1.
var _head: int = -1
var _hips: int = -1


## Takes the person's scene, in its size, and how the server's bodies hang together.
func _init(p_node: Ragdoll, p_joints: PersonSkeleton) -> void:
	node = p_node
	_skeleton = p_node.get_skeleton()
	hull = BodyHull.new(_skeleton)
	p_node.get_simulator().active = false
	if p_joints.is_sound():
		_set_up_poser(p_joints)
	_meshes = SkinnedSurface.find_meshes(_skeleton)
	_head = _skeleton.find_bone(&"Head")
	_hips = _skeleton.find_bone(&"Hips")
	_reach = 1.5 * RestSkeleton.new(_skeleton).height()


## Applies a smoother's state of the person. Returns whether there is one.
func pose(p_smoother: SnapshotSmoother, p_person: int) -> bool:
	var is_known: bool = _poser.pose(_skeleton, p_smoother, p_person)
	if is_known:
		_bound()
	return is_known


## Applies floats as of [method SnapshotSmoother.person_transforms]. Returns whether they are valid.
func pose_floats(p_floats: PackedFloat32Array) -> bool:
	var is_pose: bool = _poser.pose_floats(_skeleton, p_floats)
	if is_pose:
		_bound()
	return is_pose


## Where the hips were put last in the world, m.
func hips() -> Vector3:
	return _poser.get_root()


## Where the head's joint was put last in the world, m.
func head_joint() -> Vector3:
	if _head < 0:
		return hips()
	return _skeleton.global_transform * _skeleton.get_bone_global_pose(_head).origin


## Where the head was put last in the world, its front towards +Z.
func head() -> Transform3D:
	return Transform3D(_turn_of(_head), head_joint())


## Where the hips face: angle about the vertical, 0 towards +Z.
func heading() -> float:
	var ahead: Vector3 = _turn_of(_hips) * Vector3.BACK
	return atan2(ahead.x, ahead.z)


## How a bone is turned in the world, from its rest.
func _turn_of(p_bone: int) -> Basis:
	if p_bone < 0:
		return Basis.IDENTITY
	var rest: Basis = _skeleton.get_bone_global_rest(p_bone).basis.orthonormalized()
	var pose: Basis = _skeleton.global_basis * _skeleton.get_bone_global_pose(p_bone).basis
	return pose.orthonormalized() * rest.inverse()


func _set_up_poser(p_joints: PersonSkeleton) -> void:
	var bones: PackedInt32Array = []
	var offsets: Array[Transform3D] = []
	var resets: PackedFloat32Array = []
	for limb: int in Limbs.COUNT:
		var name: StringName = Limbs.BONES[limb]
		var body: PhysicalBone3D = node.get_simulator().get_node_or_null(NodePath(name))
		bones.append(_skeleton.find_bone(name) if body != null else -1)
		offsets.append(body.body_offset if body != null else Transform3D.IDENTITY)
		var reset: Quaternion = p_joints.reset_orientations[limb]
		resets.append_array([reset.x, reset.y, reset.z, reset.w])
	if not _poser.setup(_skeleton, bones, offsets, resets):
		Log.warning("actor", "the bones of %s are not those of a person" % node.name)
	_poser.set_neck(_skeleton, _skeleton.find_bone(&"Neck"), Limbs.find(&"Head"))


## Sets the visible box: the engine would use that of the rest pose at the node, and cull people who
## are elsewhere.
func _bound() -> void:
	if _middle.distance_squared_to(hips()) < _SLACK * _SLACK:
		return
	_middle = hips()
	for mesh: MeshInstance3D in _meshes:
		var middle: Vector3 = mesh.global_transform.affine_inverse() * _middle
		var unit: float = maxf(mesh.global_basis.get_scale().x, 1e-4)
		mesh.custom_aabb = AABB(middle, Vector3.ZERO).grow((_reach + _SLACK) / unit)
