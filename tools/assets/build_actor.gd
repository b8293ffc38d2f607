extends SceneTree
## Makes the scenes of people: for each avatar [code]scenes/actor/NAME.tscn[/code], the figure with
## the physical bones of its own profile, and of all but the default one
## [code]scenes/actor/people/NAME.tscn[/code], which has what [code]scenes/actor/person.tscn[/code]
## adds: entity, health.
##
## [code]godot --headless --path . -s tools/assets/build_actor.gd [-- NAME...][/code]
## The scene holds the avatar as an instance with editable children, so that designers can change
## the bodies and a new avatar is followed.

const _AVATAR: String = "res://assets/avatar/%s.glb"
const _SHAPES: String = "res://assets/avatar/shapes/%s.json"
const _TARGET: String = "res://scenes/actor/%s.tscn"
const _PERSON: String = "res://scenes/actor/people/%s.tscn"
const _EXAMPLE: String = "res://scenes/actor/person.tscn"


func _initialize() -> void:
	var names: PackedStringArray = OS.get_cmdline_user_args()
	for name: String in names if not names.is_empty() else AvatarStore.NAMES:
		if not _build(name) or (name != AvatarStore.default_name() and not _build_person(name)):
			quit(1)
			return
	quit(0)


func _build(p_name: String) -> bool:
	var reader: RagdollProfileReader = RagdollProfileReader.new()
	var profile: RagdollProfile = reader.read(_SHAPES % p_name)
	if profile == null:
		printerr(reader.error)
		return false
	var person: Ragdoll = Ragdoll.new()
	person.name = p_name.to_pascal_case()
	person.profile = profile
	var avatar: PackedScene = load(_AVATAR % p_name)
	var body: Node = avatar.instantiate(PackedScene.GEN_EDIT_STATE_INSTANCE)
	body.name = "Avatar"
	person.add_child(body)
	body.owner = person
	person.set_editable_instance(body, true)
	var figure: RestSkeleton = RestSkeleton.new(person.get_skeleton())
	figure.fill_pose(profile)
	LimbDistance.keep_apart(profile)
	LimbContacts.fill(profile, figure, SkinnedSurface.new(figure))
	if RagdollBuilder.build(person.get_skeleton(), profile, person) == null:
		return false
	return _save(person, _TARGET % p_name)


## The text of the example's scene with another figure in the place of the default one.
func _build_person(p_name: String) -> bool:
	var text: String = FileAccess.get_file_as_string(_EXAMPLE)
	var default_scene: String = _TARGET % AvatarStore.default_name()
	var file: FileAccess = FileAccess.open(_PERSON % p_name, FileAccess.WRITE)
	if file == null or not text.contains(default_scene):
		printerr("%s could not be made of %s" % [_PERSON % p_name, _EXAMPLE])
		return false
	file.store_string(text.replace(default_scene, _TARGET % p_name))
	return true


func _save(p_root: Node, p_path: String) -> bool:
	var scene: PackedScene = PackedScene.new()
	var error: Error = scene.pack(p_root)
	if error == OK:
		error = ResourceSaver.save(scene, p_path)
	if error != OK:
		printerr("%s could not be saved: %s" % [p_path, error_string(error)])
	p_root.free()
	return error == OK
