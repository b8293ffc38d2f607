extends TestCase
## Operators get stats by HTTP; nobody can make the server wait, or ask for much.

var _endpoint: StatusEndpoint = StatusEndpoint.new()
var _port: int = 0
var _asked: int = 0
var _stats: Dictionary = {"ticks_per_second": 60.0, "sessions": [{"name": "Ada"}]}


func before_each() -> void:
	for port: int in range(47310, 47400):
		if _endpoint.open(port) == OK:
			_port = port
			return
	fail("no free port")


func after_each() -> void:
	_endpoint.close()


func test_the_stats() -> void:
	for path: String in ["/", "/status", "/status.json"]:
		var reply: String = _ask("GET %s HTTP/1.1\r\nHost: 127.0.0.1:7777\r\n\r\n" % path)
		is_true(reply.begins_with("HTTP/1.1 200 OK\r\n"), path)
		contains(reply, "Content-Type: application/json\r\n")
		var body: String = reply.get_slice("\r\n\r\n", 1)
		contains(reply, "Content-Length: %d\r\n" % body.to_utf8_buffer().size())
		equal(JSON.parse_string(body), _stats)
	equal(_asked, 3)


func test_a_site_whose_name_points_here_gets_nothing() -> void:
	for host: String in ["evil.example", "127.0.0.1.evil.example:7777", "localhost.evil", ""]:
		var reply: String = _ask("GET / HTTP/1.1\r\nHost: %s\r\n\r\n" % host)
		is_true(reply.begins_with("HTTP/1.1 421 "), host)
	_ask("GET / HTTP/1.1\r\nHost: localhost\r\nhost: evil\r\n\r\n")
	equal(_asked, 0)
	for host: String in ["localhost", "LOCALHOST:7777", "127.0.0.1", "[::1]:7777"]:
		var reply: String = _ask("GET / HTTP/1.1\r\nhOst: %s\r\n\r\n" % host)
		is_true(reply.begins_with("HTTP/1.1 200 OK\r\n"), host)


func test_the_head_alone() -> void:
	var reply: String = _ask("HEAD / HTTP/1.1\r\n\r\n")
	is_true(reply.begins_with("HTTP/1.1 200 OK\r\n"))
	is_true(reply.ends_with("\r\n\r\n"), "no body")
	is_false(reply.contains("Content-Length: 0"))


func test_what_is_no_request_for_stats() -> void:
	var cases: Dictionary[String, String] = {
		"GET /etc/passwd HTTP/1.1": "404 Not Found",
		"GET /../ HTTP/1.0": "404 Not Found",
		"POST / HTTP/1.1": "405 Method Not Allowed",
		"get / HTTP/1.1": "405 Method Not Allowed",
		"GET /": "400 Bad Request",
		"GET / SMTP/1.1": "400 Bad Request",
		"GET  / HTTP/1.1": "400 Bad Request",
		"": "400 Bad Request",
	}
	for line: String in cases:
		var reply: String = _ask(line + "\r\n\r\n")
		is_true(reply.begins_with("HTTP/1.1 %s\r\n" % cases[line]), "%s: %s" % [line, reply])
		not_null(JSON.parse_string(reply.get_slice("\r\n\r\n", 1)))
	equal(_asked, 0, "the stats are not even made")


func test_garbage() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	for _round: int in 50:
		var bytes: PackedByteArray = []
		for _at: int in random.randi_range(1, 300):
			bytes.append(random.randi_range(1, 255))
		var reply: String = _ask_bytes(bytes + "\r\n\r\n".to_ascii_buffer())
		is_true(reply.begins_with("HTTP/1.1 4"), reply)
	contains(_ask("GET / HTTP/1.1\r\n\r\n"), "200 OK")


func test_a_head_that_is_too_long() -> void:
	var long: String = "GET / HTTP/1.1\r\nX: " + "a".repeat(3 * StatusEndpoint.MAX_HEAD)
	is_true(_ask(long).begins_with("HTTP/1.1 431 "))
	equal(_asked, 0)


func test_a_request_in_pieces() -> void:
	var stream: StreamPeerTCP = _connect()
	for piece: String in ["GE", "T / HT", "TP/1.1\r", "\n\r", "\n"]:
		stream.put_data(piece.to_ascii_buffer())
		_turn(3)
	contains(_read(stream), "200 OK")


