extends TestCase
## As what people are shown who choose no avatar.

const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")

var _people: ServerPeople = null
var _table: EntityTable = null


func before_each() -> void:
	_people = ServerPeople.new()
	_people.scene = PERSON
	_table = EntityTable.new()
	_people.setup(_table)
	add_child(_people)


func after_each() -> void:
	_people.free()


func test_who_chooses_no_avatar_gets_that_of_the_level() -> void:
	_people.default_avatar = "show"
	var cards: Array[PersonCard] = [PersonCard.of("Ada", 0.95), PersonCard.of("Bob", 0.95)]
	cards[1].index = 1
	cards[1].avatar = "raider"
	_people.set_people(7, cards, "Ada")
	_people.settle()
	equal(_table.person_of(7, 0).path, "show")
	equal(_table.person_of(7, 1).path, "raider")


func test_the_next_level_changes_only_who_comes_later() -> void:
	_people.default_avatar = "show"
	var ada: Array[PersonCard] = [PersonCard.of("Ada", 0.95)]
	_people.set_people(7, ada, "Ada")
	_people.settle()
	_people.default_avatar = ""
	var bob: Array[PersonCard] = [PersonCard.of("Bob", 0.95)]
	_people.set_people(8, bob, "Bob")
	_people.settle()
	var shown: Array[String] = []
	for person: ServerPerson in _people.list():
		shown.append(person.card.avatar)
	equal(shown, ["show", ""] as Array[String])
