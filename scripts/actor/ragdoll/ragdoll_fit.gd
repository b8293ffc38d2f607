@tool
class_name RagdollFit
extends RefCounted
## Gives a [Ragdoll] that is not started yet the size of a person: skeleton, profile, bodies, skin.
##
## Each bone has a linear map in its own axes: along a limb by the limb's factor, across by the
## body's; head, hands and feet in all directions alike, and what hangs on a limb (fingers, toes,
## shoulders) as the limb itself. Positions go through the map of their bone. Bones never get a
## scale of their own, which children would inherit: the skin is stretched by the poses that its
## meshes are bound with, so that it follows without shear however the limbs turn.
## Rotations stay, and so do the rest and the reset pose. Nothing that scenes share is changed.

## Limbs that one part of the work fits, so that none takes long.
const _SLICE: int = 6

var _ragdoll: RagdollFigure = null
var _scale: BodyScale = null
var _skeleton: Skeleton3D = null
var _figure: RestSkeleton = null
## Map of each bone, in its own axes.
var _maps: Array[Basis] = []
## Rests of the limbs' bones before, in model space, by bone.
var _rests: Dictionary[StringName, Transform3D] = {}
## The limbs' bodies, by bone.
var _bodies: Dictionary[StringName, PhysicalBone3D] = {}
## The profile before, and the limbs of the new one so far.
var _former: RagdollProfile = null
var _fitted: Array[RagdollLimb] = []
## What is still to be done.
var _parts: Array[Callable] = []


## Applies a scale. It can be done once.
static func apply(p_ragdoll: RagdollFigure, p_scale: BodyScale) -> void:
	var fit: RagdollFit = begin(p_ragdoll, p_scale)
	while not fit.advance():
		pass


## Begins to apply a scale; [method advance] does it. Without the skin it is quicker, for who draws
## nothing.
static func begin(
	p_ragdoll: RagdollFigure, p_scale: BodyScale, p_has_skin: bool = true
) -> RagdollFit:
	var fit: RagdollFit = RagdollFit.new()
	fit._ragdoll = p_ragdoll
	fit._scale = p_scale
	fit._skeleton = p_ragdoll.get_skeleton()
	fit._figure = RestSkeleton.new(fit._skeleton)
	fit._former = p_ragdoll.profile
	fit._bodies = fit._find_bodies()
	for bone: StringName in Limbs.BONES:
		fit._rests[bone] = fit._figure.scaled_rest(bone)
	fit._parts = [fit._find_maps]
	if p_has_skin:
		fit._parts.append(fit._fit_skins)
	fit._parts.append_array([fit._move_bones, fit._stand])
	for first: int in range(0, fit._bodies.size(), _SLICE):
		fit._parts.append(fit._fit_bodies.bind(fit._bodies.keys().slice(first, first + _SLICE)))
	for first: int in range(0, fit._former.limbs.size(), _SLICE):
		fit._parts.append(fit._fit_limbs.bind(fit._former.limbs.slice(first, first + _SLICE)))
	fit._parts.append_array([fit._put_profile, fit._share_strength])
	return fit


## Does the next part, some tenths of a millisecond of work. Returns whether all is done.
func advance() -> bool:
	if not _parts.is_empty():
		(_parts.pop_front() as Callable).call()
	return _parts.is_empty()


## Maps of all bones; those of bones above the hips leave everything as it is.
func _find_maps() -> void:
	_maps.resize(_skeleton.get_bone_count())
	_maps.fill(Basis.IDENTITY)
	var next: Dictionary[int, int] = _find_chains()
	for bone: int in _in_order():
		var parent: int = _skeleton.get_bone_parent(bone)
		var turn: Basis = _skeleton.get_bone_rest(bone).basis.orthonormalized()
		if parent >= 0:
			_maps[bone] = turn.inverse() * _maps[parent] * turn
		var limb: int = Limbs.find(_skeleton.get_bone_name(bone))
		if next.has(bone):
			var end: Vector3 = _skeleton.get_bone_rest(next[bone]).origin
			_maps[bone] = _stretch(end.normalized(), _scale.along[_owner_of(bone)])
		elif limb >= 0:
			_maps[bone] = Basis.from_scale(Vector3.ONE * _scale.along[limb])


## The bone that follows each bone on the path from a limb's joint to the next limb's.
func _find_chains() -> Dictionary[int, int]:
	var next: Dictionary[int, int] = {}
	for limb: int in Limbs.COUNT:
		if BodyScale.is_uniform(limb):
			continue
		var top: int = _skeleton.find_bone(Limbs.BONES[limb])
		var bone: int = _skeleton.find_bone(Limbs.BONES[BodyScale.NEXT[limb]])
		var path: Dictionary[int, int] = {}
		while bone >= 0 and bone != top:
			path[_skeleton.get_bone_parent(bone)] = bone
			bone = _skeleton.get_bone_parent(bone)
		if bone == top:
			next.merge(path)
	return next


