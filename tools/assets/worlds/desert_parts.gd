class_name DesertParts
extends RefCounted
## What stands in the desert, as meshes: rocks, wrecks, ruins, a checkpoint, a camp and a telegraph
## line. See build_desert.gd.

## Names of the parts; the other lists are in their order.
var names: PackedStringArray = []
## Their meshes.
var meshes: Array[BlockMesh] = []
## Where they stand, m.
var places: Array[Vector3] = []
## Parts whose faces are their shape; the others have boxes.
var is_rock: Array[bool] = []
## Whether they throw shadows and stop people.
var casts: Array[bool] = []

var _layout: Dictionary = {}
var _field: HeightField = null


func _init(p_layout: Dictionary, p_field: HeightField) -> void:
	_layout = p_layout
	_field = p_field


## Makes all.
func build() -> void:
	_add_rocks()
	_add_wrecks()
	_add_ruins()
	_add_checkpoint()
	_add_camp()
	_add_telegraph()


## How many vertices all have.
func count() -> int:
	var sum: int = 0
	for mesh: BlockMesh in meshes:
		sum += mesh.get_vertex_count()
	return sum


func _ground(p_x: float, p_z: float) -> Vector3:
	return Vector3(p_x, _field.height_at(p_x, p_z), p_z)


func _spot(p_pair: Array) -> Vector3:
	return _ground(p_pair[0], p_pair[1])


## A part at a place; what is built next stands there.
func _begin(p_name: String, p_place: Vector3, p_is_rock: bool = false) -> BlockMesh:
	var mesh: BlockMesh = BlockMesh.new()
	mesh.set_layer_edges(PackedFloat32Array(SurfaceLayers.EDGE_M))
	mesh.set_dust(0.35, 0.0)
	mesh.set_finest(1.2)
	names.append(p_name)
	meshes.append(mesh)
	places.append(p_place)
	is_rock.append(p_is_rock)
	casts.append(true)
	return mesh


## Where a thing stands in a part: upright on the ground below, or lying on its slope.
func _stand(p_part: Vector3, p_at: Vector3, p_turn: float, p_leans: bool) -> Transform3D:
	var basis: Basis = Basis(Vector3.UP, p_turn)
	if p_leans:
		var up: Vector3 = _field.normal_at(p_at.x, p_at.z)
		basis = Basis(Quaternion(Vector3.UP, up)) * basis
	return Transform3D(basis, p_at - p_part)


func _add_rocks() -> void:
	var number: int = 0
	for rock: Dictionary in (_layout["mesas"] as Array) + (_layout["needles"] as Array):
		number += 1
		var place: Vector3 = _spot(rock["at"])
		# The slope of debris is part of the ground: stand on its foot.
		place.y -= float(rock["height"]) * 0.18
		var mesh: BlockMesh = _begin("Rock%d" % number, place, true)
		mesh.set_dust(0.22, 0.0)
		var rock_seed: int = int(rock["seed"])
		var tint: int = SolidMaker.Tint.PALE_ROCK if rock_seed % 3 > 0 else SolidMaker.Tint.RED_ROCK
		var maker: RockMaker = RockMaker.new()
		maker.mesa(mesh, rock["radius"], rock["height"], rock_seed, tint)
		_add_boulders(maker, mesh, place, rock["radius"], rock_seed, tint)


func _add_boulders(
	p_maker: RockMaker,
	p_mesh: BlockMesh,
	p_place: Vector3,
	p_radius: float,
	p_seed: int,
	p_tint: int
) -> void:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = p_seed + 500
	for number: int in roundi(4.0 + p_radius * 0.7):
		var turn: float = dice.randf() * TAU
		var reach: float = p_radius * (1.15 + 0.9 * dice.randf() * dice.randf()) + 1.5
		var at: Vector3 = _ground(p_place.x + cos(turn) * reach, p_place.z + sin(turn) * reach)
		var size: float = 0.5 + 2.6 * pow(dice.randf(), 3.0)
		if _field.paint_at(at.x, at.z, HeightField.Paint.ROAD) < 0.05:
			p_maker.boulder(p_mesh, at - p_place, size, p_seed * 31 + number, p_tint)


