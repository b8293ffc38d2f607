class_name PeopleFusion
extends RefCounted
## Who of all sources is one of the people, and who completes the first source's person limb by limb
## ([LimbFusion]). Sources have numbers from 1 on.

## Somebody is one of the people now.
signal appeared(p_source: MotionSource, p_name: String)
## Somebody is one no more.
signal vanished(p_source: MotionSource)

## The groups that somebody who walks by keys or a stick gives to another: all or none.
const WALKED: Array[LimbFusion.Group] = [
	LimbFusion.Group.ROOT, LimbFusion.Group.LEGS, LimbFusion.Group.FEET
]

## The first source's person, completed by others; null while nobody is.
var fusion: LimbFusion = null
## How many sources there are.
var count: int = 0
## Number of the source that walks by keys or a stick; 0: there is none.
var walker: int = 0

# Which source gives a group of limbs, those that complete the first one's person, and all who are
# there: source, name, number.
var _choices: Dictionary[LimbFusion.Group, int] = {}
var _completing: Dictionary[int, MotionSource] = {}
var _present: Array[Array] = []
# The first source's first person, or null.
var _foremost: MotionSource = null


## Reads choices such as "feet:2,head:3" for the sources that there are. Returns what is wrong, or
## an empty text.
func read(p_text: String) -> String:
	var fault: String = LimbFusion.parse(p_text, _choices)
	if fault != "":
		return "--fuse is " + fault
	for number: int in _choices.values():
		if number > count:
			return "--fuse names source %d, and there are %d" % [number, count]
	for group: LimbFusion.Group in _choices.keys():
		var limit: String = _limit_of(group, _choices[group])
		if limit != "":
			return "--fuse: " + limit
		_take_along(group, _choices[group])
	return ""


## Whether the first source's person walks by keys or a stick.
func is_carried() -> bool:
	return walker > 1 and choice(LimbFusion.Group.LEGS) == walker


## Whether one of the people, as told by [signal appeared], is the one who does.
func carries(p_person: MotionSource) -> bool:
	return is_carried() and p_person == _foremost


## Lets a source of a number give a group of limbs of the first one's person; 1 gives it back.
## Returns why it can't, or an empty text.
func choose(p_group: LimbFusion.Group, p_number: int) -> String:
	if p_number < 1 or p_number > count:
		return "there is no source %d, only 1 to %d" % [p_number, count]
	var limit: String = _limit_of(p_group, p_number)
	if limit != "":
		return limit
	var before: Dictionary[int, bool] = _completing_numbers()
	var was_carried: bool = is_carried()
	_take_along(p_group, p_number)
	_choices[p_group] = p_number
	if fusion != null:
		for group: LimbFusion.Group in _choices:
			fusion.choose(group, _choices[group])
	if fusion == null or _completing_numbers() != before or is_carried() != was_carried:
		# Everybody comes anew, as the choices have it.
		var present: Array[Array] = _present.duplicate()
		for row: Array in present:
			vanish(row[0])
		for row: Array in present:
			appear(row[0], row[1], row[2])
	return ""


## Which source gives a group.
func choice(p_group: LimbFusion.Group) -> int:
	return _choices.get(p_group, 1)


## Somebody of the source of a number: the name, or what the source says of itself; empty if nobody
## is there.
func find_person(p_number: int) -> String:
	for row: Array in _present:
		if row[2] == p_number:
			return row[1] if row[1] != "" else (row[0] as MotionSource).describe()
	return ""


## Somebody of the source of a number has come.
func appear(p_source: MotionSource, p_name: String, p_number: int) -> void:
	_present.append([p_source, p_name, p_number])
	if p_number == walker and is_carried():
		return
	var completes: bool = p_number > 1 and _choices.values().has(p_number)
	if completes and not _completing.has(p_number):
		_completing[p_number] = p_source
		if fusion != null:
			fusion.set_source(p_number, p_source)
		return
	if p_number != 1 or fusion != null or _completing_numbers().is_empty():
		if p_number == 1 and _foremost == null:
			_foremost = p_source
		appeared.emit(p_source, p_name)
		return
	fusion = LimbFusion.new(p_source)
	for group: LimbFusion.Group in _choices:
		fusion.choose(group, _choices[group])
	for number: int in _completing:
		fusion.set_source(number, _completing[number])
	_foremost = fusion
	appeared.emit(fusion, p_name)


## Somebody has gone.
func vanish(p_source: MotionSource) -> void:
	_present = _present.filter(func(row: Array) -> bool: return row[0] != p_source)
	if p_source == _foremost or (fusion != null and p_source == fusion.first()):
		_foremost = null
	var number: Variant = _completing.find_key(p_source)
	if number != null:
		_completing.erase(number)
		if fusion != null:
			fusion.set_source(number, null)
	elif fusion != null and fusion.first() == p_source:
		var gone: LimbFusion = fusion
		fusion = null
		vanished.emit(gone)
	else:
		vanished.emit(p_source)


## Why a source can't give a group, or an empty text.
func _limit_of(p_group: LimbFusion.Group, p_number: int) -> String:
	if walker == 1 and p_number != walker:
		return (
			"source 1 walks: name it after the source that has arms and head, such as"
			+ " --source=xr --source=walker --fuse=legs:2"
		)
	if walker == 0 or p_number != walker or walker == 1 or WALKED.has(p_group):
		return ""
	return "source %d walks: it gives legs, feet and root, together" % walker


## Gives the rest of what walks with a group that is given to the walker, or taken from it.
func _take_along(p_group: LimbFusion.Group, p_number: int) -> void:
	if walker < 2 or not WALKED.has(p_group):
		return
	var was_walked: bool = choice(p_group) == walker
	for group: LimbFusion.Group in WALKED:
		if p_number == walker:
			_choices[group] = walker
		elif was_walked and choice(group) == walker:
			_choices[group] = 1


## Numbers of the sources that complete the first one limb by limb, in no order.
func _completing_numbers() -> Dictionary[int, bool]:
	var numbers: Dictionary[int, bool] = {}
	for number: int in _choices.values():
		if number > 1 and number != walker:
			numbers[number] = true
	return numbers
