class_name BvhOptions
extends RefCounted
## How to read a BVH file: what the file itself does not say, and limits against hostile files.

## Which axis of the file points up.
enum UpAxis {
	## Let [BvhGuess] look at the skeleton and its motion.
	GUESS,
	## The file's Y axis points up, as in most files.
	Y,
	## The file's Z axis points up, as Blender and 3ds Max can write.
	Z,
	## The file's X axis points up.
	X,
	## The file's Y axis points down, as in pictures of cameras.
	Y_DOWN,
	## The file's Z axis points down.
	Z_DOWN,
	## The file's X axis points down.
	X_DOWN,
}

## Metres of one unit of the files made from Carnegie Mellon's library: 1/0.45 inch.
const CMU_UNIT: float = 0.0254 / 0.45
## Names of units, and their length in m.
const UNITS: Dictionary[String, float] = {
	"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254, "cmu": CMU_UNIT, "dm": 0.1, "foot": 0.3048
}
## Long names of the units in [constant UNITS].
const UNIT_NAMES: Dictionary[String, String] = {
	"m": "metre",
	"cm": "centimetre",
	"mm": "millimetre",
	"inch": "inch",
	"cmu": "CMU",
	"dm": "decimetre",
	"foot": "foot"
}
## Names of the axes that can point up, and the axes.
const AXES: Dictionary[String, UpAxis] = {
	"y": UpAxis.Y,
	"z": UpAxis.Z,
	"x": UpAxis.X,
	"-y": UpAxis.Y_DOWN,
	"-z": UpAxis.Z_DOWN,
	"-x": UpAxis.X_DOWN,
}
## How each axis is turned up.
const FRAMES: Dictionary[UpAxis, SourceFrames.Frame] = {
	UpAxis.GUESS: SourceFrames.Frame.GODOT,
	UpAxis.Y: SourceFrames.Frame.GODOT,
	UpAxis.Z: SourceFrames.Frame.BVH_Z_UP,
	UpAxis.X: SourceFrames.Frame.BVH_X_UP,
	UpAxis.Y_DOWN: SourceFrames.Frame.BVH_Y_DOWN,
	UpAxis.Z_DOWN: SourceFrames.Frame.BVH_Z_DOWN,
	UpAxis.X_DOWN: SourceFrames.Frame.BVH_X_DOWN,
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


## The unit called [param p_text]: one of [constant UNITS] or a number of metres. Returns m, or 0 if
## there is no such unit.
static func parse_unit(p_text: String) -> float:
	var text: String = p_text.to_lower()
	if UNITS.has(text):
		return UNITS[text]
	if not BvhText.is_number(text):
		return 0.0
	var metres: float = text.to_float()
	return metres if metres >= 1e-6 and metres <= 1e6 else 0.0


## The axis called [param p_text], or [constant GUESS] if there is no such axis.
static func parse_axis(p_text: String) -> UpAxis:
	return AXES.get(p_text.to_lower(), UpAxis.GUESS)


## What an axis is called: "Z", or "-Y" if Y points down.
static func axis_name(p_axis: UpAxis) -> String:
	var found: Variant = AXES.find_key(p_axis)
	return "?" if found == null else (found as String).to_upper()


## What a unit of that many metres is called: "centimetre", or "0.3 m".
static func unit_name(p_metres: float) -> String:
	for unit: String in UNITS:
		if is_equal_approx(UNITS[unit], p_metres):
			return UNIT_NAMES[unit]
	return "%s m" % String.num(p_metres, 6)
