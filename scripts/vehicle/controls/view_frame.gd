class_name ViewFrame
extends Control
## What surrounds the picture of a [SeatView]: the tube and the reticle of the gunner's sight with
## the range, or the slit of a periscope.

const _DARK: Color = Color(0.01, 0.012, 0.014)
const _MARK: Color = Color(0.05, 0.05, 0.05, 0.9)
const _LIGHT: Color = Color(1.0, 0.62, 0.2)
## Radius of the sight's picture, as a share of the window's height.
const _RADIUS: float = 0.46
## The slit of a periscope, as shares of the window: half its width and half its height.
const _SLIT: Vector2 = Vector2(0.44, 0.24)
## Angles of the marks beside and below the cross, mrad.
const _MARKS_MRAD: Array[int] = [2, 4, 6, 8, 10]

var _view: SeatView = null
var _kind: SeatView.Kind = SeatView.Kind.OPEN
var _range_m: float = 0.0
var _magnification: float = 1.0


func _draw() -> void:
	match _kind:
		SeatView.Kind.SIGHT:
			_draw_tube()
			_draw_reticle()
		SeatView.Kind.PERISCOPE:
			_draw_slit()


## Frames what a view shows; null: nothing.
func show_view(p_view: SeatView) -> void:
	var kind: SeatView.Kind = p_view.kind if p_view != null else SeatView.Kind.OPEN
	var nearer: float = p_view.magnification() if p_view != null else 1.0
	if p_view != _view or kind != _kind or nearer != _magnification:
		_view = p_view
		_kind = kind
		_magnification = nearer
		queue_redraw()


## Shows how far it is to what is aimed at, m; 0: unknown.
func show_range(p_range_m: float) -> void:
	if absf(p_range_m - _range_m) >= 1.0:
		_range_m = p_range_m
		queue_redraw()


func _draw_tube() -> void:
	var radius: float = _RADIUS * size.y
	# A ring that is wide enough to cover the corners.
	var width: float = size.length()
	draw_arc(size / 2.0, radius + width / 2.0, 0.0, TAU, 96, _DARK, width)
	draw_arc(size / 2.0, radius, 0.0, TAU, 96, _DARK.lightened(0.1), 3.0, true)


func _draw_reticle() -> void:
	var middle: Vector2 = size / 2.0
	var radius: float = _RADIUS * size.y
	# Length of a milliradian on the screen.
	var mrad: float = 0.001 * size.y / 2.0 / tan(deg_to_rad(_view.fov) / 2.0)
	for way: Vector2 in [Vector2.LEFT, Vector2.RIGHT, Vector2.DOWN, Vector2.UP]:
		draw_line(middle + way * radius * 0.92, middle + way * mrad, _MARK, 1.5)
	for mark: int in _MARKS_MRAD:
		var half: float = 6.0 if mark % 4 == 0 else 3.5
		for way: Vector2 in [Vector2.LEFT, Vector2.RIGHT, Vector2.DOWN]:
			var at: Vector2 = middle + way * mrad * mark
			if at.distance_to(middle) < radius:
				draw_line(at - way.orthogonal() * half, at + way.orthogonal() * half, _MARK, 1.5)
	var font: Font = get_theme_default_font()
	var text: String = "---- m" if _range_m == 0.0 else "%d m" % roundi(_range_m)
	text += "    x%d" % roundi(_magnification)
	var place: Vector2 = middle + Vector2(-radius * 0.5, radius * 0.8)
	draw_string(font, place, text, HORIZONTAL_ALIGNMENT_CENTER, radius, 18, _LIGHT)


func _draw_slit() -> void:
	var half: Vector2 = _SLIT * size
	var middle: Vector2 = size / 2.0
	draw_rect(Rect2(0.0, 0.0, size.x, middle.y - half.y), _DARK)
	draw_rect(Rect2(0.0, middle.y + half.y, size.x, middle.y - half.y), _DARK)
	draw_rect(Rect2(0.0, 0.0, middle.x - half.x, size.y), _DARK)
	draw_rect(Rect2(middle.x + half.x, 0.0, middle.x - half.x, size.y), _DARK)
	var edge: Rect2 = Rect2(middle - half, 2.0 * half)
	draw_rect(edge, _DARK.lightened(0.08), false, 6.0)
