class_name ImpactMarks
extends RefCounted
## Marks that stay where shells and bullets hit the level and fade: one draw, a fixed number, of
## which the oldest give way.

## Most marks, and how long they last, s.
const MARKS: int = 160
const LASTING_S: float = 120.0
const _LOOK: Shader = preload("res://assets/shaders/impact_marks.gdshader")
const _CLOUDS: Texture2D = preload("res://assets/world/materials/clouds.png")

## How many have been made since the beginning.
var made: int = 0

var _marks: MultiMesh = MultiMesh.new()
var _material: ShaderMaterial = ShaderMaterial.new()
var _seconds: float = 0.0


## Adds what is drawn below [param p_parent].
func configure(p_parent: Node3D) -> void:
	var quad: PlaneMesh = PlaneMesh.new()
	quad.size = Vector2.ONE
	_marks.transform_format = MultiMesh.TRANSFORM_3D
	_marks.use_custom_data = true
	_marks.mesh = quad
	_marks.instance_count = MARKS
	_marks.visible_instance_count = 0
	_material.shader = _LOOK
	_material.set_shader_parameter(&"clouds", _CLOUDS)
	_material.set_shader_parameter(&"lasting", LASTING_S)
	var shown: MultiMeshInstance3D = MultiMeshInstance3D.new()
	shown.multimesh = _marks
	shown.material_override = _material
	shown.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	shown.top_level = true
	shown.custom_aabb = AABB(Vector3.ONE * -1e4, Vector3.ONE * 2e4)
	p_parent.add_child(shown)


## Time goes on.
func advance(p_delta: float) -> void:
	_seconds += p_delta
	if made > 0:
		_material.set_shader_parameter(&"now", _seconds)


## Leaves a mark at a position with a normal, in the world, so wide (m).
func make(p_place: Vector3, p_normal: Vector3, p_width: float) -> void:
	var mark: int = made % MARKS
	var at: Transform3D = Transform3D(upward(p_normal) * Basis(Vector3.UP, made * 2.4), p_place)
	at = at.scaled_local(Vector3.ONE * p_width)
	at.origin += p_normal * 0.015
	_marks.set_instance_transform(mark, at)
	_marks.set_instance_custom_data(mark, Color(_seconds, 0.9, fmod(made * 0.37, 1.0)))
	made += 1
	_marks.visible_instance_count = mini(made, MARKS)


## Axes whose +Y is a direction.
static func upward(p_normal: Vector3) -> Basis:
	var aside: Vector3 = Vector3.RIGHT if absf(p_normal.x) < 0.8 else Vector3.BACK
	var x: Vector3 = aside.slide(p_normal).normalized()
	return Basis(x, p_normal, x.cross(p_normal))
