class_name WreckMaker
extends SolidMaker
## Burnt-out vehicles. Each is built around its place, on the ground, facing -Z.

const BURNT: int = SurfaceLayers.Layer.BURNT
const METAL: int = SurfaceLayers.Layer.METAL


## A lorry of 6.6 m: cab without glass, bent hoops over the bed.
func lorry() -> void:
	for side: float in [-1.0, 1.0]:
		_box(Vector3(side * 0.42, 0.62, 0.2), Vector3(0.14, 0.2, 6.0), BURNT, Tint.PLAIN)
		for axle: float in [-2.15, 1.15, 2.3]:
			_wheel(Vector3(side * 0.92, 0.36, axle), 0.46, 0.28)
	for axle: float in [-2.15, 1.15, 2.3]:
		_mesh.rod(Vector3(-0.9, 0.4, axle), Vector3(0.9, 0.4, axle), 0.08, 0.08, BURNT, Tint.SOOT)
	_cab(Vector3(0.0, 0.75, -1.75), Vector3(2.15, 1.55, 1.5))
	_box(Vector3(0.0, 0.95, -2.85), Vector3(1.3, 0.75, 0.85), BURNT, Tint.PLAIN)
	_box(Vector3(0.0, 0.72, -3.32), Vector3(2.2, 0.22, 0.16), BURNT, Tint.SOOT)
	for side: float in [-1.0, 1.0]:
		_box(Vector3(side * 0.88, 0.88, -2.75), Vector3(0.42, 0.07, 1.1), BURNT, Tint.SOOT)
	# The bed: floor, low walls with gaps, hoops.
	_box(Vector3(0.0, 0.98, 1.25), Vector3(2.3, 0.1, 4.0), BURNT, Tint.PLAIN)
	for side: float in [-1.0, 1.0]:
		_box(Vector3(side * 1.12, 1.28, 0.55), Vector3(0.05, 0.5, 2.5), BURNT, Tint.PLAIN)
		_mesh.rod(
			Vector3(side * 1.12, 1.0, 3.2), Vector3(side * 1.3, 1.5, 3.1), 0.04, 0.04, BURNT, 1
		)
	_box(Vector3(0.0, 1.32, -0.72), Vector3(2.3, 0.6, 0.05), BURNT, Tint.SOOT)
	for hoop: int in 4:
		_hoop(Vector3(0.0, 1.5, -0.5 + 1.15 * hoop), 1.12, 1.25 - 0.25 * float(hoop == 2))
	_solid(Vector3(0.0, 1.0, 0.2), Vector3(2.3, 0.9, 6.4))
	_solid(Vector3(0.0, 1.6, -1.75), Vector3(2.15, 1.4, 1.5))


## A saloon of 4.2 m on its rims.
func car() -> void:
	var half: float = 0.82
	# Outline of the side from the front, z and y.
	var low: float = 0.28
	var outline: PackedVector2Array = [
		Vector2(-2.1, 0.72),
		Vector2(-0.85, 0.92),
		Vector2(-0.25, 1.42),
		Vector2(0.95, 1.42),
		Vector2(1.45, 0.96),
		Vector2(2.1, 0.9)
	]
	for part: int in [0, 2, 4]:
		_strip(outline[part], outline[part + 1], half - (0.14 if part == 2 else 0.0))
	for side: float in [-1.0, 1.0]:
		_side_wall(outline, side * half, low)
		for pillar: Vector2 in [Vector2(-0.85, -0.25), Vector2(0.4, 0.4), Vector2(1.45, 0.95)]:
			_mesh.rod(
				Vector3(side * half, 0.92, pillar.x),
				Vector3(side * (half - 0.14), 1.42, pillar.y),
				0.04,
				0.04,
				BURNT,
				Tint.SOOT,
				6
			)
		for axle: float in [-1.3, 1.35]:
			_wheel(Vector3(side * 0.72, 0.27, axle), 0.27, 0.18)
	for end: Vector2 in [Vector2(-2.1, 0.72), Vector2(2.1, 0.9)]:
		_box(Vector3(0.0, (end.y + low) / 2.0, end.x), Vector3(1.64, end.y - low, 0.05), BURNT, 0)
	_box(Vector3(0.0, low, 0.0), Vector3(1.6, 0.05, 4.1), BURNT, Tint.SOOT)
	for seat: Vector2 in [Vector2(-0.38, -0.1), Vector2(0.38, -0.1), Vector2(0.0, 0.9)]:
		_box(Vector3(seat.x, 0.62, seat.y + 0.25), Vector3(0.5, 0.62, 0.1), BURNT, Tint.SOOT)
		_box(Vector3(seat.x, 0.4, seat.y), Vector3(0.5, 0.12, 0.45), BURNT, Tint.SOOT)
	_solid(Vector3(0.0, 0.6, 0.0), Vector3(1.7, 0.66, 4.2))
	_solid(Vector3(0.0, 1.15, 0.5), Vector3(1.4, 0.5, 1.5))


