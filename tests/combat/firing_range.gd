class_name FiringRange
extends RefCounted
## A tank that belongs to a session of this machine alone, on ground of its own, and things to shoot
## at.

## The world.
var ground: VehicleGround = null
## The tank, and what it fires with.
var tank: Vehicle = null
var entity: Entity = null
var shells: Shells = null
var gun: VehicleGun = null
var coax: VehicleGun = null
var armour: VehicleArmour = null
## What hit what: [position, normal, surface, ammunition] of each hit.
var hits: Array[Array] = []


## Adds a tank at the origin that looks to -Z, with its gunner's seat taken.
func _init(p_parent: Node, p_preset: String = "tank") -> void:
	ground = VehicleGround.new(p_parent)
	ground.add_floor()
	var place: Node3D = Node3D.new()
	tank = VehicleGround.create(p_preset)
	place.add_child(tank)
	place.add_child(LocalSession.new())
	ground.view.add_child(place)
	entity = tank.get_node("Entity")
	shells = tank.get_node_or_null("Shells")
	armour = VehicleArmour.find_in(tank) as VehicleArmour
	if shells != null:
		shells.struck.connect(
			func(p_at: Vector3, p_normal: Vector3, p_on: StringName, p_by: Ammunition) -> void:
				hits.append([p_at, p_normal, p_on, p_by])
		)
	gun = tank.get_node_or_null("Turret/Gun/Muzzle/MainGun")
	coax = tank.get_node_or_null("Turret/Gun/Coax/CoaxGun")


## Lets the tank come to rest, and somebody take the gunner's seat.
func settle() -> void:
	await ground.run(1.5)
	if gun != null:
		gun.seat.take(LocalSession.SESSION)


## A wooden crate of the level kit's kind.
func add_crate(p_at: Vector3, p_mass: float = 20.0, p_size: float = 0.8) -> RigidBody3D:
	var crate: RigidBody3D = RigidBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3.ONE * p_size
	shape.shape = box
	crate.add_child(shape)
	crate.mass = p_mass
	crate.collision_layer = PhysicsLayers.PROPS
	crate.collision_mask = PhysicsLayers.ALL
	crate.physics_material_override = ContactMaterial.find(&"wood")
	crate.position = p_at
	ground.view.add_child(crate)
	return crate


## Somebody who stands, facing the tank.
func add_person(p_at: Vector3) -> Ragdoll:
	var person: Ragdoll = (load("res://scenes/actor/soldier.tscn") as PackedScene).instantiate()
	person.root_mode = RagdollMotor.ROOT_GROUNDED
	person.position = p_at
	ground.view.add_child(person)
	person.start()
	return person


## Points the gun at a place by turning the tank's turret at once.
func aim_at(p_place: Vector3) -> void:
	var turret: VehicleTurret = tank.get_node("Turret")
	turret.set_stabilised(false)
	var from: Vector3 = (tank.get_node("Turret/Gun") as Node3D).global_position
	var way: Vector3 = tank.global_basis.inverse() * (p_place - from)
	var angles: Vector2 = Shells.angles_of(way)
	turret.place(angles.x, angles.y)


## Commands in the name of this session.
func command(p_name: StringName, p_values: PackedFloat32Array = []) -> void:
	entity.send_command(p_name, p_values)


## What rays and blasts ask.
func space() -> PhysicsDirectSpaceState3D:
	return tank.get_world_3d().direct_space_state


func free_all() -> void:
	ground.free_all()
