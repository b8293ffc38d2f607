class_name TrackView
extends RefCounted
## One side's track: links around its wheels, wheels and sprocket that turn with them, arms that
## follow the ground. From afar a strip with moving links painted on takes the links' place.

const _STRIP: Shader = preload("res://assets/shaders/track_strip.gdshader")
## Names of the sides' nodes in the model.
const _SIDES: Array[String] = ["L", "R"]
## Names of the wheels besides the sprocket, and how many there may be.
const _MAX_WHEELS: int = 12

## How far the track has run since it was shown first, m, forward positive.
var way: float = 0.0
## The wheels' lowest points at rest, in the vehicle's frame, from rear to front.
var feet: PackedVector3Array = []
## The links.
var belt: TrackBelt = TrackBelt.new()
## Whether it is drawn as a strip.
var is_strip: bool = false

var _layout: TrackLayout = null
var _wheels: Array[Transform3D] = []
var _arms: Array[Transform3D] = []
var _radius: float = 0.3
var _links: MultiMeshInstance3D = null
var _wheel_mesh: MultiMeshInstance3D = null
var _arm_mesh: MultiMeshInstance3D = null
var _strip: MeshInstance3D = null
var _strip_look: ShaderMaterial = null
var _turning: Array[Node3D] = []
var _turning_rest: Array[Basis] = []
var _turning_radius: PackedFloat32Array = []
var _numbers: PackedFloat32Array = []
var _arm_numbers: PackedFloat32Array = []


## Takes over a side's nodes of a model (0 left, 1 right) and adds what is drawn to [param p_hull].
func configure(p_model: Node3D, p_hull: Node3D, p_side: int, p_layout: TrackLayout) -> void:
	_layout = p_layout
	var side: String = _SIDES[p_side]
	var wheels: Array[MeshInstance3D] = _take(p_model, "Wheel_%s" % side)
	var arms: Array[MeshInstance3D] = _take(p_model, "Arm_%s" % side)
	var rollers: Array[MeshInstance3D] = _take(p_model, "Roller_%s" % side)
	wheels.reverse()
	arms.reverse()
	for wheel: MeshInstance3D in wheels:
		_wheels.append(wheel.transform)
	for arm: MeshInstance3D in arms:
		_arms.append(arm.transform)
	_radius = wheels[0].mesh.get_aabb().size.y / 2.0
	var sprocket: MeshInstance3D = p_model.find_child("Cog_%s" % side, true, false)
	var idler: MeshInstance3D = p_model.find_child("Idler_%s" % side, true, false)
	_add_turning(sprocket, p_layout.sprocket_radius())
	_add_turning(idler, _radius_of(idler) + p_layout.inner)
	_lay_out(sprocket, idler, rollers)
	for transform: Transform3D in _wheels:
		feet.append(transform.origin - Vector3(0.0, _radius + p_layout.inner + p_layout.outer, 0.0))
	var link: MeshInstance3D = p_model.find_child("TrackLink", true, false)
	_links = _add_copies(p_hull, link.mesh, belt.get_link_count())
	_wheel_mesh = _add_copies(p_hull, wheels[0].mesh, _wheels.size())
	_arm_mesh = _add_copies(p_hull, arms[0].mesh, _arms.size())
	_add_copies(p_hull, rollers[0].mesh, rollers.size(), rollers)
	_numbers.resize(_wheels.size() * 12)
	_arm_numbers.resize(_arms.size() * 12)
	_make_strip(p_hull, sprocket.position.x)
	for part: MeshInstance3D in wheels + arms + rollers:
		part.free()


## Shows it as a strip, or link by link.
func show_strip(p_is_strip: bool) -> void:
	is_strip = p_is_strip
	_links.visible = not is_strip
	_arm_mesh.visible = not is_strip
	_strip.visible = is_strip


## Runs on by a speed (m/s) for a time (s), with the wheels lifted by [param p_lifts], m, from rear
## to front.
func advance(p_speed: float, p_delta: float, p_lifts: PackedFloat32Array) -> void:
	way += p_speed * p_delta
	for index: int in _turning.size():
		var turn: float = -way / _turning_radius[index]
		_turning[index].basis = Basis(Vector3.RIGHT, fmod(turn, TAU)) * _turning_rest[index]
	if is_strip:
		_strip_look.set_shader_parameter(&"run", fposmod(way / _layout.pitch, 1000.0))
	else:
		belt.lay(way, p_lifts)
		belt.show(_links.multimesh.get_rid())
		_place_arms(p_lifts)
	_place_wheels(p_lifts)


## How far the sprocket has turned, rad, forward positive.
func sprocket_angle() -> float:
	return belt.get_sprocket_angle(way)


func _place_wheels(p_lifts: PackedFloat32Array) -> void:
	var turned: Basis = Basis(Vector3.RIGHT, fmod(-way / (_radius + _layout.inner), TAU))
	var basis: Basis = turned * _wheels[0].basis
	for wheel: int in _wheels.size():
		var place: Vector3 = _wheels[wheel].origin
		place.y += p_lifts[wheel]
		_write(_numbers, wheel * 12, basis, place)
	RenderingServer.multimesh_set_buffer(_wheel_mesh.multimesh.get_rid(), _numbers)


