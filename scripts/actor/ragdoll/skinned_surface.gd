@tool
class_name SkinnedSurface
extends RefCounted
## The skinned meshes of a figure in the rest pose, taken to pieces by limb.
##
## A point of the surface belongs to the limb whose bones move it most. Bones between the limbs
## count for the nearest limb above them (shoulders for the chest, fingers for the hand), a bone
## above all of them for the hips; the upper half of the neck counts for the head. Meshes without
## bones and blend shapes are left out.

## Meshes that say nothing of the body's shape: the figure as it is seen from afar, and what hangs
## far off the body, as a robe.
const _LEFT_OUT: Array[StringName] = [&"FarMesh", &"DrapeMesh"]

## Points of each limb in model space, m, in the order of [constant Limbs.BONES].
var points: Array[PackedVector3Array] = []
## The area that each of these points stands for, m².
var areas: Array[PackedFloat32Array] = []

var _figure: RestSkeleton = null
var _limbs: PackedInt32Array = []
var _neck: int = -1
var _neck_height: float = 0.0


func _init(p_figure: RestSkeleton) -> void:
	_figure = p_figure
	for _limb: int in Limbs.COUNT:
		points.append(PackedVector3Array())
		areas.append(PackedFloat32Array())
	_assign_bones()
	for instance: MeshInstance3D in find_meshes(p_figure.skeleton):
		if not _LEFT_OUT.has(instance.name):
			_add_instance(instance)


## The meshes that a skeleton moves: below it or beside it, up to the [Ragdoll].
static func find_meshes(p_skeleton: Skeleton3D) -> Array[MeshInstance3D]:
	var top: Node = p_skeleton
	while top.get_parent() is Node3D and top is not RagdollFigure:
		top = top.get_parent()
	var found: Array[MeshInstance3D] = []
	for instance: MeshInstance3D in top.find_children("*", "MeshInstance3D", true, false):
		if instance.mesh == null or instance.skeleton.is_empty():
			continue
		if instance.get_node_or_null(instance.skeleton) == p_skeleton:
			found.append(instance)
	return found


## Whether there is no skinned mesh.
func is_empty() -> bool:
	return points.all(func(some: PackedVector3Array) -> bool: return some.is_empty())


func _assign_bones() -> void:
	var skeleton: Skeleton3D = _figure.skeleton
	for bone: int in skeleton.get_bone_count():
		var above: int = bone
		while above >= 0 and Limbs.find(skeleton.get_bone_name(above)) < 0:
			above = skeleton.get_bone_parent(above)
		_limbs.append(Limbs.ROOT if above < 0 else Limbs.find(skeleton.get_bone_name(above)))
	_neck = skeleton.find_bone(&"Neck")
	if _neck >= 0:
		_neck_height = (_figure.rest(&"Neck").origin.y + _figure.rest(&"Head").origin.y) / 2.0


func _add_instance(p_instance: MeshInstance3D) -> void:
	var transform: Transform3D = RestSkeleton.transform_of(p_instance)
	var bones: PackedInt32Array = []
	var moves: Array[Transform3D] = []
	var skeleton: Skeleton3D = _figure.skeleton
	var skin: Skin = p_instance.skin
	for bind: int in skin.get_bind_count() if skin != null else skeleton.get_bone_count():
		var bone: int = bind
		if skin != null:
			var name: StringName = skin.get_bind_name(bind)
			bone = skin.get_bind_bone(bind) if name == &"" else skeleton.find_bone(name)
		if bone < 0 or bone >= skeleton.get_bone_count():
			bone = 0
		var pose: Transform3D = Transform3D.IDENTITY
		if skin != null:
			pose = skeleton.get_bone_global_rest(bone) * skin.get_bind_pose(bind)
		bones.append(bone)
		moves.append(transform * pose)
	for surface: int in p_instance.mesh.get_surface_count():
		_add_surface(p_instance.mesh.surface_get_arrays(surface), bones, moves)


func _add_surface(p_arrays: Array, p_bones: PackedInt32Array, p_moves: Array[Transform3D]) -> void:
	if p_arrays.is_empty() or p_arrays[Mesh.ARRAY_BONES] == null:
		return
	var vertices: PackedVector3Array = p_arrays[Mesh.ARRAY_VERTEX]
	var bones: PackedInt32Array = p_arrays[Mesh.ARRAY_BONES]
	var weights: PackedFloat32Array = p_arrays[Mesh.ARRAY_WEIGHTS]
	if vertices.is_empty() or bones.size() < vertices.size() or weights.size() != bones.size():
		return
	var count: int = bones.size() / vertices.size()
	var positions: PackedVector3Array = []
	var owners: PackedInt32Array = []
	positions.resize(vertices.size())
	owners.resize(vertices.size())
	for i: int in vertices.size():
		var position: Vector3 = Vector3.ZERO
		var total: float = 0.0
		for slot: int in range(i * count, (i + 1) * count):
			if weights[slot] > 0.0 and bones[slot] < p_moves.size():
				position += p_moves[bones[slot]] * vertices[i] * weights[slot]
				total += weights[slot]
		owners[i] = -1
		if total > 0.0 and position.is_finite():
			positions[i] = position / total
			owners[i] = _find_limb(positions[i], i * count, count, bones, weights, p_bones)
	_add_points(positions, owners, p_arrays[Mesh.ARRAY_INDEX])


func _find_limb(
	p_position: Vector3,
	p_first: int,
	p_count: int,
	p_slots: PackedInt32Array,
	p_weights: PackedFloat32Array,
	p_bones: PackedInt32Array
) -> int:
	var shares: PackedFloat32Array = []
	shares.resize(Limbs.COUNT)
	var best: int = 0
	for slot: int in range(p_first, p_first + p_count):
		if p_weights[slot] <= 0.0 or p_slots[slot] >= p_bones.size():
			continue
		var bone: int = p_bones[p_slots[slot]]
		var limb: int = _limbs[bone]
		if bone == _neck and p_position.y > _neck_height:
			limb = Limbs.find(&"Head")
		shares[limb] += p_weights[slot]
		if shares[limb] > shares[best]:
			best = limb
	return best


## Every corner stands for a third of its triangles.
func _add_points(
	p_positions: PackedVector3Array, p_owners: PackedInt32Array, p_indices: Variant
) -> void:
	var corners: PackedInt32Array = p_indices if p_indices != null else PackedInt32Array()
	if p_indices == null:
		corners = PackedInt32Array(range(p_positions.size()))
	var shares: PackedFloat32Array = []
	shares.resize(p_positions.size())
	for i: int in range(0, corners.size() - 2, 3):
		var a: Vector3 = p_positions[corners[i]]
		var edge: Vector3 = p_positions[corners[i + 1]] - a
		var third: float = edge.cross(p_positions[corners[i + 2]] - a).length() / 6.0
		for corner: int in 3:
			shares[corners[i + corner]] += third
	for i: int in p_positions.size():
		if p_owners[i] >= 0 and shares[i] > 0.0:
			points[p_owners[i]].append(p_positions[i])
			areas[p_owners[i]].append(shares[i])