## A tank of 6.3 m whose gun hangs and which has thrown a track.
func tank() -> void:
	var half: float = 0.98
	var side: PackedVector2Array = [
		Vector2(-3.15, 0.85),
		Vector2(-2.35, 1.42),
		Vector2(2.75, 1.42),
		Vector2(3.1, 0.95),
		Vector2(2.6, 0.45),
		Vector2(-2.6, 0.45)
	]
	_hull(side, half)
	for flank: float in [-1.0, 1.0]:
		_box(Vector3(flank * 1.32, 1.16, 0.0), Vector3(0.68, 0.05, 6.0), BURNT, Tint.PLAIN)
		_box(Vector3(flank * 1.45, 1.32, 1.5), Vector3(0.4, 0.28, 1.3), METAL, Tint.GREY)
		_box(Vector3(flank * 1.45, 1.30, -0.3), Vector3(0.4, 0.24, 0.9), BURNT, Tint.PLAIN)
		for wheel: int in 5:
			_road_wheel(Vector3(flank * 1.31, 0.44, -2.15 + 1.02 * wheel), 0.41)
		_road_wheel(Vector3(flank * 1.31, 0.66, -2.95), 0.30)
		_road_wheel(Vector3(flank * 1.31, 0.66, 2.75), 0.32)
	_track(-1.31)
	_mesh.set_finest(1.25)
	# The turret: a dome of three rings, turned aside.
	var turret: Vector3 = Vector3(0.0, 1.42, -0.35)
	_mesh.rod(turret, turret + Vector3.UP * 0.34, 1.22, 1.12, METAL, Tint.GREY, 20, false)
	_mesh.rod(
		turret + Vector3.UP * 0.34, turret + Vector3.UP * 0.62, 1.12, 0.86, BURNT, 0, 20, false
	)
	_mesh.rod(turret + Vector3.UP * 0.62, turret + Vector3.UP * 0.78, 0.86, 0.5, BURNT, 0, 20)
	_mesh.rod(
		turret + Vector3(0.35, 0.74, 0.2), turret + Vector3(0.35, 0.9, 0.2), 0.3, 0.3, BURNT, 1, 12
	)
	_mesh.rod(
		turret + Vector3(0.62, 0.92, 0.25),
		turret + Vector3(0.82, 1.42, 0.3),
		0.29,
		0.29,
		BURNT,
		0,
		12
	)
	var root: Vector3 = turret + Vector3(-0.35, 0.38, -1.0)
	var muzzle: Vector3 = root + Vector3(-1.35, -0.42, -3.7)
	_mesh.rod(root, root.lerp(muzzle, 0.14), 0.24, 0.17, METAL, Tint.GREY, 12)
	_mesh.rod(root, muzzle, 0.115, 0.085, BURNT, Tint.PLAIN, 12)
	_mesh.rod(root.lerp(muzzle, 0.62), root.lerp(muzzle, 0.74), 0.14, 0.14, BURNT, Tint.PLAIN, 12)
	_solid(Vector3(0.0, 0.95, 0.0), Vector3(3.3, 0.95, 6.0))
	_solid(turret + Vector3.UP * 0.35, Vector3(2.2, 0.75, 2.2))


