class_name WalkOptions
extends RefCounted
## How a user walks who has no suit (docs/walker.md).


## Their rows.
static func rows() -> Array[OptionRow]:
	var moving: PackedStringArray = [Roles.name_of(Roles.Role.TRAINEE)]
	return [
		OptionRow.text("walk", moving, "walk by a list instead of keys: " + WalkScript.FORM),
		OptionRow.file(
			"motion-set", moving, "walk by the gait that ./run motion-set record made of you"
		),
		OptionRow.choice(
			"walk-by", moving, "head", ["head", "hand"], "where ahead is for the stick of a headset"
		),
	]
