extends TestCase
## Lamps that are lit at dusk.

const SKY: PackedScene = preload("res://scenes/world/sky/world_sky.tscn")


func test_a_lamp_is_lit_as_far_as_the_sky_says() -> void:
	var lamp: WorldLamp = WorldLamp.new()
	add_child(lamp)
	is_false(lamp.visible)
	get_tree().call_group(WorldSky.LAMPS, &"set_lamp_strength", 0.5)
	is_true(lamp.visible)
	equal(lamp.light_energy, 1.0)
	lamp.lit_energy = 4.0
	equal(lamp.light_energy, 2.0)
	lamp.set_lamp_strength(0.0)
	is_false(lamp.visible)
	lamp.free()


func test_a_lamp_that_comes_at_night_is_lit() -> void:
	var sky: WorldSky = SKY.instantiate()
	add_child(sky)
	sky.show_conditions(23.0, WorldConditions.Weather.CLEAR)
	var lamp: WorldLamp = WorldLamp.new()
	add_child(lamp)
	equal(lamp.light_energy, lamp.lit_energy)
	lamp.free()
	sky.free()


func test_a_fire_flickers_around_its_energy() -> void:
	var fire: WorldLamp = WorldLamp.new()
	fire.flicker = 0.3
	add_child(fire)
	fire.set_lamp_strength(1.0)
	var least: float = INF
	var most: float = -INF
	for _frame: int in 200:
		fire._process(1.0 / 60.0)
		least = minf(least, fire.light_energy)
		most = maxf(most, fire.light_energy)
	is_true(least < 1.8 and least > 1.3, str(least))
	is_true(most > 2.2 and most < 2.7, str(most))
	fire.free()
