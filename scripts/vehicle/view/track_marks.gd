class_name TrackMarks
extends RefCounted
## Prints that stay in soft ground behind a vehicle and fade: one draw, a fixed number of pieces, of
## which the oldest give way.

## Pieces of both sides together, and the length of one, m.
const PIECES: int = 320
const PIECE_M: float = 0.6
## How long they last, s.
const LASTING_S: float = 90.0
const _LOOK: Shader = preload("res://assets/shaders/track_marks.gdshader")
## Gap beyond which the next print begins anew, m: the vehicle has jumped.
const _GAP_M: float = 2.0

## How many pieces have been laid since the beginning.
var laid: int = 0

var _pieces: MultiMesh = null
var _shown: MultiMeshInstance3D = null
var _material: ShaderMaterial = null
var _last: PackedVector3Array = [Vector3.INF, Vector3.INF]
var _seconds: float = 0.0
var _width: float = 0.6


## Adds what is drawn below [param p_parent]; [param p_pitch] is from pad to pad, m, 0 for tyres.
func configure(p_parent: Node3D, p_width: float, p_pitch: float) -> void:
	_width = p_width
	_pieces = MultiMesh.new()
	_pieces.transform_format = MultiMesh.TRANSFORM_3D
	_pieces.use_custom_data = true
	_pieces.mesh = _make_piece()
	_pieces.instance_count = PIECES
	_pieces.visible_instance_count = 0
	_material = ShaderMaterial.new()
	_material.shader = _LOOK
	_material.set_shader_parameter(&"lasting", LASTING_S)
	_material.set_shader_parameter(&"pitch", p_pitch)
	_shown = MultiMeshInstance3D.new()
	_shown.multimesh = _pieces
	_shown.material_override = _material
	_shown.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	_shown.top_level = true
	_shown.custom_aabb = AABB(Vector3.ONE * -1e4, Vector3.ONE * 2e4)
	p_parent.add_child(_shown)


## Time goes on.
func advance(p_delta: float) -> void:
	_seconds += p_delta
	if laid > 0:
		_material.set_shader_parameter(&"now", _seconds)


## A side's track lies on the ground at [param p_place], which faces [param p_normal]; it has run
## [param p_way], m, and sinks in by [param p_depth], 0 to 1.
func press(p_side: int, p_place: Vector3, p_normal: Vector3, p_way: float, p_depth: float) -> void:
	var last: Vector3 = _last[p_side]
	if p_depth <= 0.0:
		_last[p_side] = Vector3.INF
		return
	if not last.is_finite() or last.distance_to(p_place) > _GAP_M:
		_last[p_side] = p_place
		return
	var along: Vector3 = p_place - last
	if along.length() < PIECE_M:
		return
	_last[p_side] = p_place
	var across: Vector3 = along.cross(p_normal).normalized()
	var up: Vector3 = across.cross(along).normalized()
	var basis: Basis = Basis(across * _width, up, along * 1.02)
	var piece: int = laid % PIECES
	_pieces.set_instance_transform(piece, Transform3D(basis, last + up * 0.03))
	_pieces.set_instance_custom_data(
		piece, Color(_seconds, p_depth, fmod(absf(p_way), 100.0), along.length())
	)
	laid += 1
	_pieces.visible_instance_count = mini(laid, PIECES)


## What is laid: a square metre along +Z, upwards.
static func _make_piece() -> ArrayMesh:
	var tool: SurfaceTool = SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for row: int in 2:
		for column: int in 2:
			tool.set_uv(Vector2(column, row))
			tool.set_normal(Vector3.UP)
			tool.add_vertex(Vector3(column - 0.5, 0.0, row))
	for corner: int in [0, 2, 1, 1, 2, 3]:
		tool.add_index(corner)
	return tool.commit()
