extends TestCase
## LZ4 frames as Python's lz4 4.x writes them.

## lz4.frame.compress of TEXT twice.
const FRAME: String = (
	"04224d186840e000000000000000434c000000ff2a7b2276657273696f6e223a22332c30222c227363656e65"
	+ "223a7b2274696d657374616d70223a312e352c226163746f7273223a5b5d7d7d2c203900240f3700240f7000"
	+ "21503a5b5d7d7d00000000"
)
const TEXT: String = (
	'{"version":"3,0","scene":{"timestamp":1.5,"actors":[]}}, '
	+ '{"version":"3,0","scene":{"timestamp":1.5,"actors":[]}}'
)


func test_what_python_packs_is_unpacked() -> void:
	var frame: PackedByteArray = FRAME.hex_decode()
	is_true(Lz4.is_frame(frame))
	equal(Lz4.unpack(frame, 1000).get_string_from_ascii(), TEXT + TEXT)
	is_false(Lz4.is_frame(TEXT.to_ascii_buffer()))


func test_nothing_grows_beyond_its_limit() -> void:
	var frame: PackedByteArray = FRAME.hex_decode()
	equal(Lz4.unpack(frame, 100).size(), 0)
	# A match that repeats one byte for ever.
	var bomb: PackedByteArray = "04224d1868400000000000000000".hex_decode().slice(0, 15)
	bomb.append_array([0, 0x08, 0x10, 0, 0, 0x1F, 0x41, 1, 0])
	for _number: int in 4097:
		bomb.append(255)
	equal(Lz4.unpack(bomb, 100000).size(), 0)


func test_wrong_bytes_are_survived() -> void:
	var frame: PackedByteArray = FRAME.hex_decode()
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 3
	for _round: int in 3000:
		var wrong: PackedByteArray = frame.duplicate()
		for _byte: int in 3:
			wrong[random.randi_range(4, wrong.size() - 1)] = random.randi() & 0xFF
		wrong = wrong.slice(0, random.randi_range(7, wrong.size()))
		is_true(Lz4.unpack(wrong, 1000).size() <= 1000)
