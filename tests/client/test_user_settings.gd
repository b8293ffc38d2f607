extends TestCase
## What is kept of what somebody has chosen.

const PATH: String = "user://test_settings.cfg"
const OTHER: RenderingDevice.DeviceType = RenderingDevice.DEVICE_TYPE_OTHER


func after_each() -> void:
	DirAccess.remove_absolute(PATH)


func test_the_first_start_chooses_what_fits_and_keeps_it() -> void:
	equal(UserSettings.new(PATH).quality("llvmpipe", OTHER), "low")
	is_true(FileAccess.file_exists(PATH))
	equal(UserSettings.new(PATH).quality("llvmpipe", OTHER), "low")


func test_another_graphics_card_gets_another_tier() -> void:
	equal(UserSettings.new(PATH).quality("llvmpipe", OTHER), "low")
	equal(UserSettings.new(PATH).quality("NVIDIA GeForce", OTHER), "high")


func test_what_a_person_has_chosen_stays() -> void:
	UserSettings.new(PATH).choose_quality("ultra")
	equal(UserSettings.new(PATH).quality("llvmpipe", OTHER), "ultra")


func test_a_damaged_file_counts_as_none() -> void:
	var file: FileAccess = FileAccess.open(PATH, FileAccess.WRITE)
	file.store_string('[display]\nquality="best"\n')
	file.close()
	equal(UserSettings.new(PATH).quality("llvmpipe", OTHER), "low")
