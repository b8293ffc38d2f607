class_name SoundOptions
extends RefCounted
## What a client hears (docs/sound.md).


## Their rows.
static func rows() -> Array[OptionRow]:
	var showing: PackedStringArray = ProgramRoles.showing()
	return [
		OptionRow.choice(
			"sound",
			showing,
			"auto",
			ClientSound.MODES,
			"whether the client makes sound; auto: where it has a window (docs/sound.md)"
		),
		OptionRow.text("volume", showing, "how loud all is, instead of the menu's, %").shown_as(
			"0-100"
		),
		OptionRow.flag("captions", showing, "show captions of sounds, whatever the menu says"),
	]
