class_name LimbRates
extends RefCounted
## A sample's rates in the axes of a profile's limbs, for [method RagdollMotor.push_sample].


## Three floats for each limb of the profile, rad/s; none if the sample lacks one of the limbs.
static func of(p_sample: PoseSample, p_profile: RagdollProfile) -> PackedFloat32Array:
	var rates: PackedFloat32Array = PackedFloat32Array()
	for limb: RagdollLimb in p_profile.limbs:
		var slot: int = Limbs.BONES.find(limb.bone)
		if slot < 0:
			return PackedFloat32Array()
		var turned: Quaternion = p_sample.orientation(slot) * limb.reset_orientation
		var own: Vector3 = turned.inverse() * p_sample.details.rates[slot]
		rates.append_array([own.x, own.y, own.z])
	return rates
