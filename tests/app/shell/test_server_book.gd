extends TestCase
## What is remembered of servers outlives the program, and no file harms it.

const _PATH: String = "user://test_servers.cfg"


func before_each() -> void:
	for path: String in [_PATH, _PATH + ".damaged", _PATH + ".part"]:
		DirAccess.remove_absolute(path)


func after_each() -> void:
	before_each()


func test_it_is_there_again() -> void:
	var book: ServerBook = ServerBook.new(_PATH)
	book.toggle("example.org")
	book.toggle("[::1]:7790")
	book.remember("10.0.0.7", "Ann")
	var again: ServerBook = ServerBook.new(_PATH)
	equal(again.favourites, PackedStringArray(["example.org", "[::1]:7790"]))
	equal(again.last_address, "10.0.0.7")
	equal(again.last_name, "Ann")
	again.toggle("example.org")
	is_false(ServerBook.new(_PATH).has("example.org"))


func test_a_damaged_file_is_kept_beside_and_renewed() -> void:
	FileAccess.open(_PATH, FileAccess.WRITE).store_string("[favourites\naddresses = (")
	allow_error("ConfigFile")
	var book: ServerBook = ServerBook.new(_PATH)
	equal(book.favourites.size(), 0)
	is_true(FileAccess.file_exists(_PATH + ".damaged"))
	book.toggle("example.org")
	is_true(ServerBook.new(_PATH).has("example.org"))


func test_values_of_other_kinds_are_left_out() -> void:
	var file: ConfigFile = ConfigFile.new()
	var many: PackedStringArray = ["a b", "x".repeat(10000), "good.example"]
	for i: int in 200:
		many.append("host%d" % i)
	file.set_value("favourites", "addresses", many)
	file.set_value("last", "address", 7)
	file.set_value("last", "name", "n".repeat(10000))
	file.save(_PATH)
	var book: ServerBook = ServerBook.new(_PATH)
	is_true(book.favourites.size() <= ServerBook.MAX_FAVOURITES)
	is_true(book.has("good.example"))
	is_false(book.has("a b"))
	equal(book.last_address, "")
	equal(book.last_name.length(), Protocol.MAX_NAME)
