class_name LoadOptions
extends RefCounted
## What a load puts on a server (docs/load.md).

## Maximum of trainees, and of observers.
const _MAX: int = 500


## Their rows.
static func rows() -> Array[OptionRow]:
	var load_only: PackedStringArray = [ProgramRoles.LOAD]
	return [
		OptionRow.number("trainees", load_only, 1, [0, _MAX], "clients that send motion"),
		OptionRow.number("walkers", load_only, 0, [0, _MAX], "clients that walk without a suit"),
		OptionRow.number("observers", load_only, 1, [0, _MAX], "clients that watch"),
	]


## How many clients there are together.
static func count_clients(p_options: Options) -> int:
	return (
		p_options.number("trainees") + p_options.number("walkers") + p_options.number("observers")
	)
