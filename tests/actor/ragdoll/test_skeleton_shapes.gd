extends TestCase
## Bodies from skeleton and mesh: of the soldier, and of characters with any axes and scale.

const Stats: GDScript = preload("rest_samples.gd")
const FastPhysics: GDScript = preload("fast_physics.gd")
const Stage: GDScript = preload("stage.gd")
const AVATAR: PackedScene = preload("res://assets/avatar/soldier.glb")
const FILE: String = "res://assets/avatar/shapes/soldier.json"

var _person: Ragdoll = null


func after_each() -> void:
	if _person != null:
		_person.free()
	_person = null


func test_the_soldier_is_measured_as_by_the_tool() -> void:
	_person = _soldier(1.0)
	var made: RagdollProfile = SkeletonShapes.describe(_person.get_skeleton())
	equal(made.find_fault(), "")
	equal(RagdollBuilder.overlaps(made), [] as Array[Array])
	var wanted: RagdollProfile = RagdollProfileReader.new().read(FILE)
	for limb: RagdollLimb in made.limbs:
		var other: RagdollLimb = wanted.find(limb.bone)
		equal(limb.type, other.type, limb.bone)
		if limb.is_foot:
			continue  # Its body ends behind the toes.
		almost_equal(limb.position, other.position, 0.005, limb.bone)
		almost_equal(limb.anchor, other.anchor, 1e-4, limb.bone)
		almost_equal([limb.radius, limb.length], [other.radius, other.length], 0.003, limb.bone)
		if limb.type == RagdollLimb.BOX:
			almost_equal(limb.size, other.size, 0.008, limb.bone)


func test_the_skin_lies_near_the_shapes() -> void:
	_person = _soldier(1.0)
	var figure: RestSkeleton = RestSkeleton.new(_person.get_skeleton())
	var surface: SkinnedSurface = SkinnedSurface.new(figure)
	var made: RagdollProfile = SkeletonShapes.describe(_person.get_skeleton())
	for limb: int in Limbs.COUNT:
		var sum: float = 0.0
		var area: float = 0.0
		for i: int in surface.points[limb].size():
			var shape: RagdollLimb = made.find(Limbs.BONES[limb])
			var off: float = LimbDistance.to_surface(shape, surface.points[limb][i])
			sum += absf(off) * surface.areas[limb][i]
			area += surface.areas[limb][i]
		is_true(sum / area < 0.03, "%s: %f m" % [Limbs.BONES[limb], sum / area])


func test_half_the_size_is_half_of_everything() -> void:
	_person = _soldier(1.0)
	var whole: RagdollProfile = SkeletonShapes.describe(_person.get_skeleton())
	_person.free()
	_person = _soldier(0.5)
	var half: RagdollProfile = SkeletonShapes.describe(_person.get_skeleton())
	for i: int in Limbs.COUNT:
		var limb: RagdollLimb = half.limbs[i]
		almost_equal(limb.position, whole.limbs[i].position / 2.0, 0.002, limb.bone)
		almost_equal(limb.anchor, whole.limbs[i].anchor / 2.0, 1e-4, limb.bone)
		almost_equal(limb.radius, whole.limbs[i].radius / (2.0 if limb.type == 0 else 1.0), 0.002)
		almost_equal(limb.reset_orientation, whole.limbs[i].reset_orientation, 1e-4, limb.bone)
	almost_equal(half.mass, whole.mass / 4.0, 0.1)
	is_true(whole.mass > 65.0 and whole.mass < 95.0, "a grown man of %f kg" % whole.mass)
	almost_equal(half.limbs[5].max_torque, whole.limbs[5].max_torque / 8.0, 0.1)


func test_axes_and_scale_of_the_skeleton_do_not_matter() -> void:
	_person = Stats.make(Stats.Kind.new())
	var plain: RagdollProfile = SkeletonShapes.describe(_person.get_skeleton())
	equal(plain.find_fault(), "")
	almost_equal(plain.find(&"LeftUpperArm").radius, Stats.RADIUS, 0.003)
	for seed_of_axes: int in [1, 2]:
		_person.free()
		_person = Stats.make(_odd(seed_of_axes))
		var made: RagdollProfile = SkeletonShapes.describe(_person.get_skeleton())
		equal(made.find_fault(), "")
		for i: int in Limbs.COUNT:
			var limb: RagdollLimb = made.limbs[i]
			var other: RagdollLimb = plain.limbs[i]
			almost_equal(limb.anchor, other.anchor, 1e-3, limb.bone)
			almost_equal(limb.position, other.position, 2e-3, limb.bone)
			almost_equal([limb.radius, limb.length], [other.radius, other.length], 2e-3, limb.bone)
			var turn: Quaternion = limb.reset_orientation * limb.rest_orientation.inverse()
			var wanted: Quaternion = other.reset_orientation * other.rest_orientation.inverse()
			is_true(rad_to_deg(turn.angle_to(wanted)) < 0.5, "%s in the reset pose" % limb.bone)


