extends TestCase
## Every block of a hall: faces that are sound, solid boxes, no warnings as it comes, and the same
## from the same numbers.


func test_each_has_faces_and_is_solid() -> void:
	for block: KitBlock in _all():
		add_child(block)
		var mesh: BlockMesh = KitChecks.mesh_of(block)
		var name: String = block.get_script().get_global_name()
		is_true(mesh.get_triangle_count() > 3, name)
		KitChecks.check_sound(self, block, mesh)
		equal(mesh.get_solid_count() > 0, not (block is FloorMarking or block is CeilingLamp), name)
		equal(block.get_child_count(true), mesh.get_solid_count(), name)
		block.free()


func test_each_leaves_the_place_of_a_mesh_as_it_was() -> void:
	KitChecks.check_place(self, _all())


func test_the_same_numbers_give_the_same_goods() -> void:
	var sizes: Dictionary[int, bool] = {}
	for variant: int in [1, 1, 2, 3]:
		var rack: PalletRack = PalletRack.new()
		rack.variant = variant
		sizes[hash(KitChecks.mesh_of(rack).get_points())] = true
		rack.free()
	equal(sizes.size(), 3)


func test_a_server_has_the_boxes_that_clients_see() -> void:
	KitChecks.check_boxes(self, _all())


func test_what_people_cannot_use_warns() -> void:
	var hall: SteelHall = SteelHall.new()
	hall.south = [Rect2(1.0, 0.0, 0.6, 2.1)]
	contains(hall._get_configuration_warnings()[0], "do not fit through a door")
	hall.south = [Rect2(18.0, 0.0, 4.0, 3.0)]
	contains(hall._get_configuration_warnings()[0], "reaches beyond its wall")
	hall.south = []
	hall.bays = 1
	contains(hall._get_configuration_warnings()[0], "choose more bays")
	hall.free()
	var ramp: Ramp = Ramp.new()
	ramp.size = Vector3(2.0, 3.0, 3.0)
	contains(ramp._get_configuration_warnings()[0], "slide down")
	ramp.free()
	var gallery: Gallery = Gallery.new()
	gallery.front = [Vector2(7.0, 9.0)]
	contains(gallery._get_configuration_warnings()[0], "must lie within the length")
	gallery.free()
	var stairs: SteelStairs = SteelStairs.new()
	stairs.rise = 0.25
	stairs.going = 0.35
	contains(stairs._get_configuration_warnings()[0], "here it is 0.85 m")
	stairs.free()


func test_a_lamp_shines_down_from_below_its_shade() -> void:
	var lamp: CeilingLamp = CeilingLamp.new()
	lamp.drop = 1.5
	var light: LampLight = lamp.get_lamps()[0]
	almost_equal(light.position, Vector3(0.0, -1.8, 0.0), 1e-4)
	almost_equal(light.way, Vector3.DOWN, 1e-4)
	is_true(light.angle < PI / 2.0, "it lights the ceiling above its shade")
	lamp.free()


func _all() -> Array[KitBlock]:
	var hall: SteelHall = SteelHall.new()
	hall.south = [Rect2(8.0, 0.0, 4.0, 4.0), Rect2(2.0, 0.0, 1.0, 2.1), Rect2(15.0, 3.0, 3.0, 1.0)]
	var open: ShippingContainer = ShippingContainer.new()
	open.is_open = true
	var empty: Pallets = Pallets.new()
	empty.height = 0.0
	var stripes: FloorMarking = FloorMarking.new()
	stripes.shape = FloorMarking.Shape.STRIPES
	var hooped: Ladder = Ladder.new()
	hooped.has_hoops = true
	return [
		hall,
		open,
		ShippingContainer.new(),
		Pallets.new(),
		empty,
		PalletRack.new(),
		Gallery.new(),
		SteelStairs.new(),
		Ramp.new(),
		Ladder.new(),
		hooped,
		CeilingLamp.new(),
		FloorMarking.new(),
		stripes,
		SheetFence.new(),
	]
