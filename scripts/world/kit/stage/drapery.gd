class_name Drapery
extends RefCounted
## Hanging cloth: a sheet of a width and a height (m) in folds, around the middle of its foot, seen
## from +Z. A fold is a wave of its width; neighbours differ, the same on all machines.

## Points along a fold.
const PER_FOLD: int = 6
## Distance of points along the height, m.
const ROW_M: float = 1.25

## Points, normals and indices of the sheet, and its picture's coordinates from 0 to 1 from the
## upper left corner.
var points: PackedVector3Array = []
var normals: PackedVector3Array = []
var uvs: PackedVector2Array = []
var indices: PackedInt32Array = []
## Length of the cloth along its folds from the left, m, beside the height below its upper edge.
var lengths: PackedVector2Array = []

var _size: Vector2
var _fold: float
var _depth: float


func _init(p_size: Vector2, p_fold_m: float, p_depth_m: float) -> void:
	_size = p_size
	_fold = maxf(p_fold_m, 0.05)
	_depth = p_depth_m
	var columns: int = clampi(roundi(p_size.x / _fold * PER_FOLD), 2, 600)
	var rows: int = clampi(ceili(p_size.y / ROW_M), 1, 40)
	for column: int in columns + 1:
		_add_column(float(column) / columns, rows)
	for column: int in columns:
		for row: int in rows:
			var at: int = column * (rows + 1) + row
			var next: int = at + rows + 1
			indices.append_array([at, next, next + 1, at, next + 1, at + 1])


## Adds the sheet to a mesh, both sides of it.
func build(p_mesh: BlockMesh, p_layer: int, p_tint: int) -> void:
	p_mesh.surface(points, normals, lengths, indices, p_layer, p_tint)
	var behind: PackedVector3Array = []
	for normal: Vector3 in normals:
		behind.append(-normal)
	var other: PackedInt32Array = indices.duplicate()
	other.reverse()
	p_mesh.surface(points, behind, lengths, other, p_layer, p_tint)


func _add_column(p_share: float, p_rows: int) -> void:
	var x: float = (p_share - 0.5) * _size.x
	var length: float = p_share * _size.x * sqrt(1.0 + pow(_depth * 4.0 / _fold, 2.0))
	for row: int in p_rows + 1:
		var down: float = float(row) / p_rows
		var step: float = 0.01
		var z: float = _wave(x, down)
		var slope: float = (_wave(x + step, down) - _wave(x - step, down)) / (2.0 * step)
		points.append(Vector3(x, _size.y * (1.0 - down), z))
		normals.append(Vector3(-slope, 0.0, 1.0).normalized())
		uvs.append(Vector2(p_share, down))
		lengths.append(Vector2(length, down * _size.y))


## How far the cloth stands out at a position; folds open a little towards the foot.
func _wave(p_x: float, p_down: float) -> float:
	var turn: float = p_x / _fold * TAU
	var uneven: float = sin(p_x * 1.7 + 0.4) * 0.8 + sin(p_x * 0.61) * 1.3
	return sin(turn + uneven) * _depth * lerpf(0.75, 1.0, p_down)
