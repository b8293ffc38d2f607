extends TestCase
## Effects that are drawn while a client loads.


func test_without_a_display_it_ends_at_once() -> void:
	var warm_up: EffectWarmUp = EffectWarmUp.new()
	var ended: Array[bool] = []
	warm_up.finished.connect(func() -> void: ended.append(true))
	add_child(warm_up)
	await process_frames(3)
	equal(ended.size(), 1)
	is_false(is_instance_valid(warm_up))
