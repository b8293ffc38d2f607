@tool
extends EditorScenePostImport
## Called by the importer on vehicles: puts our material in the place of the file's name of it, and
## lets only what is large throw shadows.

const _MATERIAL: String = "res://assets/vehicle/materials/%s.tres"
## Parts whose shadow the hull's covers.
const _WITHOUT_SHADOW: Array[String] = ["Wheel_", "Idler_", "Cog_", "Roller_", "Arm_", "TrackLink"]


func _post_import(p_scene: Node) -> Object:
	for found: Node in p_scene.find_children("*", "MeshInstance3D"):
		var instance: MeshInstance3D = found
		for surface: int in instance.mesh.get_surface_count():
			var name: String = instance.mesh.surface_get_material(surface).resource_name
			if name == "":
				continue  # Copies share a mesh, and this one has it by now.
			var material: Material = load(_MATERIAL % name)
			if material == null:
				push_error(
					"%s names the material '%s', which is not there" % [get_source_file(), name]
				)
				return null
			instance.mesh.surface_set_material(surface, material)
		for prefix: String in _WITHOUT_SHADOW:
			if instance.name.begins_with(prefix):
				instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	return p_scene