func test_who_says_nothing_is_dropped() -> void:
	var silent: StreamPeerTCP = _connect()
	var half: StreamPeerTCP = _connect()
	half.put_data("GET / HTTP/1.1\r\nHost".to_ascii_buffer())
	_turn(5)
	contains(_ask("GET / HTTP/1.1\r\n\r\n"), "200 OK", "others are served")
	for request: StatusEndpoint.Request in _endpoint._requests:
		request.since_usec -= StatusEndpoint.PATIENCE_USEC
	equal(_endpoint._requests.size(), 2)
	_turn(3)
	equal(_endpoint._requests.size(), 0)
	equal([_read(silent), _read(half)], ["", ""])


func test_more_requests_than_are_served_at_a_time() -> void:
	var streams: Array[StreamPeerTCP] = []
	for _request: int in StatusEndpoint.MAX_REQUESTS + 5:
		streams.append(_connect())
	_turn(5)
	equal(_endpoint._requests.size(), StatusEndpoint.MAX_REQUESTS)
	for stream: StreamPeerTCP in streams:
		stream.disconnect_from_host()
	_turn(5)
	contains(_ask("GET / HTTP/1.1\r\n\r\n"), "200 OK", "there is room again")


func test_who_hangs_up_at_once() -> void:
	for _request: int in 20:
		var stream: StreamPeerTCP = _connect()
		stream.put_data("GET / HTTP/1.1\r\n\r\n".to_ascii_buffer())
		stream.disconnect_from_host()
	_turn(10)
	equal(_endpoint._requests.size(), 0)
	contains(_ask("GET / HTTP/1.1\r\n\r\n"), "200 OK")


func test_a_large_reply_to_who_reads_slowly() -> void:
	_stats = {"long": "x".repeat(16000000)}
	var stream: StreamPeerTCP = _connect()
	stream.put_data("GET / HTTP/1.1\r\n\r\n".to_ascii_buffer())
	_turn(20)
	equal(_endpoint._requests.size(), 1, "it waits, and the server goes on")
	equal(_asked, 1)
	var reply: String = _read(stream)
	var begin: int = reply.find("\r\n\r\n") + 4
	contains(reply.left(begin), "Content-Length: %d\r\n" % (reply.length() - begin))
	is_true(reply.ends_with('x"\n}\n'), "to the end")
	equal(_asked, 1, "the stats are made once")


func test_a_port_that_is_in_use() -> void:
	not_equal(StatusEndpoint.new().open(_port), OK)


func _ask(p_text: String) -> String:
	return _ask_bytes(p_text.to_ascii_buffer())


func _ask_bytes(p_bytes: PackedByteArray) -> String:
	var stream: StreamPeerTCP = _connect()
	stream.put_data(p_bytes)
	return _read(stream)


func _connect() -> StreamPeerTCP:
	var stream: StreamPeerTCP = StreamPeerTCP.new()
	_endpoint.poll(_tell)
	stream.connect_to_host("127.0.0.1", _port)
	var end: int = Time.get_ticks_msec() + 60000
	while Time.get_ticks_msec() < end:
		stream.poll()
		if stream.get_status() == StreamPeerTCP.STATUS_CONNECTED:
			break
		_endpoint.poll(_tell)
		OS.delay_msec(1)
	return stream


## What comes until the other end hangs up.
func _read(p_stream: StreamPeerTCP) -> String:
	var bytes: PackedByteArray = []
	var end: int = Time.get_ticks_msec() + 60000
	while Time.get_ticks_msec() < end:
		_endpoint.poll(_tell)
		p_stream.poll()
		if p_stream.get_status() != StreamPeerTCP.STATUS_CONNECTED:
			break
		var waiting: int = p_stream.get_available_bytes()
		if waiting > 0:
			bytes.append_array(p_stream.get_data(waiting)[1])
		else:
			OS.delay_usec(200)
	return bytes.get_string_from_utf8()


func _turn(p_count: int) -> void:
	for _turn_number: int in p_count:
		_endpoint.poll(_tell)
		OS.delay_msec(2)


func _tell() -> Dictionary:
	_asked += 1
	return _stats
