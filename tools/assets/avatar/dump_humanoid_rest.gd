extends SceneTree
## Writes the rest pose of Godot's SkeletonProfileHumanoid as JSON, for rig.py.
##
## Run as `godot --headless --script dump_humanoid_rest.gd -- OUT.json`. The basis columns x, y, z
## and the origin o (metres) are those of each bone relative to its parent.


func _init() -> void:
	var profile := SkeletonProfileHumanoid.new()
	var bones: Dictionary[String, Dictionary] = {}
	for i: int in profile.bone_size:
		var rest := profile.get_reference_pose(i)
		bones[profile.get_bone_name(i)] = {
			"parent": String(profile.get_bone_parent(i)),
			"tail": String(profile.get_bone_tail(i)),
			"x": _components(rest.basis.x),
			"y": _components(rest.basis.y),
			"z": _components(rest.basis.z),
			"o": _components(rest.origin),
		}
	var path := OS.get_cmdline_user_args()[0]
	var file := FileAccess.open(path, FileAccess.WRITE)
	file.store_line(JSON.stringify(bones))
	file.close()
	quit()


func _components(vector: Vector3) -> Array[float]:
	return [vector.x, vector.y, vector.z]
