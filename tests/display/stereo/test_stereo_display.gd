extends TestCase
## What stereo displays refuse.


func test_what_cannot_be_shown_is_said() -> void:
	var display: StereoDisplay = StereoDisplay.new()
	contains(display.set_up("sidebyside", 0.065, 3.0), "it is one of side-by-side")
	contains(display.set_up("mono", 0.065, 3.0), "there is no stereo 'mono'")
	for apart: float in [-0.1, 2.0, NAN, INF]:
		contains(display.set_up("rows", apart, 3.0), "distance between the eyes is 0 to 1")
	for away: float in [0.0, -1.0, NAN, INF]:
		contains(display.set_up("rows", 0.065, away), "the eyes meet at a distance of at least")
	equal(display.set_up("rows", 0.065, 3.0), "")
	contains(display.open(), "start without --headless")
	display.free()
