@tool
class_name KitCatalogue
extends RefCounted
## What the dock of the editor offers: all that the classes of blocks and the features bring, see
## [KitEntry] and [KitRows].


## All of it, in the order in which it is shown.
static func items() -> Array[KitItem]:
	var found: Array[KitItem] = []
	for entry: KitEntry in KitEntry.all():
		found.append_array(entry.items)
	for each: KitRows in KitRows.all():
		found.append_array(each.items())
	return found
