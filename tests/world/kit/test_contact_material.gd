extends TestCase
## What things are made of: friction, dust and sounds by a key.


func test_the_kits_materials_have_the_key_of_their_name() -> void:
	for file: String in ResourceLoader.list_directory(ContactMaterial.FOLDER):
		var material: ContactMaterial = ContactMaterial.find(file.get_basename())
		equal(material.key, file.get_basename())
		is_true(material.friction > 0.0)
	is_null(ContactMaterial.find(&"../../x"))
	equal(ContactMaterial.named(&"../../x").key, String(ContactMaterial.NO_KEY))


func test_every_surface_has_a_material() -> void:
	for layer: int in SurfaceLayers.KEY.size():
		var key: StringName = SurfaceLayers.key_of(layer)
		equal(ContactMaterial.named(key).key, String(key))
	for key: StringName in HeightField.KEYS:
		equal(ContactMaterial.named(key).key, String(key))


func test_bodies_say_what_they_are_made_of() -> void:
	var scene: PackedScene = load("res://scenes/world/props/crate.tscn")
	var crate: RigidBody3D = scene.instantiate()
	equal(ContactMaterial.key_of(crate), &"wood")
	crate.free()
	var door: Door = Door.new()
	equal(ContactMaterial.key_of(door), &"wood")
	door.layer = SurfaceLayers.Layer.STEEL
	equal(ContactMaterial.key_of(door), &"metal")
	door.free()
	var bare: StaticBody3D = StaticBody3D.new()
	equal(ContactMaterial.key_of(bare), ContactMaterial.NO_KEY)
	bare.free()


func test_a_block_rubs_as_its_surface_does() -> void:
	var block: Block = Block.new()
	block.surface = SurfaceLayers.Layer.STEEL
	add_child(block)
	equal(ContactMaterial.at(block, Vector3.ZERO).key, "metal")
	equal(block.physics_material_override, ContactMaterial.find(&"metal"))
	block.surface = SurfaceLayers.Layer.SAND
	equal(block.physics_material_override, ContactMaterial.find(&"sand"))
	almost_equal(ContactMaterial.at(block, Vector3.ZERO).dust, 1.0, 1e-6)


func test_a_designers_own_material_stays() -> void:
	var block: Block = Block.new()
	var ice: PhysicsMaterial = PhysicsMaterial.new()
	ice.friction = 0.05
	block.physics_material_override = ice
	add_child(block)
	equal(block.physics_material_override, ice)
