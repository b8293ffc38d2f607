class_name SensorBoxesView
extends Node3D
## The sensors' own orientations: boxes with their axes (X red, Y green, Z blue, as Xsens has
## them: X and Y level, Z up), where they are worn by somebody in the reset pose.

## Colours of the boxes: sensors that are in the last frame, and silent ones.
const SPEAKS: Color = Color(0.95, 0.75, 0.25)
const SILENT: Color = Color(0.35, 0.35, 0.38)

# Xsens' X, Y, Z in Godot's axes (SourceFrames), and their colours.
const _AXES: Array[Vector3] = [Vector3.BACK, Vector3.RIGHT, Vector3.UP]
const _COLORS: Array[Color] = [Color(0.95, 0.3, 0.3), Color(0.4, 0.85, 0.4), Color(0.4, 0.55, 1.0)]
const _LENGTH_M: float = 0.11

var _sensors: Array[Node3D] = []
var _looks: Array[StandardMaterial3D] = []


func _init() -> void:
	for color: Color in [SILENT, SPEAKS]:
		_looks.append(_look(color))


## Shows a frame of sensors that are on mounts (-1: beside the person) of somebody of a size.
func show_frame(p_frame: SensorFrame, p_mounts: PackedInt32Array, p_size: BodySize) -> void:
	while _sensors.size() < p_frame.count():
		_sensors.append(_make_sensor())
		add_child(_sensors[_sensors.size() - 1])
	var bases: PackedVector3Array = p_size.joints()
	var tails: PackedVector3Array = p_size.tails()
	var beside: int = 0
	for sensor: int in _sensors.size():
		_sensors[sensor].visible = sensor < p_frame.count()
		if sensor >= p_frame.count():
			continue
		var mount: int = p_mounts[sensor] if sensor < p_mounts.size() else -1
		var at: Vector3 = Vector3(-0.9 + 0.15 * beside, 0.1, 0.6)
		if mount >= 0:
			var limb: int = BodyMounts.LIMBS[mount]
			at = (bases[limb] + tails[limb]) / 2.0
			if mount == 3 or mount == 7:
				at = bases[limb].lerp(bases[4 if mount == 3 else 7], 0.6) + Vector3(0, 0.1, 0)
		else:
			beside += 1
		var speaks: bool = p_frame.present[sensor] != 0
		_sensors[sensor].position = at
		if speaks:
			_sensors[sensor].quaternion = p_frame.orientation(sensor).normalized()
		var box: MeshInstance3D = _sensors[sensor].get_child(0)
		box.material_override = _looks[1 if speaks else 0]


static func _make_sensor() -> Node3D:
	var sensor: Node3D = Node3D.new()
	sensor.add_child(_make_box(Vector3(0.045, 0.025, 0.06), Vector3.ZERO, null))
	for axis: int in 3:
		var along: Vector3 = _AXES[axis]
		var size: Vector3 = Vector3.ONE * 0.012 + along * _LENGTH_M
		sensor.add_child(_make_box(size, along * _LENGTH_M / 2.0, _look(_COLORS[axis])))
	return sensor


static func _make_box(p_size: Vector3, p_at: Vector3, p_look: Material) -> MeshInstance3D:
	var box: MeshInstance3D = MeshInstance3D.new()
	var mesh: BoxMesh = BoxMesh.new()
	mesh.size = p_size
	mesh.material = p_look
	box.mesh = mesh
	box.position = p_at
	return box


static func _look(p_color: Color) -> StandardMaterial3D:
	var look: StandardMaterial3D = StandardMaterial3D.new()
	look.albedo_color = p_color
	return look
