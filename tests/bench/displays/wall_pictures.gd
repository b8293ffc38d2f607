extends SceneTree
## Walls, as the panels show them, against one wide picture of the same world: a JSON line a case.
##
## Cases: "cave": three walls at right angles, stitched. "monitors": three in a row on monitors of
## their own. "seam": two projectors that overlap, warped and blended, their light added. "white":
## likewise of a white test picture, where all should be white. Options:
## --case=NAME, --layout=FILE.

## The light of two projectors may be compared there where both pictures are, and beyond.
const GAMMA: float = 2.2
## Samples of the wall along each axis: of its shape.
const COLUMNS: int = 560
const ROWS: int = 200
const EDGE: int = 2

var _scene: WallScene = null
var _display: WallDisplay = null


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	_scene = WallScene.new()
	root.add_child(_scene)
	root.msaa_3d = Viewport.MSAA_4X
	_display = WallDisplay.new()
	_display.camera = _scene.camera
	_display.failed.connect(printerr)
	root.add_child(_display)
	var fault: String = _display.set_up(_option("layout"))
	fault = _display.open() if fault == "" else fault
	if fault != "":
		printerr(fault)
		quit(2)
		return
	if _option("case") == "white":
		_display.show_test_picture(TestPicture.Kind.WHITE)
	await WallScene.draw(4)
	await process_frame
	var panel: Image = _desktop()
	var wide: EyeView = EyeView.new()
	root.add_child(wide)
	wide.follow(_scene.camera)
	match _option("case"):
		"cave":
			await _compare_cave(panel, wide)
		"monitors":
			await _compare_row(panel, wide)
		"seam", "white":
			await _compare_seam(panel, wide)
	quit()


func _option(p_name: String) -> String:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--%s=" % p_name):
			return argument.get_slice("=", 1)
	return ""


## What all monitors show.
func _desktop() -> Image:
	var whole: Rect2i = Rect2i()
	for screen: int in DisplayServer.get_screen_count():
		var at: Vector2i = DisplayServer.screen_get_position(screen)
		whole = whole.merge(Rect2i(at, DisplayServer.screen_get_size(screen)))
	var image: Image = Image.create(whole.size.x, whole.size.y, false, Image.FORMAT_RGBA8)
	for screen: int in DisplayServer.get_screen_count():
		var part: Image = DisplayServer.screen_get_image(screen)
		part.convert(Image.FORMAT_RGBA8)
		var at: Vector2i = DisplayServer.screen_get_position(screen)
		image.blit_rect(part, Rect2i(Vector2i.ZERO, part.get_size()), at)
	return image


## The picture of a rectangle of the station, with so many pixels.
func _picture_of(
	p_wide: EyeView, p_low: Vector3, p_right: Vector3, p_high: Vector3, p_size: Vector2i
) -> Image:
	p_wide.resize(p_size)
	var eye: Vector3 = _display.eye()
	var frustum: OffAxisFrustum = OffAxisFrustum.through(p_low, p_right, p_high, eye)
	p_wide.camera.global_transform = _display.station() * Transform3D(frustum.basis, eye)
	frustum.aim(p_wide.camera, _scene.camera.near, _scene.camera.far)
	await WallScene.draw(3)
	return p_wide.get_texture().get_image()


func _say(p_found: Dictionary) -> void:
	p_found["case"] = _option("case")
	print(JSON.stringify(p_found))


## A picture of 120 degrees and what the walls show along the same rays.
func _compare_cave(p_panel: Image, p_wide: EyeView) -> void:
	var size: Vector2i = Vector2i(900, 300)
	var eye: Vector3 = _display.eye()
	var half: Vector2 = Vector2(1.5, 0.5)
	var low: Vector3 = eye + Vector3(-half.x, -half.y, -1.0)
	var right: Vector3 = low + Vector3(2.0 * half.x, 0.0, 0.0)
	var high: Vector3 = low + Vector3(0.0, 2.0 * half.y, 0.0)
	var wide: Image = await _picture_of(p_wide, low, right, high, size)
	var sum: float = 0.0
	var count: int = 0
	for y: int in size.y:
		for x: int in size.x:
			var at: Vector2 = Vector2((x + 0.5) / size.x, 1.0 - (y + 0.5) / size.y)
			var ray: Vector3 = low + (right - low) * at.x + (high - low) * at.y - eye
			var seen: Color = _on_walls(p_panel, eye, ray)
			if seen.a > 0.0:
				sum += _difference(seen, wide.get_pixel(x, y))
				count += 1
	_say({"mean": sum / count * 255.0, "covered": float(count) / (size.x * size.y)})


