class_name StickFigureView
extends Node3D
## A person of boxes, one for each limb.

## Colours: limbs that are measured, those that are filled, and those with a fault.
const MEASURED: Color = Color(0.85, 0.88, 0.92)
const FILLED: Color = Color(0.45, 0.5, 0.6)
const TROUBLE: Color = Color(1.0, 0.6, 0.15)

# Width and depth of each limb's box, m.
const _THICK: Array[Vector2] = [
	Vector2(0.3, 0.18),
	Vector2(0.26, 0.16),
	Vector2(0.34, 0.2),
	Vector2(0.17, 0.2),
	Vector2(0.09, 0.09),
	Vector2(0.08, 0.07),
	Vector2(0.09, 0.04),
	Vector2(0.09, 0.09),
	Vector2(0.08, 0.07),
	Vector2(0.09, 0.04),
	Vector2(0.15, 0.15),
	Vector2(0.11, 0.11),
	Vector2(0.09, 0.07),
	Vector2(0.15, 0.15),
	Vector2(0.11, 0.11),
	Vector2(0.09, 0.07),
]

var _boxes: Array[MeshInstance3D] = []
var _figure: BodySegments = null
var _size: BodySize = null
var _looks: Array[StandardMaterial3D] = []


func _init() -> void:
	for color: Color in [FILLED, MEASURED, TROUBLE]:
		var look: StandardMaterial3D = StandardMaterial3D.new()
		look.albedo_color = color
		_looks.append(look)
	for limb: int in Limbs.COUNT:
		var box: MeshInstance3D = MeshInstance3D.new()
		box.mesh = BoxMesh.new()
		_boxes.append(box)
		add_child(box)


## Shows a pose of somebody of a size; limbs in [param p_trouble] stand out.
func show_pose(p_pose: PoseSample, p_size: BodySize, p_trouble: PackedInt32Array) -> void:
	if _size != p_size:
		_size = p_size
		_figure = BodySegments.new(p_size)
	_figure.solve(p_pose)
	for limb: int in Limbs.COUNT:
		var rest: Vector3 = _figure.rest_tail(limb) - _figure.rest_base(limb)
		var box: BoxMesh = _boxes[limb].mesh
		box.size = Vector3(_THICK[limb].x, maxf(rest.length(), 0.05), _THICK[limb].y)
		# The box's Y goes along the limb, its X and Z stay as they are in the reset pose.
		var stand: Quaternion = Quaternion(Vector3.UP, rest.normalized())
		if rest.normalized().dot(Vector3.UP) < -0.999:
			stand = Quaternion(Vector3.BACK, PI)
		var middle: Vector3 = (_figure.bases[limb] + _figure.tails[limb]) / 2.0
		var turn: Quaternion = p_pose.orientation(limb) * stand
		_boxes[limb].transform = Transform3D(Basis(turn), middle)
		var measured: bool = p_pose.details == null or p_pose.details.measured.is_empty()
		measured = measured or p_pose.details.measured[limb] != 0
		var look: int = 2 if p_trouble.has(limb) else 1 if measured else 0
		_boxes[limb].material_override = _looks[look]
