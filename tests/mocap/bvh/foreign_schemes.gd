extends RefCounted
## How programs name the joints of people, for the tests.

## Sides, then names in the order of [constant KEYS]; # stands for the side. A name that follows the
## last one is that of a helper at the end of each lower arm, as twist bones and fingers are.
const SCHEMES: Dictionary[String, Array] = {
	"CMU":
	[
		"Left Right",
		"Hips Spine Spine1 Neck Head",
		"#Shoulder #Arm #ForeArm #Hand",
		"#UpLeg #Leg #Foot #ToeBase",
		"#FingerBase"
	],
	"shoulder, arm, wrist":
	["L R", "Hips Spine Chest Neck Head", "#Collar #Shoulder #Arm #Wrist", "#Hip #Leg #Ankle #Toe"],
	"Russian":
	[
		"Лев Прав",
		"Таз Поясница Грудь Шея Голова",
		"Ключица_#ая Плечо_#ое Предплечье_#ое Кисть_#ая",
		"Бедро_#ое Голень_#ая Стопа_#ая Носок_#ый"
	],
	"numbers": ["1 2", "n10 n11 n12 n13 n14", "n15# n16# n17# n18#", "n19# n20# n21# n22#"],
	"ASF":
	[
		"l r",
		"root lowerback thorax lowerneck head",
		"#clavicle #humerus #radius #hand",
		"#femur #tibia #foot #toes",
		"#thumb"
	],
	"Mixamo":
	[
		"Left Right",
		"mixamorig:Hips mixamorig:Spine mixamorig:Spine1 mixamorig:Neck mixamorig:Head",
		"mixamorig:#Shoulder mixamorig:#Arm mixamorig:#ForeArm mixamorig:#Hand",
		"mixamorig:#UpLeg mixamorig:#Leg mixamorig:#Foot mixamorig:#ToeBase",
		"mixamorig:#HandIndex1"
	],
	"3ds Max":
	[
		"L R",
		"Bip01 Bip01_Spine Bip01_Spine1 Bip01_Neck Bip01_Head",
		"Bip01_#_Clavicle Bip01_#_UpperArm Bip01_#_Forearm Bip01_#_Hand",
		"Bip01_#_Thigh Bip01_#_Calf Bip01_#_Foot Bip01_#_Toe0",
		"Bip01_#_Finger0"
	],
	"Source":
	[
		"L R",
		"VB.Bip01_Pelvis VB.Bip01_Spine VB.Bip01_Spine2 VB.Bip01_Neck1 VB.Bip01_Head1",
		"VB.Bip01_#_Clavicle VB.Bip01_#_UpperArm VB.Bip01_#_Forearm VB.Bip01_#_Hand",
		"VB.Bip01_#_Thigh VB.Bip01_#_Calf VB.Bip01_#_Foot VB.Bip01_#_Toe0"
	],
	"Poser":
	[
		"l r",
		"hip abdomen chest neck head",
		"#Collar #Shldr #ForeArm #Hand",
		"#Thigh #Shin #Foot #Toe",
		"#Thumb1"
	],
	"DAZ":
	[
		"l r",
		"hip abdomenLower chestUpper neckLower head",
		"#Collar #ShldrBend #ForearmBend #Hand",
		"#ThighBend #Shin #Foot #Toe",
		"#ForearmTwist"
	],
	"lower case":
	[
		"l r",
		"hip abdomen chest neck head",
		"#collar #shoulder #elbow #hand",
		"#hip #knee #foot #toe",
		"finger1-1.#"
	],
	"Blender":
	[
		"L R",
		"hips spine chest neck head",
		"shoulder.# upper_arm.# forearm.# hand.#",
		"thigh.# shin.# foot.# toe.#",
		"forearm.#.001"
	],
	"Rigify":
	[
		"L R",
		"DEF-spine DEF-spine.001 DEF-spine.003 DEF-spine.004 DEF-spine.006",
		"DEF-shoulder.# DEF-upper_arm.# DEF-forearm.# DEF-hand.#",
		"DEF-thigh.# DEF-shin.# DEF-foot.# DEF-toe.#",
		"DEF-forearm.#.001"
	],
	"MakeHuman":
	[
		"L R",
		"root spine05 spine01 neck01 head",
		"clavicle.# upperarm01.# lowerarm01.# wrist.#",
		"upperleg01.# lowerleg01.# foot.# toe1-1.#",
		"lowerarm02.#"
	],
	"Unreal":
	[
		"l r",
		"pelvis spine_01 spine_03 neck_01 head",
		"clavicle_# upperarm_# lowerarm_# hand_#",
		"thigh_# calf_# foot_# ball_#",
		"lowerarm_twist_01_#"
	],
	"MVN":
	[
		"Left Right",
		"Hips Chest Chest4 Neck Head",
		"#Collar #Shoulder #Elbow #Wrist",
		"#Hip #Knee #Ankle #Toe"
	],
	"MVN segments":
	[
		"Left Right",
		"Pelvis L5 T8 Neck Head",
		"#Shoulder #UpperArm #ForeArm #Hand",
		"#UpperLeg #LowerLeg #Foot #Toe"
	],
	"Rokoko":
	[
		"Left Right",
		"Hips Spine1 Spine4 Neck Head",
		"#Shoulder #Arm #ForeArm #Hand",
		"#Thigh #Shin #Foot #Toe"
	],
	"VRM":
	[
		"L R",
		"J_Bip_C_Hips J_Bip_C_Spine J_Bip_C_Chest J_Bip_C_Neck J_Bip_C_Head",
		"J_Bip_#_Shoulder J_Bip_#_UpperArm J_Bip_#_LowerArm J_Bip_#_Hand",
		"J_Bip_#_UpperLeg J_Bip_#_LowerLeg J_Bip_#_Foot J_Bip_#_ToeBase",
		"J_Bip_#_Index1"
	],
	"Neuron":
	[
		"Left Right",
		"Robot_Hips Robot_Spine Robot_Spine3 Robot_Neck Robot_Head",
		"Robot_#Shoulder Robot_#Arm Robot_#ForeArm Robot_#Hand",
		"Robot_#UpLeg Robot_#Leg Robot_#Foot Robot_#ToeBase",
		"Robot_#InHandThumb"
	],
	"Kinect":
	[
		"Left Right",
		"SpineBase SpineMid SpineShoulder Neck Head",
		"Clavicle# Shoulder# Elbow# Wrist#",
		"Hip# Knee# Ankle# Foot#",
		"HandTip#"
	],
	"SMPL":
	[
		"L R",
		"Pelvis Spine1 Spine3 Neck Head",
		"#_Collar #_Shoulder #_Elbow #_Wrist",
		"#_Hip #_Knee #_Ankle #_Foot",
		"#_Hand"
	],
	"HumanIK":
	[
		"Left Right",
		"Character1_Hips Character1_Spine Character1_Spine1 Character1_Neck Character1_Head",
		"Character1_#Shoulder Character1_#Arm Character1_#ForeArm Character1_#Hand",
		"Character1_#UpLeg Character1_#Leg Character1_#Foot Character1_#ToeBase",
		"Character1_#ForeArmRoll"
	],
	"Motive":
	["L R", "Hip Ab Chest Neck Head", "#Shoulder #UArm #FArm #Hand", "#Thigh #Shin #Foot #Toe"],
	"Character Creator":
	[
		"L R",
		"CC_Base_Hip CC_Base_Waist CC_Base_Spine02 CC_Base_NeckTwist01 CC_Base_Head",
		"CC_Base_#_Clavicle CC_Base_#_Upperarm CC_Base_#_Forearm CC_Base_#_Hand",
		"CC_Base_#_Thigh CC_Base_#_Calf CC_Base_#_Foot CC_Base_#_ToeBase",
		"CC_Base_#_ForearmTwist01"
	],
	"numbered":
	[
		"Left Right",
		"Hips_02 Spine_03 Spine1_04 Neck_05 Head_06",
		"#Shoulder_07 #Arm_08 #ForeArm_09 #Hand_010",
		"#UpLeg_055 #Leg_056 #Foot_057 #ToeBase_058",
		"#HandThumb1_011"
	],
	"Maya":
	[
		"L R",
		"C_hips_JNT C_spine_JNT C_chest_JNT C_neck_JNT C_head_JNT",
		"#_clavicle_JNT #_shoulder_JNT #_elbow_JNT #_wrist_JNT",
		"#_hip_JNT #_knee_JNT #_ankle_JNT #_ball_JNT",
		"#_thumb1_JNT"
	],
	"MMD": ["左 右", "センター 上半身 上半身2 首 頭", "#肩 #腕 #ひじ #手首", "#足 #ひざ #足首 #つま先", "#手捩"],
	"Second Life":
	[
		"Left Right",
		"mPelvis mTorso mChest mNeck mHead",
		"mCollar# mShoulder# mElbow# mWrist#",
		"mHip# mKnee# mAnkle# mFoot#"
	],
	"Bandai":
	[
		"L R",
		"Hips Spine Chest Neck Head",
		"Shoulder_# UpperArm_# LowerArm_# Hand_#",
		"UpperLeg_# LowerLeg_# Foot_# Toes_#"
	],
	"humanoid":
	[
		"Left Right",
		"Hips Spine Chest Neck Head",
		"#Shoulder #UpperArm #LowerArm #Hand",
		"#UpperLeg #LowerLeg #Foot #Toes",
		"#LittleProximal"
	],
}
## The joints of a scheme; those of the left stand for both sides.
const KEYS: PackedStringArray = [
	"Hips",
	"Spine",
	"Chest",
	"Neck",
	"Head",
	"LeftShoulder",
	"LeftUpperArm",
	"LeftLowerArm",
	"LeftHand",
	"LeftUpperLeg",
	"LeftLowerLeg",
	"LeftFoot",
	"LeftToes",
]


## Names of a scheme by the keys of both sides, and of the helpers by "LeftHelper", "RightHelper".
static func names(p_scheme: String) -> Dictionary[String, String]:
	var row: Array = SCHEMES[p_scheme]
	var sides: PackedStringArray = (row[0] as String).split(" ")
	var list: PackedStringArray = " ".join(row.slice(1, 4)).split(" ")
	var found: Dictionary[String, String] = {}
	for i: int in KEYS.size():
		found[KEYS[i]] = list[i].replace("#", sides[0])
		if KEYS[i].begins_with("Left"):
			found[KEYS[i].replace("Left", "Right")] = list[i].replace("#", sides[1])
	if row.size() > 4:
		found["LeftHelper"] = (row[4] as String).replace("#", sides[0])
		found["RightHelper"] = (row[4] as String).replace("#", sides[1])
	return found
