class_name JointNames
extends RefCounted
## Recognises what the joints of somebody's skeleton are by their names, whatever the naming scheme.
##
## A name is cut into words; words that say the side are taken out, also where they are written
## together with a part ("lshoulder", "rhip", "handl"). Words that most joints of the skeleton share
## ("Character1", "Robot", a number at the end of each) and a few usual ones ("jnt", "def") say
## nothing. What is left is the [method core], which [constant PARTS] knows.

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
	&"UpperLeg":
	[
		"upleg",
		"upperleg",
		"thigh",
		"thighbend",
		"uleg",
		"femur",
		"hip",
		"leg1",
		"bigleg",
		"leg",
		"足",
	],
	&"LowerLeg":
	[
		"lowleg",
		"lowerleg",
		"shin",
		"shinbend",
		"calf",
		"shank",
		"knee",
		"tibia",
		"leg",
		"leg2",
		"ひざ",
		"膝",
	],
	&"Foot": ["foot", "ankle", "feet", "足首"],
	&"UpperArm":
	[
		"arm",
		"upperarm",
		"uparm",
		"uarm",
		"shldr",
		"shldrbend",
		"humerus",
		"bicep",
		"arm1",
		"shoulder",
		"腕",
	],
	&"LowerArm":
	[
		"forearm",
		"lowarm",
		"lowerarm",
		"farm",
		"forearmbend",
		"elbow",
		"radius",
		"ulna",
		"arm2",
		"ひじ",
		"肘",
	],
	&"Hand": ["hand", "wrist", "手首", "手"],
	&"Shoulder": ["collar", "clavicle", "shoulder", "scapula", "collarbone", "肩"],
	&"Neck": ["neck", "neck1", "lowerneck", "neck0", "neck01", "首"],
	&"Head": ["head", "skull", "頭"],
	&"Toes": ["toebase", "toe", "toes", "ball", "toe0", "foottoe", "つま先"],
}

const _LEFT: PackedStringArray = [
	"left",
	"l",
	"lft",
	"lt",
	"links",
	"linke",
	"linker",
	"gauche",
	"izq",
	"izquierda",
	"izquierdo",
	"sinistra",
	"sinistro",
	"esquerda",
	"esquerdo",
	"лев",
	"левая",
	"левое",
	"левый",
]
const _RIGHT: PackedStringArray = [
	"right",
	"r",
	"rght",
	"rgt",
	"rt",
	"rechts",
	"rechte",
	"rechter",
	"droite",
	"droit",
	"derecha",
	"derecho",
	"destra",
	"destro",
	"direita",
	"direito",
	"прав",
	"правая",
	"правое",
	"правый",
]
## How a side is written together with a part, longest first.
const _JOINED: Dictionary[String, BodySide] = {
	"left": BodySide.LEFT,
	"right": BodySide.RIGHT,
	"左": BodySide.LEFT,
	"右": BodySide.RIGHT,
	"l": BodySide.LEFT,
	"r": BodySide.RIGHT,
}
## Words that say nothing about a joint.
const _EMPTY: PackedStringArray = [
	"mixamorig",
	"bip01",
	"bip001",
	"bip",
	"valvebiped",
	"def",
	"org",
	"jbip",
	"j",
	"c",
	"b",
	"m",
	"bn",
	"jnt",
	"joint",
	"bone",
	"bind",
	"sk",
	"skel",
	"rig",
]
## From this share of a skeleton's joints on, a word that they begin with, and one that they end
## with, says nothing. Helpers often have names of their own.
const _SHARED_FIRST: float = 0.4
const _SHARED_LAST: float = 0.7
## A skeleton of fewer joints has no words that are counted as shared.
const _MIN_NAMES: int = 8

var _sides: Array[BodySide] = []
var _cores: PackedStringArray = PackedStringArray()


## Reads the names of all joints of a skeleton; an empty one (of an end site) stays without a part.
func _init(p_names: PackedStringArray) -> void:
	var all: Array[PackedStringArray] = []
	for joint_name: String in p_names:
		all.append(_words(joint_name))
	_drop_shared(all)
	for words: PackedStringArray in all:
		_read(words)


## The side that a joint's name says.
func side(p_joint: int) -> BodySide:
	return _sides[p_joint]


## A joint's name without side, namespace, prefix and punctuation, in small letters: "upleg".
func core(p_joint: int) -> String:
	return _cores[p_joint]


## How well a joint's name fits a part: 0 is best, -1 does not fit.
func rank(p_joint: int, p_part: StringName) -> int:
	return _rank(_cores[p_joint], p_part)


