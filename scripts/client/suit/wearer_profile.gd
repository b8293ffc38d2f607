class_name WearerProfile
extends RefCounted
## Whose data somebody begins with who has put sensors on.


## Gives a suit what is kept of a person of a name, or, where it has no name, makes the wearer of a
## number above 1 known from the others.
static func begin(
	p_wearer: SuitSource, p_name: String, p_store: CalibrationStore, p_number: int
) -> void:
	var fault: String = PersonProfile.find_name_fault(p_name)
	if p_name != "" and fault == "":
		p_wearer.set_profile(_read(p_name, p_store))
	elif p_name != "":
		Log.warning("mocap", fault)
	elif p_number > 1:
		var other: PersonProfile = PersonProfile.new()
		other.name = "somebody %d" % p_number
		p_wearer.set_profile(other)


static func _read(p_name: String, p_store: CalibrationStore) -> PersonProfile:
	var profile: PersonProfile = p_store.read(p_name)
	if profile != null:
		Log.info("mocap", "%s: as kept in %s" % [p_name, p_store.path_of(p_name)])
		return profile
	var is_new: bool = not FileAccess.file_exists(p_store.path_of(p_name))
	Log.info("mocap", "nothing is kept of %s yet" % p_name if is_new else p_store.error)
	profile = PersonProfile.new()
	profile.name = p_name
	return profile
