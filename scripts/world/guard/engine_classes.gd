@tool
class_name EngineClasses
extends KitRows
## The rows of [LevelKit] for classes of the engine: nodes, shapes, meshes, materials, environments.

const _TEXTURES: PackedStringArray = [
	"GradientTexture2D", "NoiseTexture2D", "Texture2D", "CompressedTexture2D"
]
const _SHAPES: PackedStringArray = [
	"BoxShape3D",
	"SphereShape3D",
	"CapsuleShape3D",
	"CylinderShape3D",
	"ConvexPolygonShape3D",
	"ConcavePolygonShape3D",
	"Shape3D",
]
const _MESHES: PackedStringArray = [
	"BoxMesh", "SphereMesh", "CapsuleMesh", "CylinderMesh", "PlaneMesh", "Mesh", "ArrayMesh"
]


func rows() -> Array[KitClass]:
	return _nodes() + _lights() + _shapes() + _meshes() + _materials() + _environments()


## The rules of every lamp.
static func light_rules() -> Dictionary[String, PropertyRule]:
	var bias: PropertyRule = PropertyRule.number(0.0, 10.0)
	var energy: PropertyRule = PropertyRule.number(0.0, 16.0)
	var distance: PropertyRule = PropertyRule.number(0.0, 10000.0)
	return {
		"light_color": PropertyRule.colour(),
		"light_energy": energy,
		"light_indirect_energy": energy,
		"light_specular": energy,
		"shadow_enabled": PropertyRule.flag(),
		"shadow_bias": bias,
		"shadow_normal_bias": bias,
		"distance_fade_enabled": PropertyRule.flag(),
		"distance_fade_begin": distance,
		"distance_fade_length": distance,
	}


## The rules of a lamp that shines to all sides.
static func omni_rules() -> Dictionary[String, PropertyRule]:
	return {
		"omni_range": PropertyRule.number(0.0, 200.0),
		"omni_attenuation": PropertyRule.number(-10.0, 10.0),
	}


# Nodes of the engine.
static func _nodes() -> Array[KitClass]:
	return [
		KitClass.node("Node3D", {}),
		KitClass.node("Marker3D", {}),
		KitClass.node("StaticBody3D", KitClass.body_rules()).with_bodies(1),
		(
			KitClass
			. node(
				"RigidBody3D",
				{
					"mass": PropertyRule.number(0.05, 5000.0),
					"continuous_cd": PropertyRule.flag(),
					"can_sleep": PropertyRule.flag(),
				},
				KitClass.body_rules()
			)
			. with_bodies(1)
			. at_most(2000)
		),
		KitClass.node(
			"CollisionShape3D",
			{"shape": PropertyRule.resource(_SHAPES), "disabled": PropertyRule.flag()}
		),
		(
			KitClass
			. node(
				"MeshInstance3D",
				{
					"mesh": PropertyRule.resource(_MESHES),
					"material_override": PropertyRule.resource(KitClass.MATERIALS),
					"surface_material_override/0": PropertyRule.resource(KitClass.MATERIALS),
					"cast_shadow": PropertyRule.whole(0, 3),
					"visibility_range_begin": PropertyRule.number(0.0, 10000.0),
					"visibility_range_end": PropertyRule.number(0.0, 10000.0),
				}
			)
		),
	]


static func _lights() -> Array[KitClass]:
	var light: Dictionary[String, PropertyRule] = light_rules()
	var spot: Dictionary[String, PropertyRule] = {
		"spot_range": PropertyRule.number(0.0, 200.0),
		"spot_angle": PropertyRule.number(0.0, 180.0),
		"spot_attenuation": PropertyRule.number(-10.0, 10.0),
	}
	var sun: Dictionary[String, PropertyRule] = {
		"sky_mode": PropertyRule.whole(0, 2),
		"directional_shadow_mode": PropertyRule.whole(0, 2),
		"directional_shadow_max_distance": PropertyRule.number(0.0, 1000.0),
		"directional_shadow_split_1": PropertyRule.number(0.0, 1.0),
		"directional_shadow_blend_splits": PropertyRule.flag(),
		"light_angular_distance": PropertyRule.number(0.0, 90.0),
	}
	return [
		KitClass.node("OmniLight3D", omni_rules(), light).at_most(256),
		KitClass.node("SpotLight3D", spot, light).at_most(256),
		KitClass.node("DirectionalLight3D", sun, light).at_most(4),
		(
			KitClass
			. node("WorldEnvironment", {"environment": PropertyRule.resource(["Environment"])})
			. at_most(1)
		),
	]


static func _shapes() -> Array[KitClass]:
	var length: PropertyRule = PropertyRule.number(0.001, 2000.0)
	var rounded: Dictionary[String, PropertyRule] = {"radius": length, "height": length}
	var share: PropertyRule = PropertyRule.number(0.0, 1.0)
	return [
		KitClass.resource("PhysicsMaterial", {"friction": share, "bounce": share}).at_most(64),
		KitClass.resource("BoxShape3D", {"size": PropertyRule.vector3(0.001, 2000.0)}),
		KitClass.resource("SphereShape3D", {"radius": length}),
		KitClass.resource("CapsuleShape3D", rounded),
		KitClass.resource("CylinderShape3D", rounded),
		KitClass.resource("ConvexPolygonShape3D", {"points": PropertyRule.points(256)}),
		KitClass.resource("ConcavePolygonShape3D", {"data": PropertyRule.points(90_000)}).at_most(
			64
		),
	]


