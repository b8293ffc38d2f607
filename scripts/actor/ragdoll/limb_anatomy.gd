@tool
class_name LimbAnatomy
extends RefCounted
## What is known of the limbs of any adult: strength groups, torques, how far the joints turn.
##
## Angles are those of [member RagdollLimb.min_angles]: X twist, Y swing to the side, Z flexion,
## from the T-pose with the palms down. Source: American Academy of Orthopaedic Surgeons, Joint
## Motion: Method of Measuring and Recording, 1965. The trunk's are shared equally by spine and
## chest; small angles about axes that it leaves out (a knee to the side) are play of soft tissue.

## The strength group of each limb, in the order of [constant Limbs.BONES].
const GROUPS: Array[StringName] = [
	&"trunk",
	&"trunk",
	&"trunk",
	&"head",
	&"left_arm",
	&"left_arm",
	&"left_arm",
	&"right_arm",
	&"right_arm",
	&"right_arm",
	&"left_leg",
	&"left_leg",
	&"left_leg",
	&"right_leg",
	&"right_leg",
	&"right_leg",
]

## Least and greatest angles of each limb, degrees; right limbs mirror the left ones.
const _ANGLES: Dictionary[StringName, Array] = {
	&"Spine": [Vector3(-22.5, -17.5, -12.5), Vector3(22.5, 17.5, 40.0)],
	&"Chest": [Vector3(-22.5, -17.5, -12.5), Vector3(22.5, 17.5, 40.0)],
	&"Head": [Vector3(-60.0, -45.0, -45.0), Vector3(60.0, 45.0, 45.0)],
	&"LeftUpperArm": [Vector3(-90.0, -135.0, -120.0), Vector3(70.0, 45.0, 90.0)],
	&"LeftLowerArm": [Vector3(-80.0, -150.0, -15.0), Vector3(80.0, 5.0, 15.0)],
	&"LeftHand": [Vector3(-10.0, -20.0, -80.0), Vector3(10.0, 30.0, 70.0)],
	&"LeftUpperLeg": [Vector3(-45.0, -30.0, -30.0), Vector3(45.0, 45.0, 120.0)],
	&"LeftLowerLeg": [Vector3(-20.0, -5.0, -135.0), Vector3(20.0, 5.0, 10.0)],
	&"LeftFoot": [Vector3(-35.0, -20.0, -50.0), Vector3(15.0, 20.0, 20.0)],
}


## Gives a limb the group, torque and joint angles that its bone has in an adult.
static func fill(p_limb: RagdollLimb) -> void:
	var limb: int = Limbs.find(p_limb.bone)
	if limb < 0:
		return
	p_limb.group = GROUPS[limb]
	p_limb.max_torque = Limbs.TORQUES[limb]
	p_limb.is_foot = String(p_limb.bone).ends_with("Foot")
	var left: StringName = StringName(String(p_limb.bone).replace("Right", "Left"))
	if not _ANGLES.has(left):
		return
	var low: Vector3 = _ANGLES[left][0] * (PI / 180.0)
	var high: Vector3 = _ANGLES[left][1] * (PI / 180.0)
	var is_right: bool = left != p_limb.bone
	p_limb.min_angles = Vector3(-high.x, -high.y, low.z) if is_right else low
	p_limb.max_angles = Vector3(-low.x, -low.y, high.z) if is_right else high
