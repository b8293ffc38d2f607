@tool
class_name JointRanges
extends RefCounted
## How far the joints of people turn.
##
## Angles are about the axes of the joint in the reset pose (see [member RagdollLimb.min_angles]):
## X along the limb (twist), Y ahead, Z so that positive angles bend the limb forwards; for feet, Y
## up and positive angles about Z lift the toes. Values are for left limbs; right ones mirror them.
## Source: American Academy of Orthopaedic Surgeons, Joint Motion (1965), widened by about 15
## degrees, because motion capture never places joints exactly; the shoulder has the shoulder
## girdle's part, and a limb that follows its neighbour's axis loosely (elbow, knee) some of every
## axis.

## Least and greatest angles in degrees, by the limb's bone without its side.
const _DEGREES: Dictionary[StringName, Array] = {
	&"Spine": [Vector3(-35.0, -35.0, -35.0), Vector3(35.0, 35.0, 60.0)],
	&"Chest": [Vector3(-35.0, -35.0, -35.0), Vector3(35.0, 35.0, 60.0)],
	&"Head": [Vector3(-90.0, -55.0, -80.0), Vector3(90.0, 55.0, 75.0)],
	&"UpperArm": [Vector3(-110.0, -120.0, -70.0), Vector3(110.0, 115.0, 150.0)],
	&"LowerArm": [Vector3(-110.0, -60.0, -20.0), Vector3(110.0, 60.0, 165.0)],
	&"Hand": [Vector3(-60.0, -90.0, -60.0), Vector3(60.0, 90.0, 60.0)],
	&"UpperLeg": [Vector3(-65.0, -65.0, -45.0), Vector3(65.0, 65.0, 140.0)],
	&"LowerLeg": [Vector3(-50.0, -30.0, -165.0), Vector3(50.0, 30.0, 15.0)],
	&"Foot": [Vector3(-50.0, -45.0, -70.0), Vector3(50.0, 45.0, 50.0)],
}


## Least angles of a limb, rad.
static func least(p_bone: StringName) -> Vector3:
	return _of(p_bone, 0)


## Greatest angles of a limb, rad.
static func greatest(p_bone: StringName) -> Vector3:
	return _of(p_bone, 1)


static func _of(p_bone: StringName, p_end: int) -> Vector3:
	var plain: StringName = String(p_bone).trim_prefix("Left").trim_prefix("Right")
	if not _DEGREES.has(plain):
		return Vector3(-PI, -PI, -PI) if p_end == 0 else Vector3(PI, PI, PI)
	var angles: Vector3 = _DEGREES[plain][p_end]
	if String(p_bone).begins_with("Right"):
		# Turns about the limb and to the side are mirrored, so least and greatest change places.
		var other: Vector3 = _DEGREES[plain][1 - p_end]
		angles = Vector3(-other.x, -other.y, angles.z)
	return angles * (PI / 180.0)
