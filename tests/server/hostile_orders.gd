extends RefCounted
## Valid messages of an instructor, and those that every role may send besides motion: made by
## chance, the worst of them. Nobody is sent away by them: that would be the end of the attack.

const LEVELS: PackedStringArray = ["hall", "yard", "hangar", "town", "nowhere", "../hall"]
## No session and no peer has it.
const NOBODY: int = 60000

var _random: RandomNumberGenerator = null
var _link: ClientLink = null
var _control: InstructorControl = null
var _number: int = 0


func _init(p_link: ClientLink, p_random: RandomNumberGenerator) -> void:
	_link = p_link
	_random = p_random
	_control = InstructorControl.new(p_link)


## Asks for a level.
func send_level() -> void:
	_control.change_level(LEVELS[_random.randi_range(0, LEVELS.size() - 1)])


## Sets the time of day or the weather.
func send_fields() -> void:
	var hour: float = _random.randf_range(0.0, 24.0)
	_control.set_fields({&"time_of_day": hour} as Dictionary[StringName, float])


## Any order but those of a level and of fields.
func send_order() -> void:
	match _random.randi_range(0, 5):
		0:
			_control.ask_who()
		1:
			_control.admit(NOBODY + _random.randi_range(0, 9))
		2:
			_control.refuse(NOBODY, "x".repeat(120))
		3:
			_control.kick(NOBODY + _random.randi_range(0, 9), "é".repeat(120))
		4:
			_control.ban(NOBODY, "")
		_:
			_control.calibrate(_random.randi_range(1, 5), _random.randi_range(0, 7), 0)


## A file of an effect: one that is right, or as large as it may be.
func send_effect() -> void:
	var count: String = "@count %d" % _random.randi_range(1, 200)
	var text: String = EffectTexts.GOOD.replace("@count 50", count)
	if _random.randf() < 0.3:
		text += "//".rpad(60000, "x")
	_control.send_effect("fuzz_%d" % _random.randi_range(0, 200), text)


## A report on a suit, or an answer to a calibration that there is not.
func send_wearer() -> void:
	var number: int = 0 if _random.randf() < 0.7 else _random.randi_range(1, 65535)
	_link.send_reliably(WearerMessage.encode(number, true, "%d".repeat(90) % _digits(90)))


## A call of a node that some levels have.
func send_call() -> void:
	_number = (_number + 1) & 0xFFFF
	var call: CallMessage = CallMessage.new()
	call.number = _number
	call.path = "Bell" if _random.randf() < 0.7 else "x/y".repeat(40)
	call.method = "ring"
	call.arguments = [_random.randf(), "x".repeat(900)] if _random.randf() < 0.3 else []
	_link.send_reliably(call.encode())


## A piece of a level that the server has not.
func send_request() -> void:
	var request: LevelRequestMessage = LevelRequestMessage.new()
	request.number = _random.randi_range(0, 65535)
	request.content_hash.resize(LevelRequestMessage.HASH_SIZE)
	request.content_hash.fill(_random.randi_range(0, 255))
	request.length = _random.randi_range(1, LevelRequestMessage.MAX_LENGTH)
	_link.send_reliably(request.encode())


func _digits(p_count: int) -> Array:
	var digits: Array = []
	for _digit: int in p_count:
		digits.append(_random.randi_range(0, 9))
	return digits
