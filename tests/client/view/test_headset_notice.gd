extends TestCase
## News are seen in the headset too, for a while.


func test_a_text_comes_and_goes() -> void:
	var notice: HeadsetNotice = HeadsetNotice.new()
	add_child(notice)
	is_false(notice.visible)
	notice.tell("The server is gone")
	is_true(notice.visible)
	equal(notice.text, "The server is gone")
	notice._process(HeadsetNotice.STAYS_S - 0.1)
	is_true(notice.visible)
	notice._process(0.2)
	is_false(notice.visible)
	notice.tell("")
	is_false(notice.visible)
	notice.free()
