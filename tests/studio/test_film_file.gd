extends TestCase

const PATH: String = "user://test_film.avi"


func after_each() -> void:
	DirAccess.remove_absolute(PATH)


func test_a_film_has_its_frames_where_its_index_says() -> void:
	var film: FilmFile = FilmFile.new()
	equal(film.open(PATH, Vector2i(32, 16), 30), "")
	for i: int in 5:
		var image: Image = Image.create(32, 16, false, Image.FORMAT_RGB8)
		image.fill(Color(0.2 * i, 0.5, 0.1))
		film.add(image)
	film.close()
	var bytes: PackedByteArray = FileAccess.get_file_as_bytes(PATH)
	equal(bytes.slice(0, 4).get_string_from_ascii(), "RIFF")
	equal(bytes.decode_u32(4), bytes.size() - 8)
	equal(bytes.slice(8, 12).get_string_from_ascii(), "AVI ")
	equal(bytes.slice(220, 224).get_string_from_ascii(), "movi")
	var index: int = 220 + bytes.decode_u32(216)
	equal(bytes.slice(index, index + 4).get_string_from_ascii(), "idx1")
	equal(bytes.decode_u32(index + 4), 5 * 16)
	for i: int in 5:
		var at: int = 220 + bytes.decode_u32(index + 8 + i * 16 + 8)
		equal(bytes.slice(at, at + 4).get_string_from_ascii(), "00dc")
		var picture: Image = Image.new()
		var size: int = bytes.decode_u32(at + 4)
		equal(picture.load_jpg_from_buffer(bytes.slice(at + 8, at + 8 + size)), OK)
		equal(picture.get_size(), Vector2i(32, 16))


func test_a_folder_that_is_not_there_is_named() -> void:
	contains(
		FilmFile.new().open("user://no/such/film.avi", Vector2i(8, 8), 30), "cannot be written"
	)
