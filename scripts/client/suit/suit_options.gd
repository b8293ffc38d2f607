class_name SuitOptions
extends RefCounted
## Where motion comes from, whose it is, and where it goes to (docs/sources.md).


## Their rows.
static func rows() -> Array[OptionRow]:
	var moving: PackedStringArray = ProgramRoles.moving()
	var with_load: PackedStringArray = moving + PackedStringArray([ProgramRoles.LOAD])
	var kinds: String = ", ".join(SourceAddress.describe_kinds())
	var groups: String = ", ".join(LimbFusion.NAMES)
	return [
		OptionRow.files("bvh", with_load, "motion files, played in a loop, one person each"),
		(
			OptionRow
			. text(
				"source",
				moving,
				(
					"motion from elsewhere; again, or with commas, for more (docs/sources.md); by default"
					+ " you walk by keys: "
					+ kinds
				)
			)
			. or_more()
			. shown_as("KIND[:ADDRESS]")
		),
		(
			OptionRow
			. text(
				"fuse",
				moving,
				"limbs of the first source's person that another source gives: " + groups
			)
			. shown_as("GROUP:NUMBER,...")
		),
		(
			OptionRow
			. text("vmc-out", moving, "send your people's poses by the VMC protocol")
			. or_bare("127.0.0.1:%d" % SourceAddress.PORTS["vmc"])
			. shown_as("HOST:PORT")
		),
		OptionRow.decimal(
			"bvh-from", moving, 0.0, [0.0, 1e6], "moment of the motion files to begin at", "s"
		),
		OptionRow.flag("xbus", moving, "motion from the suit on this machine's USB ports"),
		OptionRow.number("suit-rate", moving, 100, [10, 512], "samples of the suit", "per second"),
		OptionRow.file("suit-record", moving, "record every byte of suits and of MVN in this file"),
		OptionRow.file("suit-play", moving, "motion from a file of --suit-record, in a loop"),
		OptionRow.text("person", moving, "who wears the suit: name of size and calibration"),
		OptionRow.choice(
			"avatar",
			moving,
			"",
			AvatarStore.NAMES,
			(
				"what the others see you as; by default as the world says, else %s"
				% AvatarStore.NAMES[0]
			)
		),
		OptionRow.number("webcam-people", moving, 1, [1, 4], "people before a webcam that move"),
		OptionRow.decimal(
			"webcam-fov",
			moving,
			65.0,
			[20.0, 170.0],
			"what a webcam sees across its picture",
			"degrees"
		),
		OptionRow.decimal(
			"webcam-height", moving, 0.0, [0.0, 2.5], "height of who is before it; 0: usual", "m"
		),
		OptionRow.choice(
			"calibrate", moving, "", ClientCalibration.KINDS.keys(), "calibrate at the start"
		),
		OptionRow.flag("panel", moving, "open the device panel at the start (key M)"),
		OptionRow.flag(
			"try",
			moving,
			"see yourself first: the device panel's mirror opens, and its button joins the server"
		),
		OptionRow.text("unit", with_load, "unit of the motion file; guessed by default").shown_as(
			"|".join(BvhOptions.UNITS.keys()) + "|METRES"
		),
		OptionRow.choice(
			"up",
			with_load,
			"",
			BvhOptions.AXES.keys(),
			"up axis of the motion file; guessed by default"
		),
		OptionRow.number("rate", with_load, 60, [1, 240], "samples to send", "per second"),
		OptionRow.choice(
			"feedback",
			moving,
			"local",
			["local", "server"],
			"your own body: shown at once, or as the server simulates it"
		),
	]
