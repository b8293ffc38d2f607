class_name DisplayOptions
extends RefCounted
## The options of displays, see [ProgramOptions]: how a client shows the world (docs/displays.md).


## All of them.
static func rows() -> Array[OptionRow]:
	var showing: PackedStringArray = ProgramRoles.showing()
	var rows: Array[OptionRow] = [
		OptionRow.choice(
			"display",
			showing,
			DisplayNames.WINDOW,
			DisplayNames.all(),
			"how the world is shown (docs/displays.md)"
		),
		OptionRow.choice(
			"vsync",
			showing,
			"auto",
			["auto", "on", "off"],
			"whether frames wait for the screen; auto: not where the processor draws them"
		),
		(
			OptionRow
			. flag("late-frames", showing, "begin frames as late as the screen allows")
			. or_default(1)
		),
	]
	return rows + _stereo(showing) + _walls(showing) + _headset(showing)


static func _stereo(p_showing: PackedStringArray) -> Array[OptionRow]:
	return [
		OptionRow.decimal(
			"eye-distance",
			p_showing,
			0.065,
			[0.0, 1.0],
			"between the eyes, for displays without a headset",
			"m"
		),
		OptionRow.decimal(
			"convergence",
			p_showing,
			3.0,
			[0.1, 10000.0],
			"distance of what both eyes see at the same place of the screen",
			"m"
		),
		OptionRow.flag("swap-eyes", p_showing, "give each eye the other one's picture (key Y)"),
	]


static func _walls(p_showing: PackedStringArray) -> Array[OptionRow]:
	return [
		OptionRow.file("layout", p_showing, "where screens are, for --display=wall"),
		(
			OptionRow
			. text("screens", p_showing, "screens of the layout to show; all by default")
			. shown_as("NAME,...")
		),
	]


static func _headset(p_showing: PackedStringArray) -> Array[OptionRow]:
	var sources: PackedStringArray = ["both", "hmd", "suit"]
	return [
		OptionRow.choice(
			"head-orientation", p_showing, "both", sources, "what turns the head of your body"
		),
		OptionRow.choice(
			"head-position", p_showing, "both", sources, "what places your body in the room"
		),
		(
			OptionRow
			. choice(
				"mirror",
				p_showing,
				"steady",
				["steady", "reduced", "none"],
				"what the window shows of a headset: a calm view, the same at half resolution, or nothing"
			)
		),
		(
			OptionRow
			. text(
				"marker",
				p_showing,
				"where the level has the marker that hangs on the real wall: m, heading in degrees"
			)
			. shown_as("X,Y,Z,HEADING[,NAME]")
		),
		OptionRow.flag("seated", p_showing, "you sit: the headset's height does not count"),
		OptionRow.number(
			"snap-turn", p_showing, 30, [0, 90], "turn by a thumbstick; 0: none", "degrees"
		),
		(
			OptionRow
			. flag(
				"vignette", p_showing, "darken the edge of the view while you are turned or moved"
			)
			. or_default(1)
		),
	]
