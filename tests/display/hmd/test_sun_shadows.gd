extends TestCase
## Shadows of suns, off and on again.


func test_only_those_that_were_on_come_back() -> void:
	var root: Node3D = Node3D.new()
	var lit: DirectionalLight3D = DirectionalLight3D.new()
	lit.shadow_enabled = true
	var plain: DirectionalLight3D = DirectionalLight3D.new()
	root.add_child(lit)
	root.add_child(plain)
	var suns: SunShadows = SunShadows.new()
	suns.set_shown(root, false)
	is_false(lit.shadow_enabled)
	suns.set_shown(root, false)
	suns.set_shown(root, true)
	is_true(lit.shadow_enabled)
	is_false(plain.shadow_enabled)
	suns.set_shown(root, false)
	root.free()
	suns.restore()
