class_name VehicleBumps
extends RefCounted
## A road with bumps of 0.3 m, 3 m long, every 12 m, as a mesh.

const HEIGHT_M: float = 0.3
const LENGTH_M: float = 3.0
const EVERY_M: float = 12.0
const HALF_WIDTH_M: float = 15.0
const END_M: float = 500.0
const PIECE_M: float = 0.25


## The road from behind the origin on along -Z, up to a distance, m.
static func create(p_end_m: float = END_M) -> StaticBody3D:
	var faces: PackedVector3Array = PackedVector3Array()
	var from: float = 20.0
	while from > -p_end_m:
		var to: float = from - PIECE_M
		var a: Vector3 = Vector3(-HALF_WIDTH_M, height_at(from), from)
		var b: Vector3 = Vector3(HALF_WIDTH_M, height_at(from), from)
		var c: Vector3 = Vector3(-HALF_WIDTH_M, height_at(to), to)
		var d: Vector3 = Vector3(HALF_WIDTH_M, height_at(to), to)
		faces.append_array([a, c, b, b, c, d])
		from = to
	var mesh: ConcavePolygonShape3D = ConcavePolygonShape3D.new()
	mesh.set_faces(faces)
	mesh.backface_collision = true
	var body: StaticBody3D = StaticBody3D.new()
	body.add_child(BenchBodies.collision(mesh))
	return body


## Height of the road, m.
static func height_at(p_z: float) -> float:
	if p_z > -EVERY_M:
		return 0.0
	var along: float = fposmod(-p_z, EVERY_M)
	if along > LENGTH_M:
		return 0.0
	return 0.5 * HEIGHT_M * (1.0 - cos(TAU * along / LENGTH_M))
