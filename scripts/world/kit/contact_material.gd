@tool
class_name ContactMaterial
extends PhysicsMaterial
## What a surface or a thing is made of: its friction and bounce, how it sounds, what dust it gives
## and how it takes prints. The one resource that vehicles, shots, steps and sounds ask.
##
## Those of the kit are in [code]assets/world/contacts[/code], a file for each key. Blocks and
## terrain have them by their layer ([method SurfaceLayers.key_of]); give one to another body's
## [i]Physics Material Override[/i].

## Folder of the kit's materials.
const FOLDER: String = "res://assets/world/contacts/"
## The key of bodies without a material.
const NO_KEY: StringName = &"stone"
## The key of people.
const PERSON: StringName = &"person"
## All keys of the kit, by their numbers on the wire: new ones come last.
const KEYS: Array[StringName] = [
	&"stone",
	&"asphalt",
	&"brick",
	&"cloth",
	&"concrete",
	&"dirt",
	&"glass",
	&"gravel",
	&"leaf",
	&"metal",
	&"person",
	&"plaster",
	&"rock",
	&"rubber",
	&"sand",
	&"wood",
]

static var _found: Dictionary[StringName, ContactMaterial] = {}

## The name by which it is found: that of its file.
@export_enum(
	"asphalt",
	"brick",
	"cloth",
	"concrete",
	"dirt",
	"glass",
	"gravel",
	"leaf",
	"metal",
	"person",
	"plaster",
	"rock",
	"rubber",
	"sand",
	"stone",
	"wood"
)
var key: String = "wood"

@export_group("Dust")
## Dust that wheels and feet raise on it, as a share of the greatest.
@export_range(0.0, 1.0, 0.01) var dust: float = 0.0
## Colour of its dust and of what flies up where a shot strikes it.
@export var dust_color: Color = Color(0.84, 0.74, 0.59)
## How deep the prints of wheels and tracks are that stay in it.
@export_range(0.0, 1.0, 0.01) var print_depth: float = 0.0
## Sparks that a shot strikes from it, as a share of the most.
@export_range(0.0, 1.0, 0.01) var sparks: float = 0.0

@export_group("Sound")
## Which sounds of impacts, scrapes and steps it has: the middle of their names in
## [code]assets/sound[/code].
@export_enum(
	"cloth", "concrete", "dirt", "flesh", "glass", "gravel", "metal", "rubber", "sand", "wood"
)
var sound: String = "concrete"
## Share of sound energy that it swallows where it bounds a room, at 1 kHz.
@export_range(0.0, 1.0, 0.01) var absorption: float = 0.03


## The kit's material of a key, or null.
static func find(p_key: StringName) -> ContactMaterial:
	if not _found.has(p_key):
		var path: String = FOLDER + p_key + ".tres"
		if not p_key.is_valid_filename() or not ResourceLoader.exists(path):
			return null
		_found[p_key] = load(path) as ContactMaterial
	return _found[p_key]


## The kit's material of a key; of one that the kit does not have, that of [constant NO_KEY].
static func named(p_key: StringName) -> ContactMaterial:
	var material: ContactMaterial = find(p_key)
	return material if material != null else find(NO_KEY)


## The number of a key; of one that the kit does not have, that of [constant NO_KEY].
static func number_of(p_key: StringName) -> int:
	return maxi(KEYS.find(p_key), 0)


## The kit's material of a number; of one that is none, that of [constant NO_KEY].
static func numbered(p_number: int) -> ContactMaterial:
	return named(KEYS[p_number] if p_number >= 0 and p_number < KEYS.size() else NO_KEY)


## The key of what a body is made of.
static func key_of(p_body: PhysicsBody3D) -> StringName:
	var material: PhysicsMaterial = null
	if p_body is RigidBody3D:
		material = (p_body as RigidBody3D).physics_material_override
	elif p_body is StaticBody3D:
		material = (p_body as StaticBody3D).physics_material_override
	elif p_body is PhysicalBone3D:
		return PERSON
	var made_of: ContactMaterial = material as ContactMaterial
	return StringName(made_of.key) if made_of != null else NO_KEY


## The material of a body of the level at a position (m, world); never null.
static func at(p_collider: Object, p_place: Vector3) -> ContactMaterial:
	if p_collider is Terrain:
		return named((p_collider as Terrain).surface_at(p_place))
	# Blocks say it themselves: see KitBlock.contact_key(), which knows this class.
	if p_collider != null and p_collider.has_method(&"contact_key"):
		return named(p_collider.call(&"contact_key"))
	var body: PhysicsBody3D = p_collider as PhysicsBody3D
	return named(key_of(body) if body != null else NO_KEY)
