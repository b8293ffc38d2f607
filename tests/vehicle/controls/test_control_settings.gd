extends TestCase
## Calibrations of wheels are kept between starts, and damaged files do no harm.

const PATH: String = "user://test_controls.cfg"
const STEER: AxisCalibrator.Kind = AxisCalibrator.Kind.STEER


func after_each() -> void:
	DirAccess.remove_absolute(PATH)


func test_a_calibration_is_kept_by_device() -> void:
	var wheel: AxisCalibration = AxisCalibration.new()
	wheel.axis = 2
	wheel.rest = 0.05
	equal(ControlSettings.new(PATH).keep('Wheel [1] "x"', STEER, wheel), "")
	var again: ControlSettings = ControlSettings.new(PATH)
	equal(again.find('Wheel [1] "x"', STEER).to_array(), wheel.to_array())
	is_null(again.find("Another", STEER))
	is_null(again.find('Wheel [1] "x"', AxisCalibrator.Kind.BRAKE))
	again.forget('Wheel [1] "x"')
	is_null(ControlSettings.new(PATH).find('Wheel [1] "x"', STEER))


func test_a_damaged_file_counts_as_none() -> void:
	for text: String in ["[", "[Wheel]\nsteer=[1,2]\n", "[Wheel]\nsteer=Vector3(1,2,3)\n"]:
		var file: FileAccess = FileAccess.open(PATH, FileAccess.WRITE)
		file.store_string(text)
		file.close()
		allow_error("ConfigFile")
		is_null(ControlSettings.new(PATH).find("Wheel", STEER), text)
