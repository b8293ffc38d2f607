class_name LiveSession
extends ClientPart
## The connection to a server: makes the [LiveStream] that the options ask for, asks the user about
## a changed key, tells what the server has to say, and carries the calls of [SharedNodes].

const _KEY_DIALOG: PackedScene = preload("res://scenes/client/window/server_key_dialog.tscn")
# What its note on the screen is about.
const _NOTE: StringName = &"notice"

var _live: LiveStream = LiveStream.new()
var _shared: SharedClient = null


func open(p_context: ClientContext) -> String:
	super(p_context)
	context.stream = _live
	context.link = _live.link
	var options: Options = context.options
	var role: Roles.Role = Roles.find(context.role) as Roles.Role
	_live.host = options.text("host")
	_live.port = options.number("port")
	_live.password = options.text("password")
	_live.patience_s = options.seconds("connect-timeout")
	_live.request.role = role
	_live.request.name = options.text("name") if options.text("name") != "" else context.role
	_live.request.rate = options.number("snapshot-rate")
	_live.request.version = options.number("protocol")
	var where: String = "%s:%d" % [_live.host, _live.port]
	_live.link.token_file = SessionTokenFile.claim(where, role, _live.request.name)
	_live.status_changed.connect(context.hud.show_message)
	_live.restarted.connect(context.hud.show_note.bind("", _NOTE))
	_live.link.notified.connect(_on_notified)
	_shared = SharedClient.new(_live.link, role)
	_live.connecting.connect(_shared.reconnect)
	context.scene.get_level().shared = _shared.api
	_ask_about_keys()
	if options.is_on("try"):
		if ClientContext.is_headless():
			return "--try needs a window: without one nobody can see themselves and join"
		_wait_for_user()
	return _trust()


func begin() -> String:
	return _live.open() if context.try_out == null else ""


func finish() -> void:
	_close_shared()


func close() -> void:
	_close_shared()
	_live.close()


## The session begins when the user wants it to.
func _wait_for_user() -> void:
	var user: TryOut = TryOut.new()
	user.where = _live.describe()
	_live.is_patient = true
	user.join_wanted.connect(_live.open)
	user.stop_wanted.connect(_live.close)
	_live.status_changed.connect(
		func(text: String) -> void:
			if user.phase == TryOut.Phase.JOINING:
				user.note(TryOut.Phase.JOINING, text)
	)
	_live.joined.connect(func() -> void: user.note(TryOut.Phase.JOINED, ""))
	_live.turned_away.connect(
		func(why: String) -> void:
			Log.warning("client", why)
			context.hud.show_message("")
			user.note(TryOut.Phase.LOOKING, why.left(1).to_upper() + why.substr(1) + ".")
	)
	context.try_out = user


## The keys that servers may show, as the options say.
func _trust() -> String:
	_live.link.trust = ServerTrust.of_options(context.options)
	var fault: String = _live.link.trust.find_fault()
	_live.link.seals = context.options.is_on("sealing")
	if fault == "" and not _live.link.seals and _live.link.trust.pin != "":
		fault = "--server-fingerprint: without sealing (--sealing=0) no server proves its key"
	return fault


## Asks the user where a server shows another key than the last time, if somebody is at the window.
func _ask_about_keys() -> void:
	var dialog: ServerKeyDialog = _KEY_DIALOG.instantiate()
	add_child(dialog)
	context.menus.append(dialog.is_open)
	_live.asks = not ClientContext.is_headless() and context.options.seconds("duration") == 0.0
	_live.key_changed.connect(dialog.ask)
	dialog.trusted.connect(_live.trust_key)
	dialog.leave_wanted.connect(context.leave_wanted.emit.bind(StateStream.EXIT_DONE))


func _on_notified(p_text: String) -> void:
	Log.warning("client", p_text)
	context.hud.show_note(p_text, _NOTE)
	context.notified.emit(p_text)


func _close_shared() -> void:
	_shared.api.close()
