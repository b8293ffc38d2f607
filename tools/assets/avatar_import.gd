@tool
extends EditorScenePostImport
## Called by the importer on the soldier: its vertex colours are sRGB.
##
## The Compatibility renderer takes all vertex colours for sRGB, the others take them for linear
## unless the material says so, and glTF's importer does not. Then the kit and everything that the
## baked occlusion darkens would be nearly black in one renderer, or pale in the others. The file
## holds sRGB, and this says so: all renderers show the same.


func _post_import(p_scene: Node) -> Object:
	for found: Node in p_scene.find_children("*", "MeshInstance3D"):
		var mesh: Mesh = (found as MeshInstance3D).mesh
		for surface: int in mesh.get_surface_count():
			var material: BaseMaterial3D = mesh.surface_get_material(surface)
			material.vertex_color_is_srgb = true
	return p_scene
