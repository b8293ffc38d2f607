class_name SeatOptions
extends RefCounted
## What a user does and feels in a vehicle (docs/vehicles.md, docs/motion-platform.md).


## Their rows.
static func rows() -> Array[OptionRow]:
	var clients: PackedStringArray = Roles.names()
	return [
		OptionRow.text(
			"drive",
			clients,
			"drive by a list instead of keys: THROTTLE:STEERING:BRAKE:SECONDS, with commas between"
		),
		(
			OptionRow
			. flag(
				"prediction", clients, "show the vehicle that you drive where it will be, at once"
			)
			. or_default(1)
		),
		(
			OptionRow
			. flag(
				"force-feedback", clients, "rumble and a wheel's forces while you sit in a vehicle"
			)
			. or_default(1)
		),
		(
			OptionRow
			. text(
				"platform", clients, "motion platform to send cues to while you sit in a vehicle"
			)
			. shown_as(PlatformAddress.FORM)
		),
		OptionRow.choice(
			"platform-kind",
			clients,
			MotionPlatform.PRESETS[0],
			MotionPlatform.PRESETS,
			"what the motion platform can do (docs/motion-platform.md)"
		),
		OptionRow.number(
			"platform-rate", clients, 200, [100, 250], "cues for the platform", "per second"
		),
	]
