extends TestCase
## The layers in code are those that the project names, and those of the scenes.


func test_the_project_names_the_layers() -> void:
	var layers: Dictionary[String, int] = {
		"static": PhysicsLayers.STATIC,
		"people": PhysicsLayers.PEOPLE,
		"props": PhysicsLayers.PROPS,
	}
	var named: int = 0
	for number: int in range(1, 33):
		var name: String = ProjectSettings.get_setting("layer_names/3d_physics/layer_%d" % number)
		if name != "":
			named |= 1 << (number - 1)
			equal(layers.get(name), 1 << (number - 1), name)
	equal(named, PhysicsLayers.ALL)
