extends RefCounted
## Rigged characters of every kind: any axes of the bones, any scale, several surfaces.

const People: GDScript = preload("res://tests/mocap/people_samples.gd")

## Radius of the skin about arms and legs, m.
const RADIUS: float = 0.06
const _RINGS: int = 12


## How a character is made.
class Kind:
	## Metres of a unit of the skeleton.
	var unit: float = 1.0
	## Whether the skeleton's space has Z up, as a node above turns it.
	var is_z_up: bool = false
	## Seed of the bones' axes, 0 for axes along the bones.
	var axes: int = 0
	## Whether it has a skin.
	var has_skin: bool = true


## A character below a new Ragdoll.
static func make(p_kind: Kind) -> Ragdoll:
	var person: Ragdoll = Ragdoll.new()
	person.name = "Person"
	var armature: Node3D = Node3D.new()
	if p_kind.is_z_up:
		armature.rotation.x = -PI / 2.0
	armature.scale = Vector3.ONE * p_kind.unit
	person.add_child(armature)
	var plain: Skeleton3D = BvhSkeleton.make(BvhRig.from_clip(People.make(People.Person.new())))
	var skeleton: Skeleton3D = _change(plain, armature.transform.affine_inverse(), p_kind.axes)
	armature.add_child(skeleton)
	if p_kind.has_skin:
		_add_skin(plain, skeleton, armature.transform.affine_inverse())
		# A thing that is not skinned, and huge: it must not count.
		var extra: MeshInstance3D = MeshInstance3D.new()
		extra.mesh = SphereMesh.new()
		skeleton.add_child(extra)
	plain.free()
	return person


## The same skeleton in another space, with its bones turned about their origins.
static func _change(p_plain: Skeleton3D, p_move: Transform3D, p_seed: int) -> Skeleton3D:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = p_seed
	var skeleton: Skeleton3D = Skeleton3D.new()
	var rests: Array[Transform3D] = []
	for bone: int in p_plain.get_bone_count():
		skeleton.add_bone(p_plain.get_bone_name(bone))
		var parent: int = p_plain.get_bone_parent(bone)
		skeleton.set_bone_parent(bone, parent)
		var rest: Transform3D = (p_move * p_plain.get_bone_global_rest(bone)).orthonormalized()
		if p_seed > 0:
			var axis: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn())
			rest.basis *= Basis(axis.normalized(), random.randf_range(0.0, TAU))
		rests.append(rest)
		skeleton.set_bone_rest(bone, rest if parent < 0 else rests[parent].affine_inverse() * rest)
	skeleton.reset_bone_poses()
	return skeleton


## Tubes about the limbs, in two surfaces and with a blend shape.
static func _add_skin(p_plain: Skeleton3D, p_skeleton: Skeleton3D, p_move: Transform3D) -> void:
	var mesh: ArrayMesh = ArrayMesh.new()
	mesh.add_blend_shape(&"fat")
	var figure: RestSkeleton = RestSkeleton.new(p_plain)
	for half: int in 2:
		var arrays: Array = []
		arrays.resize(Mesh.ARRAY_MAX)
		var vertices: PackedVector3Array = []
		var bones: PackedInt32Array = []
		var weights: PackedFloat32Array = []
		for limb: int in range(half * 8, half * 8 + 8):
			_add_tube(figure, limb, vertices)
			while bones.size() < vertices.size() * 4:
				bones.append_array([p_plain.find_bone(Limbs.BONES[limb]), 0, 0, 0])
				weights.append_array([1.0, 0.0, 0.0, 0.0])
		arrays[Mesh.ARRAY_VERTEX] = p_move * vertices
		arrays[Mesh.ARRAY_BONES] = bones
		arrays[Mesh.ARRAY_WEIGHTS] = weights
		var fat: Array = []
		fat.resize(Mesh.ARRAY_MAX)
		fat[Mesh.ARRAY_VERTEX] = (p_move * vertices) * Transform3D.IDENTITY.scaled(Vector3.ONE * 3)
		mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays, [fat])
	var instance: MeshInstance3D = MeshInstance3D.new()
	instance.mesh = mesh
	instance.skin = p_skeleton.create_skin_from_rest_transforms()
	p_skeleton.add_child(instance)
	instance.skeleton = ^".."


static func _add_tube(p_figure: RestSkeleton, p_limb: int, r_vertices: PackedVector3Array) -> void:
	var base: Vector3 = p_figure.rest(Limbs.BONES[p_limb]).origin
	var along: Vector3 = p_figure.direction(p_limb)
	var turn: Basis = Basis(SkeletonShapes.orientation_along(along))
	var radius: float = RADIUS * (2.5 if p_limb < 3 else 1.6 if p_limb == 3 else 1.0)
	if p_limb > 3 and p_limb % 3 == 0:
		radius = RADIUS / 2.0
	for ring: int in _RINGS:
		for step: int in _RINGS:
			for corner: Vector2 in [Vector2(0, 0), Vector2(1, 0), Vector2(0, 1)]:
				var angle: float = TAU * (step + corner.x) / _RINGS
				var out: Vector3 = turn.x * cos(angle) + turn.z * sin(angle)
				r_vertices.append(base + along * (ring + corner.y) / _RINGS + out * radius)