## All bones, parents first.
func _in_order() -> PackedInt32Array:
	var order: PackedInt32Array = _skeleton.get_parentless_bones()
	var at: int = 0
	while at < order.size():
		order.append_array(_skeleton.get_bone_children(order[at]))
		at += 1
	return order


## The limb that a bone is part of.
func _owner_of(p_bone: int) -> int:
	var bone: int = p_bone
	while bone >= 0 and Limbs.find(_skeleton.get_bone_name(bone)) < 0:
		bone = _skeleton.get_bone_parent(bone)
	return Limbs.find(_skeleton.get_bone_name(bone)) if bone >= 0 else Limbs.ROOT


## A map that stretches along a direction, and across it by the body's factor.
func _stretch(p_along: Vector3, p_factor: float) -> Basis:
	var more: float = p_factor - _scale.across
	var outer: Basis = Basis(
		p_along * p_along.x * more, p_along * p_along.y * more, p_along * p_along.z * more
	)
	var width: float = _scale.across
	return Basis(
		outer.x + Vector3(width, 0.0, 0.0),
		outer.y + Vector3(0.0, width, 0.0),
		outer.z + Vector3(0.0, 0.0, width)
	)


## The skins are bound anew; at rest this moves each point as its bones' maps do.
func _fit_skins() -> void:
	# Meshes that share a skin go on sharing it, and the renderer's palette with it.
	var fitted: Dictionary[Skin, Skin] = {}
	for instance: MeshInstance3D in SkinnedSurface.find_meshes(_skeleton):
		var skin: Skin = instance.skin
		if fitted.has(skin):
			instance.skin = fitted[skin]
			continue
		if skin == null:
			skin = _skeleton.create_skin_from_rest_transforms()
		else:
			skin = skin.duplicate()
		for bind: int in skin.get_bind_count():
			var name: StringName = skin.get_bind_name(bind)
			var bone: int = skin.get_bind_bone(bind)
			if name != &"":
				bone = _skeleton.find_bone(name)
			if bone >= 0 and bone < _maps.size():
				var map: Transform3D = Transform3D(_maps[bone], Vector3.ZERO)
				skin.set_bind_pose(bind, map * skin.get_bind_pose(bind))
		fitted[instance.skin] = skin
		instance.skin = skin


func _move_bones() -> void:
	for bone: int in _skeleton.get_bone_count():
		var parent: int = _skeleton.get_bone_parent(bone)
		if parent >= 0:
			var rest: Transform3D = _skeleton.get_bone_rest(bone)
			rest.origin = _maps[parent] * rest.origin
			_put(bone, rest)


## Lifts or lowers the hips so that the soles are as high as before.
func _stand() -> void:
	var lowest: Vector2 = Vector2(INF, INF)
	for limb: RagdollLimb in _ragdoll.profile.limbs:
		var points: PackedVector3Array = limb.contact_points.duplicate()
		if not limb.is_foot:
			continue
		points.append(limb.anchor)
		var now: Transform3D = _displacement_of(limb.bone)
		for point: Vector3 in points:
			lowest = Vector2(minf(lowest.x, point.y), minf(lowest.y, (now * point).y))
	if lowest.is_finite():
		var hips: int = _skeleton.find_bone(Limbs.BONES[Limbs.ROOT])
		var parent: int = _skeleton.get_bone_parent(hips)
		var above: Transform3D = _figure.to_model
		if parent >= 0:
			above = above * _skeleton.get_bone_global_rest(parent)
		var rest: Transform3D = _skeleton.get_bone_rest(hips)
		rest.origin += above.basis.inverse() * Vector3(0.0, lowest.x - lowest.y, 0.0)
		_put(hips, rest)


func _put(p_bone: int, p_rest: Transform3D) -> void:
	_skeleton.set_bone_rest(p_bone, p_rest)
	_skeleton.set_bone_pose_position(p_bone, p_rest.origin)


## From where a limb's points were in model space to where they are.
func _displacement_of(p_bone: StringName) -> Transform3D:
	var map: Transform3D = Transform3D(_map_of(p_bone), Vector3.ZERO)
	return _figure.scaled_rest(p_bone) * map * _rests[p_bone].affine_inverse()


func _map_of(p_bone: StringName) -> Basis:
	return _maps[_skeleton.find_bone(p_bone)]


func _fit_limbs(p_limbs: Array[RagdollLimb]) -> void:
	for limb: RagdollLimb in p_limbs:
		var fitted: RagdollLimb = limb.duplicate()
		_fit_limb(fitted)
		_fitted.append(fitted)


func _put_profile() -> void:
	var profile: RagdollProfile = _former.duplicate()
	profile.limbs = _fitted
	_ragdoll.profile = profile


## Masses, and what bears and lifts them.
func _share_strength() -> void:
	var profile: RagdollProfile = _ragdoll.profile
	_share_mass(profile)
	var before: PackedFloat32Array = _loads(_former)
	var after: PackedFloat32Array = _loads(profile)
	var limbs: Array[RagdollLimb] = profile.limbs
	for i: int in limbs.size():
		limbs[i].max_torque *= maxf(BodyMass.torque_factor(_scale.height), after[i] / before[i])
	_ragdoll.root_force *= BodyMass.mass_factor(_scale.height)
	_ragdoll.root_torque *= BodyMass.torque_factor(_scale.height)