## A number at the end counts as none if it is 0 or 1, the first of several: "upperleg01".
static func _rank(p_core: String, p_part: StringName) -> int:
	var names: Array = PARTS[p_part]
	var exact: int = names.find(p_core)
	if exact >= 0:
		return exact
	var bare: String = p_core.rstrip("0123456789")
	if bare.length() == p_core.length() or bare == "":
		return -1
	var number: int = p_core.substr(bare.length()).to_int()
	var numbered: int = names.find(bare + str(number))
	if numbered >= 0:
		return numbered
	return names.find(bare) if number <= 1 else -1


static func _is_part(p_text: String) -> bool:
	for part: StringName in PARTS:
		if _rank(p_text, part) >= 0:
			return true
	return false


func _read(p_words: PackedStringArray) -> void:
	var found: BodySide = BodySide.MIDDLE
	var kept: PackedStringArray = []
	for word: String in p_words:
		if word in _LEFT:
			found = BodySide.LEFT if found == BodySide.MIDDLE else found
		elif word in _RIGHT:
			found = BodySide.RIGHT if found == BodySide.MIDDLE else found
		elif not word in _EMPTY:
			kept.append(word)
	var text: String = "".join(kept)
	if found == BodySide.MIDDLE and not _is_part(text):
		for joined: String in _JOINED:
			var rest: String = text
			if text.begins_with(joined):
				rest = text.trim_prefix(joined)
			elif text.ends_with(joined):
				rest = text.trim_suffix(joined)
			if rest != text and _is_part(rest):
				found = _JOINED[joined]
				text = rest
				break
	_sides.append(found)
	_cores.append(text)


## Takes out the words that most names begin with, and numbers that most of them end or begin with.
static func _drop_shared(p_all: Array[PackedStringArray]) -> void:
	for at: int in [0, 0, 0, -1, -1]:
		var counts: Dictionary[String, int] = {}
		var names: int = 0
		for words: PackedStringArray in p_all:
			names += 1 if not words.is_empty() else 0
			# The last word that is left is the joint's own.
			if words.size() > 1:
				var word: String = _shared_form(words[at])
				counts[word] = counts.get(word, 0) + 1
		for word: String in counts:
			var share: float = _SHARED_FIRST if at == 0 else _SHARED_LAST
			var is_common: bool = counts[word] >= share * names and names >= _MIN_NAMES
			if is_common and not word in _LEFT and not word in _RIGHT and not _is_part(word):
				_drop(p_all, at, word)


## Numbers count as one word, as a running number differs from joint to joint.
static func _shared_form(p_word: String) -> String:
	return "0" if p_word.is_valid_int() else p_word


static func _drop(p_all: Array[PackedStringArray], p_at: int, p_word: String) -> void:
	for i: int in p_all.size():
		if p_all[i].size() > 1 and _shared_form(p_all[i][p_at]) == p_word:
			p_all[i].remove_at(p_at if p_at >= 0 else p_all[i].size() - 1)


## The words of a name: "mixamorig:LeftUpLeg" is left, up, leg; "lThigh" is l, thigh.
static func _words(p_name: String) -> PackedStringArray:
	var bare: String = p_name.get_slice(":", p_name.get_slice_count(":") - 1)
	bare = bare.get_slice("|", bare.get_slice_count("|") - 1)
	var words: PackedStringArray = []
	var word: String = ""
	for i: int in bare.length():
		var letter: String = bare[i]
		# Scripts without capitals have letters too, all of them far beyond ASCII.
		var is_letter: bool = letter.to_lower() != letter.to_upper() or letter.unicode_at(0) > 0xFF
		var is_digit: bool = letter >= "0" and letter <= "9"
		var is_upper: bool = is_letter and letter != letter.to_lower()
		var after_lower: bool = i > 0 and bare[i - 1] != bare[i - 1].to_upper()
		# "LThigh": a capital followed by a small letter begins a word after another capital.
		var next_lower: bool = i + 1 < bare.length() and bare[i + 1] != bare[i + 1].to_upper()
		if not is_letter and not is_digit or is_upper and (after_lower or next_lower):
			if word != "":
				words.append(_plain(word))
			word = ""
		if is_letter or is_digit:
			word += letter
	if word != "":
		words.append(_plain(word))
	return words


## "Lf" is left; "LF" before "Arm" is a left forearm.
static func _plain(p_word: String) -> String:
	return "left" if p_word == "Lf" else p_word.to_lower()
