class_name StatusEndpoint
extends RefCounted
## Serves a server's stats to whoever asks on this machine: HTTP on 127.0.0.1, JSON.
##
## [code]curl http://127.0.0.1:7777/[/code]. Meant for operators and their monitoring; nobody else
## can reach it. Requests must be few, short and quick, or they are dropped.

## Maximum of requests at a time.
const MAX_REQUESTS: int = 8
## Maximum of new connections in a frame.
const MAX_NEW: int = 64
## Maximum of bytes of a request's head.
const MAX_HEAD: int = 4096
## What a request may call this machine.
const HOSTS: PackedStringArray = ["127.0.0.1", "localhost"]
## Time for a request, and without progress of the reply, µs.
const PATIENCE_USEC: int = 2000000

## Requests since the start that were answered, refused for what they ask, and dropped as they came
## to nothing in time or made room for others.
var counts: Dictionary[String, int] = {"answered": 0, "refused": 0, "dropped": 0}

var _server: TCPServer = TCPServer.new()
var _requests: Array[Request] = []


## One connection.
class Request:
	var stream: StreamPeerTCP = null
	var head: PackedByteArray = PackedByteArray()
	var since_usec: int = 0
	var reply: PackedByteArray = PackedByteArray()


## Opens a TCP port of 127.0.0.1.
func open(p_port: int) -> Error:
	return _server.listen(p_port, "127.0.0.1")


## Answers requests; [param p_stats] is called for a [Dictionary] only if there is one.
func poll(p_stats: Callable) -> void:
	for _connection: int in MAX_NEW:
		if not _server.is_connection_available():
			break
		var request: Request = Request.new()
		request.stream = _server.take_connection()
		if request.stream == null:
			# The process has no descriptor left for it.
			break
		request.since_usec = Time.get_ticks_usec()
		_requests.append(request)
		# Whoever just holds a connection must not keep others out.
		if _requests.size() > MAX_REQUESTS:
			(_requests.pop_front() as Request).stream.disconnect_from_host()
			counts["dropped"] += 1
	for request: Request in _requests.duplicate():
		if _serve(request, p_stats):
			request.stream.disconnect_from_host()
			_requests.erase(request)


## Closes it.
func close() -> void:
	for request: Request in _requests:
		request.stream.disconnect_from_host()
	_requests.clear()
	_server.stop()


## Whether the request is over.
func _serve(p_request: Request, p_stats: Callable) -> bool:
	var stream: StreamPeerTCP = p_request.stream
	stream.poll()
	var is_late: bool = Time.get_ticks_usec() - p_request.since_usec > PATIENCE_USEC
	if stream.get_status() != StreamPeerTCP.STATUS_CONNECTED or is_late:
		counts["dropped"] += 1
		return true
	if p_request.reply.is_empty():
		_read(p_request, p_stats)
	if not p_request.reply.is_empty():
		var sent: Array = stream.put_partial_data(p_request.reply)
		p_request.reply = p_request.reply.slice(sent[1])
		if sent[1] > 0:
			p_request.since_usec = Time.get_ticks_usec()
		return sent[0] != OK or p_request.reply.is_empty()
	return false


func _read(p_request: Request, p_stats: Callable) -> void:
	var waiting: int = p_request.stream.get_available_bytes()
	if waiting > 0:
		# All of it: closing a connection with unread bytes would cut the reply off.
		var bytes: PackedByteArray = p_request.stream.get_data(waiting)[1]
		p_request.head.append_array(bytes.slice(0, MAX_HEAD + 1))
	if p_request.head.size() > MAX_HEAD:
		_refuse(p_request, "431 Request Header Fields Too Large", "too long")
		return
	if p_request.head.has(0):
		_refuse(p_request, "400 Bad Request", "not HTTP")
		return
	# Bytes, not text: a stranger's request may be invalid text.
	var head: String = p_request.head.get_string_from_ascii()
	if not head.contains("\r\n\r\n"):
		return
	# One answer is all there is: what follows is not read.
	head = head.get_slice("\r\n\r\n", 0)
	var line: PackedStringArray = head.get_slice("\r\n", 0).split(" ")
	if line.size() != 3 or not line[2].begins_with("HTTP/1."):
		_refuse(p_request, "400 Bad Request", "not HTTP")
	elif not _is_meant(head):
		# A page of some site, whose name was pointed at this machine, asks through a browser.
		_refuse(p_request, "421 Misdirected Request", "ask 127.0.0.1")
	elif line[0] != "GET" and line[0] != "HEAD":
		_refuse(p_request, "405 Method Not Allowed", "GET it")
	elif not line[1] in ["/", "/status", "/status.json"]:
		_refuse(p_request, "404 Not Found", "there is only /")
	else:
		counts["answered"] += 1
		p_request.reply = _reply("200 OK", p_stats.call(), line[0] == "HEAD")


func _refuse(p_request: Request, p_state: String, p_why: String) -> void:
	counts["refused"] += 1
	p_request.reply = _reply(p_state, {"error": p_why})


## Whether a request names this machine as its host. One without a host is no browser's.
static func _is_meant(p_head: String) -> bool:
	var hosts: PackedStringArray = []
	for line: String in p_head.split("\r\n"):
		if line.to_lower().begins_with("host:"):
			hosts.append(line.substr(5).strip_edges().to_lower())
	if hosts.is_empty():
		return true
	var name: String = hosts[0].get_slice(":", 0) if not hosts[0].begins_with("[") else hosts[0]
	return hosts.size() == 1 and (name in HOSTS or name.begins_with("[::1]"))


static func _reply(
	p_state: String, p_body: Dictionary, p_head_only: bool = false
) -> PackedByteArray:
	var body: PackedByteArray = (JSON.stringify(p_body, "  ") + "\n").to_utf8_buffer()
	var head: PackedStringArray = [
		"HTTP/1.1 " + p_state,
		"Content-Type: application/json",
		"Content-Length: %d" % body.size(),
		"Cache-Control: no-store",
		"Connection: close",
	]
	var bytes: PackedByteArray = ("\r\n".join(head) + "\r\n\r\n").to_utf8_buffer()
	if not p_head_only:
		bytes.append_array(body)
	return bytes
