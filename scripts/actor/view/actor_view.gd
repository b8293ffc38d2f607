class_name ActorView
extends RefCounted
## Shows a person on a client: puts the bones of the visible skeleton where the server's bodies are.
##
## Thesis section 6.3: a body's transform is that of the middle of a limb; the bone's follows from
## the offset between the two. Between the limbs (neck, shoulders, fingers) bones keep their offset
## to the limb above, but the neck shares the turn of the head. [SkeletonPoser] does it, and gives
## the renderer the bone palette (6.4); the skeleton's own bones rest, unless something hangs on
## them.

## The mesh of head and headwear.
const _HEAD_MESH: StringName = &"HeadMesh"
## Pose of the fingers until [method set_hands].
const _AT_EASE: String = "relaxed"
## Pose of fingers that hold something, and the side of the hand that does.
const _IN_HAND: String = "grip"
const _RIGHT: int = 1
## Greatest distance from the hips to a point of a person who stretches an arm up, share of the
## height.
const _REACH: float = 0.8
## Distance of the hips from the box's middle at which the box follows, m.
const _SLACK: float = 0.25

## The scene that is shown.
var node: Ragdoll = null
## What poses it.
var poser: SkeletonPoser = SkeletonPoser.new()
## Where its mesh is.
var hull: BodyHull = null

var _skeleton: Skeleton3D = null
var _meshes: Array[MeshInstance3D] = []
## The meshes of the head, which its wearer does not see.
var _heads: Array[MeshInstance3D] = []
var _is_first_person: bool = false
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
	_meshes = SkinnedSurface.find_meshes(_skeleton)
	for mesh: MeshInstance3D in _meshes:
		if mesh.name == _HEAD_MESH:
			_heads.append(mesh)
	HandPose.apply(_skeleton, _AT_EASE)
	if p_joints.is_sound():
		_set_up_poser(p_joints)
		p_node.shown_bone = poser.get_bone_transform
	for child: Node in p_node.get_children():
		var torch: Torch = child as Torch
		if torch != null:
			torch.held.connect(_hold)
	_head = _skeleton.find_bone(&"Head")
	_hips = _skeleton.find_bone(&"Hips")
	# No wider than need be: the engine takes the distance from this box for the level of detail.
	_reach = _REACH * RestSkeleton.new(_skeleton).height()


## Applies a smoother's state of the person. Returns whether there is one.
func pose(p_smoother: SnapshotSmoother, p_person: int) -> bool:
	var is_known: bool = poser.pose(_skeleton, p_smoother, p_person)
	if is_known:
		_bound()
	return is_known


## Applies floats as of [method SnapshotSmoother.person_transforms]. Returns whether they are valid.
func pose_floats(p_floats: PackedFloat32Array) -> bool:
	var is_pose: bool = poser.pose_floats(_skeleton, p_floats)
	if is_pose:
		_bound()
	return is_pose


## Where the hips were put last in the world, m.
func hips() -> Vector3:
	return poser.get_root()


## Where the head's joint was put last in the world, m.
func head_joint() -> Vector3:
	if _head < 0:
		return hips()
	return poser.get_bone_transform(_head).origin


## Where the head was put last in the world, its front towards +Z.
func head() -> Transform3D:
	return Transform3D(_turn_of(_head), head_joint())


## Where the feet (left, right) were put last in the world, m; empty where it has none.
func feet() -> PackedVector3Array:
	return _places_of([&"LeftFoot", &"RightFoot"])


## The same of the hands.
func hands() -> PackedVector3Array:
	return _places_of([&"LeftHand", &"RightHand"])


## Where the hips face: angle about the vertical, 0 towards +Z.
func heading() -> float:
	var ahead: Vector3 = _turn_of(_hips) * Vector3.BACK
	return atan2(ahead.x, ahead.z)


## Shows the body as its wearer sees it, without the head, whose shadow stays; or as all others do.
func set_first_person(p_is_first_person: bool) -> void:
	if _is_first_person == p_is_first_person:
		return
	_is_first_person = p_is_first_person
	for mesh: MeshInstance3D in _heads:
		mesh.cast_shadow = (
			GeometryInstance3D.SHADOW_CASTING_SETTING_SHADOWS_ONLY
			if p_is_first_person
			else GeometryInstance3D.SHADOW_CASTING_SETTING_ON
		)


## Bends the fingers: a name of [HandPose], for both hands or one (0 left, 1 right). Returns whether
## there is such a pose.
func set_hands(p_pose: String, p_side: int = -1) -> bool:
	var is_known: bool = HandPose.apply(_skeleton, p_pose, p_side)
	if is_known:
		poser.find_offsets(_skeleton)
	return is_known


## Puts the skeleton's own bones where they are shown, for who reads them there.
func write_skeleton() -> void:
	if not poser.is_driving_skeleton():
		poser.write_skeleton(_skeleton)


## Closes the right hand around something, or opens it.
func _hold(p_is_held: bool) -> void:
	set_hands(_IN_HAND if p_is_held else _AT_EASE, _RIGHT)


func _places_of(p_bones: Array[StringName]) -> PackedVector3Array:
	var places: PackedVector3Array = []
	for name: StringName in p_bones:
		var bone: int = _skeleton.find_bone(name)
		if bone < 0:
			return []
		places.append(poser.get_bone_transform(bone).origin)
	return places


## How a bone is turned in the world, from its rest.
func _turn_of(p_bone: int) -> Basis:
	if p_bone < 0:
		return Basis.IDENTITY
	var rest: Basis = _skeleton.get_bone_global_rest(p_bone).basis.orthonormalized()
	return poser.get_bone_transform(p_bone).basis.orthonormalized() * rest.inverse()


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
	if not poser.setup(_skeleton, bones, offsets, resets):
		Log.warning("actor", "the bones of %s are not those of a person" % node.name)
	poser.set_neck(_skeleton, _skeleton.find_bone(&"Neck"), Limbs.find(&"Head"))
	for mesh: MeshInstance3D in _meshes:
		if not poser.add_mesh(_skeleton, mesh):
			poser.set_driving_skeleton(true)
	if not _skeleton.find_children("*", "BoneAttachment3D", true, false).is_empty():
		poser.set_driving_skeleton(true)


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
