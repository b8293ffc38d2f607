extends TestCase
## Orders as bytes: fields of the world as an argument.


func test_fields_come_back_as_they_were_written() -> void:
	var fields: Dictionary[StringName, float] = {&"time_of_day": 18.25, &"weather": 3.0}
	var order: OrderMessage = OrderMessage.new()
	order.kind = OrderMessage.Kind.FIELDS
	order.argument = OrderMessage.write_fields(fields)
	var back: OrderMessage = OrderMessage.decode(order.encode())
	equal(back.kind, OrderMessage.Kind.FIELDS)
	equal(OrderMessage.read_fields(back.argument), fields)


func test_what_is_no_field_is_nothing() -> void:
	for text: String in ["", "a", "a=", "=1", "a=b", "a=1=2", "a=nan", "a=inf", "a=1 b", "a=1e999"]:
		is_true(OrderMessage.read_fields(text).is_empty(), text)
