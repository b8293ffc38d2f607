@tool
@icon("res://scenes/world/icons/level.svg")
class_name Level
extends Node3D
## Root of a level: what never moves, props, where people start, triggers and cameras.
##
## A level is a scene [code]scenes/world/NAME/NAME.tscn[/code] whose root has this script. The
## server and all clients load the same one; [method fingerprint] shows whether they have.

## What people call it.
@export var title: String = ""
## Holds what never moves: [StaticBody3D] nodes such as [Block], at any depth.
@export var static_root: Node3D:
	set(p_value):
		static_root = p_value
		update_configuration_warnings()
## Holds props and everything else that moves.
@export var props_root: Node3D:
	set(p_value):
		props_root = p_value
		update_configuration_warnings()
## Scenes that may be added while a session runs: a server can have clients make instances of these
## and of no others.
@export var spawnable: Array[PackedScene] = []
## Avatar of people who choose none: a name of [AvatarStore]; empty: the store's default.
@export var default_avatar: String = "":
	set(p_value):
		default_avatar = p_value
		update_configuration_warnings()
## The entity of the world itself, which has number 0: its fields are the variables of the level and
## of a scenario. May be empty.
@export var world: Entity:
	set(p_value):
		world = p_value
		update_configuration_warnings()

## Folder of the files that belong to it (heights, what was baked); empty: that of its scene.
var folder: String = ""

## The file with what was baked of the level; empty for one beside the scene.
var bake_path: String = ""
## What was baked of the level, or null. Read by [method prepare].
var bake: LevelBake = null
## What shows the blocks; null before [method prepare], and where there is no display.
var surfaces: LevelSurfaces = null
## What hides parts that cannot be seen; null where nothing was baked of that.
var visibility: LevelVisibility = null

var _is_prepared: bool = false
## Lights that throw shadows where the tier of quality has any.
var _shadowing: Array[DirectionalLight3D] = []


func _enter_tree() -> void:
	add_to_group(KitBlock.LEVEL_GROUP)
	# Effects that are played in it end with it.
	add_to_group(EffectPlayer.STAGES)


func _ready() -> void:
	if not Engine.is_editor_hint():
		prepare()


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if static_root == null:
		warnings.append("Choose the node that holds what never moves for 'Static Root'.")
	elif get_static_bodies().is_empty():
		warnings.append(
			"Nothing solid is below 'Static Root': people fall. Add a Block as a floor."
		)
	if props_root == null:
		warnings.append("Choose the node that holds what moves for 'Props Root'; it may be empty.")
	if get_spawn_points().is_empty():
		warnings.append("There is no SpawnPoint: people start at the origin. Add one or more.")
	for body: RigidBody3D in get_props():
		if not body.transform.basis.get_scale().is_equal_approx(Vector3.ONE):
			warnings.append("%s is scaled, bodies cannot be: scale its shape and mesh." % body.name)
	if default_avatar != "" and not AvatarStore.NAMES.has(default_avatar):
		var text: String = "There is no avatar '%s': choose one of %s for 'Default Avatar'."
		warnings.append(text % [default_avatar, ", ".join(AvatarStore.NAMES)])
	if world != null and world.type != null and world.type.body != EntityType.Body.NONE:
		warnings.append("The type of 'World' has a body: choose one with fields only.")
	return warnings


## Reads what was baked, and makes the meshes of the blocks where there is a display. It costs up to
## a second or two: a loader does it in a thread before the level enters the tree.
func prepare() -> void:
	if _is_prepared:
		return
	_is_prepared = true
	var path: String = bake_path if bake_path != "" else bake_path_of(scene_file_path)
	if FileAccess.file_exists(path):
		bake = LevelBake.load_file(path)
		if bake.error != "":
			Log.warning("world", bake.error + ": its light is not used")
			bake = null
	if DisplayServer.get_name() != "headless":
		SurfaceTextures.prepare()
		_follow_quality_from_now()
		surfaces = LevelSurfaces.new()
		surfaces.name = "Surfaces"
		surfaces.assemble(self, bake)
		visibility = LevelVisibility.begin(surfaces, self)
		add_child(surfaces, false, Node.INTERNAL_MODE_BACK)


## Shows as much as the tier of quality says: see [Quality].
func follow_quality() -> void:
	SurfaceTextures.prepare()
	var has_shadows: bool = Quality.tier.shadow_pixels > 0
	WorldLight.set_shadows(has_shadows)
	for light: DirectionalLight3D in _shadowing:
		light.shadow_enabled = has_shadows


## The file with what was baked of a scene.
static func bake_path_of(p_scene_path: String) -> String:
	return p_scene_path.get_basename() + ".bake"


## What never moves, in the order of the tree.
func get_static_bodies() -> Array[StaticBody3D]:
	var found: Array[StaticBody3D] = []
	if static_root != null:
		for node: Node in static_root.find_children("*", "StaticBody3D", true, false):
			if node is not AnimatableBody3D:
				found.append(node)
	return found


## Props without an [Entity] of their own, in the order of the tree.
func get_props() -> Array[RigidBody3D]:
	var covered: Dictionary[Node, bool] = {}
	for entity: Entity in get_entities():
		covered[entity.get_body()] = true
	var found: Array[RigidBody3D] = []
	for node: Node in _find_in_group(KitBlock.PROPS_GROUP, "RigidBody3D"):
		if node is RigidBody3D and not covered.has(node):
			found.append(node)
	return found


## Whole path of a file that belongs to the level, by its name. It may not be there, and what is in
## it is not to be trusted.
func find_file(p_name: String) -> String:
	var from: String = folder if folder != "" else scene_file_path.get_base_dir()
	return from.path_join(p_name)


## The scene of a path if it may be added while a session runs, or null.
func find_spawnable(p_path: String) -> PackedScene:
	for scene: PackedScene in spawnable:
		if scene != null and scene.resource_path == p_path:
			return scene
	return null


## The [Entity] nodes but for that of the world itself, in the order of the tree.
func get_entities() -> Array[Entity]:
	var found: Array[Entity] = []
	for node: Node in _find_in_group(Entity.GROUP, "Entity"):
		if node != world:
			found.append(node)
	return found


## Where people start, in the level's frame, in the order of the tree.
func get_spawn_points() -> Array[SpawnPoint]:
	var found: Array[SpawnPoint] = []
	for node: Node in find_children("*", "Marker3D", true, false):
		if node is SpawnPoint:
			found.append(node)
	return found


## The views that observers can go to, in the order of the tree.
func get_cameras() -> Array[ObserverCamera]:
	var found: Array[ObserverCamera] = []
	for node: Node in _find_in_group(ObserverCamera.GROUP, "Camera3D"):
		if node is ObserverCamera:
			found.append(node)
	return found


func _follow_quality_from_now() -> void:
	for node: Node in find_children("*", "DirectionalLight3D", true, false):
		var light: DirectionalLight3D = node as DirectionalLight3D
		if light.shadow_enabled:
			_shadowing.append(light)
	add_to_group(Quality.FOLLOWERS)
	follow_quality()


## Nodes of a group, in the order of the tree. In the tree the engine knows them: to look at each of
## thousands of nodes takes milliseconds.
func _find_in_group(p_group: StringName, p_class: String) -> Array[Node]:
	var found: Array[Node] = []
	if is_inside_tree():
		found = get_tree().get_nodes_in_group(p_group)
		return found.filter(func(node: Node) -> bool: return is_ancestor_of(node))
	found = find_children("*", p_class, true, false)
	return found.filter(func(node: Node) -> bool: return node.is_in_group(p_group))
