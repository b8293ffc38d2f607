extends TestCase
## Captions on the screen: the newest first, each for a while.


func test_the_newest_is_first_and_old_ones_go() -> void:
	var lines: CaptionLines = CaptionLines.new()
	add_child(lines)
	for number: int in 6:
		lines.show_caption("sound %d" % number, PI / 2.0)
	equal(lines.texts().size(), CaptionLines.MAX_LINES)
	equal(lines.texts()[0], "→  sound 5")
	lines.toasts._process(CaptionLines.STAY_S + 0.1)
	equal(lines.texts().size(), 0)
	lines.free()
