extends TestCase
## Driving by a list.

var _input: VehicleInput = VehicleInput.new()


func test_parts_follow_one_another_and_the_last_one_lasts() -> void:
	var script: DriveScript = DriveScript.parse("1:0:0:2, 0:-0.5:0:1,0:0:1:1")
	equal(script.error, "")
	var found: Array[Vector3] = []
	for _second: int in 6:
		script.read(_input)
		found.append(Vector3(_input.throttle, _input.steer, _input.brake))
		script.advance(1.0)
	var stop: Vector3 = Vector3(0.0, 0.0, 1.0)
	var go: Vector3 = Vector3(1.0, 0.0, 0.0)
	equal(found, [go, go, Vector3(0.0, -0.5, 0.0), stop, stop, stop] as Array[Vector3])
	script.restart()
	script.read(_input)
	equal(_input.throttle, 1.0, "from the start again in another seat")


func test_what_is_no_list_is_named() -> void:
	for text: String in [
		"", "1", "1:0:0", "1:0:0:x", "1:0:0:0", "1:0:0:-1", "2:0:0:1", "nan:0:0:1"
	]:
		contains(DriveScript.parse(text).error, "THROTTLE:STEERING:BRAKE:SECONDS", text)
