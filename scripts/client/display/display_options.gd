class_name DisplayOptions
extends RefCounted
## How a client shows the world (docs/displays.md).


## Their rows.
static func rows() -> Array[OptionRow]:
	var showing: PackedStringArray = ProgramRoles.showing()
	var sources: PackedStringArray = ["both", "hmd", "suit"]
	return [
		OptionRow.choices_of(
			"views", showing, "mesh,static", WorldViews.NAMES, "worlds to show at the start"
		),
		(
			OptionRow
			. text("physics-at", showing, "when the physics world fades in and out again, s")
			. shown_as("BEGIN,END")
		),
		OptionRow.choice(
			"quality",
			showing,
			"",
			Quality.NAMES,
			"how much is drawn; by default what fits the machine, or what was chosen in the menu"
		),
		OptionRow.text("camera", showing, "camera at the start, degrees and m").shown_as(
			"AZIMUTH,ELEVATION,DISTANCE|around|behind|eyes"
		),
		OptionRow.choice(
			"smoothing",
			showing,
			"adaptive_low_delay",
			WorldReplica.SMOOTHING.keys(),
			"method for the motion between updates (docs/smoothing.md)"
		),
		OptionRow.number(
			"fps",
			showing,
			FramePacer.HEADLESS_FPS,
			[1, 1000],
			"frames without a window",
			"per second"
		),
		OptionRow.choice(
			"display",
			showing,
			DisplayNames.WINDOW,
			DisplayNames.ALL,
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
		OptionRow.decimal(
			"eye-distance",
			showing,
			0.065,
			[0.0, 1.0],
			"between the eyes, for displays without a headset",
			"m"
		),
		OptionRow.decimal(
			"convergence",
			showing,
			3.0,
			[0.1, 10000.0],
			"distance of what both eyes see at the same place of the screen",
			"m"
		),
		OptionRow.flag("swap-eyes", showing, "give each eye the other one's picture (key Y)"),
		OptionRow.file("layout", showing, "where screens are, for --display=wall"),
		(
			OptionRow
			. text("screens", showing, "screens of the layout to show; all by default")
			. shown_as("NAME,...")
		),
		OptionRow.choice(
			"head-orientation", showing, "both", sources, "what turns the head of your body"
		),
		OptionRow.choice(
			"head-position", showing, "both", sources, "what places your body in the room"
		),
		(
			OptionRow
			. choice(
				"mirror",
				showing,
				"steady",
				["steady", "reduced", "none"],
				"what the window shows of a headset: a calm view, the same at half resolution, or nothing"
			)
		),
		(
			OptionRow
			. text(
				"marker",
				showing,
				"where the level has the marker that hangs on the real wall: m, heading in degrees"
			)
			. shown_as("X,Y,Z,HEADING[,NAME]")
		),
		OptionRow.flag("seated", showing, "you sit: the headset's height does not count"),
		(
			OptionRow
			. text("turn", showing, "how the right thumbstick turns you; by default by 30 degrees")
			. shown_as(StickTurn.FORM)
			. or_default("snap")
		),
		OptionRow.decimal(
			"vignette",
			showing,
			0.5,
			[0.0, 1.0],
			"how much the edge of the view darkens while you are turned or moved; 0: never",
			""
		),
	]
