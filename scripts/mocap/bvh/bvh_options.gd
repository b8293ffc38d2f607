class_name BvhOptions
extends RefCounted
## How to read a BVH file: what the file itself does not say, and limits against hostile files.

## Which axis of the file points up.
enum UpAxis {
	## Let [BvhGuess] look at the skeleton.
	GUESS,
	## The file's Y axis points up, as in most files.
	Y,
	## The file's Z axis points up, as Blender and 3ds Max can write.
	Z,
}

## Metres of one unit of the files made from Carnegie Mellon's library: 1/0.45 inch.
const CMU_UNIT: float = 0.0254 / 0.45
## Names of units, and their length in m.
const UNITS: Dictionary[String, float] = {
	"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254, "cmu": CMU_UNIT
}
## Long names of the units in [constant UNITS].
const UNIT_NAMES: Dictionary[String, String] = {
	"m": "metre", "cm": "centimetre", "mm": "millimetre", "inch": "inch", "cmu": "CMU"
}

## Length of the file's unit, m; 0 to guess it from the size of the skeleton.
var unit_metres: float = 0.0
## The file's axis that points up.
var up_axis: UpAxis = UpAxis.GUESS
## Whether position channels of joints are counted from the joint's OFFSET. Without it they replace
## the OFFSET, as in Blender and Assimp; the few files that need this have all people twice the
## size, or their hips a leg too high.
var positions_add_offset: bool = false
## Largest file, bytes.
var max_bytes: int = 256 * 1024 * 1024
## Maximum of joints, counting end sites.
var max_joints: int = 2048
## Maximum depth of joints.
var max_depth: int = 256


## The unit called [param p_text]: m, cm, mm, inch, cmu or a number of metres. Returns m, or 0 if
## there is no such unit.
static func parse_unit(p_text: String) -> float:
	var text: String = p_text.to_lower()
	if UNITS.has(text):
		return UNITS[text]
	if not BvhText.is_number(text):
		return 0.0
	var metres: float = text.to_float()
	return metres if metres >= 1e-6 and metres <= 1e6 else 0.0


## What a unit of that many metres is called: "centimetre", or "0.3 m".
static func unit_name(p_metres: float) -> String:
	for unit: String in UNITS:
		if is_equal_approx(UNITS[unit], p_metres):
			return UNIT_NAMES[unit]
	return "%s m" % String.num(p_metres, 6)