func _fit_limb(p_limb: RagdollLimb) -> void:
	var displacement: Transform3D = _displacement_of(p_limb.bone)
	var turn: Basis = Basis(p_limb.rest_orientation.inverse() * p_limb.orientation)
	var factors: Vector3 = _factors(_map_of(p_limb.bone), turn)
	var thin: float = sqrt(factors.x * factors.z)
	p_limb.anchor = displacement * p_limb.anchor
	p_limb.position = displacement * p_limb.position
	p_limb.contact_points = displacement * p_limb.contact_points
	p_limb.size *= factors
	p_limb.length *= factors.y
	p_limb.radius *= thin
	if p_limb.type == RagdollLimb.PILL:
		p_limb.contact_radius *= thin
	else:
		p_limb.contact_radius *= factors[(p_limb.size / factors).min_axis_index()]


## The torque that holds each limb and all that hangs on it out level, over the gravity, kg m.
static func _loads(p_profile: RagdollProfile) -> PackedFloat32Array:
	var limbs: Array[RagdollLimb] = p_profile.limbs
	var numbers: Dictionary[StringName, int] = {}
	for i: int in limbs.size():
		numbers[limbs[i].bone] = i
	var parents: PackedInt32Array = []
	var anchors: PackedVector3Array = []
	for limb: RagdollLimb in limbs:
		parents.append(numbers.get(limb.parent_bone, -1))
		anchors.append(limb.anchor)
	var loads: PackedFloat32Array = []
	loads.resize(limbs.size())
	for i: int in limbs.size():
		var position: Vector3 = limbs[i].position
		var mass: float = p_profile.mass * limbs[i].mass_fraction
		var above: int = i
		while above >= 0:
			loads[above] += mass * position.distance_to(anchors[above])
			above = parents[above]
	return loads


## Masses go with the limbs' volumes, their sum with the height by [BodyMass].
func _share_mass(p_profile: RagdollProfile) -> void:
	var own: float = p_profile.mass
	p_profile.mass = BodyMass.scaled_mass(own, _scale.height)
	var sums: Vector2 = Vector2.ZERO
	for limb: RagdollLimb in p_profile.limbs:
		var share: float = limb.mass_fraction
		sums += Vector2(share, share * _scale.volume(Limbs.find(limb.bone)))
	for limb: RagdollLimb in p_profile.limbs:
		var former: float = limb.mass_fraction
		limb.mass_fraction *= _scale.volume(Limbs.find(limb.bone)) * sums.x / sums.y
		var bone: PhysicalBone3D = _bodies.get(limb.bone)
		if bone != null and former > 0.0:
			bone.mass *= limb.mass_fraction / former * p_profile.mass / own


func _fit_bodies(p_names: Array[StringName]) -> void:
	for name: StringName in p_names:
		var map: Basis = _map_of(name)
		var offset: Transform3D = _bodies[name].body_offset
		offset.origin = map * offset.origin
		_bodies[name].body_offset = offset
		for child: Node in _bodies[name].get_children():
			if child is CollisionShape3D and (child as CollisionShape3D).shape != null:
				_fit_shape(child as CollisionShape3D, map)


func _fit_shape(p_shape: CollisionShape3D, p_map: Basis) -> void:
	var factors: Vector3 = _factors(p_map, p_shape.transform.basis.orthonormalized())
	var thin: float = sqrt(factors.x * factors.z)
	var shape: Shape3D = p_shape.shape.duplicate()
	if shape is BoxShape3D:
		(shape as BoxShape3D).size *= factors
	elif shape is SphereShape3D:
		(shape as SphereShape3D).radius *= thin
	elif shape is CapsuleShape3D:
		var capsule: CapsuleShape3D = shape
		var straight: float = capsule.height - 2.0 * capsule.radius
		var radius: float = capsule.radius * thin
		# The engine never lets the height be less than the caps need.
		capsule.height = maxf(capsule.height, 2.0 * radius)
		capsule.radius = radius
		capsule.height = straight * factors.y + 2.0 * radius
	p_shape.shape = shape
	p_shape.position = p_map * p_shape.position


## How a map stretches the axes of a shape.
static func _factors(p_map: Basis, p_axes: Basis) -> Vector3:
	var turned: Basis = p_map * p_axes
	return Vector3(turned.x.length(), turned.y.length(), turned.z.length())


func _find_bodies() -> Dictionary[StringName, PhysicalBone3D]:
	var bodies: Dictionary[StringName, PhysicalBone3D] = {}
	var simulator: PhysicalBoneSimulator3D = _ragdoll.get_simulator()
	if simulator != null:
		for child: Node in simulator.get_children():
			var bone: PhysicalBone3D = child as PhysicalBone3D
			if bone != null and Limbs.find(bone.bone_name) >= 0:
				bodies[bone.bone_name] = bone
	return bodies
