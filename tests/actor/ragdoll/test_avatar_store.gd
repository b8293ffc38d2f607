extends TestCase
## Figures by name: each has a scene with bodies that fit its mesh; names that nobody knows harm
## nobody.

const _PERSON: PackedScene = preload("res://scenes/actor/person.tscn")
## Of each figure how far the mesh may be from the bodies: the mean of the worst limb, and what 90 %
## of all limbs' surface keeps to, m. Kit, folds and what tapers make the difference.
const _WORST_MEAN_M: float = 0.032
const _MOST_M: float = 0.045
## Highest number of triangles of the figure as it is seen from afar.
const _FAR_TRIANGLES: int = 5000
## Weights a vertex.
const _WEIGHTS: int = 4


func test_names_of_strangers_are_resolved_without_harm() -> void:
	for name: String in AvatarStore.NAMES:
		equal(AvatarStore.resolve(name), name)
	var hostile: PackedStringArray = [
		"../person",
		"soldier.tscn",
		"res://scenes/server/server.tscn",
		"user://x",
		"Soldier",
		" soldier",
		"soldier\n2026 ERROR forged",
		"%s%s%n",
		"people/raider",
		"x".repeat(5000),
		String.chr(0x202e) + "reidlos",
	]
	for name: String in hostile:
		equal(AvatarStore.resolve(name), AvatarStore.default_name(), name.left(40).c_escape())
		equal(AvatarStore.scene_of(name, _PERSON), _PERSON)
	equal(AvatarStore.scene_of("", _PERSON), _PERSON)


func test_every_avatar_is_a_person() -> void:
	var example: Node = _PERSON.instantiate()
	var type: EntityType = Entity.find_in(example).type
	example.free()
	for name: String in AvatarStore.NAMES:
		var person: Ragdoll = AvatarStore.scene_of(name, _PERSON).instantiate()
		add_child(person)
		is_true(person.check(), name)
		is_true(person.get_joints().is_sound(), name)
		equal(Entity.find_in(person).type, type, name)
		var meshes: Array[MeshInstance3D] = SkinnedSurface.find_meshes(person.get_skeleton())
		var names: Array[String] = []
		for mesh: MeshInstance3D in meshes:
			names.append(String(mesh.name))
			equal(mesh.skin, meshes[0].skin, "%s: a skin for all" % name)
			_check_mesh(mesh, name)
		for needed: String in ["BodyMesh", "HeadMesh", "FarMesh"]:
			contains(names, needed, name)
		person.free()


func test_bodies_fit_the_mesh() -> void:
	for name: String in AvatarStore.NAMES:
		var person: Ragdoll = AvatarStore.scene_of(name, _PERSON).instantiate()
		add_child(person)
		var surface: SkinnedSurface = SkinnedSurface.new(RestSkeleton.new(person.get_skeleton()))
		var gaps: PackedFloat32Array = []
		for limb: int in Limbs.COUNT:
			var shape: RagdollLimb = person.profile.find(Limbs.BONES[limb])
			var mean: float = 0.0
			var area: float = 0.0
			for i: int in range(0, surface.points[limb].size(), 5):
				var gap: float = absf(_distance(shape, surface.points[limb][i]))
				mean += gap * surface.areas[limb][i]
				area += surface.areas[limb][i]
				gaps.append(gap)
			mean /= maxf(area, 1e-9)
			var parts: Array = [name, Limbs.BONES[limb], mean * 1000.0]
			is_true(mean < _WORST_MEAN_M, "%s, %s: %.0f mm" % parts)
		gaps.sort()
		var most: float = gaps[int(gaps.size() * 0.9)]
		is_true(most < _MOST_M, "%s: 90 %% within %.0f mm" % [name, most * 1000.0])
		person.free()


## A person of the wearer's measures is as large in any figure.
func test_every_avatar_takes_the_wearers_size() -> void:
	for name: String in AvatarStore.NAMES:
		var person: Ragdoll = AvatarStore.scene_of(name, _PERSON).instantiate()
		add_child(person)
		var lengths: PackedFloat32Array = []
		lengths.resize(Limbs.COUNT)
		lengths[Limbs.LEFT_UPPER_LEG] = 0.40
		lengths[Limbs.LEFT_UPPER_LEG + 1] = 0.41
		is_true(person.fit(lengths, 0.86), name)
		var skeleton: Skeleton3D = person.get_skeleton()
		var hip: Vector3 = person.get_bone_transform(&"LeftUpperLeg").origin
		var knee: Vector3 = person.get_bone_transform(&"LeftLowerLeg").origin
		almost_equal(hip.distance_to(knee), 0.40, 0.002, name)
		var meshes: Array[MeshInstance3D] = SkinnedSurface.find_meshes(skeleton)
		for mesh: MeshInstance3D in meshes:
			equal(mesh.skin, meshes[0].skin, "%s: still one skin" % name)
		person.free()


## The far figure is one surface of few triangles; no vertex hangs on more than four bones.
func _check_mesh(p_mesh: MeshInstance3D, p_avatar: String) -> void:
	var triangles: int = 0
	for surface: int in p_mesh.mesh.get_surface_count():
		var arrays: Array = p_mesh.mesh.surface_get_arrays(surface)
		var vertices: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
		var bones: PackedInt32Array = arrays[Mesh.ARRAY_BONES]
		equal(bones.size(), vertices.size() * _WEIGHTS, p_avatar)
		triangles += (arrays[Mesh.ARRAY_INDEX] as PackedInt32Array).size() / 3
		is_true(p_mesh.mesh.surface_get_material(surface) is ShaderMaterial, p_avatar)
	if p_mesh.name == &"FarMesh":
		equal(p_mesh.mesh.get_surface_count(), 1, p_avatar)
		is_true(triangles <= _FAR_TRIANGLES, "%s: %d triangles" % [p_avatar, triangles])
		is_true(p_mesh.visibility_range_begin > 5.0, p_avatar)
	else:
		is_true(p_mesh.visibility_range_end > 5.0, p_avatar)


## From a point to the surface of a limb's body in the rest pose, m; negative inside.
static func _distance(p_limb: RagdollLimb, p_point: Vector3) -> float:
	var local: Vector3 = p_limb.orientation.inverse() * (p_point - p_limb.position)
	if p_limb.type == RagdollLimb.PILL:
		var along: float = clampf(local.y, -p_limb.length / 2.0, p_limb.length / 2.0)
		return (local - Vector3(0.0, along, 0.0)).length() - p_limb.radius
	var beyond: Vector3 = local.abs() - p_limb.size / 2.0
	return beyond.max(Vector3.ZERO).length() + minf(beyond[beyond.max_axis_index()], 0.0)
