extends TestCase
## Every block of a stage: faces that are sound, solid boxes, no warnings as it comes, and the same
## boxes on a server as on a client.


func test_each_has_faces_that_are_sound() -> void:
	for block: KitBlock in _all():
		add_child(block)
		var mesh: BlockMesh = KitChecks.mesh_of(block)
		var name: String = block.get_script().get_global_name()
		equal(mesh.get_triangle_count() > 3, not (block is Backdrop), name)
		KitChecks.check_sound(self, block, mesh)
		var is_solid: bool = not (
			block is StageLight or (block is Loudspeakers and not block.is_standing)
		)
		equal(mesh.get_solid_count() > 0, is_solid, name)
		block.free()


func test_each_leaves_the_place_of_a_mesh_as_it_was() -> void:
	KitChecks.check_place(self, _all())


func test_a_server_has_the_boxes_that_clients_see() -> void:
	KitChecks.check_boxes(self, _all())


func test_a_podium_carries_at_its_height() -> void:
	var podium: StagePodium = StagePodium.new()
	podium.size = Vector3(4.0, 1.2, 3.0)
	var mesh: BlockMesh = KitChecks.mesh_of(podium)
	almost_equal(mesh.get_solid_size(0), podium.size, 1e-4)
	almost_equal(mesh.get_solid_place(0).origin, Vector3(0.0, 0.6, 0.0), 1e-4)
	podium.free()


func test_people_go_through_a_curtain_that_is_not_solid() -> void:
	var curtain: Curtain = Curtain.new()
	equal(KitChecks.mesh_of(curtain).get_solid_count(), 1)
	curtain.is_solid = false
	equal(KitChecks.mesh_of(curtain).get_solid_count(), 0)
	curtain.free()


func test_cloth_has_its_size_and_its_folds() -> void:
	var cloth: Drapery = Drapery.new(Vector2(3.0, 2.0), 0.5, 0.1)
	var box: AABB = AABB(cloth.points[0], Vector3.ZERO)
	for point: Vector3 in cloth.points:
		box = box.expand(point)
	almost_equal(box.size.x, 3.0, 1e-4)
	almost_equal(box.size.y, 2.0, 1e-4)
	is_true(box.size.z > 0.15 and box.size.z <= 0.2, "%s" % box)
	equal(cloth.normals.size(), cloth.points.size())
	for normal: Vector3 in cloth.normals:
		almost_equal(normal.length(), 1.0, 1e-3)
	is_true(Drapery.new(Vector2(3.0, 2.0), 0.5, 0.1).points == cloth.points, "it differs")


func test_a_backdrop_without_a_picture_warns() -> void:
	var back: Backdrop = Backdrop.new()
	equal(back._get_configuration_warnings(), PackedStringArray())
	back.picture = null
	contains(back._get_configuration_warnings()[0], "choose a picture")
	back.free()


func test_values_out_of_range_are_taken_as_the_nearest() -> void:
	var truss: Truss = Truss.new()
	truss.length = -3.0
	equal(truss.length, 0.5)
	truss.free()
	var row: SeatRow = SeatRow.new()
	row.count = 100_000
	equal(row.count, 60)
	row.free()
	var podium: StagePodium = StagePodium.new()
	podium.size = Vector3.ZERO
	equal(podium.size, Vector3(1.0, 0.2, 1.0))
	podium.free()


func _all() -> Array[KitBlock]:
	var standing: Loudspeakers = Loudspeakers.new()
	standing.is_standing = true
	return [
		StagePodium.new(),
		Curtain.new(),
		Backdrop.new(),
		Truss.new(),
		SeatRow.new(),
		CrowdBarrier.new(),
		Loudspeakers.new(),
		standing,
		FlightCase.new(),
		MixingDesk.new(),
		StageLight.new(),
		CameraScreen.new(),
	]
