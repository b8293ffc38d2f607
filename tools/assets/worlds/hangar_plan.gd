extends RefCounted
## Where everything in the hangar stands. The floor is 40 x 24 m around the origin, its middle free
## from -8 to 9 m in x and from -3 to 11 m in z. +Z is south, +X is east.

const SIZE: Vector3 = Vector3(40.0, 7.2, 24.0)
const TINT: Dictionary = SurfaceTints.Tint
## Half the yard, x and z, m.
const YARD: Vector2 = Vector2(36.0, 30.0)
## Where the first person starts.
const START: Vector3 = Vector3(-7.6, 0.0, 0.0)

## Crates: name of the scene, place of the middle of the bottom, turn in degrees.
var crates: Array[Array] = []

var _root: Node3D = null
var _count: Dictionary[String, int] = {}


## Makes everything; returns the root.
func lay_out() -> Node3D:
	_root = Node3D.new()
	_root.name = "HangarBlocks"
	_shell()
	_gallery_and_dock()
	_racks()
	_containers()
	_goods()
	_markings()
	_lamps()
	_yard()
	_props()
	return _root


func _add(p_node: KitBlock, p_at: Vector3, p_turn_degrees: float = 0.0) -> void:
	var kind: String = (p_node.get_script() as GDScript).get_global_name()
	_count[kind] = _count.get(kind, 0) + 1
	p_node.name = "%s%d" % [kind, _count[kind]]
	p_node.transform = Transform3D(Basis(Vector3.UP, deg_to_rad(p_turn_degrees)), p_at)
	_root.add_child(p_node)


func _shell() -> void:
	var hall: SteelHall = SteelHall.new()
	hall.size = SIZE
	hall.rise = 2.0
	hall.bays = 8
	# The great gate to the south, windows high up between the frames.
	var south: Array[Rect2] = [Rect2(16.2, 0.0, 8.0, 5.0)]
	var north: Array[Rect2] = [Rect2(5.7, 0.0, 1.1, 2.1)]
	for bay: int in 8:
		var x: float = 1.0 + 5.0 * bay
		if bay < 2 or bay > 5:
			south.append(Rect2(x, 3.9, 3.4, 1.5))
		north.append(Rect2(x, 4.9, 3.4, 1.4))
	hall.south = south
	hall.north = north
	hall.west = [Rect2(3.0, 4.4, 3.6, 1.6), Rect2(15.6, 0.0, 4.6, 4.4), Rect2(9.0, 4.4, 3.6, 1.6)]
	hall.east = [Rect2(2.6, 0.0, 1.1, 2.1), Rect2(5.0, 4.4, 5.0, 1.6), Rect2(14.0, 4.4, 5.0, 1.6)]
	_add(hall, Vector3.ZERO)


func _gallery_and_dock() -> void:
	var gallery: Gallery = Gallery.new()
	gallery.size = Vector3(21.5, 3.2, 3.2)
	gallery.front = [Vector2(1.0, 2.4), Vector2(17.6, 18.3)]
	gallery.is_open_right = true
	_add(gallery, Vector3(-10.0, 0.0, -8.3))
	var up: SteelStairs = SteelStairs.new()
	up.steps = 19
	up.rise = 3.2 / 19.0
	up.width = 1.3
	_add(up, Vector3(-8.3, 0.0, -8.3 + 19.0 * 0.28))
	var ladder: Ladder = Ladder.new()
	ladder.height = 3.2
	_add(ladder, Vector3(7.95, 0.0, -8.2))
	var dock: Block = Block.new()
	dock.size = Vector3(7.0, 1.2, 6.6)
	_add(dock, Vector3(16.4, 0.6, -8.6))
	var edge: FloorMarking = FloorMarking.new()
	edge.size = Vector2(4.2, 0.3)
	edge.shape = FloorMarking.Shape.STRIPES
	edge.line = 0.2
	_add(edge, Vector3(17.7, 1.2, -5.5))
	var ramp: Ramp = Ramp.new()
	ramp.size = Vector3(2.4, 1.2, 7.2)
	_add(ramp, Vector3(14.2, 0.0, 1.9))
	var more: SteelStairs = SteelStairs.new()
	more.steps = 12
	more.rise = 2.0 / 12.0
	more.width = 1.3
	_add(more, Vector3(11.5 + 12.0 * 0.28, 1.2, -10.2), 90.0)
	var climb: Ladder = Ladder.new()
	climb.height = 6.9
	climb.has_hoops = true
	_add(climb, Vector3(-19.75, 0.0, -1.2), 90.0)


