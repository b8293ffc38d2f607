extends TestCase
## What options offer is what there is.


func test_every_stereo_mode_can_be_set_up() -> void:
	for name: String in DisplayNames.STEREO + PackedStringArray(StereoMode.NAMES.slice(1)):
		var stereo: StereoDisplay = StereoDisplay.new()
		equal(stereo.set_up(name, 0.065, 3.0), "", name)
		stereo.free()


func test_the_option_offers_every_display() -> void:
	var displays: Array[String] = [DisplayNames.WINDOW, DisplayNames.HMD, DisplayNames.WALL]
	equal(DisplayNames.ALL, PackedStringArray(displays) + DisplayNames.STEREO)
