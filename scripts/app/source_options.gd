class_name SourceOptions
extends RefCounted
## The options that say where motion comes from and goes to.


## Their rows, for roles that send motion and for those and the load.
static func rows(p_moving: PackedStringArray, p_with_load: PackedStringArray) -> Array[OptionRow]:
	var kinds: String = ", ".join(SourceAddress.describe_kinds())
	var groups: String = ", ".join(LimbFusion.NAMES)
	return [
		OptionRow.files("bvh", p_with_load, "motion files, played in a loop, one person each"),
		(
			OptionRow
			. text(
				"source",
				p_moving,
				"motion from elsewhere; again, or with commas, for more (docs/sources.md): " + kinds
			)
			. or_more()
			. shown_as("KIND[:ADDRESS]")
		),
		(
			OptionRow
			. text(
				"fuse",
				p_moving,
				"limbs of the first source's person that another source gives: " + groups
			)
			. shown_as("GROUP:NUMBER,...")
		),
		(
			OptionRow
			. text("vmc-out", p_moving, "send your people's poses by the VMC protocol")
			. or_bare("127.0.0.1:%d" % SourceAddress.PORTS["vmc"])
			. shown_as("HOST:PORT")
		),
		OptionRow.decimal(
			"bvh-from", p_moving, 0.0, [0.0, 1e6], "moment of the motion files to begin at", "s"
		),
		OptionRow.file(
			"default-bvh", p_moving, "motion file if no source is given; ./run gives one of ours"
		),
		OptionRow.flag("xbus", p_moving, "motion from the suit on this machine's USB ports"),
		OptionRow.number(
			"suit-rate", p_moving, 100, [10, 512], "samples of the suit", "per second"
		),
		(
			OptionRow
			. number("mvn", p_moving, 0, [0, 65535], "UDP port for MVN's network stream; 0: none")
			. or_bare(str(SourceAddress.PORTS["mvn"]))
		),
		OptionRow.text(
			"tracker", p_moving, "body tracker of another plugin, such as /user/body_tracker"
		),
		OptionRow.file(
			"suit-record", p_moving, "record every byte of suits and of MVN in this file"
		),
		OptionRow.file("suit-play", p_moving, "motion from a file of --suit-record, in a loop"),
	]
