extends TestCase
## Files of heights: what is written is read again, what is damaged is refused with a reason.

const SEED: int = 11


func test_what_is_written_is_read() -> void:
	var field: HeightField = _field()
	var read: HeightFile = HeightFile.parse(HeightFile.encode(field))
	equal(read.error, "")
	equal([read.field.columns, read.field.rows, read.field.cell_m], [40, 30, 0.5])
	equal(read.field.paint, field.paint)
	equal(read.field.light, field.light)
	for index: int in field.heights.size():
		almost_equal(read.field.heights[index], field.heights[index], 0.0005)


func test_a_file_on_disk() -> void:
	var path: String = "user://test_%d.height" % OS.get_process_id()
	equal(HeightFile.write(path, _field()), "")
	equal(HeightFile.read(path).error, "")
	DirAccess.remove_absolute(path)
	contains(HeightFile.read(path).error, "cannot be read")


func test_refusals_say_why() -> void:
	var whole: PackedByteArray = HeightFile.encode(_field())
	contains(HeightFile.parse([]).error, "no file of heights")
	contains(HeightFile.parse("PNG".to_ascii_buffer() + whole).error, "no file of heights")
	contains(_error_with(whole, 4, [9, 0]), "version 9")
	contains(_error_with(whole, 8, [0, 0, 0, 0]), "a side of 0 points")
	contains(_error_with(whole, 8, [0xFF, 0xFF, 0xFF, 0x7F]), "a side of")
	contains(_error_with(whole, 12, [41, 0, 0, 0]), "is not that of")
	contains(_error_with(whole, 16, [0, 0, 0xC0, 0x7F]), "distance of nan")
	contains(_error_with(whole, 16, [0, 0, 0, 0]), "distance of 0")
	contains(HeightFile.parse(whole.slice(0, whole.size() - 5)).error, "cut off")
	contains(HeightFile.parse(whole + PackedByteArray([0])).error, "too long")


func test_heights_that_are_none_are_refused() -> void:
	for height: float in [NAN, INF, -INF, 1001.0]:
		var field: HeightField = _field()
		field.heights[77] = height
		var file: HeightFile = HeightFile.parse(HeightFile.encode(field))
		contains(file.error, "a height of")
		is_null(file.field)


func test_damaged_files_never_do_harm() -> void:
	allow_error("")
	var whole: PackedByteArray = HeightFile.encode(_field())
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = SEED
	var refused: int = 0
	for _try: int in 3000:
		var bytes: PackedByteArray = whole.duplicate()
		for _change: int in dice.randi_range(1, 4):
			bytes[dice.randi_range(0, bytes.size() - 1)] = dice.randi() & 0xFF
		if dice.randf() < 0.2:
			bytes.resize(dice.randi_range(0, bytes.size()))
		var file: HeightFile = HeightFile.parse(bytes)
		equal(file.field == null, file.error != "")
		refused += 1 if file.field == null else 0
		if file.field != null:
			equal(file.field.heights.size(), file.field.points())
			equal(file.field.paint.size(), 4 * file.field.points())
	is_true(refused > 1000, "only %d of 3000 were refused" % refused)


func _error_with(p_whole: PackedByteArray, p_at: int, p_bytes: PackedByteArray) -> String:
	var bytes: PackedByteArray = p_whole.duplicate()
	for index: int in p_bytes.size():
		bytes[p_at + index] = p_bytes[index]
	var file: HeightFile = HeightFile.parse(bytes)
	is_null(file.field)
	return file.error


func _field() -> HeightField:
	var field: HeightField = HeightField.create(40, 30, 0.5)
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = SEED
	for index: int in field.points():
		field.heights[index] = dice.randf_range(-20.0, 20.0)
		field.light[index] = dice.randi() & 0xFF
		field.paint[4 * index + dice.randi_range(0, 3)] = dice.randi() & 0xFF
	return field
