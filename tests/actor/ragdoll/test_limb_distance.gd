extends TestCase
## Distances of shapes, limbs that are too near each other, and making them thinner.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")
const CLIPS: Array[String] = ["01_01", "01_03", "Boxing_Toes"]

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _soldier: RagdollProfile = null


func before_each() -> void:
	_random.seed = 1
	var scene: Ragdoll = SOLDIER.instantiate()
	_soldier = scene.profile.duplicate(true)
	for i: int in _soldier.limbs.size():
		_soldier.limbs[i] = _soldier.limbs[i].duplicate()
	scene.free()


func test_distances_of_shapes() -> void:
	var pill: RagdollLimb = _limb(RagdollLimb.PILL)
	var box: RagdollLimb = _limb(RagdollLimb.BOX)
	var at: Transform3D = Transform3D.IDENTITY
	var aside: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.5, 0.0, 0.0))
	almost_equal(LimbDistance.separation(pill, at, pill, aside), 0.3, 1e-4)
	almost_equal(LimbDistance.separation(pill, at, box, aside), 0.3, 1e-4)
	almost_equal(LimbDistance.separation(box, at, pill, aside), 0.3, 1e-4)
	almost_equal(LimbDistance.separation(box, at, box, aside), 0.3, 1e-4)
	var lying: Transform3D = Transform3D(Basis(Vector3.BACK, PI / 2.0), aside.origin)
	almost_equal(LimbDistance.separation(pill, at, pill, lying), 0.2, 1e-4)


func test_distances_agree_with_points_on_the_surface() -> void:
	for _round: int in 40:
		var a: RagdollLimb = _limb(_random.randi_range(0, 1))
		var b: RagdollLimb = _limb(_random.randi_range(0, 1))
		b.position = NetSamples.vector(_random, 0.5)
		b.orientation = NetSamples.rotation(_random)
		var found: float = LimbDistance.separation(a, Transform3D(), b, Transform3D())
		var nearest: float = INF
		for _point: int in 400:
			var inside: Vector3 = b.position + b.orientation * _point_in(b)
			nearest = minf(nearest, LimbDistance.to_surface(a, inside))
		is_true(found <= nearest + 1e-4, "%f, but a point at %f" % [found, nearest])


func test_the_engine_agrees_that_the_soldiers_limbs_are_apart() -> void:
	equal(LimbDistance.overlaps(_soldier), [] as Array[Array])
	var moves: Array[Transform3D] = LimbDistance.rest_to_reset(_soldier)
	var space: RID = PhysicsServer3D.space_create()
	PhysicsServer3D.space_set_active(space, true)
	var bodies: Array[RID] = []
	var shapes: Array[Shape3D] = []
	for i: int in _soldier.limbs.size():
		var limb: RagdollLimb = _soldier.limbs[i]
		var place: Transform3D = Transform3D(Basis(limb.orientation), limb.position)
		shapes.append(RagdollBuilder.make_shape(limb))
		bodies.append(PhysicsServer3D.body_create())
		PhysicsServer3D.body_set_mode(bodies[i], PhysicsServer3D.BODY_MODE_STATIC)
		PhysicsServer3D.body_add_shape(bodies[i], shapes[i].get_rid())
		PhysicsServer3D.body_set_space(bodies[i], space)
		var state: PhysicsServer3D.BodyState = PhysicsServer3D.BODY_STATE_TRANSFORM
		PhysicsServer3D.body_set_state(bodies[i], state, moves[i] * place)
	await physics_frames(2)
	for i: int in bodies.size():
		var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
		query.shape = shapes[i]
		query.transform = PhysicsServer3D.body_get_state(
			bodies[i], PhysicsServer3D.BODY_STATE_TRANSFORM
		)
		query.exclude = [bodies[i]]
		for hit: Dictionary in PhysicsServer3D.space_get_direct_state(space).intersect_shape(query):
			var other: int = bodies.find(hit["rid"])
			var is_joint: bool = (
				_soldier.get_parent_index(i) == other or _soldier.get_parent_index(other) == i
			)
			is_true(is_joint, "%s in %s" % [_soldier.limbs[i].bone, _soldier.limbs[other].bone])
	for body: RID in bodies:
		PhysicsServer3D.free_rid(body)
	PhysicsServer3D.free_rid(space)


func test_overlaps_are_found_and_taken_away() -> void:
	_soldier.find(&"LeftUpperLeg").radius = 0.13
	_soldier.find(&"RightUpperLeg").radius = 0.13
	equal(RagdollBuilder.overlaps(_soldier), [[&"LeftUpperLeg", &"RightUpperLeg"]] as Array[Array])
	var left: Dictionary[StringName, float] = LimbDistance.keep_apart(_soldier)
	equal(RagdollBuilder.overlaps(_soldier), [] as Array[Array])
	is_true(left[&"LeftUpperLeg"] < 1.0 and left[&"LeftUpperLeg"] > LimbDistance.THINNEST)
	equal(left[&"Head"], 1.0)


func test_what_cannot_be_kept_apart_is_reported() -> void:
	_soldier.find(&"LeftUpperLeg").radius = 0.4
	LimbDistance.keep_apart(_soldier)
	is_true(not RagdollBuilder.overlaps(_soldier).is_empty())
	var person: Ragdoll = Ragdoll.new()
	person.profile = _soldier
	contains(str(person._get_configuration_warnings()), "touch in the reset pose: make one")
	person.free()


func test_skeletons_of_clips_have_no_overlaps() -> void:
	for clip: String in CLIPS:
		var result: BvhParser.Result = BvhParser.parse_file("res://assets/motion/%s.bvh" % clip)
		var skeleton: Skeleton3D = BvhSkeleton.make(BvhRig.from_clip(result.clip))
		var profile: RagdollProfile = SkeletonShapes.describe(skeleton)
		equal(profile.find_fault(), "")
		equal(RagdollBuilder.overlaps(profile), [] as Array[Array], clip)
		skeleton.free()


func _limb(p_type: RagdollLimb.Type) -> RagdollLimb:
	var limb: RagdollLimb = RagdollLimb.new()
	limb.type = p_type
	limb.radius = 0.1
	limb.length = 0.2
	limb.size = Vector3(0.2, 0.4, 0.2)
	return limb


func _point_in(p_limb: RagdollLimb) -> Vector3:
	var half: Vector3 = p_limb.size / 2.0
	if p_limb.type == RagdollLimb.BOX:
		return Vector3(
			_random.randf_range(-half.x, half.x),
			_random.randf_range(-half.y, half.y),
			_random.randf_range(-half.z, half.z)
		)
	var out: Vector3 = NetSamples.vector(_random, 1.0).normalized() * p_limb.radius
	return out + Vector3(0.0, _random.randf_range(-0.5, 0.5) * p_limb.length, 0.0)
