extends SceneTree
## Makes [code]scenes/actor/soldier.tscn[/code]: the avatar with the physical bones of a
## profile.
##
## [code]godot --headless --path . -s tools/assets/build_actor.gd[/code]
## The scene holds the avatar as an instance with editable children, so that designers can change
## the bodies and a new avatar is followed.

const _AVATAR: String = "res://assets/avatar/soldier.glb"
const _SHAPES: String = "res://assets/avatar/limb_shapes.json"
const _TARGET: String = "res://scenes/actor/soldier.tscn"


func _initialize() -> void:
	quit(0 if _build() else 1)


func _build() -> bool:
	var reader: RagdollProfileReader = RagdollProfileReader.new()
	var profile: RagdollProfile = reader.read(_SHAPES)
	if profile == null:
		printerr(reader.error)
		return false
	var person: Ragdoll = Ragdoll.new()
	person.name = "Soldier"
	person.profile = profile
	var avatar: PackedScene = load(_AVATAR)
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
	var scene: PackedScene = PackedScene.new()
	var error: Error = scene.pack(person)
	if error == OK:
		error = ResourceSaver.save(scene, _TARGET)
	if error != OK:
		printerr("%s could not be saved: %s" % [_TARGET, error_string(error)])
	person.free()
	return error == OK
