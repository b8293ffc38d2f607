extends TestCase
## Parameters without sense are refused by name.


func test_the_presets_make_sense() -> void:
	for preset: String in DirAccess.get_directories_at("res://scenes/vehicle"):
		if not FileAccess.file_exists("res://scenes/vehicle/%s/%s.tscn" % [preset, preset]):
			continue
		var vehicle: Vehicle = VehicleGround.create(preset)
		equal(vehicle._get_configuration_warnings(), PackedStringArray(), preset)
		equal(
			VehicleCheck.find_fault(vehicle.parameters, VehicleParameters.GearKind.RAYS), "", preset
		)
		vehicle.free()


func test_each_fault_is_named() -> void:
	var faults: Dictionary[String, Callable] = {
		"mass must be above zero": func(p: VehicleParameters) -> void: p.mass = 0.0,
		"mass must be a finite number": func(p: VehicleParameters) -> void: p.mass = NAN,
		"mass must be above that of all spheres":
		func(p: VehicleParameters) -> void: p.mass = 9000.0,
		"stiffness must be above zero, found -5":
		func(p: VehicleParameters) -> void: p.spheres[2].stiffness = -5.0,
		"spheres[1]: damping must not be below zero":
		func(p: VehicleParameters) -> void: p.spheres[1].damping = -1.0,
		"spheres[0]: position must be finite":
		func(p: VehicleParameters) -> void: p.spheres[0].position = Vector3(NAN, 0.0, 0.0),
		"spheres[3]: the wheel is missing": func(p: VehicleParameters) -> void: p.spheres[3] = null,
		"spheres must have two wheels": func(p: VehicleParameters) -> void: p.spheres.clear(),
		"brake_force must not be below zero":
		func(p: VehicleParameters) -> void: p.brake_force = -1.0,
		"engine_curve must be sorted":
		func(p: VehicleParameters) -> void: p.engine_curve[1] = Vector2(100.0, 5.0),
		"gearbox_forward and gearbox_reverse must have a gear":
		func(p: VehicleParameters) -> void: p.gearbox_reverse = PackedFloat32Array(),
		"gearbox_forward and gearbox_reverse must be above zero":
		func(p: VehicleParameters) -> void: p.gearbox_forward[0] = NAN,
		"inertia_box must be above zero": func(p: VehicleParameters) -> void: p.inertia_box.y = 0.0,
	}
	for text: String in faults:
		var parameters: VehicleParameters = _tank_parameters()
		equal(VehicleCheck.find_fault(parameters, parameters.gear_kind), "", text)
		faults[text].call(parameters)
		contains(VehicleCheck.find_fault(parameters, parameters.gear_kind), text)


func test_a_vehicle_without_sense_stays_where_it_is_and_the_session_goes_on() -> void:
	var ground: VehicleGround = VehicleGround.new(self)
	ground.add_floor()
	var vehicle: Vehicle = VehicleGround.create("tank")
	vehicle.parameters = _tank_parameters()
	vehicle.parameters.mass = -3.0
	ground.view.add_child(vehicle)
	var other: Vehicle = ground.add_vehicle(
		"tank",
		VehicleParameters.GearKind.SPHERES,
		Transform3D(Basis.IDENTITY, Vector3(9.0, 0.0, 0.0))
	)
	other.input.throttle = 1.0
	await ground.run(2.0)
	contains(vehicle.fault, "mass")
	is_true(VehicleGround.speed_of(other) > 1.0)
	ground.free_all()


func _tank_parameters() -> VehicleParameters:
	var vehicle: Vehicle = VehicleGround.create("tank")
	var parameters: VehicleParameters = vehicle.parameters.duplicate_deep(
		Resource.DEEP_DUPLICATE_ALL
	)
	vehicle.free()
	return parameters
