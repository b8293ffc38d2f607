class_name TestPicture
extends SubViewport
## A picture by which the projectors of a screen are aligned, shown as the world would be: warped,
## blended, on the right monitor.

## What it shows.
enum Kind {
	## The world.
	NONE,
	## A numbered grid with circles, and a frame of one pixel.
	GRID,
	## White where the screen overlaps with others, the edges of overlaps, dark elsewhere.
	OVERLAP,
	## Steps of grey, and lines that look as grey as their middle where the gamma is right.
	GREYS,
	## All white.
	WHITE,
	## All black, for the black level.
	BLACK,
}

## What the kinds are called for the user.
const TITLES: Array[String] = ["the world", "grid", "overlaps", "steps of grey", "white", "black"]

var _sheet: TestSheet = TestSheet.new()


func _init() -> void:
	disable_3d = true
	render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(_sheet)


## Draws a kind for a screen, with so many pixels.
func draw_for(p_screen: WallScreen, p_kind: Kind, p_size: Vector2i) -> void:
	size = p_size.max(Vector2i(2, 2))
	_sheet.size = size
	_sheet.screen = p_screen
	_sheet.kind = p_kind
	_sheet.queue_redraw()


class TestSheet:
	extends Control
	## What is drawn.

	const _LEFT: HorizontalAlignment = HORIZONTAL_ALIGNMENT_LEFT
	const _CELLS: int = 16
	const _STEPS: int = 11
	const _DARK: Color = Color(0.1, 0.1, 0.12)

	var screen: WallScreen = null
	var kind: Kind = Kind.GRID

	func _draw() -> void:
		var whole: Rect2 = Rect2(Vector2.ZERO, size)
		match kind:
			Kind.GRID:
				draw_rect(whole, _DARK)
				_draw_grid()
			Kind.OVERLAP:
				draw_rect(whole, _DARK)
				_draw_overlaps()
			Kind.GREYS:
				_draw_greys()
			Kind.WHITE:
				draw_rect(whole, Color.WHITE)
			Kind.BLACK:
				draw_rect(whole, Color.BLACK)

	func _draw_grid() -> void:
		var cell: float = size.x / _CELLS
		var rows: int = maxi(roundi(size.y / cell), 1)
		var high: float = size.y / rows
		var font: Font = ThemeDB.fallback_font
		var text: int = maxi(int(high * 0.25), 8)
		for row: int in rows:
			for column: int in _CELLS:
				var at: Vector2 = Vector2(column * cell, row * high)
				draw_rect(Rect2(at.floor(), Vector2(1.0, high)), Color.WHITE)
				draw_rect(Rect2(at.floor(), Vector2(cell, 1.0)), Color.WHITE)
				var place: Vector2 = at + Vector2(4.0, text + 2.0)
				draw_string(font, place, "%d.%d" % [row, column], _LEFT, -1.0, text, Color.YELLOW)
		var radius: float = minf(size.x, size.y) * 0.5 - 1.0
		draw_arc(size * 0.5, radius, 0.0, TAU, 180, Color.CYAN, 2.0)
		draw_arc(size * 0.5, radius * 0.5, 0.0, TAU, 120, Color.CYAN, 2.0)
		draw_string(font, size * 0.5, screen.name, _LEFT, -1.0, text * 2, Color.WHITE)
		for edge: Rect2 in [
			Rect2(0.0, 0.0, size.x, 1.0),
			Rect2(0.0, size.y - 1.0, size.x, 1.0),
			Rect2(0.0, 0.0, 1.0, size.y),
			Rect2(size.x - 1.0, 0.0, 1.0, size.y),
		]:
			draw_rect(edge, Color.RED)

	func _draw_overlaps() -> void:
		var blend: Vector4 = screen.blend
		var left: float = blend.x * size.x
		var right: float = blend.y * size.x
		var top: float = blend.z * size.y
		var bottom: float = blend.w * size.y
		for zone: Rect2 in [
			Rect2(0.0, 0.0, left, size.y),
			Rect2(size.x - right, 0.0, right, size.y),
			Rect2(0.0, 0.0, size.x, top),
			Rect2(0.0, size.y - bottom, size.x, bottom),
		]:
			if zone.has_area():
				draw_rect(zone, Color.WHITE)

	func _draw_greys() -> void:
		var step: float = size.x / _STEPS
		for at: int in _STEPS:
			var value: float = float(at) / (_STEPS - 1)
			var color: Color = Color(value, value, value)
			draw_rect(Rect2(at * step, 0.0, step + 1.0, size.y * 0.5), color)
		draw_rect(Rect2(0.0, size.y * 0.5, size.x, size.y * 0.5), Color.BLACK)
		for row: int in range(int(size.y * 0.5), int(size.y), 2):
			draw_rect(Rect2(0.0, row, size.x, 1.0), Color.WHITE)
		# Half of the light.
		var half: float = pow(0.5, 1.0 / screen.gamma)
		var patch: Rect2 = Rect2(size * Vector2(0.3, 0.6), size * Vector2(0.4, 0.3))
		draw_rect(patch, Color(half, half, half))