func test_a_character_in_centimetres_is_driven() -> void:
	FastPhysics.start()
	_person = Stats.make(_odd(3))
	add_child(_person)
	_person.make_bodies()
	equal(_person._find_obstacles(), PackedStringArray())
	for bone: PhysicalBone3D in _person.get_simulator().get_children():
		almost_equal(bone.global_basis.get_scale(), Vector3.ONE, 1e-3, bone.name)
	is_true(_person.start())
	var stage: Stage = Stage.new()
	add_child(stage)
	var player: Stage.Player = Stage.Player.new()
	player.ragdoll = _person
	player.pose = func(_time: float) -> PoseSample: return Stage.arms_pose(40.0, 20.0)
	var place: Vector3 = Vector3(0.0, _person.get_hip_height() + 0.1, 0.0)
	player.place = func(_time: float) -> Vector3: return place
	stage.players.append(player)
	await stage.run(60)
	FastPhysics.stop()
	var worst: float = player.worst_error_deg(Stage.arms_pose(40.0, 20.0))
	is_true(worst < 0.5, "off by %f deg" % worst)
	var hand: Vector3 = player.body(Limbs.find(&"LeftHand")).origin
	is_true(hand.distance_to(place) < 1.2, "hand at %s" % hand)
	stage.free()


func test_without_a_skin_a_body_is_an_average_one() -> void:
	var kind: Stats.Kind = Stats.Kind.new()
	kind.has_skin = false
	_person = Stats.make(kind)
	_person.make_bodies()
	equal(_person.profile.find_fault(), "")
	equal(RagdollBuilder.overlaps(_person.profile), [] as Array[Array])
	var warnings: PackedStringArray = _person._get_configuration_warnings()
	equal(warnings.size(), 1, str(warnings))
	contains(warnings[0], "No skinned mesh belongs to the skeleton")
	for limb: RagdollLimb in _person.profile.limbs:
		if limb.is_foot:
			equal(limb.contact_points.size(), 5)
			for point: Vector3 in limb.contact_points:
				almost_equal(point.y, limb.position.y - limb.size.y / 2.0, 1e-4)


func test_feet_stand_on_the_sole_of_the_skin() -> void:
	_person = _soldier(1.0)
	var made: RagdollProfile = SkeletonShapes.describe(_person.get_skeleton())
	var figure: RestSkeleton = RestSkeleton.new(_person.get_skeleton())
	var surface: SkinnedSurface = SkinnedSurface.new(figure)
	for bone: StringName in [&"LeftFoot", &"RightFoot"]:
		var foot: RagdollLimb = made.find(bone)
		var lowest: float = INF
		for point: Vector3 in surface.points[Limbs.find(bone)]:
			lowest = minf(lowest, point.y)
		almost_equal(foot.position.y - foot.size.y / 2.0, lowest, 1e-3)
		equal(foot.contact_radius, 0.0)
		var ahead: PackedFloat32Array = []
		for point: Vector3 in foot.contact_points:
			is_true(point.y - lowest < 0.01, "%s is above the sole" % point)
			ahead.append((point - foot.anchor).dot(figure.forward(12)))
		# Heel behind the ankle, ball before it, toes foremost.
		is_true(ahead[0] < 0.0 and ahead[1] > 0.08 and ahead[3] > ahead[1], str(ahead))


func test_faults_of_characters_say_what_to_do() -> void:
	var cases: Dictionary[String, Callable] = {
		"does not face +Z: turn": func(armature: Node3D) -> void: armature.rotate_y(PI),
		"not upright": func(armature: Node3D) -> void: armature.rotate_x(PI / 2.0),
		"mirrored": func(armature: Node3D) -> void: armature.scale.x = -1.0,
		"scaled unevenly": func(armature: Node3D) -> void: armature.scale = Vector3(1, 2, 1),
		"unevenly: scale it equally":
		func(armature: Node3D) -> void: armature.scale = Vector3(1, 1, 1.5),
	}
	for text: String in cases:
		_person = Stats.make(Stats.Kind.new())
		cases[text].call(_person.get_child(0))
		expect_error(text)
		_person.make_bodies()
		is_null(_person.profile)
		contains(str(_person._get_configuration_warnings()), text)
		_person.free()
	_person = null


static func _odd(p_seed: int) -> Stats.Kind:
	var kind: Stats.Kind = Stats.Kind.new()
	kind.unit = 0.01
	kind.is_z_up = true
	kind.axes = p_seed
	return kind


func _soldier(p_scale: float) -> Ragdoll:
	var person: Ragdoll = Ragdoll.new()
	var above: Node3D = Node3D.new()
	above.scale = Vector3.ONE * p_scale
	person.add_child(above)
	above.add_child(AVATAR.instantiate())
	return person