func _add_wrecks() -> void:
	var kinds: Array[Array] = [
		["Tank", -96.0, 26.0, 0.8],
		["Tank", 72.0, -62.0, -1.9],
		["Tank", -14.0, 148.0, 2.7],
		["Lorry", -58.0, -2.0, 1.35],
		["Lorry", 26.0, -26.5, -0.4],
		["Lorry", -178.0, 4.0, 2.3],
		["Car", 8.0, -6.0, 1.2],
		["Car", 64.0, -9.5, -1.4],
		["Car", -118.0, 20.0, 0.5],
		["Car", -50.0, 12.0, 2.4]
	]
	var number: int = 0
	for row: Array in kinds:
		number += 1
		var place: Vector3 = _ground(row[1], row[2])
		var mesh: BlockMesh = _begin("%s%d" % [row[0], number], place)
		mesh.set_finest(0.8)
		mesh.set_dust(0.55, 0.2)
		var stand: Transform3D = _stand(place, place, row[3], true)
		stand.origin.y -= 0.10
		mesh.set_place(stand)
		var maker: WreckMaker = WreckMaker.new(mesh, number)
		match row[0]:
			"Tank":
				maker.tank()
			"Lorry":
				maker.lorry()
			_:
				maker.car()


func _add_ruins() -> void:
	var number: int = 0
	for ruin: Dictionary in _layout["ruins"]:
		number += 1
		var place: Vector3 = _spot(ruin["at"])
		var mesh: BlockMesh = _begin("Ruin%d" % number, place)
		mesh.set_finest(0.9)
		var least: float = place.y
		for corner: Vector2 in [Vector2(4, 3), Vector2(-4, 3), Vector2(4, -3), Vector2(-4, -3)]:
			var turned: Vector2 = corner.rotated(-float(ruin["turn"]))
			least = minf(least, _ground(place.x + turned.x, place.z + turned.y).y)
		var stand: Transform3D = _stand(place, place, ruin["turn"], false)
		stand.origin.y = least - place.y - 0.05
		mesh.set_place(stand)
		CampMaker.new(mesh, int(ruin["seed"])).ruin()


func _add_checkpoint() -> void:
	var middle: Vector3 = _spot(_layout["checkpoint"])
	var mesh: BlockMesh = _begin("Checkpoint", middle)
	mesh.set_finest(0.8)
	var maker: CampMaker = CampMaker.new(mesh, 77)
	var east: float = -0.16
	var things: Array[Array] = [
		["hut", Vector2(2.0, 7.0), PI],
		["beam", Vector2(0.0, 4.6), PI / 2.0],
		["barrier", Vector2(-9.0, 2.0), 0.25],
		["barrier", Vector2(-4.5, -2.4), -0.2],
		["barrier", Vector2(9.0, -2.2), 0.1],
		["barrier", Vector2(13.0, 1.9), -0.15],
		["hedgehog", Vector2(-13.0, 5.6), 0.4],
		["hedgehog", Vector2(-13.5, -5.8), 1.2],
		["hedgehog", Vector2(-10.8, -7.2), 2.2],
		["hedgehog", Vector2(-10.4, 7.4), 2.0],
		["drum", Vector2(4.4, 6.2), 0.0],
		["drum", Vector2(5.0, 6.6), 0.0],
		["drum", Vector2(4.9, 5.9), 0.0],
		["crate", Vector2(-0.6, 8.6), 0.3],
		["bags", Vector2(-2.4, 6.2), 0.1],
		["bags", Vector2(3.5, -6.4), PI]
	]
	for thing: Array in things:
		var offset: Vector2 = (thing[1] as Vector2).rotated(east)
		var at: Vector3 = _ground(middle.x + offset.x, middle.z + offset.y)
		mesh.set_place(_stand(middle, at, float(thing[2]) - east, thing[0] == "barrier"))
		mesh.set_dust(0.3, at.y - middle.y)
		match thing[0]:
			"hut":
				maker.hut()
			"beam":
				maker.barrier_beam(6.6, 1.1)
			"barrier":
				maker.road_barrier()
			"hedgehog":
				maker.hedgehog()
			"drum":
				maker.drum(SolidMaker.Tint.RED if offset.x > 4.8 else SolidMaker.Tint.PLAIN)
			"crate":
				maker.crate(Vector3(1.1, 0.7, 0.7), SolidMaker.Tint.OLIVE)
			_:
				maker.sandbags(
					[
						Vector2(-1.6, 0.9),
						Vector2(-1.6, -0.9),
						Vector2(1.6, -0.9),
						Vector2(1.6, 0.9)
					],
					6
				)


