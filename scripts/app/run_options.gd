class_name RunOptions
extends RefCounted
## How long the program runs, and what it writes: the options that most roles have.


## Their rows.
static func rows() -> Array[OptionRow]:
	var showing: PackedStringArray = ProgramRoles.showing()
	var all: PackedStringArray = ProgramRoles.names()
	var recording: PackedStringArray = PackedStringArray([ProgramRoles.SERVER]) + showing
	var drawing: PackedStringArray = PackedStringArray([ProgramRoles.START]) + showing
	return [
		OptionRow.choice(
			"renderer",
			drawing,
			RendererChoice.AUTO,
			RendererChoice.NAMES,
			"renderer of the engine; auto: gl_compatibility where a processor draws"
		),
		OptionRow.file("config", all, "read options from this file, see docs/options.md"),
		OptionRow.file(
			"log-file", all, "write the log to this file too; a server reopens it after SIGHUP"
		),
		OptionRow.choice("log-level", all, "info", Log.LEVELS, "lines that are left out below it"),
		OptionRow.choice("role", all, "", all, "role to start; by default server or observer"),
		OptionRow.decimal("duration", all, 0.0, [0.0, 1e7], "end after this time; 0: never", "s"),
		OptionRow.file("report", all, "write stats to this file (JSON)"),
		OptionRow.decimal(
			"report-every",
			recording,
			ReportFile.PERIOD_S,
			[0.02, 86400.0],
			"time between two writings of --report",
			"s"
		),
		OptionRow.file(
			"record", recording, "record what this client receives, or everything at the server"
		),
	]