func _racks() -> void:
	var places: Array[Vector3] = [
		Vector3(-18.9, 0.0, -10.55), Vector3(-18.9, 0.0, -5.6), Vector3(-18.9, 0.0, -4.4)
	]
	for number: int in places.size():
		var rack: PalletRack = PalletRack.new()
		rack.bays = 3 if number == 0 else 2
		rack.variant = 3 + number * 7
		rack.levels = 3 if number == 0 else 2
		rack.pitch = 1.5
		# The second and the third stand back to back.
		var turn: float = 180.0 if number == 1 else 0.0
		var at: Vector3 = places[number]
		if turn > 0.0:
			at += Vector3(5.6, 0.0, -1.1)
		_add(rack, at, turn)


func _containers() -> void:
	var rows: Array[Array] = [
		[Vector3(15.9, 0.0, 10.3), 180.0, TINT.BLUE, false],
		[Vector3(15.9, 2.59, 10.35), 180.0, TINT.RED, false],
		[Vector3(16.2, 0.0, 6.3), 180.0, TINT.DARK_GREEN, true],
		[Vector3(-27.5, 0.0, 16.0), 90.0, TINT.ORANGE, false],
		[Vector3(24.5, 0.0, 17.5), 20.0, TINT.NAVY, false],
	]
	for row: Array in rows:
		var container: ShippingContainer = ShippingContainer.new()
		container.tint = row[2]
		container.is_open = row[3]
		_add(container, row[0], row[1])


func _goods() -> void:
	var rows: Array[Array] = [
		[Vector3(-5.5, 0.0, -10.8), 0.0, 4, 1.3, 5],
		[Vector3(1.2, 0.0, -10.9), 0.0, 3, 1.1, 21],
		[Vector3(-12.0, 0.0, 9.9), 0.0, 2, 1.2, 14],
		[Vector3(-9.0, 0.0, 10.9), 0.0, 1, 0.0, 2],
		[Vector3(16.0, 1.2, -11.0), 0.0, 3, 1.3, 33],
		[Vector3(18.9, 0.0, -3.2), 90.0, 2, 1.0, 8],
		[Vector3(10.6, 0.0, -10.6), 0.0, 1, 0.0, 4],
		[Vector3(-4.0, 3.2, -11.0), 0.0, 2, 0.9, 17],
		[Vector3(17.5, 0.16, 6.3), 90.0, 1, 1.2, 19],
		[Vector3(8.0, 0.0, 15.4), 12.0, 2, 1.1, 41],
		[Vector3(-13.0, 0.0, 14.2), 90.0, 1, 0.0, 6],
	]
	for row: Array in rows:
		var pallets: Pallets = Pallets.new()
		pallets.count = row[2]
		pallets.height = row[3]
		pallets.variant = row[4]
		_add(pallets, row[0], row[1])
	for row: Array in [
		[Vector3(-16.5, 0.0, 10.9), 4, TINT.BLUE],
		[Vector3(5.6, 0.0, -11.2), 2, TINT.RED],
		[Vector3(-6.8, 0.0, 13.6), 3, TINT.YELLOW],
	]:
		var barrels: Barrels = Barrels.new()
		barrels.count = row[1]
		barrels.tint = row[2]
		_add(barrels, row[0])


func _markings() -> void:
	_mark(Vector3(0.3, 0.0, 3.9), Vector2(17.0, 13.6), FloorMarking.Shape.FRAME, 0.12)
	_mark(Vector3(0.2, 0.0, 11.55), Vector2(8.0, 0.7), FloorMarking.Shape.STRIPES, 0.3)
	_mark(Vector3(-19.3, 0.0, 6.0), Vector2(0.7, 4.4), FloorMarking.Shape.STRIPES, 0.3)
	for x: float in [-5.0, -1.0, 3.0]:
		_mark(Vector3(x + 0.8, 0.0, -10.2), Vector2(3.7, 3.0), FloorMarking.Shape.FRAME, 0.08)
	_mark(Vector3(-10.5, 0.0, 3.0), Vector2(0.12, 14.0), FloorMarking.Shape.AREA, 0.1)
	_mark(Vector3(11.0, 0.0, 3.0), Vector2(0.12, 14.0), FloorMarking.Shape.AREA, 0.1)
	_mark(Vector3(7.95, 0.0, -7.5), Vector2(1.0, 1.0), FloorMarking.Shape.STRIPES, 0.12)


func _mark(p_at: Vector3, p_size: Vector2, p_shape: FloorMarking.Shape, p_line: float) -> void:
	var marking: FloorMarking = FloorMarking.new()
	marking.size = p_size
	marking.shape = p_shape
	marking.line = p_line
	_add(marking, p_at)


