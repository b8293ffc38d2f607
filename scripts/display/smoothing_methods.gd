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


## The method of a name; the default for an empty or unknown one.
static func find(p_name: String) -> SnapshotSmoother.Method:
	return BY_NAME.get(p_name, SnapshotSmoother.ADAPTIVE_LOW_DELAY)
