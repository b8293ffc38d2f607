class_name JointNames
extends RefCounted
## Recognises what a joint of somebody's skeleton is by its name, whatever the naming scheme.

## The sides of a body.
enum BodySide {
	## Neither, or not said.
	MIDDLE,
	## The person's left.
	LEFT,
	## The person's right.
	RIGHT,
}

## Parts of the body, and their names without side, namespace and punctuation; best names first.
const PARTS: Dictionary[StringName, Array] = {
	&"UpperLeg": ["upleg", "upperleg", "thigh", "upleg1", "femur", "hip", "leg1", "bigleg"],
	&"LowerLeg": ["lowleg", "lowerleg", "shin", "calf", "knee", "tibia", "leg", "leg2"],
	&"Foot": ["foot", "ankle", "feet"],
	&"UpperArm": ["arm", "upperarm", "uparm", "shldr", "humerus", "arm1", "shoulder"],
	&"LowerArm": ["forearm", "lowarm", "lowerarm", "elbow", "radius", "arm2"],
	&"Hand": ["hand", "wrist"],
	&"Shoulder": ["collar", "clavicle", "shoulder", "scapula", "collarbone"],
	&"Neck": ["neck", "neck1", "lowerneck", "neck0", "neck01"],
	&"Head": ["head"],
	&"Toes": ["toebase", "toe", "toes", "ball", "toe0", "foottoe"],
}

const _PREFIXES: Array[String] = [
	"mixamorig", "bip01", "bip001", "bip", "valvebiped", "def", "jbip", "j", "c"
]


## The side that a name stands for.
static func side(p_name: String) -> BodySide:
	var words: PackedStringArray = _words(p_name)
	for word: String in words:
		if word in ["left", "l"]:
			return BodySide.LEFT
		if word in ["right", "r"]:
			return BodySide.RIGHT
	return BodySide.MIDDLE


## A name without side, namespace, prefix and punctuation, in small letters: "upleg".
static func core(p_name: String) -> String:
	var kept: PackedStringArray = []
	for word: String in _words(p_name):
		if not word in ["left", "l", "right", "r"] and not _PREFIXES.has(word):
			kept.append(word)
	return "".join(kept)


## How well a name fits a part: 0 is best, -1 does not fit.
static func rank(p_name: String, p_part: StringName) -> int:
	return PARTS[p_part].find(core(p_name))


## The words of a name: "mixamorig:LeftUpLeg" is mixamorig, left, up, leg; "lThigh" is l, thigh.
static func _words(p_name: String) -> PackedStringArray:
	var bare: String = p_name.get_slice(":", p_name.get_slice_count(":") - 1)
	var words: PackedStringArray = []
	var word: String = ""
	for i: int in bare.length():
		var letter: String = bare[i]
		var is_letter: bool = letter.to_lower() != letter.to_upper()
		var is_digit: bool = letter >= "0" and letter <= "9"
		var is_upper: bool = is_letter and letter == letter.to_upper()
		var after_lower: bool = i > 0 and bare[i - 1] != bare[i - 1].to_upper()
		# "LThigh": a capital followed by a small letter begins a word after another capital.
		var next_lower: bool = i + 1 < bare.length() and bare[i + 1] != bare[i + 1].to_upper()
		if not is_letter and not is_digit or is_upper and (after_lower or next_lower):
			if word != "":
				words.append(word.to_lower())
			word = ""
		if is_letter or is_digit:
			word += letter
	if word != "":
		words.append(word.to_lower())
	return words