func _lamps() -> void:
	for x: float in [-15.0, -5.0, 5.0, 15.0]:
		for z: float in [-6.0, 6.0]:
			var lamp: CeilingLamp = CeilingLamp.new()
			lamp.drop = 0.6
			_add(lamp, Vector3(x, 6.65, z))
	for x: float in [-9.0, 9.4]:
		var post: StreetLamp = StreetLamp.new()
		post.height = 5.5
		_add(post, Vector3(x, 0.0, 15.2))
	var side: StreetLamp = StreetLamp.new()
	_add(side, Vector3(-24.0, 0.0, 2.4))


## An apron of concrete, ground around it, a fence and something to look at.
func _yard() -> void:
	_slab(Vector3(0.0, -0.15, 0.0), Vector3(52.0, 0.28, 40.0), SurfaceLayers.Layer.CONCRETE)
	var whole: Vector3 = Vector3(YARD.x * 2.0, 0.4, YARD.y * 2.0)
	_slab(Vector3(0.0, -0.26, 0.0), whole, SurfaceLayers.Layer.DIRT)
	_slab(Vector3(0.2, -0.13, 24.9), Vector3(9.0, 0.26, 10.2), SurfaceLayers.Layer.ASPHALT)
	_fence(Vector3(-YARD.x, -0.1, -YARD.y), 0.0, 2.0 * YARD.x)
	_fence(Vector3(YARD.x, -0.1, -YARD.y), -90.0, 2.0 * YARD.y)
	_fence(Vector3(YARD.x, -0.1, YARD.y), 180.0, YARD.x - 4.6)
	_fence(Vector3(-4.4, -0.1, YARD.y), 180.0, YARD.x - 4.4)
	_fence(Vector3(-YARD.x, -0.1, YARD.y), 90.0, 2.0 * YARD.y)
	var gate: Wall = Wall.new()
	gate.size = Vector3(9.4, 2.6, 0.1)
	gate.surface = SurfaceLayers.Layer.CORRUGATED
	gate.tint = SurfaceTints.Tint.BLUE
	gate.cap = false
	_add(gate, Vector3(-4.5, -0.1, YARD.y + 0.2))
	var rubble: Rubble = Rubble.new()
	_add(rubble, Vector3(29.0, -0.06, -20.0))


func _slab(p_at: Vector3, p_size: Vector3, p_surface: SurfaceLayers.Layer) -> void:
	var slab: Block = Block.new()
	slab.size = p_size
	slab.surface = p_surface
	_add(slab, p_at)


func _fence(p_at: Vector3, p_turn: float, p_length: float) -> void:
	var fence: SheetFence = SheetFence.new()
	fence.length = p_length
	_add(fence, p_at, p_turn)


## Crates to push, and piles of them to run into.
func _props() -> void:
	# A pile in the way of the first person.
	for row: Array in [
		[0.03, 0.0], [0.55, 0.0], [1.07, 0.0], [0.29, 0.5], [0.81, 0.5], [0.55, 1.0]
	]:
		_crate("crate", START + Vector3(row[0], row[1], 3.3), 0.0)
	for number: int in 3:
		_crate("crate_large", Vector3(9.9 - 0.9 * (number % 2), 0.8 * (number / 2), 10.2), 4.0)
	_crate("crate_large", Vector3(-9.4, 0.0, 2.6), 12.0)
	for number: int in 6:
		var row: int = number if number < 3 else number - 3
		var up: float = 0.0 if number < 3 else 0.5
		var shift: float = 0.0 if number < 3 else 0.27
		if number < 5:
			_crate("crate", Vector3(-9.6, up, 5.0 + 0.54 * row + shift), 0.0)
	_crate("crate", Vector3(-7.2, 0.0, 9.2), 25.0)
	_crate("crate", Vector3(6.4, 0.0, -1.8), -18.0)
	for number: int in 3:
		_crate("crate", Vector3(12.9, 1.2, -6.6 - 0.7 * number), 5.0 * number)
	for number: int in 4:
		_crate("crate_small", Vector3(9.3 + 0.34 * (number % 2), 0.3 * (number / 2), 8.7), 3.0)
	_crate("crate_small", Vector3(-9.4, 0.8, 2.6), 30.0)
	_crate("crate_small", Vector3(-8.6, 0.0, 3.4), 50.0)
	_crate("crate_small", Vector3(6.1, 0.0, -2.6), 10.0)


func _crate(p_scene: String, p_at: Vector3, p_turn: float) -> void:
	crates.append([p_scene, p_at, p_turn])
