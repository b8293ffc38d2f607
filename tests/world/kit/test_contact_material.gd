extends TestCase
## What things are made of: keys of sounds and dust.


func test_the_kits_materials_have_the_key_of_their_name() -> void:
	for file: String in ResourceLoader.list_directory(ContactMaterial.FOLDER):
		var material: ContactMaterial = ContactMaterial.find(file.get_basename())
		equal(material.key, file.get_basename())
		is_true(material.friction > 0.0)
	is_null(ContactMaterial.find(&"../../x"))


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
