extends TestCase
## What options offer is what there is.


func test_every_way_of_stereo_can_be_asked_for() -> void:
	equal(DisplayNames.stereo(), PackedStringArray(StereoMode.NAMES.slice(1)))
	for name: String in DisplayNames.stereo():
		var stereo: StereoDisplay = StereoDisplay.new()
		equal(stereo.set_up(name, 0.065, 3.0), "", name)
		stereo.free()
