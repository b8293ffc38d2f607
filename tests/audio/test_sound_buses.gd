extends TestCase
## Buses and what a user sets of them.


func after_each() -> void:
	SoundBuses.set_volume(SoundBuses.WORLD, 1.0)
	SoundBuses.set_limited(true)


func test_they_are_made_once() -> void:
	SoundBuses.make()
	var count: int = AudioServer.bus_count
	SoundBuses.make()
	equal(AudioServer.bus_count, count)
	for bus: StringName in SoundBuses.SETTABLE:
		is_true(AudioServer.get_bus_index(bus) >= 0, bus)
	equal(AudioServer.get_bus_send(AudioServer.get_bus_index(SoundBuses.MUFFLED)), SoundBuses.ROOM)


func test_volumes_stay_within_their_range() -> void:
	SoundBuses.make()
	SoundBuses.set_volume(SoundBuses.WORLD, 0.5)
	almost_equal(SoundBuses.volume(SoundBuses.WORLD), 0.5, 1e-4)
	SoundBuses.set_volume(SoundBuses.WORLD, NAN)
	almost_equal(SoundBuses.volume(SoundBuses.WORLD), 0.5, 1e-4)
	SoundBuses.set_volume(SoundBuses.WORLD, 0.0)
	is_true(AudioServer.is_bus_mute(AudioServer.get_bus_index(SoundBuses.WORLD)))
	SoundBuses.set_volume(SoundBuses.WORLD, 7.0)
	almost_equal(SoundBuses.volume(SoundBuses.WORLD), 1.0, 1e-4)
