class_name EyeReader
extends CompositorEffect
## Reads where a bright target lies in both eyes' pictures, as the renderer has drawn them: what a
## headset shows cannot be read from its viewport.

const _SHADER: String = """#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D picture;
layout(set = 0, binding = 1, std430) buffer Sums { uint weight; uint across; uint down; } sums;
void main() {
	ivec2 at = ivec2(gl_GlobalInvocationID.xy);
	ivec2 size = textureSize(picture, 0);
	if (at.x >= size.x || at.y >= size.y) {
		return;
	}
	uint bright = uint(255.0 * clamp(texelFetch(picture, at, 0).r, 0.0, 1.0));
	if (bright > 8u) {
		atomicAdd(sums.weight, bright);
		atomicAdd(sums.across, bright * (2u * uint(at.x) + 1u));
		atomicAdd(sums.down, bright * (2u * uint(at.y) + 1u));
	}
}
"""

## Where the target is in each eye's picture, px from its upper left corner; NaN: nowhere.
var found: Array[Vector2] = [Vector2(NAN, NAN), Vector2(NAN, NAN)]
## Size of a picture, px.
var size: Vector2i = Vector2i.ZERO
## The frame that was read.
var frame: int = -1

# What the shader has added up of the picture that was read last: three whole numbers.
var _added: PackedInt32Array = []
var _device: RenderingDevice = null
var _shader: RID = RID()
var _pipeline: RID = RID()
var _sampler: RID = RID()
var _sums: RID = RID()


func _init(p_shader: String = _SHADER) -> void:
	effect_callback_type = EFFECT_CALLBACK_TYPE_POST_TRANSPARENT
	_device = RenderingServer.get_rendering_device()
	var source: RDShaderSource = RDShaderSource.new()
	source.source_compute = p_shader
	var code: RDShaderSPIRV = _device.shader_compile_spirv_from_source(source)
	_shader = _device.shader_create_from_spirv(code)
	_pipeline = _device.compute_pipeline_create(_shader)
	_sampler = _device.sampler_create(RDSamplerState.new())
	_sums = _device.storage_buffer_create(16)


func _render_callback(_type: int, p_data: RenderData) -> void:
	var buffers: RenderSceneBuffersRD = p_data.get_render_scene_buffers() as RenderSceneBuffersRD
	if buffers == null or buffers.get_view_count() < 2:
		return
	size = buffers.get_internal_size()
	for view: int in 2:
		found[view] = _read(buffers.get_color_layer(view))
	frame = Engine.get_process_frames()


func _read(p_picture: RID) -> Vector2:
	var nothing: PackedByteArray = []
	nothing.resize(16)
	_device.buffer_update(_sums, 0, 16, nothing)
	var picture: RDUniform = RDUniform.new()
	picture.uniform_type = RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE
	picture.binding = 0
	picture.add_id(_sampler)
	picture.add_id(p_picture)
	var sums: RDUniform = RDUniform.new()
	sums.uniform_type = RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER
	sums.binding = 1
	sums.add_id(_sums)
	var uniforms: RID = _device.uniform_set_create([picture, sums], _shader, 0)
	var list: int = _device.compute_list_begin()
	_device.compute_list_bind_compute_pipeline(list, _pipeline)
	_device.compute_list_bind_uniform_set(list, uniforms, 0)
	_device.compute_list_dispatch(list, (size.x + 7) / 8, (size.y + 7) / 8, 1)
	_device.compute_list_end()
	var bytes: PackedByteArray = _device.buffer_get_data(_sums)
	_device.free_rid(uniforms)
	_added = bytes.to_int32_array()
	var weight: float = bytes.decode_u32(0)
	if weight == 0.0:
		return Vector2(NAN, NAN)
	return Vector2(bytes.decode_u32(4), bytes.decode_u32(8)) / (2.0 * weight)
