@tool
class_name ContactMaterial
extends PhysicsMaterial
## What a thing is made of: friction, bounce, and the key by which its sounds and dust are found.
##
## Those of the kit are in [code]assets/world/contacts[/code]; give one to a body's [i]Physics
## Material Override[/i]. Surfaces of blocks have keys by their layer: SurfaceLayers.key_of.

## Folder of the kit's materials, a file for each key.
const FOLDER: String = "res://assets/world/contacts/"
## The key of what has none.
const NO_KEY: StringName = &"stone"

## The key of its sounds and dust.
@export_enum("wood", "metal", "concrete", "cloth", "glass", "rubber", "rock", "stone")
var key: String = "wood"


## The kit's material of a key, or null.
static func find(p_key: StringName) -> ContactMaterial:
	var path: String = FOLDER + p_key + ".tres"
	return load(path) as ContactMaterial if ResourceLoader.exists(path) else null


## The key of what a body is made of.
static func key_of(p_body: PhysicsBody3D) -> StringName:
	var material: PhysicsMaterial = null
	if p_body is RigidBody3D:
		material = (p_body as RigidBody3D).physics_material_override
	elif p_body is StaticBody3D:
		material = (p_body as StaticBody3D).physics_material_override
	var made_of: ContactMaterial = material as ContactMaterial
	return StringName(made_of.key) if made_of != null else NO_KEY
