class_name WorldOptions
extends RefCounted
## Which world a server has, its weather, and who gets a body in it.


## Their rows.
static func rows() -> Array[OptionRow]:
	var server: PackedStringArray = [ProgramRoles.SERVER]
	return [
		(
			OptionRow
			. text("world", server, "the level: one of the program's, or of --levels")
			. or_default(LevelStore.DEFAULT)
			. shown_as("|".join(LevelStore.names()) + "|NAME")
		),
		(
			OptionRow
			. file("levels", server, "folder of levels that clients may get from this server")
			. shown_as("FOLDER")
		),
		(
			OptionRow
			. file("effects", server, "folder of effects; what changes in it goes to all clients")
			. shown_as("FOLDER")
		),
		OptionRow.text(
			"time", server, "time of day at the start, hours; by default the level's own"
		),
		OptionRow.choice(
			"weather",
			server,
			"",
			WorldConditions.WEATHERS,
			"weather at the start; by default the level's own"
		),
		OptionRow.number(
			"level-bandwidth",
			server,
			LevelOffers.DEFAULT_KBITS,
			[100, 10_000_000],
			"limit for all downloads of levels together",
			"kbit/s"
		),
		(
			OptionRow
			. number(
				"max-people",
				server,
				PeopleChanges.DEFAULT_MAX,
				# Each has 16 bodies of the 10,240 that the engine has room for.
				[1, 500],
				"maximum of people who have a body, of all clients together"
			)
		),
		OptionRow.choice(
			"root",
			server,
			"grounded",
			RootModes.BY_NAME.keys(),
			"how people's travel is found and followed"
		),
	]