func _add_camp() -> void:
	var middle: Vector3 = _spot(_layout["camp"])
	var mesh: BlockMesh = _begin("Camp", middle)
	mesh.set_finest(0.8)
	var maker: CampMaker = CampMaker.new(mesh, 78)
	var things: Array[Array] = [
		["tent", Vector2(-6.0, -3.0), 0.3],
		["tent", Vector2(-5.0, 5.0), 0.15],
		["tent", Vector2(7.0, 3.0), 1.7],
		["crate", Vector2(0.0, -4.0), 0.2],
		["crate", Vector2(1.3, -4.2), 0.25],
		["crate", Vector2(0.6, -3.0), 1.4],
		["drum", Vector2(3.0, -5.0), 0.0],
		["drum", Vector2(3.7, -5.3), 0.0],
		["bags", Vector2(12.0, -4.0), 1.0],
		["bags", Vector2(-12.0, 1.0), -1.6]
	]
	for thing: Array in things:
		var offset: Vector2 = thing[1]
		var at: Vector3 = _ground(middle.x + offset.x, middle.z + offset.y)
		mesh.set_place(_stand(middle, at, thing[2], thing[0] != "bags"))
		mesh.set_dust(0.3, at.y - middle.y)
		match thing[0]:
			"tent":
				maker.tent()
			"crate":
				maker.crate(Vector3(1.1, 0.7, 0.7), SolidMaker.Tint.OLIVE)
			"drum":
				maker.drum(SolidMaker.Tint.PLAIN)
			_:
				maker.sandbags(
					[
						Vector2(-1.8, 1.2),
						Vector2(-1.8, -0.9),
						Vector2(1.8, -0.9),
						Vector2(1.8, 1.2)
					],
					5
				)


## Poles beside the road, some leaning, wires between them.
func _add_telegraph() -> void:
	var line: Curve2D = Curve2D.new()
	for place: Array in _layout["road"]:
		line.add_point(Vector2(place[0], place[1]))
	line.bake_interval = 1.0
	var last: PackedVector3Array = []
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = 5
	var poles: BlockMesh = null
	var wires: BlockMesh = null
	var part: Vector3 = Vector3.ZERO
	var count: int = int((line.get_baked_length() - 170.0) / 34.0)
	for number: int in count:
		var on: float = 16.0 + number * 34.0
		var way: Vector2 = (line.sample_baked(on + 1.0) - line.sample_baked(on - 1.0)).normalized()
		var side: Vector2 = line.sample_baked(on) + way.orthogonal() * 9.5
		var at: Vector3 = _ground(side.x, side.y)
		if number % 3 == 0:
			part = at
			poles = _begin("Poles%d" % (number / 3 + 1), part)
			poles.set_dust(0.0, 0.0)
			wires = _begin("Wires%d" % (number / 3 + 1), part)
			casts[casts.size() - 1] = false
			wires.set_finest(60.0)
		var lean: Basis = Basis(
			Vector3(dice.randfn(), 0.0, dice.randfn()).normalized(), 0.05 * dice.randf()
		)
		var turn: Basis = lean * Basis(Vector3.UP, PI / 2.0 - way.angle())
		var stand: Transform3D = Transform3D(turn, at - part)
		poles.set_place(stand)
		var ends: PackedVector3Array = CampMaker.new(poles, number).pole()
		var hung: PackedVector3Array = []
		for end: Vector3 in ends:
			hung.append(stand * end + part)
		if not last.is_empty() and number != 5:
			_hang_wires(wires, last, hung, part)
		last = hung


func _hang_wires(
	p_wires: BlockMesh, p_from: PackedVector3Array, p_to: PackedVector3Array, p_part: Vector3
) -> void:
	for wire: int in p_from.size():
		var last: Vector3 = p_from[wire] - p_part
		for step: int in range(1, 9):
			var along: float = step / 8.0
			var next: Vector3 = p_from[wire].lerp(p_to[wire], along) - p_part
			next.y -= 4.0 * along * (1.0 - along) * (0.55 + 0.12 * wire)
			p_wires.rod(last, next, 0.02, 0.02, SurfaceLayers.Layer.STEEL, 11, 3, false)
			last = next
