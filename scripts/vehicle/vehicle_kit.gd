@tool
class_name VehicleKit
extends KitRows
## Which vehicles levels from elsewhere may have, and the editor's dock offers.

## Where the vehicles are, and which a level may have: of each so many at most, with so many bodies.
const FOLDER: String = "res://scenes/vehicle"
const NAMES: PackedStringArray = ["tank", "carrier", "truck", "scootmobile"]
const MAX_VEHICLES: int = 20
const BODIES: int = 12


func rows() -> Array[KitClass]:
	var found: Array[KitClass] = []
	for name: String in NAMES:
		found.append(KitClass.scene(scene_of(name), {}).with_bodies(BODIES).at_most(MAX_VEHICLES))
	return found


func items() -> Array[KitItem]:
	return [
		_item("Battle tank", "vehicle tracks gun drive", "tank", 0.1),
		_item("Carrier", "vehicle tracks drive", "carrier", 0.1),
		_item("Truck", "vehicle car wheels drive", "truck", 0.1),
		_item("Scootmobile", "vehicle scooter wheels drive", "scootmobile", 0.05),
	]


## Path of a vehicle's scene.
static func scene_of(p_name: String) -> String:
	return FOLDER.path_join(p_name).path_join(p_name + ".tscn")


static func _item(p_title: String, p_words: String, p_name: String, p_lift: float) -> KitItem:
	return KitItem.new(p_title, p_words, scene_of(p_name), KitItem.Place.PROPS, {}, p_lift)
