extends TestCase
## What the level kit's dock offers: each can be made, is found by its words, and stands on the
## ground.


func test_each_can_be_made() -> void:
	var titles: Dictionary[String, bool] = {}
	for item: RefCounted in KitCatalogue.items():
		is_false(titles.has(item.title), item.title)
		titles[item.title] = true
		var node: Node3D = item.make()
		add_child(node)
		for property: StringName in item.values:
			equal(node.get(property), item.values[property], item.title)
		if node.has_method(&"contact_key"):
			equal(node._get_configuration_warnings(), PackedStringArray(), item.title)
		node.free()


func test_search() -> void:
	var found: Callable = func(search: String) -> PackedStringArray:
		var titles: PackedStringArray = []
		for item: RefCounted in KitCatalogue.items():
			if item.fits(search):
				titles.append(item.title)
		return titles
	equal(found.call("HOUSE"), PackedStringArray(["House", "Shop", "Closed house"]))
	equal(found.call("wall door"), PackedStringArray(["Wall with door"]))
	equal(found.call("no such thing"), PackedStringArray())
	equal(found.call("").size(), KitCatalogue.items().size())


func test_blocks_stand_on_the_ground() -> void:
	for item: RefCounted in KitCatalogue.items():
		var node: Node3D = item.make()
		if item.source.ends_with("/kit/block.gd"):
			almost_equal(item.lift, node.get(&"size").y / 2.0, 1e-5, item.title)
		node.free()
