extends TestCase
## What options offer is what there is.


func test_every_way_of_stereo_can_be_asked_for() -> void:
	equal(DisplayNames.STEREO, StereoMode.NAMES.slice(1))
	for name: String in DisplayNames.STEREO:
		var stereo: StereoDisplay = StereoDisplay.new()
		equal(stereo.set_up(name, 0.065, 3.0), "", name)
		stereo.free()
