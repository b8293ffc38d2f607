class_name SharedTables
extends RefCounted
## Decodes each message about the entity table once, however many clients of a process get it.

## Messages that are remembered.
const KEPT: int = 256

var _known: Dictionary[int, EntityTableMessage] = {}


## The message of some bytes, for a client that knows these types; null if it is none. Nobody may
## change it.
func decode(p_bytes: PackedByteArray, p_types: Array[EntityType]) -> EntityTableMessage:
	var key: int = hash([p_bytes, p_types.size()])
	if not _known.has(key):
		if _known.size() >= KEPT:
			_known.erase(_known.keys()[0])
		_known[key] = EntityTableMessage.decode(p_bytes, p_types)
	return _known[key]
