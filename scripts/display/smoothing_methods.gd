class_name SmoothingMethods
extends RefCounted
## What the option --smoothing can be: the methods of [SnapshotSmoother] by name.

## The methods.
const BY_NAME: Dictionary[String, SnapshotSmoother.Method] = {
	"none": SnapshotSmoother.NONE,
	"linear": SnapshotSmoother.LINEAR,
	"hermite": SnapshotSmoother.HERMITE,
	"extrapolate_lerp": SnapshotSmoother.EXTRAPOLATE_LERP,
	"error_offset": SnapshotSmoother.ERROR_OFFSET,
	"adaptive_low_delay": SnapshotSmoother.ADAPTIVE_LOW_DELAY,
}


## Why there is no such method, or an empty text. The empty name is the default's.
static func find_fault(p_name: String) -> String:
	if p_name == "" or BY_NAME.has(p_name):
		return ""
	return "--smoothing is one of %s, found '%s'" % [", ".join(BY_NAME.keys()), p_name]


## The method of a name; the default for an empty or unknown one.
static func find(p_name: String) -> SnapshotSmoother.Method:
	return BY_NAME.get(p_name, SnapshotSmoother.ADAPTIVE_LOW_DELAY)
