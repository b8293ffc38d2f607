extends TestCase
## An instructor's orders for things of the level.

var _replica: WorldReplica = WorldReplica.new()
var _entities: Listener = null
var _orders: ThingOrders = null


## Notes what would be sent.
class Listener:
	extends ClientEntities
	var sent: Array[int] = []

	func send_command(p_entity: int, _command: int, _values: PackedFloat32Array, _at: int) -> void:
		sent.append(p_entity)


func before_each() -> void:
	_entities = Listener.new(_replica)
	_orders = ThingOrders.new(_replica, _entities)


func test_things_are_found_by_name_whole_shortened_or_all() -> void:
	for name: String in ["Tank", "Tank2", "Truck"]:
		_add(name)
	equal(_orders.names("upright"), PackedStringArray(["Tank", "Tank2", "Truck"]))
	equal(_orders.give("upright", "Tank"), "upright: Tank")
	equal(_orders.give("upright", "tr"), "upright: Truck")
	equal(_entities.sent.size(), 2)
	_orders.give("upright", "*")
	equal(_entities.sent.size(), 5)
	contains(_orders.give("upright", "Boat"), "Tank, Tank2, Truck")


func test_where_there_is_nothing_that_is_said() -> void:
	equal(_orders.give("upright", "*"), "there is nothing to upright in this level")
	equal(
		ThingOrders.new(null, null).give("repair", "x"), "there is nothing to repair in this level"
	)


func _add(p_name: String) -> void:
	var row: EntityRow = EntityRow.new()
	row.type = load("res://scenes/vehicle/tank/tank_type.tres")
	row.source = EntityRow.Source.LEVEL
	row.path = "Props/%s/Entity" % p_name
	_replica.table.spawn(row)
