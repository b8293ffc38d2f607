extends TestCase
## Commands and events on the wire.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 5


func test_the_last_commands_go_through_with_their_numbers() -> void:
	var commands: Array[EntityCommand] = []
	for number: int in [65534, 65535, 0, 1]:
		var command: EntityCommand = EntityCommand.new()
		command.number = number
		command.tick = 70000 + number
		command.entity = 1024 + number % 7
		command.command = number % 3
		command.bytes = NetSamples.noise(_random, 20)
		commands.append(command)
	var read: Array[EntityCommand] = CommandMessage.decode(CommandMessage.encode(commands))
	equal(read.size(), 4)
	for index: int in read.size():
		var sent: EntityCommand = commands[index]
		equal([read[index].number, read[index].tick], [sent.number, sent.tick])
		equal([read[index].entity, read[index].command], [sent.entity, sent.command])
		equal(read[index].bytes, sent.bytes)


func test_a_command_that_goes_on_costs_its_values_and_a_byte() -> void:
	var commands: Array[EntityCommand] = []
	for number: int in 8:
		var command: EntityCommand = EntityCommand.new()
		command.number = number
		command.tick = 500 + number
		command.entity = 1
		command.command = 1
		command.bytes = NetSamples.noise(_random, 8).slice(0, 8)
		command.bytes.resize(8)
		commands.append(command)
	var bytes: PackedByteArray = CommandMessage.encode(commands)
	equal(bytes.size(), 4 + 9 + 8 + 7 * 9)
	var read: Array[EntityCommand] = CommandMessage.decode(bytes)
	for index: int in 8:
		equal(read[index].bytes, commands[index].bytes)
		equal([read[index].tick, read[index].entity, read[index].command], [500 + index, 1, 1])


func test_what_is_known_is_not_made_again() -> void:
	var commands: Array[EntityCommand] = []
	for number: int in 8:
		var command: EntityCommand = EntityCommand.new()
		command.number = (65533 + number) & 0xFFFF
		command.tick = 500 + number
		command.entity = 3 if number < 5 else 4
		command.bytes = NetSamples.noise(_random, 20)
		commands.append(command)
	var bytes: PackedByteArray = CommandMessage.encode(commands)
	equal(CommandMessage.newest_in(bytes), 4)
	for known: int in 8:
		var read: Array[EntityCommand] = CommandMessage.decode(bytes, commands[known].number)
		equal(read.size(), 7 - known)
		for index: int in read.size():
			var sent: EntityCommand = commands[known + 1 + index]
			equal([read[index].number, read[index].tick], [sent.number, sent.tick])
			equal([read[index].entity, read[index].bytes], [sent.entity, sent.bytes])


func test_events_go_through() -> void:
	var events: Array[EntityEvent] = []
	for number: int in 5:
		var event: EntityEvent = EntityEvent.new()
		event.number = number
		event.tick = 100 + number
		event.entity = number
		event.event = number
		event.bytes = NetSamples.noise(_random, 9)
		events.append(event)
	var read: Array[EntityEvent] = EventMessage.decode(EventMessage.encode(events))
	equal(read.size(), 5)
	equal([read[4].tick, read[4].entity, read[4].bytes], [104, 4, events[4].bytes])


func test_damage_and_noise_are_bounded() -> void:
	var command: EntityCommand = EntityCommand.new()
	command.bytes = PackedByteArray([1, 2, 3])
	var good: PackedByteArray = CommandMessage.encode([command])
	for _time: int in 3000:
		var damaged: PackedByteArray = NetSamples.damage(_random, good)
		is_true(CommandMessage.decode(damaged).size() <= CommandMessage.MAX_REPEATED)
		for event: EntityEvent in EventMessage.decode(NetSamples.noise(_random, 300)):
			is_true(event.bytes.size() <= EventMessage.MAX_BYTES)