static func _meshes() -> Array[KitClass]:
	var length: PropertyRule = PropertyRule.number(0.001, 2000.0)
	var material: PropertyRule = PropertyRule.resource(KitClass.MATERIALS)
	var parts: PropertyRule = PropertyRule.whole(1, 64)
	var rounded: Dictionary[String, PropertyRule] = {
		"radius": length,
		"height": length,
		"radial_segments": PropertyRule.whole(4, 64),
		"rings": PropertyRule.whole(1, 32),
		"material": material,
	}
	var cylinder: Dictionary[String, PropertyRule] = rounded.duplicate()
	cylinder["top_radius"] = PropertyRule.number(0.0, 2000.0)
	cylinder["bottom_radius"] = PropertyRule.number(0.0, 2000.0)
	return [
		KitClass.resource(
			"BoxMesh", {"size": PropertyRule.vector3(0.001, 2000.0), "material": material}
		),
		KitClass.resource("SphereMesh", rounded),
		KitClass.resource("CapsuleMesh", rounded),
		KitClass.resource("CylinderMesh", cylinder),
		(
			KitClass
			. resource(
				"PlaneMesh",
				{
					"size": PropertyRule.vector2(0.001, 2000.0),
					"subdivide_width": parts,
					"subdivide_depth": parts,
					"material": material,
				}
			)
		),
	]


static func _materials() -> Array[KitClass]:
	var texture: PropertyRule = PropertyRule.resource(_TEXTURES)
	var share: PropertyRule = PropertyRule.number(0.0, 1.0)
	var pixels: PropertyRule = PropertyRule.whole(1, 1024)
	return [
		(
			KitClass
			. resource(
				"StandardMaterial3D",
				{
					"albedo_color": PropertyRule.colour(),
					"albedo_texture": texture,
					"roughness": share,
					"metallic": share,
					"metallic_specular": share,
					"emission_enabled": PropertyRule.flag(),
					"emission": PropertyRule.colour(),
					"emission_energy_multiplier": PropertyRule.number(0.0, 64.0),
					"uv1_scale": PropertyRule.vector3(-1000.0, 1000.0),
					"uv1_offset": PropertyRule.vector3(-1000.0, 1000.0),
					"uv1_triplanar": PropertyRule.flag(),
					"uv1_world_triplanar": PropertyRule.flag(),
				}
			)
			. at_most(256)
		),
		KitClass.resource(
			"Gradient", {"offsets": PropertyRule.numbers(64), "colors": PropertyRule.colours(64)}
		),
		(
			KitClass
			. resource(
				"GradientTexture2D",
				{
					"gradient": PropertyRule.resource(["Gradient"]),
					"width": pixels,
					"height": pixels,
					"fill": PropertyRule.whole(0, 2),
					"fill_from": PropertyRule.vector2(-10.0, 10.0),
					"fill_to": PropertyRule.vector2(-10.0, 10.0),
				}
			)
			. at_most(32)
		),
		(
			KitClass
			. resource(
				"FastNoiseLite",
				{
					"frequency": PropertyRule.number(0.0001, 1.0),
					"fractal_octaves": PropertyRule.whole(1, 6),
					"seed": PropertyRule.whole(0, 1 << 30),
				}
			)
		),
		(
			KitClass
			. resource(
				"NoiseTexture2D",
				{
					"width": pixels,
					"height": pixels,
					"seamless": PropertyRule.flag(),
					"noise": PropertyRule.resource(["FastNoiseLite"]),
					"color_ramp": PropertyRule.resource(["Gradient"]),
				}
			)
			. at_most(8)
		),
	]


static func _environments() -> Array[KitClass]:
	var colour: PropertyRule = PropertyRule.colour(16.0)
	var energy: PropertyRule = PropertyRule.number(0.0, 16.0)
	return [
		(
			KitClass
			. resource(
				"Environment",
				{
					"background_mode": PropertyRule.whole(0, 2),
					"background_color": colour,
					"sky": PropertyRule.resource(["Sky"]),
					"ambient_light_source": PropertyRule.whole(0, 3),
					"ambient_light_color": colour,
					"ambient_light_energy": energy,
					"tonemap_mode": PropertyRule.whole(0, 4),
					"tonemap_white": energy,
					"fog_enabled": PropertyRule.flag(),
					"fog_light_color": colour,
					"fog_density": PropertyRule.number(0.0, 1.0),
					"fog_sky_affect": PropertyRule.number(0.0, 1.0),
				}
			)
		),
		KitClass.resource(
			"Sky", {"sky_material": PropertyRule.resource(["ProceduralSkyMaterial"])}
		),
		(
			KitClass
			. resource(
				"ProceduralSkyMaterial",
				{
					"sky_top_color": colour,
					"sky_horizon_color": colour,
					"ground_bottom_color": colour,
					"ground_horizon_color": colour,
					"sky_energy_multiplier": energy,
				}
			)
		),
	]
