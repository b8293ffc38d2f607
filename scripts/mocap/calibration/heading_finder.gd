class_name HeadingFinder
extends RefCounted
## Finds sensors that turned the other way round than the others.

## Headings that differ by more than this are reversed, rad.
const REVERSED_RAD: float = 2.4
## Headings that differ by less agree, rad.
const AGREE_RAD: float = 0.5


## Mounts whose heading (rad, by mount) points the other way round than that of most others, all
## of which agree: their sensors are on the other side, or on the other end of a joint. Empty if
## that is not clear.
static func reversed(p_headings: Dictionary[int, float]) -> PackedInt32Array:
	var most: float = NorthFinder.middle(p_headings.values())
	var odd: PackedInt32Array = []
	for mount: int in p_headings:
		var off: float = absf(angle_difference(most, p_headings[mount]))
		if off > REVERSED_RAD:
			odd.append(mount)
		elif off > AGREE_RAD:
			return PackedInt32Array()
	odd.sort()
	return odd if odd.size() * 2 < p_headings.size() else PackedInt32Array()
