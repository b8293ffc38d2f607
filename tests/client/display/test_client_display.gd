extends TestCase
## Where a display cannot be, the client goes on in its window and says why.


func test_without_a_window_there_is_no_display() -> void:
	if DisplayServer.get_name() != "headless":
		return
	for name: String in DisplayNames.ALL:
		var display: ClientDisplay = ClientDisplay.new()
		var context: ClientContext = ClientContext.new()
		context.options = ProgramOptions.parse(["--display=" + name])
		equal(display.open(context), "", name)
		equal(display.mode, null, name)
		equal(display.report(), {"display": {"display": "window"}}, name)
		equal(display.due_usec(), 0)
		is_false(context.is_headset_worn())
		is_false(context.agreement.is_valid())
		display.free()


func test_a_display_that_there_is_not_is_refused() -> void:
	contains(ProgramOptions.parse(["--display=hologram"]).error, "hologram")
	contains(ProgramOptions.parse(["--convergence=0"]).error, "convergence")
