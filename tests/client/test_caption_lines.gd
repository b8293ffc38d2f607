extends TestCase
## Captions on the screen: the newest first, each for a while.


func test_the_newest_is_first_and_old_ones_go() -> void:
	var lines: CaptionLines = CaptionLines.new()
	add_child(lines)
	for number: int in 6:
		lines.show_caption("sound %d" % number, PI / 2.0)
	equal(lines.texts().size(), CaptionLines.MAX_LINES)
	equal(lines.texts()[0], "→  sound 5")
	await process_frames(roundi(CaptionLines.STAY_S * 60.0) + 5)
	equal(lines.texts().size(), 0)
	lines.free()
