class_name SensorPositions
extends RefCounted
## Where on a body sensors usually sit, and how joints lie to them: a few centimetres right.

## Where a sensor sits, m, from the joint of its mount, in the reset pose of somebody of
## [constant BodySize.USUAL_HEIGHT]: about where suits' straps and shirts have them.
const _PLACES: Array[Vector3] = [
	Vector3(0.0, 0.05, -0.1),
	Vector3(0.0, 0.13, 0.11),
	Vector3(0.0, 0.14, -0.1),
	Vector3(0.08, 0.02, -0.06),
	Vector3(0.2, 0.04, 0.0),
	Vector3(0.2, 0.025, 0.0),
	Vector3(0.07, 0.02, 0.0),
	Vector3(-0.08, 0.02, -0.06),
	Vector3(-0.2, 0.04, 0.0),
	Vector3(-0.2, 0.025, 0.0),
	Vector3(-0.07, 0.02, 0.0),
	Vector3(0.07, -0.28, 0.0),
	Vector3(-0.02, -0.15, 0.04),
	Vector3(0.0, -0.03, 0.08),
	Vector3(-0.07, -0.28, 0.0),
	Vector3(0.02, -0.15, 0.04),
	Vector3(0.0, -0.03, 0.08),
]
## How far from the middle shoulder blades turn about the collar bones, m.
const _COLLAR_M: float = 0.03

## The joint of each mount, and each sensor, m, in the reset pose, the soles at 0.
var joints: PackedVector3Array = PackedVector3Array()
var places: PackedVector3Array = PackedVector3Array()


func _init(p_size: BodySize) -> void:
	var part: float = p_size.height / BodySize.USUAL_HEIGHT
	var limbs: PackedVector3Array = p_size.joints()
	for mount: int in BodyMounts.COUNT:
		var joint: Vector3 = limbs[BodyMounts.LIMBS[mount]]
		if mount == BodyMounts.LEFT_SHOULDER or mount == BodyMounts.RIGHT_SHOULDER:
			var shoulder: Vector3 = limbs[BodyMounts.LIMBS[mount + 1]]
			joint = Vector3(BodyMounts.side(mount) * _COLLAR_M * part, shoulder.y, shoulder.z)
		joints.append(joint)
		places.append(joint + _PLACES[mount] * part)


## Tells what finds drifts where all joints are.
func set_joints(r_drift: HeadingDrift) -> void:
	for mount: int in BodyMounts.COUNT:
		var above: int = BodyMounts.PARENTS[mount]
		if above >= 0:
			var joint: Vector3 = joints[mount]
			r_drift.set_joint(mount, joint - places[above], joint - places[mount])
