class_name MotionStreams
extends RefCounted
## The network streams that the sources of a client are: opened by what [code]--source[/code] says,
## each a [PoseStream] or a [SensorFeed].

## Somebody's motion has begun to come; by the number that its source was opened with.
signal appeared(p_source: MotionSource, p_name: String, p_number: int)
## A person's motion has stopped.
signal vanished(p_source: MotionSource)

## Streams of poses, in the order in which they were opened.
var poses: Array[PoseStream] = []
## How cameras see, for webcams that are opened.
var camera: CameraSettings = CameraSettings.new()
## SlimeVR's trackers, or null.
var slime: SlimeFeed = null


## What reads a kind's datagrams; null for kinds that are no stream of poses.
static func reader_of(p_kind: String) -> StreamReader:
	match p_kind:
		"vmc":
			return VmcReader.new()
		"rokoko":
			return RokokoReader.new()
		"axis":
			return AxisReader.new()
		"mocopi":
			return MocopiReader.new()
		"natnet":
			return NatnetReader.new()
		"webcam":
			return WebcamReader.new()
	return null


## Opens a source, under a number. Returns why it can't, or an empty text.
func open(p_address: SourceAddress, p_number: int) -> String:
	if p_address.kind == "slime":
		return _open_slime(p_address)
	var reader: StreamReader = reader_of(p_address.kind)
	if reader == null:
		return "'%s' is no network stream" % p_address.kind
	var group: String = ""
	if reader is NatnetReader:
		group = NatnetReader.GROUP
		var host: String = p_address.host
		if host != "":
			host = SourceAddress.resolve(host)
			if host == "":
				return "NatNet: the host '%s' can't be found" % p_address.host.left(60)
		(reader as NatnetReader).host = host
	elif reader is AxisReader:
		(reader as AxisReader).is_tcp = p_address.is_tcp
	elif reader is WebcamReader:
		(reader as WebcamReader).use(camera)
	var stream: PoseStream = PoseStream.new(reader)
	stream.appeared.connect(appeared.emit.bind(p_number))
	stream.vanished.connect(vanished.emit)
	var fault: String = ""
	if p_address.is_tcp:
		stream.open_tcp(p_address.host, p_address.port)
	elif reader is WebcamReader and p_address.text != "":
		fault = stream.open_local()
		var what: String = _pictures_of(p_address)
		if fault == "":
			(reader as WebcamReader).start_helper(what, stream.port.get_port())
	else:
		fault = stream.open(p_address.port, group)
	if fault == "":
		poses.append(stream)
	return fault


## Goes on, in the main thread, each frame.
func advance() -> void:
	for stream: PoseStream in poses:
		stream.advance()
	if slime != null:
		slime.advance()


## Whether any stream is open.
func has_any() -> bool:
	return not poses.is_empty() or slime != null


## For the panel, see [constant DeviceList.KEYS].
func list_devices() -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	for stream: PoseStream in poses:
		rows.append_array(stream.list_devices())
	if slime != null:
		rows.append_array(slime.list_devices())
	return rows


## What is wrong, or what is waited for, for the wearer; empty if all is well.
func trouble() -> String:
	var texts: PackedStringArray = []
	for stream: PoseStream in poses:
		var text: String = stream.trouble()
		if text == "" and stream.people.is_empty():
			text = stream.describe()
		if text != "":
			texts.append(text)
	if slime != null:
		var text: String = slime.trouble()
		if text == "" and not slime.has_sensors():
			text = slime.describe()
		if text != "":
			texts.append(text)
	return "\n".join(texts)


## One line of text about the stream, for the user.
func describe() -> String:
	var texts: PackedStringArray = []
	for stream: PoseStream in poses:
		texts.append(stream.describe())
	return ", ".join(texts)


## What webcams see, for the panel, in the order in which they were opened.
func list_pictures() -> Array[WebcamPicture]:
	var found: Array[WebcamPicture] = []
	for stream: PoseStream in poses:
		if stream.reader() is WebcamReader:
			found.append((stream.reader() as WebcamReader).picture)
	return found


## UDP ports that are open.
func list_ports() -> PackedInt32Array:
	var ports: PackedInt32Array = []
	for stream: PoseStream in poses:
		ports.append(stream.port.get_port())
	if slime != null:
		ports.append(slime.get_port())
	return ports


## Closes all.
func close() -> void:
	for stream: PoseStream in poses:
		stream.close()
	if slime != null:
		slime.close()


## The pictures that a webcam's address names: a camera's number, or a film.
static func _pictures_of(p_address: SourceAddress) -> String:
	var is_camera: bool = p_address.text.is_valid_int()
	return p_address.text if is_camera else Options.full_path(p_address.text)


func _open_slime(p_address: SourceAddress) -> String:
	if slime != null:
		return "SlimeVR trackers have one port: name slime once"
	var feed: SlimeFeed = SlimeFeed.new()
	feed.open(p_address.port)
	if feed.error == "":
		slime = feed
	return feed.error
