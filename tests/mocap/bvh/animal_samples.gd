extends RefCounted
## Skeletons that are no people's, some with a person's names, for the tests.

## Rows of name, parent's name, place in the rest pose, m (Y up, facing +Z). Of a name with # there
## are two, the one on the right mirrored.
const ANIMALS: Dictionary[String, Array] = {
	"dog with a person's names":
	[
		["Hips", "", Vector3(0.0, 0.55, 0.0)],
		["Spine", "Hips", Vector3(0.0, 0.56, 0.15)],
		["Spine1", "Spine", Vector3(0.0, 0.57, 0.32)],
		["Neck", "Spine1", Vector3(0.0, 0.6, 0.5)],
		["Head", "Neck", Vector3(0.0, 0.7, 0.62)],
		["#Shoulder", "Spine1", Vector3(0.05, 0.55, 0.46)],
		["#Arm", "#Shoulder", Vector3(0.08, 0.45, 0.5)],
		["#ForeArm", "#Arm", Vector3(0.08, 0.28, 0.44)],
		["#Hand", "#ForeArm", Vector3(0.08, 0.08, 0.46)],
		["#UpLeg", "Hips", Vector3(0.07, 0.5, -0.02)],
		["#Leg", "#UpLeg", Vector3(0.07, 0.32, 0.04)],
		["#Foot", "#Leg", Vector3(0.07, 0.14, -0.08)],
		["#ToeBase", "#Foot", Vector3(0.07, 0.02, -0.05)],
		["Tail", "Hips", Vector3(0.0, 0.55, -0.12)],
		["Tail1", "Tail", Vector3(0.0, 0.5, -0.3)],
	],
	"dog whose front legs are longer":
	[
		["Hips", "", Vector3(0.0, 0.5, 0.0)],
		["Spine", "Hips", Vector3(0.0, 0.56, 0.25)],
		["Neck", "Spine", Vector3(0.0, 0.7, 0.45)],
		["Head", "Neck", Vector3(0.0, 0.8, 0.55)],
		["#Shoulder", "Spine", Vector3(0.05, 0.72, 0.38)],
		["#Arm", "#Shoulder", Vector3(0.08, 0.7, 0.4)],
		["#ForeArm", "#Arm", Vector3(0.08, 0.4, 0.36)],
		["#Hand", "#ForeArm", Vector3(0.08, 0.08, 0.4)],
		["#UpLeg", "Hips", Vector3(0.07, 0.38, -0.02)],
		["#Leg", "#UpLeg", Vector3(0.07, 0.26, -0.12)],
		["#Foot", "#Leg", Vector3(0.07, 0.14, -0.24)],
		["#ToeBase", "#Foot", Vector3(0.07, 0.02, -0.2)],
	],
	"horse of a Biped":
	[
		["Bip01 Pelvis", "", Vector3(0.0, 1.35, 0.0)],
		["Bip01 Spine", "Bip01 Pelvis", Vector3(0.0, 1.38, 0.3)],
		["Bip01 Spine1", "Bip01 Spine", Vector3(0.0, 1.38, 0.75)],
		["Bip01 Neck", "Bip01 Spine1", Vector3(0.0, 1.5, 1.2)],
		["Bip01 Head", "Bip01 Neck", Vector3(0.0, 2.0, 1.6)],
		["Bip01 # Clavicle", "Bip01 Spine1", Vector3(0.1, 1.3, 1.1)],
		["Bip01 # UpperArm", "Bip01 # Clavicle", Vector3(0.18, 1.1, 1.2)],
		["Bip01 # Forearm", "Bip01 # UpperArm", Vector3(0.18, 0.8, 1.05)],
		["Bip01 # Hand", "Bip01 # Forearm", Vector3(0.18, 0.4, 1.1)],
		["Bip01 # Thigh", "Bip01 Pelvis", Vector3(0.2, 1.2, -0.05)],
		["Bip01 # Calf", "Bip01 # Thigh", Vector3(0.2, 0.85, 0.1)],
		["Bip01 # Foot", "Bip01 # Calf", Vector3(0.2, 0.5, -0.15)],
		["Bip01 # Toe0", "Bip01 # Foot", Vector3(0.2, 0.1, -0.1)],
	],
	"dog":
	[
		["pelvis", "", Vector3(0.0, 0.55, 0.0)],
		["spine", "pelvis", Vector3(0.0, 0.56, 0.3)],
		["head", "spine", Vector3(0.0, 0.7, 0.6)],
		["front_upperleg_#", "spine", Vector3(0.08, 0.5, 0.45)],
		["front_lowerleg_#", "front_upperleg_#", Vector3(0.08, 0.28, 0.4)],
		["front_paw_#", "front_lowerleg_#", Vector3(0.08, 0.03, 0.42)],
		["hind_upperleg_#", "pelvis", Vector3(0.07, 0.5, 0.0)],
		["hind_lowerleg_#", "hind_upperleg_#", Vector3(0.07, 0.3, 0.05)],
		["hind_paw_#", "hind_lowerleg_#", Vector3(0.07, 0.03, -0.05)],
	],
	"crab":
	[
		["Hips", "", Vector3(0.0, 0.3, 0.0)],
		["Eye_#", "Hips", Vector3(0.05, 0.4, 0.2)],
		["Leg_#_01", "Hips", Vector3(0.1, 0.3, 0.1)],
		["Leg_#_02", "Leg_#_01", Vector3(0.3, 0.4, 0.1)],
		["Leg_#_03", "Leg_#_02", Vector3(0.5, 0.0, 0.1)],
		["Leg_#_11", "Hips", Vector3(0.1, 0.3, -0.1)],
		["Leg_#_12", "Leg_#_11", Vector3(0.3, 0.4, -0.1)],
		["Leg_#_13", "Leg_#_12", Vector3(0.5, 0.0, -0.1)],
		["Arm_#_01", "Hips", Vector3(0.1, 0.3, 0.2)],
		["Arm_#_02", "Arm_#_01", Vector3(0.25, 0.35, 0.35)],
		["Claw_#", "Arm_#_02", Vector3(0.1, 0.35, 0.5)],
	],
	"hand":
	[
		["LeftForeArm", "", Vector3(0.0, 1.0, 0.0)],
		["LeftHand", "LeftForeArm", Vector3(0.25, 1.0, 0.0)],
		["LeftHandThumb1", "LeftHand", Vector3(0.28, 1.0, 0.04)],
		["LeftHandThumb2", "LeftHandThumb1", Vector3(0.31, 1.0, 0.06)],
		["LeftHandIndex1", "LeftHand", Vector3(0.34, 1.0, 0.02)],
		["LeftHandIndex2", "LeftHandIndex1", Vector3(0.38, 1.0, 0.02)],
		["LeftHandRing1", "LeftHand", Vector3(0.34, 1.0, -0.02)],
		["LeftHandRing2", "LeftHandRing1", Vector3(0.38, 1.0, -0.02)],
	],
	"bird":
	[
		["Hips", "", Vector3(0.0, 0.3, 0.0)],
		["Chest", "Hips", Vector3(0.0, 0.35, 0.1)],
		["Head", "Chest", Vector3(0.0, 0.45, 0.2)],
		["#Wing1", "Chest", Vector3(0.1, 0.35, 0.1)],
		["#Wing2", "#Wing1", Vector3(0.3, 0.35, 0.1)],
		["#UpLeg", "Hips", Vector3(0.05, 0.28, 0.0)],
		["#Leg", "#UpLeg", Vector3(0.05, 0.18, 0.03)],
		["#Foot", "#Leg", Vector3(0.05, 0.05, 0.0)],
	],
	"all arms":
	[
		["LeftUpLeg", "", Vector3(0.0, 1.0, 0.0)],
		["LeftLeg", "LeftUpLeg", Vector3(0.0, 0.5, 0.0)],
		["LeftArm", "LeftLeg", Vector3(0.0, 0.3, 0.0)],
		["LeftForeArm", "LeftArm", Vector3(0.0, 0.2, 0.0)],
		["RightUpLeg", "LeftUpLeg", Vector3(0.2, 1.0, 0.0)],
		["RightLeg", "RightUpLeg", Vector3(0.2, 0.5, 0.0)],
		["RightArm", "RightLeg", Vector3(0.2, 0.3, 0.0)],
		["RightForeArm", "RightArm", Vector3(0.2, 0.2, 0.0)],
	],
}


