class_name ReplayOptions
extends RefCounted
## Which recording a replay plays.


## Their rows.
static func rows() -> Array[OptionRow]:
	return [
		OptionRow.file("file", [ProgramRoles.REPLAY], "recording to replay"),
		OptionRow.decimal(
			"from", [ProgramRoles.REPLAY], 0.0, [0.0, 1e7], "where in the recording to begin", "s"
		),
	]
