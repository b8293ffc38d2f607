class_name CommandMessage
extends RefCounted
## The last commands of a client as bytes: client to server, fast path. Each command is sent at once
## and again with the next ones, so that one that gets lost comes with a later datagram.
##
## Little-endian: u8 message; u16 number of the newest command; u8 count, 1 to 8, the newest last;
## of each u8 1 if it is the same command as the one before, of the same entity and size, a tick
## later: then only its values follow. Else u8 0, u32 the server's tick that it is meant for, u16
## entity, u8 which of its type's commands, u8 size, its values as in
## [method EntitySchema.encode].

## Maximum of commands in a datagram.
const MAX_REPEATED: int = 8
## Maximum of bytes of a command's values.
const MAX_BYTES: int = 128


## Number of the newest command in a datagram; -1 where it is too short to have one.
static func newest_in(p_bytes: PackedByteArray) -> int:
	return p_bytes.decode_u16(1) if p_bytes.size() >= 3 else -1


## The bytes; the newest command is the last one.
static func encode(p_commands: Array[EntityCommand]) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.COMMAND, 0, 0, p_commands.size()]
	bytes.encode_u16(1, p_commands[-1].number)
	var before: EntityCommand = null
	for command: EntityCommand in p_commands:
		if before != null and _goes_on(before, command):
			bytes.append(1)
		else:
			var head: PackedByteArray = []
			head.resize(9)
			head.encode_u32(1, command.tick)
			head.encode_u16(5, command.entity)
			head.encode_u8(7, command.command)
			head.encode_u8(8, command.bytes.size())
			bytes.append_array(head)
		bytes.append_array(command.bytes)
		before = command
	return bytes


## The commands in a datagram that are newer than the one whose number is given (-1: all of them),
## oldest first; none if it is invalid. Most are known, and need not be made again.
static func decode(p_bytes: PackedByteArray, p_known: int = -1) -> Array[EntityCommand]:
	var commands: Array[EntityCommand] = []
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var newest: int = reader.read_u16()
	var count: int = reader.read_u8()
	if count < 1 or count > MAX_REPEATED:
		return []
	var head: EntityCommand = EntityCommand.new()
	var size: int = 0
	for index: int in count:
		var goes_on: int = reader.read_u8()
		if goes_on > 1 or (goes_on == 1 and index == 0):
			return []
		if goes_on == 1:
			head.tick = (head.tick + 1) & 0xFFFFFFFF
		else:
			head.tick = reader.read_u32()
			head.entity = reader.read_u16()
			head.command = reader.read_u8()
			size = reader.read_u8()
		if size > MAX_BYTES:
			return []
		head.number = (newest - (count - 1 - index)) & 0xFFFF
		if p_known >= 0 and not CommandQueue.is_newer(head.number, p_known):
			reader.skip(size)
		else:
			commands.append(_made(head, reader.read_bytes(size)))
	return commands if reader.is_complete() else ([] as Array[EntityCommand])


static func _made(p_head: EntityCommand, p_values: PackedByteArray) -> EntityCommand:
	var command: EntityCommand = EntityCommand.new()
	command.number = p_head.number
	command.tick = p_head.tick
	command.entity = p_head.entity
	command.command = p_head.command
	command.bytes = p_values
	return command


static func _goes_on(p_before: EntityCommand, p_command: EntityCommand) -> bool:
	return (
		p_command.tick == p_before.tick + 1
		and p_command.entity == p_before.entity
		and p_command.command == p_before.command
		and p_command.bytes.size() == p_before.bytes.size()
	)
