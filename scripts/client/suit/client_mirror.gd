class_name ClientMirror
extends RefCounted
## What the device panel's mirror shows: the body of one of the client's people, as others will see
## it, and in words what there is to know before joining.

## What moves nobody, and what to do.
const NO_SOURCE: String = (
	"You wear no suit: in the session you walk by keys. To be moved by a suit, plug it in and start"
	+ " with --xbus, let a program send to this machine and take it under Sources, or start with"
	+ " --source=KIND or --bvh=FILE."
)
const _WORLDS: String = "as the world says"
## Period of the words, s.
const _PERIOD_S: float = 0.25
## Age from which on a source counts as silent, s.
const _SILENT_S: float = 0.5

var _context: ClientContext = null
var _inputs: MotionInputs = null
var _sheet: MirrorSheet = null
# Made when it is seen for the first time.
var _body: MirrorBody = null
# Who is seen: a place among the people.
var _at: int = 0
var _said_s: float = -INF
var _shown_usec: int = 0


## Takes what the client is, its sources, and where it is shown.
func _init(p_context: ClientContext, p_inputs: MotionInputs, p_sheet: MirrorSheet) -> void:
	_context = p_context
	_inputs = p_inputs
	_sheet = p_sheet
	p_sheet.avatar_chosen.connect(_choose_avatar)
	p_sheet.person_chosen.connect(_choose_person)
	if p_context.try_out != null:
		p_sheet.join_wanted.connect(_join)
		p_sheet.stop_wanted.connect(p_context.try_out.stop)
		p_context.try_out.changed.connect(_show_session)
		_show_session()


## Goes on, at a time, s: call it in every frame in which it can be seen, after the samples have
## been taken.
func advance(p_now_s: float) -> void:
	if not _sheet.is_visible_in_tree():
		return
	if _body == null:
		_body = MirrorBody.new(_context.scene.person_scene, _context.options.number("rate"))
		_body.made.connect(_sheet.mirror.begin)
		_sheet.mirror.stage.add_child(_body)
	_body.show_motion(_motion(), _context.people.avatar())
	var now: int = Time.get_ticks_usec()
	var delta: float = minf((now - _shown_usec) / 1e6, 1.0)
	_shown_usec = now
	if _body.advance(now, delta):
		var view: ActorView = _body.view
		_sheet.mirror.follow(view.hips(), _body.floor_height, view.heading(), delta)
	if p_now_s > _said_s + _PERIOD_S:
		_said_s = p_now_s
		_say(p_now_s)


## Who is seen, or null.
func _motion() -> ClientMotion:
	var motions: Array[ClientMotion] = _context.people.motions()
	return motions[mini(_at, motions.size() - 1)] if not motions.is_empty() else null


func _say(p_now_s: float) -> void:
	var names: PackedStringArray = []
	for motion: ClientMotion in _context.people.motions():
		names.append("%d: %s" % [names.size() + 1, motion.source.describe()])
	_sheet.show_people(names, _at)
	var avatars: PackedStringArray = [_WORLDS]
	avatars.append_array(AvatarStore.NAMES)
	_sheet.show_avatars(avatars, maxi(avatars.find(_context.people.avatar()), 0))
	_sheet.show_wearer(_describe(_motion()))
	_sheet.show_trouble(_inputs.guide(p_now_s) if _inputs.has_any() else NO_SOURCE)
	_sheet.show_devices(_list())


## Devices, then those who are moved.
func _list() -> Array[Dictionary]:
	var rows: Array[Dictionary] = _inputs.list_devices()
	for motion: ClientMotion in _context.people.motions():
		var row: Dictionary = {"name": "body %d" % (motion.card.index + 1)}
		row["detail"] = motion.source.describe()
		if motion.source.error != "":
			row["advice"] = motion.source.error
		row["state"] = _state_of(motion.newest)
		rows.append(row)
	return rows


static func _state_of(p_newest: PoseSample) -> String:
	if p_newest == null:
		return "waits"
	var age_s: float = Time.get_unix_time_from_system() - p_newest.time_usec / 1e6
	return "moves" if age_s < _SILENT_S else "silent %s" % SensorTable.age_text(age_s)


## Who it is, how tall, and whether calibrated.
func _describe(p_motion: ClientMotion) -> String:
	if p_motion == null:
		return ""
	var size: BodySize = p_motion.source.get_body()
	var text: String = "%.2f m tall, hips at %.2f m." % [size.height, p_motion.card.hip_height]
	var name: String = p_motion.card.name
	name = _context.options.text("name") if name == "" else name
	if name != "":
		text = "%s, %s" % [name, text]
	var suit: SuitSource = p_motion.suit()
	if suit == null:
		return text + " This motion comes calibrated."
	var state: String = SuitWords.describe(suit)
	return "%s %s." % [text, state.left(1).to_upper() + state.substr(1)]


func _choose_avatar(p_at: int) -> void:
	_context.people.wear(AvatarStore.NAMES[p_at - 1] if p_at > 0 else "")


func _choose_person(p_at: int) -> void:
	_at = p_at


## Who has no source is moved by what a session without one has.
func _join() -> void:
	var fault: String = _inputs.open_default()
	if fault != "":
		_context.try_out.note(TryOut.Phase.LOOKING, fault)
	else:
		_context.try_out.join()


func _show_session() -> void:
	var user: TryOut = _context.try_out
	_sheet.offer_session(user.where if user.is_before_session() else "")
	_sheet.show_session(user.text, user.phase == TryOut.Phase.JOINING)
