class_name WarpMesh
extends RefCounted
## How a picture is bent for a projector on a curved screen: a mesh file, as Paul Bourke's warp
## meshes are (the form that planetariums and many calibration tools write).
##
## First line: the type, which is not used. Second: columns and rows. Then a line for each node, row
## by row: x (from minus to plus the window's width by height), y (-1 at the window's bottom to 1 at
## its top), u, v (0..1 from the picture's lower left), and an intensity; one below 0 is not drawn.

## Most nodes along a side.
const MAX_SIDE: int = 512
const _MAX_BYTES: int = 16 << 20
const _FIELDS: int = 5

## What is wrong: "FILE:LINE: ...", or empty.
var error: String = ""
## Nodes of a row.
var columns: int = 0
## Rows of nodes.
var rows: int = 0

var _x: PackedFloat32Array = []
var _y: PackedFloat32Array = []
var _places: PackedVector2Array = []
var _intensities: PackedFloat32Array = []
var _aspect: float = 1.0


## Reads a file.
static func read(p_path: String) -> WarpMesh:
	var found: WarpMesh = WarpMesh.new()
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null:
		var why: String = error_string(FileAccess.get_open_error())
		found.error = "the mesh %s cannot be read: %s" % [p_path, why]
	elif file.get_length() > _MAX_BYTES:
		found.error = "the mesh %s is too large: 16 MiB at most" % p_path
	else:
		found._parse(file.get_buffer(file.get_length()).get_string_from_utf8(), p_path)
	return found


## Reads a text; the path is for messages.
static func parse(p_text: String, p_path: String) -> WarpMesh:
	var found: WarpMesh = WarpMesh.new()
	found._parse(p_text, p_path)
	return found


## Gives its triangles to a picture, in a frame of a window, pixels.
func draw_on(p_picture: EyePicture, p_frame: Rect2i) -> void:
	var points: PackedVector2Array = []
	var colors: PackedColorArray = []
	var middle: Vector2 = Rect2(p_frame).get_center()
	var half: Vector2 = Vector2(p_frame.size) * 0.5
	for node: int in _x.size():
		points.append(middle + half * Vector2(_x[node] / _aspect, -_y[node]))
		var value: float = maxf(_intensities[node], 0.0)
		colors.append(Color(value, value, value))
	var indices: PackedInt32Array = []
	for row: int in rows - 1:
		for column: int in columns - 1:
			var at: int = row * columns + column
			var corners: PackedInt32Array = [at, at + 1, at + columns + 1, at + columns]
			if not Array(corners).any(_is_hidden):
				for corner: int in [0, 1, 2, 0, 2, 3]:
					indices.append(corners[corner])
	if not indices.is_empty():
		p_picture.draw_triangles(points, _places, indices, colors)


func _is_hidden(p_node: int) -> bool:
	return _intensities[p_node] < 0.0


func _parse(p_text: String, p_path: String) -> void:
	var lines: PackedStringArray = p_text.split("\n")
	var number: int = 0
	for raw: String in lines:
		number += 1
		var words: PackedStringArray = raw.replace("\t", " ").strip_edges().split(" ", false)
		if words.is_empty() or number == 1 and words.size() == 1:
			continue
		var fault: String = _take_size(words) if columns == 0 else _take_node(words)
		if fault != "":
			error = "%s:%d: %s" % [p_path, number, fault]
			return
	if columns == 0 or _x.size() != columns * rows:
		var text: String = "%s:%d: the mesh has %d nodes, its size asks for %d"
		error = text % [p_path, number, _x.size(), columns * rows]
		return
	_aspect = 0.0
	for x: float in _x:
		_aspect = maxf(_aspect, absf(x))
	if _aspect == 0.0:
		error = "%s:3: all nodes are in the middle: x goes from minus to plus the aspect" % p_path


func _take_size(p_words: PackedStringArray) -> String:
	if p_words.size() != 2 or not (p_words[0].is_valid_int() and p_words[1].is_valid_int()):
		return "the second line is the columns and rows of the mesh, such as 33 33"
	columns = p_words[0].to_int()
	rows = p_words[1].to_int()
	if mini(columns, rows) < 2 or maxi(columns, rows) > MAX_SIDE:
		columns = 0
		return "a mesh has 2 to %d columns and rows" % MAX_SIDE
	return ""


func _take_node(p_words: PackedStringArray) -> String:
	if p_words.size() != _FIELDS:
		return "a node is x y u v intensity, found %d words" % p_words.size()
	var values: PackedFloat32Array = []
	for word: String in p_words:
		if not word.is_valid_float() or not is_finite(word.to_float()):
			return "'%s' is no number" % ByteReader.clean(word).left(40)
		values.append(word.to_float())
	_x.append(values[0])
	_y.append(values[1])
	_places.append(Vector2(values[2], 1.0 - values[3]))
	_intensities.append(values[4])
	return ""
