class_name WebcamView
extends Control
## The picture of a webcam, with the skeletons that are seen in it; hidden while there is none.

## Colours of a landmark that is seen well, and of one that is guessed.
const SEEN: Color = Color(0.35, 0.95, 0.5)
const GUESSED: Color = Color(0.95, 0.55, 0.2)
## Width of the lines, px.
const LINE_PX: float = 2.0

var _pictures: Array[WebcamPicture] = []
var _texture: ImageTexture = null
var _counted: int = -1
var _shown: WebcamPicture = null
var _people: Array[PackedVector3Array] = []


func _init() -> void:
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	visible = false


func _process(_delta: float) -> void:
	# Hidden controls are processed too: the panel may be closed.
	if get_parent() is Control and not (get_parent() as Control).is_visible_in_tree():
		return
	_take()
	visible = _texture != null
	if visible:
		_people = _shown.people(roundi(Time.get_unix_time_from_system() * 1e6))
		queue_redraw()


func _draw() -> void:
	var at: Rect2 = picture_rect()
	draw_texture_rect(_texture, at, false)
	for points: PackedVector3Array in _people:
		for line: Vector2i in WebcamPicture.LINES:
			var from: Vector3 = points[line.x]
			var to: Vector3 = points[line.y]
			var color: Color = GUESSED.lerp(SEEN, minf(from.z, to.z))
			draw_line(_spot(from, at), _spot(to, at), color, LINE_PX, true)


## Shows what webcams see: the first one's that sends pictures.
func show_pictures(p_pictures: Array[WebcamPicture]) -> void:
	_pictures = p_pictures


## Where the picture is drawn: as large as fits.
func picture_rect() -> Rect2:
	if _texture == null:
		return Rect2()
	var whole: Vector2 = _texture.get_size()
	var part: Vector2 = whole * minf(size.x / whole.x, size.y / whole.y)
	return Rect2((size - part) / 2.0, part)


## How many skeletons are drawn.
func count_people() -> int:
	return _people.size()


func _take() -> void:
	for picture: WebcamPicture in _pictures:
		if picture.count() == 0 or (picture == _shown and picture.count() == _counted):
			continue
		_shown = picture
		_counted = picture.count()
		var image: Image = picture.image()
		if image != null:
			_texture = ImageTexture.create_from_image(image)
		return


## Where a landmark is drawn.
static func _spot(p_point: Vector3, p_at: Rect2) -> Vector2:
	return p_at.position + Vector2(p_point.x, p_point.y) * p_at.size.x