## What the walls show in a direction; no opacity where there is none.
func _on_walls(p_panel: Image, p_eye: Vector3, p_ray: Vector3) -> Color:
	for screen: WallScreen in _display.layout.screens:
		var frustum: OffAxisFrustum = screen.seen_from(p_eye)
		var ahead: float = -frustum.basis.z.dot(p_ray)
		if ahead <= 0.0:
			continue
		var hit: Vector3 = p_eye + p_ray * (frustum.distance / ahead) - screen.bottom_left
		var at: Vector2 = Vector2(frustum.basis.x.dot(hit), frustum.basis.y.dot(hit))
		at /= frustum.extent
		if at == at.clamp(Vector2.ZERO, Vector2.ONE):
			var pixel: Vector2 = Vector2(at.x, 1.0 - at.y) * Vector2(screen.size)
			return _sample(p_panel, Rect2i(screen.position, screen.size), pixel)
	return Color(0.0, 0.0, 0.0, 0.0)


## A colour between pixels of a window.
static func _sample(p_image: Image, p_window: Rect2i, p_at: Vector2) -> Color:
	var from: Vector2 = p_at - Vector2(0.5, 0.5)
	var base: Vector2i = Vector2i(from.floor())
	var share: Vector2 = from - Vector2(base)
	var rows: Array[Color] = []
	for y: int in 2:
		var pair: Array[Color] = []
		for x: int in 2:
			var pixel: Vector2i = (base + Vector2i(x, y)).clamp(
				Vector2i.ZERO, p_window.size - Vector2i.ONE
			)
			pair.append(p_image.get_pixelv(p_window.position + pixel))
		rows.append(pair[0].lerp(pair[1], share.x))
	return rows[0].lerp(rows[1], share.y)


static func _difference(p_first: Color, p_second: Color) -> float:
	var found: float = absf(p_first.r - p_second.r) + absf(p_first.g - p_second.g)
	return (found + absf(p_first.b - p_second.b)) / 3.0


## Screens in a row, each on its own monitor: one picture, pixel by pixel.
func _compare_row(p_panel: Image, p_wide: EyeView) -> void:
	var first: WallScreen = _display.layout.screens[0]
	var last: WallScreen = _display.layout.screens[-1]
	var size: Vector2i = Vector2i(last.position.x + last.size.x, first.size.y)
	var wide: Image = await _picture_of(
		p_wide, first.bottom_left, last.bottom_right, first.top_left, size
	)
	var sum: float = 0.0
	for y: int in size.y:
		for x: int in size.x:
			sum += _difference(p_panel.get_pixel(x, y), wide.get_pixel(x, y))
	_say({"mean": sum / (size.x * size.y) * 255.0, "screens": DisplayServer.get_screen_count()})


## Two projectors on one plane: their light is added along the wall, and compared with that of one.
func _compare_seam(p_panel: Image, p_wide: EyeView) -> void:
	var screens: Array[WallScreen] = _display.layout.screens
	var low: Vector3 = screens[0].bottom_left
	var right: Vector3 = screens[-1].bottom_right
	var wide: Image = await _picture_of(
		p_wide, low, right, screens[0].top_left, Vector2i(COLUMNS, ROWS) * 2
	)
	if _option("case") == "white":
		wide.fill(Color.WHITE)
	var sums: Vector2 = Vector2.ZERO
	var counts: Vector2 = Vector2.ZERO
	var most: float = 0.0
	for y: int in ROWS:
		for x: int in COLUMNS:
			var at: Vector2 = Vector2(x + 0.5, y + 0.5) / Vector2(COLUMNS, ROWS)
			var spot: Vector3 = low.lerp(right, at.x)
			var light: Vector3 = Vector3.ZERO
			var covering: int = 0
			for screen: WallScreen in screens:
				var share: float = spot.x - screen.bottom_left.x
				share /= screen.bottom_right.x - screen.bottom_left.x
				if share > 0.0 and share < 1.0:
					light += _light_of(screen, p_panel, Vector2(share, at.y))
					covering += 1
			var wanted: Color = _sample(
				wide, Rect2i(Vector2i.ZERO, wide.get_size()), at * Vector2(wide.get_size())
			)
			var off: Vector3 = (light - _to_light(wanted)).abs()
			var difference: float = (off.x + off.y + off.z) / 3.0
			var place: int = 1 if covering > 1 else 0
			sums[place] += difference
			counts[place] += 1.0
			# At a picture's upper and lower edge half a pixel is none of it.
			if place == 1 and y > EDGE and y < ROWS - EDGE:
				most = maxf(most, difference)
	var found: Dictionary = {"seam": sums.y / counts.y * 255.0, "most": most * 255.0}
	found["beside"] = sums.x / counts.x * 255.0
	_say(found)


## What a projector throws at a place of its picture (0..1): it undoes the warp, as its lens does.
func _light_of(p_screen: WallScreen, p_panel: Image, p_at: Vector2) -> Vector3:
	var place: Vector2 = p_at
	if not p_screen.warp.is_empty():
		place = Homography.apply(Homography.to_corners(p_screen.warp), p_at)
	var window: Rect2i = Rect2i(p_screen.position, p_screen.size)
	return _to_light(_sample(p_panel, window, place * Vector2(p_screen.size)))


static func _to_light(p_value: Color) -> Vector3:
	return Vector3(pow(p_value.r, GAMMA), pow(p_value.g, GAMMA), pow(p_value.b, GAMMA))
