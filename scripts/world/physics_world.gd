class_name PhysicsWorld
extends Node3D
## Draws the server's bodies as wire frames, exactly where the newest snapshot has them: no
## smoothing, no meshes of our own (thesis section 4.2.3).

## Colour of people's limbs.
const LIMBS: Color = Color(0.2, 1.0, 0.35)
## Colour of props.
const PROPS: Color = Color(1.0, 0.75, 0.2)
## Colour of what never moves.
const FIXED: Color = Color(0.35, 0.6, 1.0)

var _frames: Dictionary[int, Node3D] = {}


## Makes the wire frames of a world anew.
func describe(p_world: WorldDescription) -> void:
	for child: Node in get_children():
		child.queue_free()
	_frames.clear()
	for id: int in p_world.bodies:
		var body: WorldDescription.Body = p_world.bodies[id]
		var fixed: bool = body.actor == WorldDescription.FIXED
		var colour: Color = FIXED if fixed else (LIMBS if body.actor >= 0 else PROPS)
		var frame: Node3D = Node3D.new()
		frame.visible = fixed
		add_child(frame)
		_frames[id] = frame
		for entry: Array in body.shapes:
			frame.add_child(_make_wires(entry, colour))


## Moves a wire frame to where its body is.
func place(p_id: int, p_transform: Transform3D) -> void:
	var frame: Node3D = _frames.get(p_id)
	if frame != null:
		frame.transform = p_transform
		frame.visible = true


## Where a wire frame is, for tests and measurements.
func get_placed(p_id: int) -> Transform3D:
	return _frames[p_id].transform


static func _make_wires(p_entry: Array, p_colour: Color) -> MeshInstance3D:
	var material: StandardMaterial3D = StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.albedo_color = p_colour
	var wires: MeshInstance3D = MeshInstance3D.new()
	wires.mesh = _keep_lines(WorldDescription.make_shape(p_entry).get_debug_mesh())
	wires.material_override = material
	wires.transform = p_entry[2]
	wires.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	return wires


## The lines of a debug mesh, which fills its faces too.
static func _keep_lines(p_mesh: ArrayMesh) -> ArrayMesh:
	var lines: ArrayMesh = ArrayMesh.new()
	for surface: int in p_mesh.get_surface_count():
		if p_mesh.surface_get_primitive_type(surface) == Mesh.PRIMITIVE_LINES:
			var arrays: Array = p_mesh.surface_get_arrays(surface)
			lines.add_surface_from_arrays(Mesh.PRIMITIVE_LINES, arrays)
	return lines
