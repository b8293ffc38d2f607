class_name AvatarStore
extends RefCounted
## What people can be shown as: avatars, by their names.
##
## A trainee chooses one ([code]--avatar=NAME[/code]); its name goes to the server with the
## [PersonCard] and from there to everybody. Each has bodies of its own shape. Recipes, pictures and
## scenes are made by [code]tools/assets/avatar[/code].

## All names, the default first.
const NAMES: PackedStringArray = [
	"soldier", "raider", "civilian_woman", "civilian_man", "instructor", "range_dummy", "show"
]

const _FOLDER: String = "res://scenes/actor/people"


## The avatar of those who choose none, or one that is not known.
static func default_name() -> String:
	return NAMES[0]


## The known name that a stranger's text means: the text itself, or the default's. Empty text is the
## default's without a word; other texts are logged.
static func resolve(p_text: String) -> String:
	if NAMES.has(p_text):
		return p_text
	if p_text != "":
		var parts: Array = [
			p_text.left(PersonCard.MAX_AVATAR).c_escape(), default_name(), ", ".join(NAMES)
		]
		var text: String = "there is no avatar '%s': shown as %s; known are %s"
		Log.limited("actor", "avatar", text % parts)
	return default_name()


## The scene of a person with this avatar, its root a [Ragdoll]. [param p_default] is the scene of
## who has the default one: levels and games may have their own.
static func scene_of(p_name: String, p_default: PackedScene) -> PackedScene:
	var path: String = path_of(p_name)
	if path == "":
		return p_default
	var scene: PackedScene = load(path) as PackedScene
	if scene == null:
		Log.limited("actor", "avatar", "the avatar '%s' cannot be loaded" % path)
		return p_default
	return scene


## Path of the scene that [method scene_of] loads; empty for the default's, which is given to it.
static func path_of(p_name: String) -> String:
	var name: String = resolve(p_name)
	return "" if name == default_name() else _FOLDER.path_join(name + ".tscn")


## Loads all scenes, so that nobody waits for one later; keep what is returned.
static func load_all() -> Array[PackedScene]:
	var scenes: Array[PackedScene] = []
	for name: String in NAMES.slice(1):
		scenes.append(scene_of(name, null))
	return scenes