## The clip of an animal, which swings all of its joints, in a file with the axes that [param
## p_turn] turns Godot's into and so many units a metre.
static func make(p_animal: String, p_turn: Quaternion, p_per_metre: float) -> BvhClip:
	var joints: Array[BvhJoint] = []
	var index: Dictionary[String, int] = {"": -1}
	var places: Dictionary[String, Vector3] = {"": Vector3.ZERO}
	for row: Array in _rows(p_animal):
		var joint: BvhJoint = BvhJoint.new()
		joint.name = row[0]
		joint.parent = index[row[1]]
		places[row[0]] = row[2]
		joint.offset = p_turn * (row[2] - places[row[1]]) * p_per_metre
		joint.channels = PackedInt32Array([5, 3, 4])
		index[row[0]] = joints.size()
		joints.append(joint)
	joints[0].channels = PackedInt32Array([0, 1, 2, 5, 3, 4])
	var values: PackedFloat64Array = []
	for frame: int in 20:
		var hips: Vector3 = p_turn * (places[joints[0].name] + Vector3(0.0, 0.0, 0.05 * frame))
		for axis: int in 3:
			values.append(hips[axis] * p_per_metre)
		for joint: int in joints.size() * 3:
			values.append(8.0 * sin(0.4 * frame + joint))
	var clip: BvhClip = BvhClip.new()
	clip.source_name = "animal.bvh"
	clip.set_data(joints, values, 1.0 / 30.0)
	return clip


static func _rows(p_animal: String) -> Array[Array]:
	var found: Array[Array] = []
	var mirror: Vector3 = Vector3(-1.0, 1.0, 1.0)
	for side: String in ["Left", "Right"]:
		for row: Array in ANIMALS[p_animal]:
			var name: String = row[0]
			var word: String = (
				side if not name.contains("_") and not name.contains(" ") else side[0]
			)
			if not name.contains("#") and side == "Right":
				continue
			var place: Vector3 = row[2] if side == "Left" else row[2] * mirror
			found.append([name.replace("#", word), (row[1] as String).replace("#", word), place])
	return found
