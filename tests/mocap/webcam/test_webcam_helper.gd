extends TestCase
## The helper's process: it starts, tells faults, is started again, and ends with its client. What
## it says before its environment is needed is said on any machine with Python.


func goes_by_clock() -> bool:
	return true


func test_a_film_that_is_not_there_is_told_and_the_helper_ends_with_the_stream() -> void:
	var streams: MotionStreams = MotionStreams.new()
	equal(streams.open(SourceAddress.parse("webcam:/nowhere/film.avi"), 1), "")
	var reader: WebcamReader = streams.poses[0].reader() as WebcamReader
	var text: String = ""
	for _frame: int in 2000:
		streams.advance()
		text = streams.trouble()
		if text.contains("no film"):
			break
		await get_tree().create_timer(0.01).timeout
	contains(text, "there is no film /nowhere/film.avi")
	contains(streams.list_devices()[0]["advice"], "no film")
	contains(streams.list_devices()[0]["name"], "film.avi")
	is_true(reader.helper.is_running())
	var pid: int = reader.helper.get_pid()
	# Not OS.kill(), which takes the process' end in.
	OS.execute("kill", ["-KILL", str(pid)])
	for _frame: int in 2000:
		streams.advance()
		if reader.helper.is_running() and reader.helper.get_pid() != pid:
			break
		await get_tree().create_timer(0.01).timeout
	not_equal(reader.helper.get_pid(), pid)
	pid = reader.helper.get_pid()
	streams.close()
	for _frame: int in 500:
		if not DirAccess.dir_exists_absolute("/proc/%d" % pid):
			break
		await get_tree().create_timer(0.01).timeout
	is_true(not DirAccess.dir_exists_absolute("/proc/%d" % pid))


func test_cameras_are_numbers_and_films_are_paths() -> void:
	equal(SourceAddress.parse("webcam").text, "0")
	equal(SourceAddress.parse("webcam:2").text, "2")
	equal(SourceAddress.parse("webcam:a/b.avi").text, "a/b.avi")
	equal(SourceAddress.parse("webcam:udp:14050").port, 14050)
	equal(SourceAddress.parse("webcam:udp:14050").text, "")
	contains(SourceAddress.parse("webcam:14050").fault, "webcam:udp:14050")
	for text: String in ["webcam:", "webcam:-1", "webcam:udp:", "webcam:udp:0"]:
		not_equal(SourceAddress.parse(text).fault, "", text)
