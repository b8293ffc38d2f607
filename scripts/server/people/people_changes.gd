class_name PeopleChanges
extends RefCounted
## Brings the people on the server to those who are wanted: bodies are made and removed a little in
## each tick, so that no change delays a tick.

## A body has been made: it is in the tree, at its position, and started. Its joints are as [method
## Ragdoll.get_joints] has them.
signal made(p_key: int, p_wanted: Wanted, p_ragdoll: Ragdoll, p_joints: PersonSkeleton)
## A body has to go now: [method discard] takes it.
signal left(p_key: int)

## Default of the maximum of people: as many as two cores simulate in real time.
const DEFAULT_MAX: int = 128

## Maximum of people of all sessions.
var max_people: int = DEFAULT_MAX
## How people's travel is found.
var root_mode: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT
## What a tick spends.
var budget: WorkBudget = WorkBudget.new()

var _workshop: RagdollWorkshop = null
var _start_of: Callable = Callable()
var _wanted: Dictionary[int, Wanted] = {}
## The card of each body that is there.
var _present: Dictionary[int, PersonCard] = {}
## People whose bodies are to be made or removed, in the order of the requests.
var _due: Dictionary[int, bool] = {}


## Somebody who is to be there.
class Wanted:
	var session: int = 0
	var card: PersonCard = null
	var name: String = ""


## Bodies are instances of a scene, and get into the tree below a node.
## [code]func(key: int, avatar: String) -> Transform3D[/code] says where somebody starts, m, and
## which way it faces.
func _init(p_scene: PackedScene, p_parent: Node3D, p_start_of: Callable) -> void:
	_workshop = RagdollWorkshop.new(p_scene, p_parent)
	_start_of = p_start_of


## Makes some bodies in advance.
func prepare() -> void:
	_workshop.prepare()


## The key of a person: its session, and its index among the session's people.
static func key_of(p_session: int, p_index: int) -> int:
	return p_session * PersonCard.MAX_PEOPLE + p_index


## Sets the people of a session. Returns how many of them there is no room for. [param p_name] is
## for people without a name.
func take_list(p_session: int, p_cards: Array[PersonCard], p_name: String) -> int:
	var listed: Dictionary[int, PersonCard] = {}
	for card: PersonCard in p_cards:
		listed[card.index] = card
	for index: int in PersonCard.MAX_PEOPLE:
		if not listed.has(index):
			_forget(key_of(p_session, index))
	var refused: int = 0
	for index: int in listed:
		var key: int = key_of(p_session, index)
		if not _wanted.has(key) and _wanted.size() >= max_people:
			refused += 1
			continue
		_want(key, p_session, listed[index], p_name)
	return refused


## The person who is wanted under a number, or null.
func wanted(p_key: int) -> Wanted:
	return _wanted.get(p_key)


## Number of people who are there or will be.
func count() -> int:
	return _wanted.size()


## Whether all is as it is to be.
func is_settled() -> bool:
	return _due.is_empty()


## Does what fits into a tick.
func advance() -> void:
	budget.begin()
	# First of all: a flood of changes must not fill the memory.
	if _workshop.waste_count() > 0:
		budget.do(&"free", _workshop.tidy)
	while not _due.is_empty():
		var kind: StringName = _next_kind()
		if kind != &"" and not (budget.allows(kind) and _workshop.is_ready()):
			break
		_do_next(kind)
	while _due.is_empty() and _workshop.waste_count() > 0 and budget.allows(&"free"):
		budget.do(&"free", _workshop.tidy)
	budget.end()


## Makes a body for the stock, which takes a millisecond: call it where no tick waits for it.
## Without a stock people wait a little longer for their bodies.
func restock() -> void:
	_workshop.restock()


## Does everything at once, for tests and measurements.
func settle() -> void:
	while not _due.is_empty():
		_do_next(_next_kind())


## Takes a body that is no longer needed.
func discard(p_ragdoll: Ragdoll) -> void:
	_workshop.discard(p_ragdoll)


## For a report: who is due, and what ticks in which bodies were made or removed have spent on it.
func stats() -> Dictionary:
	return {
		"wanted": _wanted.size(),
		"due": _due.size(),
		"waste": _workshop.waste_count(),
		"ticks": budget.time.count(),
		"ms_p50": budget.time.percentile(0.5) * 1000.0,
		"ms_p99": budget.time.percentile(0.99) * 1000.0,
		"ms_max": budget.time.percentile(1.0) * 1000.0,
	}


## Frees what belongs to nobody.
func close() -> void:
	_workshop.close()


func _want(p_key: int, p_session: int, p_card: PersonCard, p_name: String) -> void:
	var one: Wanted = _wanted.get(p_key)
	if one == null:
		one = Wanted.new()
		_wanted[p_key] = one
	one.session = p_session
	one.card = p_card
	one.name = p_card.name if p_card.name != "" else p_name
	var card: PersonCard = _present.get(p_key)
	if card == null or not card.is_same_body(p_card):
		_due[p_key] = true


func _forget(p_key: int) -> void:
	if _wanted.erase(p_key):
		_due[p_key] = true


## The kind of the next part of work; an empty name if it is none.
func _next_kind() -> StringName:
	var key: int = _first()
	if _must_go(key):
		return &"remove"
	if not _wanted.has(key) or _present.has(key):
		return &""
	if _workshop.card != _wanted[key].card:
		return &"begin"
	return _workshop.next_kind() if _workshop.next_kind() != &"" else &"enter"


func _do_next(p_kind: StringName) -> void:
	var key: int = _first()
	match p_kind:
		&"":
			# Who is no longer wanted may be half made.
			_workshop.drop()
			_due.erase(key)
		&"remove":
			budget.do(p_kind, _remove.bind(key))
		&"begin":
			var card: PersonCard = _wanted[key].card
			var start: Callable = _start_of.bind(key, AvatarStore.resolve(card.avatar))
			budget.do(p_kind, _workshop.begin.bind(card, root_mode, start))
		&"enter":
			budget.do(p_kind, _enter.bind(key))
		_:
			budget.do(p_kind, _workshop.advance)


func _first() -> int:
	for key: int in _due:
		return key
	return -1


func _must_go(p_key: int) -> bool:
	var card: PersonCard = _present.get(p_key)
	var one: Wanted = _wanted.get(p_key)
	return card != null and (one == null or not card.is_same_body(one.card))


func _remove(p_key: int) -> void:
	_present.erase(p_key)
	left.emit(p_key)


func _enter(p_key: int) -> void:
	_due.erase(p_key)
	var one: Wanted = _wanted[p_key]
	if _workshop.has_failed:
		Log.limited("server", "body", "'%s' gets no body: the scene has a fault" % one.name)
		_workshop.drop()
		_wanted.erase(p_key)
		return
	_present[p_key] = one.card
	made.emit(p_key, one, _workshop.hand_over(), _workshop.joints)
