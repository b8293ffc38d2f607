extends TestCase
## Suns have simple shadows while walls are shown, whenever their level is loaded.


func _sun(p_mode: DirectionalLight3D.ShadowMode) -> DirectionalLight3D:
	var sun: DirectionalLight3D = DirectionalLight3D.new()
	sun.directional_shadow_mode = p_mode
	return sun


func test_suns_of_now_and_later_and_as_they_were() -> void:
	var first: DirectionalLight3D = _sun(DirectionalLight3D.SHADOW_PARALLEL_4_SPLITS)
	var level: Node3D = Node3D.new()
	add_child(first)
	var suns: ObliqueSuns = ObliqueSuns.new()
	suns.begin(get_tree())
	equal(first.directional_shadow_mode, DirectionalLight3D.SHADOW_ORTHOGONAL)
	var later: DirectionalLight3D = _sun(DirectionalLight3D.SHADOW_PARALLEL_2_SPLITS)
	level.add_child(later)
	add_child(level)
	equal(later.directional_shadow_mode, DirectionalLight3D.SHADOW_ORTHOGONAL)
	remove_child(level)
	add_child(level)
	first.free()
	suns.end()
	equal(later.directional_shadow_mode, DirectionalLight3D.SHADOW_PARALLEL_2_SPLITS)
	var after: DirectionalLight3D = _sun(DirectionalLight3D.SHADOW_PARALLEL_2_SPLITS)
	level.add_child(after)
	equal(after.directional_shadow_mode, DirectionalLight3D.SHADOW_PARALLEL_2_SPLITS)
	level.free()
	suns.end()
