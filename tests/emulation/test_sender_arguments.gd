extends TestCase
## What programs that play motion as a stream read of their command line.

const RANGES: Dictionary[String, Vector2] = {"port": Vector2(1, 65535), "rate": Vector2(1, 240)}

var _options: Dictionary[String, String] = {}


func before_each() -> void:
	_options = {"bvh": "", "port": "9763", "rate": "60"}


func test_values_take_the_place_of_defaults() -> void:
	equal(_read(["--bvh=a=b.bvh", "--rate=59.94"]), "")
	equal(_options, {"bvh": "a=b.bvh", "port": "9763", "rate": "59.94"})


func test_what_is_wrong_is_said() -> void:
	for pair: Array in [
		["--wrong=1", "unknown option or no value: '--wrong=1'; see ./run sender --help"],
		["--rate", "unknown option or no value: '--rate'"],
		["rate=30", "unknown option or no value: 'rate=30'"],
		["--port=99999", "--port is 1 to 65535, found '99999'"],
		["--port=80.5", "--port is 1 to 65535, found '80.5'"],
		["--rate=abc", "--rate is 1 to 240, found 'abc'"],
		["--rate=nan", "--rate is 1 to 240, found 'nan'"],
		["--rate=0.5", "--rate is 1 to 240, found '0.5'"],
	]:
		before_each()
		contains(_read([pair[0]]), pair[1], pair[0])


func _read(p_arguments: PackedStringArray) -> String:
	return SenderArguments.read(_options, RANGES, ["port"], "sender", p_arguments)
