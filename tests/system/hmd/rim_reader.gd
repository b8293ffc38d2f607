class_name RimReader
extends EyeReader
## Reads how bright both eyes' pictures are in their middle and at their rim.

const _RIM: String = """#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D picture;
layout(set = 0, binding = 1, std430) buffer Sums { uint weight; uint centre; uint rim; } sums;
void main() {
	ivec2 at = ivec2(gl_GlobalInvocationID.xy);
	ivec2 size = textureSize(picture, 0);
	if (at.x >= size.x || at.y >= size.y) {
		return;
	}
	uint bright = uint(255.0 * clamp(texelFetch(picture, at, 0).r, 0.0, 1.0));
	vec2 off = abs((vec2(at) + 0.5) / vec2(size) - 0.5);
	sums.weight = 1u;
	if (max(off.x, off.y) < 0.05) {
		atomicAdd(sums.centre, bright);
	} else if (max(off.x, off.y) > 0.45) {
		atomicAdd(sums.rim, bright);
	}
}
"""

## Of each eye: "centre" and "rim", sums of brightness.
var bright: Array[Dictionary] = [{}, {}]


func _init() -> void:
	super(_RIM)


func _read(p_picture: RID) -> Vector2:
	super(p_picture)
	bright.append({"centre": _added[1], "rim": _added[2]})
	bright.pop_front()
	return Vector2.ZERO
