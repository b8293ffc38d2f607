class_name CommandMessage
extends RefCounted
## The last commands of a client as bytes: client to server, fast path. Each command is sent at once
## and again with the next ones, so that one that gets lost comes with a later datagram.
##
## Little-endian: u8 message; u16 number of the newest command; u8 count, 1 to 8, the newest last;
## of each: u32 the server's tick that it is meant for, u16 entity, u8 which of its type's commands,
## u8 size, its values as in [method EntitySchema.encode].

## Maximum of commands in a datagram.
const MAX_REPEATED: int = 8
## Maximum of bytes of a command's values.
const MAX_BYTES: int = 128


## The bytes; the newest command is the last one.
static func encode(p_commands: Array[EntityCommand]) -> PackedByteArray:
	var bytes: PackedByteArray = [Protocol.Message.COMMAND, 0, 0, p_commands.size()]
	bytes.encode_u16(1, p_commands[-1].number)
	for command: EntityCommand in p_commands:
		var head: PackedByteArray = []
		head.resize(8)
		head.encode_u32(0, command.tick)
		head.encode_u16(4, command.entity)
		head.encode_u8(6, command.command)
		head.encode_u8(7, command.bytes.size())
		bytes.append_array(head)
		bytes.append_array(command.bytes)
	return bytes


## The commands in a datagram, oldest first; none if it is invalid.
static func decode(p_bytes: PackedByteArray) -> Array[EntityCommand]:
	var commands: Array[EntityCommand] = []
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	var newest: int = reader.read_u16()
	var count: int = reader.read_u8()
	if count < 1 or count > MAX_REPEATED:
		return []
	for index: int in count:
		var command: EntityCommand = EntityCommand.new()
		command.number = (newest - (count - 1 - index)) & 0xFFFF
		command.tick = reader.read_u32()
		command.entity = reader.read_u16()
		command.command = reader.read_u8()
		var size: int = reader.read_u8()
		if size > MAX_BYTES:
			return []
		command.bytes = reader.read_bytes(size)
		commands.append(command)
	if not reader.is_complete():
		commands.clear()
	return commands
