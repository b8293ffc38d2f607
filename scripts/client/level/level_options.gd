class_name LevelOptions
extends RefCounted
## What a client keeps of levels that servers send (docs/levels.md).


## Their rows.
static func rows() -> Array[OptionRow]:
	var clients: PackedStringArray = Roles.names()
	return [
		OptionRow.number(
			"level-store",
			clients,
			ReceivedLevels.DEFAULT_ROOM >> 20,
			[1, 1 << 20],
			"room for levels that servers have sent",
			"MB"
		),
	]
