extends TestCase
## Bytes of Open Sound Control against those of python-osc 1.9 (PyPI), and bytes that are none.

## Made by python-osc: a bundle of /VMC/Ext/OK 1 3 0 1, /VMC/Ext/T 12.5, /VMC/Ext/Root/Pos with
## scale 2, and the bones Hips and LeftLowerArm.
const PYTHON_OSC: String = (
	"2362756e646c65000000000000000001000000242f564d432f4578742f4f4b002c69696969000000000000010000"
	+ "00030000000000000001000000142f564d432f4578742f5400002c66000041480000000000602f564d432f457874"
	+ "2f526f6f742f506f730000002c736666666666666666666666666600726f6f74000000003f00000000000000be80"
	+ "00000000000000000000000000003f80000040000000400000004000000000000000000000000000000000000044"
	+ "2f564d432f4578742f426f6e652f506f730000002c736666666666666600000048697073000000003e8000003f80"
	+ "00003f000000000000003f3504f3000000003f3504f30000004c2f564d432f4578742f426f6e652f506f73000000"
	+ "2c73666666666666660000004c6566744c6f77657241726d00000000be8000000000000000000000000000000000"
	+ "00003f0000003f5db3d7"
)


static func python_osc() -> PackedByteArray:
	return PYTHON_OSC.hex_decode()


func test_what_python_osc_writes_is_read() -> void:
	var osc: Osc = Osc.new()
	var messages: Array[Array] = osc.read(python_osc())
	equal(osc.fault, "")
	equal(messages.size(), 5)
	equal(messages[0], ["/VMC/Ext/OK", 1, 3, 0, 1])
	equal(messages[1], ["/VMC/Ext/T", 12.5])
	equal(messages[3][1], "Hips")
	almost_equal(messages[4][9 - 1], 0.8660254, 1e-6)


func test_what_is_written_is_what_python_osc_writes() -> void:
	var parts: Array[PackedByteArray] = [
		Osc.message("/VMC/Ext/OK", [1, 3, 0, 1]),
		Osc.message("/VMC/Ext/T", [12.5]),
		Osc.message(
			"/VMC/Ext/Root/Pos",
			["root", 0.5, 0.0, -0.25, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0, 0.0, 0.0, 0.0]
		),
		Osc.message(
			"/VMC/Ext/Bone/Pos", ["Hips", 0.25, 1.0, 0.5, 0.0, 0.70710678, 0.0, 0.70710678]
		),
		Osc.message(
			"/VMC/Ext/Bone/Pos", ["LeftLowerArm", -0.25, 0.0, 0.0, 0.0, 0.0, 0.5, 0.8660254]
		),
	]
	equal(Osc.bundle(parts).hex_encode(), PYTHON_OSC)


func test_every_cut_and_every_wrong_byte_is_survived() -> void:
	var bytes: PackedByteArray = python_osc()
	var osc: Osc = Osc.new()
	for size: int in bytes.size():
		osc.read(bytes.slice(0, size))
		is_true(osc.fault != "" or size in [16, 56, 80, 180, 252], "%d bytes" % size)
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 7
	for _round: int in 2000:
		var wrong: PackedByteArray = bytes.duplicate()
		for _byte: int in random.randi_range(1, 6):
			wrong[random.randi() % wrong.size()] = random.randi() & 0xFF
		is_true(osc.read(wrong).size() <= Osc.MAX_MESSAGES)


func test_a_bundle_of_bundles_has_an_end() -> void:
	var bytes: PackedByteArray = Osc.message("/a", [1])
	for _depth: int in 10:
		bytes = Osc.bundle([bytes])
	var osc: Osc = Osc.new()
	equal(osc.read(bytes).size(), 0)
	contains(osc.fault, "bundle")
