extends TestCase
## Datagrams between the displays of a station: read as they were sent, or not at all.


func _message() -> StationMessage:
	var message: StationMessage = StationMessage.new()
	message.kind = StationMessage.Kind.WANT
	message.fingerprint = 0xFEDCBA98
	message.sender = 77
	message.sequence = 5
	message.sent_usec = 1_000_000
	message.at_usec = 1_016_000
	message.tick = 12345.625
	message.rate = 60.0
	message.mount = Transform3D(Basis(Vector3.UP, 1.2), Vector3(3.0, 0.0, -8.5))
	message.eye = Vector3(0.1, 1.6, -0.2)
	message.right = Vector3(0.0, 0.0, 1.0)
	return message


func test_there_and_back() -> void:
	var sent: StationMessage = _message()
	var got: StationMessage = StationMessage.decode(sent.encode())
	equal(got.kind, sent.kind)
	equal(got.fingerprint, sent.fingerprint)
	equal([got.sender, got.sequence], [77, 5])
	equal([got.sent_usec, got.at_usec], [1_000_000, 1_016_000])
	equal(got.tick, 12345.625)
	almost_equal(got.eye, sent.eye, 1e-6)
	almost_equal(got.right, sent.right, 1e-6)
	almost_equal(got.mount.origin, sent.mount.origin, 1e-5)
	almost_equal(got.mount.basis.x, sent.mount.basis.x, 1e-5)


func test_what_is_no_message() -> void:
	var good: PackedByteArray = _message().encode()
	is_null(StationMessage.decode(PackedByteArray()))
	is_null(StationMessage.decode(good.slice(1)))
	is_null(StationMessage.decode(good + PackedByteArray([0])))
	for change: Array in [[0, 1], [4, 9], [5, 2]]:
		var bytes: PackedByteArray = good.duplicate()
		bytes[change[0]] = change[1]
		is_null(StationMessage.decode(bytes), str(change))
	for place: int in [42, 46, 58, 74, 94]:
		var bytes: PackedByteArray = good.duplicate()
		bytes.encode_float(place, NAN)
		is_null(StationMessage.decode(bytes), "NaN at %d" % place)
	var bytes: PackedByteArray = good.duplicate()
	bytes.encode_double(34, INF)
	is_null(StationMessage.decode(bytes))
