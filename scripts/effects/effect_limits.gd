@tool
class_name EffectLimits
extends RefCounted
## What every effect keeps to, be it a file of ours or one that came over the network: see
## [EffectFile].

## Largest file, bytes.
const MAX_BYTES: int = 65536
## Longest name, characters.
const MAX_NAME: int = 40
## Problems that are named at once; one mistake often makes many.
const MAX_PROBLEMS: int = 20

static var _name: RegEx = RegEx.create_from_string("^[a-z][a-z0-9_]{0,39}$")


## Whether an effect can have this name: small letters, digits and _, at most
## [constant MAX_NAME] of them.
static func is_name(p_name: String) -> bool:
	return _name.search(p_name) != null and not p_name.contains("\n")