func _wheel(p_middle: Vector3, p_radius: float, p_width: float) -> void:
	var across: Vector3 = Vector3.RIGHT * p_width / 2.0
	_mesh.rod(p_middle - across, p_middle + across, p_radius, p_radius, BURNT, Tint.RUBBER, 14)
	across *= 1.12
	_mesh.rod(p_middle - across, p_middle + across, p_radius * 0.6, p_radius * 0.6, BURNT, 0, 12)


func _road_wheel(p_middle: Vector3, p_radius: float) -> void:
	for side: float in [-0.14, 0.14]:
		var from: Vector3 = p_middle + Vector3.RIGHT * (side - 0.09)
		_mesh.rod(from, from + Vector3.RIGHT * 0.18, p_radius, p_radius, BURNT, Tint.SOOT, 14)
	var hub: Vector3 = Vector3.RIGHT * 0.27
	_mesh.rod(p_middle - hub, p_middle + hub, p_radius * 0.35, p_radius * 0.3, BURNT, 0, 10)


## A track around the wheels of one side; the other side's lies behind the tank.
func _track(p_x: float) -> void:
	var around: PackedVector2Array = [
		Vector2(-3.25, 0.68),
		Vector2(-3.05, 0.97),
		Vector2(2.8, 0.98),
		Vector2(3.08, 0.7),
		Vector2(2.2, 0.02),
		Vector2(-2.3, 0.02)
	]
	for part: int in around.size():
		var from: Vector2 = around[part]
		var to: Vector2 = around[(part + 1) % around.size()]
		_links(Vector3(p_x, from.y, from.x), Vector3(p_x, to.y, to.x))
	_links(Vector3(1.35, 0.04, 2.2), Vector3(1.5, 0.05, 5.4))
	_links(Vector3(1.5, 0.05, 5.4), Vector3(2.2, 0.06, 8.0))


func _links(p_from: Vector3, p_to: Vector3) -> void:
	var count: int = maxi(roundi(p_from.distance_to(p_to) / 0.16), 1)
	var place: Transform3D = _mesh.get_place()
	var way: Vector3 = (p_to - p_from).normalized()
	var up: Vector3 = Vector3.UP if absf(way.y) < 0.95 else Vector3.FORWARD
	for link: int in count:
		var at: Vector3 = p_from.lerp(p_to, (link + 0.5) / count)
		_mesh.set_place(place * Transform3D(Basis.looking_at(way, up), at))
		_box(Vector3.ZERO, Vector3(0.56, 0.05, 0.13), BURNT, Tint.PLAIN)
	_mesh.set_place(place)


func _cab(p_foot: Vector3, p_size: Vector3) -> void:
	var half: Vector3 = p_size / 2.0
	for side: float in [-1.0, 1.0]:
		_box(
			p_foot + Vector3(side * half.x, p_size.y * 0.24, 0.0),
			Vector3(0.05, p_size.y * 0.48, p_size.z),
			BURNT,
			Tint.PLAIN
		)
		for end: float in [-1.0, 1.0]:
			var foot: Vector3 = p_foot + Vector3(side * half.x, p_size.y * 0.45, end * half.z)
			var top: Vector3 = p_foot + Vector3(side * half.x * 0.94, p_size.y, end * half.z * 0.86)
			_mesh.rod(foot, top, 0.05, 0.045, BURNT, Tint.SOOT, 6)
	_box(p_foot + Vector3.UP * p_size.y, Vector3(p_size.x * 0.95, 0.05, p_size.z * 0.9), BURNT, 0)
	_box(
		p_foot + Vector3(0.0, p_size.y * 0.24, -half.z),
		Vector3(p_size.x, p_size.y * 0.48, 0.05),
		BURNT,
		Tint.PLAIN
	)
	_box(p_foot + Vector3(0.0, p_size.y * 0.5, half.z), Vector3(p_size.x, p_size.y, 0.05), BURNT, 0)
	_box(p_foot + Vector3(0.0, 0.3, 0.35), Vector3(1.8, 0.5, 0.5), BURNT, Tint.SOOT)