func _place_arms(p_lifts: PackedFloat32Array) -> void:
	var reach: float = _layout.arm.length()
	var rest: float = asin(-_layout.arm.y / reach)
	for arm: int in _arms.size():
		var drop: float = clampf((-_layout.arm.y - p_lifts[arm]) / reach, -1.0, 1.0)
		var basis: Basis = Basis(Vector3.RIGHT, asin(drop) - rest)
		_write(_arm_numbers, arm * 12, basis, _arms[arm].origin)
	RenderingServer.multimesh_set_buffer(_arm_mesh.multimesh.get_rid(), _arm_numbers)


static func _write(
	r_numbers: PackedFloat32Array, p_at: int, p_basis: Basis, p_place: Vector3
) -> void:
	r_numbers[p_at] = p_basis.x.x
	r_numbers[p_at + 1] = p_basis.y.x
	r_numbers[p_at + 2] = p_basis.z.x
	r_numbers[p_at + 3] = p_place.x
	r_numbers[p_at + 4] = p_basis.x.y
	r_numbers[p_at + 5] = p_basis.y.y
	r_numbers[p_at + 6] = p_basis.z.y
	r_numbers[p_at + 7] = p_place.y
	r_numbers[p_at + 8] = p_basis.x.z
	r_numbers[p_at + 9] = p_basis.y.z
	r_numbers[p_at + 10] = p_basis.z.z
	r_numbers[p_at + 11] = p_place.z


## The wheels around which the belt runs: sprocket, road wheels from the rear, idler, rollers.
func _lay_out(
	p_sprocket: MeshInstance3D, p_idler: MeshInstance3D, p_rollers: Array[MeshInstance3D]
) -> void:
	var around: PackedVector3Array = []
	around.append(_seat(p_sprocket.position, _layout.sprocket_radius()))
	for transform: Transform3D in _wheels:
		around.append(_seat(transform.origin, _radius + _layout.inner))
	around.append(_seat(p_idler.position, _radius_of(p_idler) + _layout.inner))
	for roller: MeshInstance3D in p_rollers:
		around.append(_seat(roller.position, _radius_of(roller) + _layout.inner))
	belt.configure(around, 1 + _wheels.size(), 0, _layout.pitch, p_sprocket.position.x)


static func _seat(p_place: Vector3, p_radius: float) -> Vector3:
	return Vector3(p_place.z, p_place.y, p_radius)


static func _radius_of(p_part: MeshInstance3D) -> float:
	return p_part.mesh.get_aabb().size.y / 2.0


func _add_turning(p_part: Node3D, p_radius: float) -> void:
	_turning.append(p_part)
	_turning_rest.append(p_part.basis)
	_turning_radius.append(p_radius)


static func _take(p_model: Node3D, p_prefix: String) -> Array[MeshInstance3D]:
	var found: Array[MeshInstance3D] = []
	for number: int in _MAX_WHEELS:
		var part: Node = p_model.find_child(p_prefix + str(number + 1), true, false)
		if part != null:
			found.append(part as MeshInstance3D)
	return found


static func _add_copies(
	p_hull: Node3D, p_mesh: Mesh, p_count: int, p_where: Array[MeshInstance3D] = []
) -> MultiMeshInstance3D:
	var copies: MultiMesh = MultiMesh.new()
	copies.transform_format = MultiMesh.TRANSFORM_3D
	copies.mesh = p_mesh
	copies.instance_count = p_count
	for index: int in p_where.size():
		copies.set_instance_transform(index, p_where[index].transform)
	var shown: MultiMeshInstance3D = MultiMeshInstance3D.new()
	shown.multimesh = copies
	shown.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	shown.custom_aabb = AABB(Vector3(-2.0, -0.5, -4.5), Vector3(4.0, 2.0, 9.0))
	p_hull.add_child(shown)
	return shown


func _make_strip(p_hull: Node3D, p_x: float) -> void:
	var outline: PackedVector2Array = belt.get_outline()
	var tool: SurfaceTool = SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for index: int in outline.size() + 1:
		var here: Vector2 = outline[index % outline.size()]
		var next: Vector2 = outline[(index + 1) % outline.size()]
		var along: Vector2 = (next - here).normalized()
		for edge: int in 2:
			tool.set_uv(Vector2(edge, index))
			tool.set_normal(Vector3(0.0, along.x, -along.y))
			var x: float = p_x + (edge - 0.5) * _layout.width
			tool.add_vertex(
				Vector3(x, here.y + along.x * _layout.outer * 0.5, here.x - along.y * 0.02)
			)
	for index: int in outline.size():
		var first: int = index * 2
		for corner: int in [0, 1, 2, 1, 3, 2]:
			tool.add_index(first + corner)
	_strip_look = ShaderMaterial.new()
	_strip_look.shader = _STRIP
	_strip = MeshInstance3D.new()
	_strip.mesh = tool.commit()
	_strip.material_override = _strip_look
	_strip.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	_strip.visible = false
	p_hull.add_child(_strip)
