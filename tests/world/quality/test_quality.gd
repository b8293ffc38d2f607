extends TestCase
## Which tier of quality fits a machine, and what it changes.

var _tier: QualityTier = null


func before_each() -> void:
	_tier = Quality.tier


func after_each() -> void:
	Quality.use(_tier, get_tree().root)


func test_a_machine_without_a_graphics_card_gets_the_tier_that_costs_least() -> void:
	var other: RenderingDevice.DeviceType = RenderingDevice.DEVICE_TYPE_OTHER
	equal(Quality.fitting("llvmpipe (LLVM 21.1.8, 256 bits)", other), "low")
	equal(Quality.fitting("SwiftShader Device", RenderingDevice.DEVICE_TYPE_CPU), "low")
	equal(Quality.fitting("whatever", RenderingDevice.DEVICE_TYPE_CPU), "low")
	equal(Quality.fitting("Mesa Intel(R) UHD Graphics 620", other), "medium")
	equal(Quality.fitting("NVIDIA GeForce RTX 3060/PCIe/SSE2", other), "high")
	equal(Quality.fitting("AMD Something", RenderingDevice.DEVICE_TYPE_DISCRETE_GPU), "high")


func test_each_tier_costs_more_than_the_one_before() -> void:
	var last: QualityTier = null
	for name: String in Quality.NAMES:
		var tier: QualityTier = Quality.find(name)
		equal(tier.name, name)
		if last != null:
			is_true(tier.render_scale >= last.render_scale)
			is_true(tier.shadow_pixels > last.shadow_pixels)
			is_true(tier.lod_pixels < last.lod_pixels)
			is_true(tier.scatter >= last.scatter)
		last = tier


func test_a_level_follows_the_tier() -> void:
	var level: Level = LevelStore.instantiate("yard")
	level.prepare()
	add_child(level)
	var window: SubViewport = SubViewport.new()
	add_child(window)
	Quality.use(QualityTier.low(), window)
	equal(window.scaling_3d_scale, 0.5)
	equal(Quality.tier.name, "low")
	level.free()
	window.free()


func test_compressed_layers_are_unpacked_at_the_size_asked_for() -> void:
	var layers: CompressedTexture2DArray = load(SurfaceLayers.ALBEDO)
	var images: Array[Image] = SurfaceTextures.unpack(layers.load_path, 256)
	equal(images.size(), SurfaceLayers.EDGE_M.size())
	for index: int in images.size():
		equal(images[index].get_size(), Vector2i(256, 256))
		is_true(images[index].has_mipmaps())
		var sum: float = 0.0
		for at: int in 1024:
			var pixel: Color = images[index].get_pixel(at % 32 * 8, at / 32 * 8)
			sum += pixel.srgb_to_linear().g
		almost_equal(sum / 1024.0, SurfaceLayers.AVERAGE[index].g, 0.1)


func test_files_that_are_no_layers_are_left_as_they_are() -> void:
	equal(SurfaceTextures.unpack("res://project.godot", 256).size(), 0)
	equal(SurfaceTextures.unpack("res://no such file", 256).size(), 0)
