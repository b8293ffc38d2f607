class_name WindowOptions
extends RefCounted
## Options of what a client's window does without a user, and what is saved of it.


## Their rows.
static func rows() -> Array[OptionRow]:
	var showing: PackedStringArray = ProgramRoles.showing()
	var clients: PackedStringArray = Roles.names()
	return [
		OptionRow.text(
			"use", clients, "use the Interactable at or below a node of this name, once it is there"
		),
		OptionRow.file("screenshot", showing, "save a picture (PNG) in high quality at the end"),
		OptionRow.file("latency-csv", showing, "write the latency of each sample, stage by stage"),
	]
