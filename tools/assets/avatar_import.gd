@tool
extends EditorScenePostImport
## Called by the importer on avatars: puts our materials in the place of the file's names of them,
## says which of their meshes is for near and which
## for far, and lets all share a skin.

const _MATERIALS: String = "res://assets/avatar/materials/%s.tres"
## The far mesh takes the place of the others from this distance on, m.
const _FAR_M: float = 10.0
## The node of the far mesh.
const _FAR: StringName = &"FarMesh"


func _post_import(p_scene: Node) -> Object:
	var skin: Skin = null
	for found: Node in p_scene.find_children("*", "MeshInstance3D"):
		var instance: MeshInstance3D = found
		# The importer gives each mesh a skin of its own, but one palette of bones does for all.
		skin = instance.skin if skin == null else skin
		instance.skin = skin
		for surface: int in instance.mesh.get_surface_count():
			var name: String = instance.mesh.surface_get_material(surface).resource_name
			var material: Material = load(_MATERIALS % name)
			if material == null:
				push_error(
					"%s names the material '%s', which is not there" % [get_source_file(), name]
				)
				return null
			instance.mesh.surface_set_material(surface, material)
		if instance.name == _FAR:
			instance.visibility_range_begin = _FAR_M
		else:
			instance.visibility_range_end = _FAR_M
	return p_scene