func _hoop(p_middle: Vector3, p_half: float, p_height: float) -> void:
	var last: Vector3 = p_middle + Vector3(-p_half, 0.0, 0.0)
	for part: int in range(1, 9):
		var turn: float = PI * part / 8.0
		var bend: Vector3 = Vector3(
			-cos(turn) * p_half, sin(turn) * p_height, 0.12 * sin(turn * 2.0)
		)
		_mesh.rod(last, p_middle + bend, 0.028, 0.028, BURNT, Tint.SOOT, 5, false)
		last = p_middle + bend


## A strip of a car's body between two points of its side.
func _strip(p_from: Vector2, p_to: Vector2, p_half: float) -> void:
	_mesh.quad(
		Vector3(p_half, p_from.y, p_from.x),
		Vector3(-p_half, p_from.y, p_from.x),
		Vector3(-p_half, p_to.y, p_to.x),
		Vector3(p_half, p_to.y, p_to.x),
		BURNT,
		Tint.PLAIN
	)
	_mesh.quad(
		Vector3(p_half, p_to.y, p_to.x),
		Vector3(-p_half, p_to.y, p_to.x),
		Vector3(-p_half, p_from.y, p_from.x),
		Vector3(p_half, p_from.y, p_from.x),
		BURNT,
		Tint.SOOT
	)


func _side_wall(p_outline: PackedVector2Array, p_x: float, p_low: float) -> void:
	var spans: Array[Vector4] = [
		Vector4(-2.1, 0.72, -0.85, 0.92),
		Vector4(-0.85, 0.92, 1.45, 0.96),
		Vector4(1.45, 0.96, 2.1, p_outline[5].y)
	]
	for span: Vector4 in spans:
		var a: Vector3 = Vector3(p_x, p_low, span.x)
		var b: Vector3 = Vector3(p_x, span.y, span.x)
		var c: Vector3 = Vector3(p_x, span.w, span.z)
		var d: Vector3 = Vector3(p_x, p_low, span.z)
		_mesh.quad(a, b, c, d, BURNT, Tint.PLAIN)
		_mesh.quad(d, c, b, a, BURNT, Tint.PLAIN)


## A hull whose side is an outline from the front over the top, z and y.
func _hull(p_side: PackedVector2Array, p_half: float) -> void:
	var count: int = p_side.size()
	for part: int in count:
		var from: Vector2 = p_side[part]
		var to: Vector2 = p_side[(part + 1) % count]
		_mesh.quad(
			Vector3(-p_half, from.y, from.x),
			Vector3(-p_half, to.y, to.x),
			Vector3(p_half, to.y, to.x),
			Vector3(p_half, from.y, from.x),
			BURNT,
			Tint.PLAIN
		)
	for flank: float in [-1.0, 1.0]:
		for part: int in range(1, count - 1):
			var corners: Array[Vector2] = [p_side[0], p_side[part], p_side[part + 1]]
			if flank < 0.0:
				corners.reverse()
			_mesh.triangle(
				Vector3(flank * p_half, corners[0].y, corners[0].x),
				Vector3(flank * p_half, corners[1].y, corners[1].x),
				Vector3(flank * p_half, corners[2].y, corners[2].x),
				BURNT,
				Tint.PLAIN
			)
