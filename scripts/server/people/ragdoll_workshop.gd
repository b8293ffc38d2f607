class_name RagdollWorkshop
extends RefCounted
## Makes and frees [Ragdoll]s of people's sizes, part by part: each part takes some tenths of a
## millisecond, so that no tick has to wait.
##
## Some new ones of the default avatar are always in stock, as to make an instance of a scene is the
## longest part. None is used twice: a scene's scripts know only one wearer.

## New ragdolls in stock, outside the tree.
const STOCK: int = 16

## The ragdoll that is being made, or null.
var ragdoll: Ragdoll = null
## How its bodies hang together, when it is made.
var joints: PersonSkeleton = null
## For whom.
var card: PersonCard = null
## Whether the last one that was begun cannot be made: its scene has a fault.
var has_failed: bool = false

var _scene: PackedScene = null
var _parent: Node3D = null
var _stock: Array[Ragdoll] = []
## Scenes of the other avatars, loaded once.
var _others: Array[PackedScene] = []
var _waste: Array[Ragdoll] = []
var _parts: Array[Array] = []
var _fit: RagdollFit = null


## Ragdolls are instances of a scene, and get into the tree below a node.
func _init(p_scene: PackedScene, p_parent: Node3D) -> void:
	_scene = p_scene
	_parent = p_parent


## Fills the stock at once: before anybody is here.
func prepare() -> void:
	_others = AvatarStore.load_all()
	while restock():
		pass


## Begins to make the ragdoll of a person. [code]func() -> Transform3D[/code] returns its transform,
## m: it is called when the ragdoll enters the world.
func begin(p_card: PersonCard, p_root_mode: RagdollMotor.RootMode, p_start: Callable) -> void:
	drop()
	card = p_card
	has_failed = false
	# Two kinds, as the budget has to know how long each takes.
	var scene: PackedScene = AvatarStore.scene_of(p_card.avatar, _scene)
	if scene != _scene or _stock.is_empty():
		_parts.append([&"make", _make.bind(scene)])
	_parts.append([&"take", _take.bind(p_root_mode)])
	_parts.append([&"check", _check])
	if not p_card.lengths.is_empty():
		_parts.append([&"measure", _measure])
	_parts.append([&"rests", _measure_rests])
	_parts.append([&"joints", _find_joints])
	_parts.append([&"stand", _stand.bind(p_start)])
	_parts.append([&"add", _add])
	_parts.append([&"start", _start])


## The kind of the next part, or an empty name if the ragdoll is made.
func next_kind() -> StringName:
	return _parts[0][0] if not _parts.is_empty() else &""


## Whether the next part can be done without waiting for a level that is being loaded.
func is_ready() -> bool:
	if next_kind() != &"make":
		return true
	var is_free: bool = RenderLock.try_hold()
	if is_free:
		RenderLock.release()
	return is_free


## Does the next part.
func advance() -> void:
	var part: Array = _parts.pop_front()
	(part[1] as Callable).call()


## Hands over the ragdoll that is made.
func hand_over() -> Ragdoll:
	var made: Ragdoll = ragdoll
	ragdoll = null
	card = null
	return made


## Gives up what is being made.
func drop() -> void:
	if ragdoll != null:
		discard(ragdoll)
	ragdoll = null
	card = null
	_fit = null
	_parts.clear()


## Takes a ragdoll out of the world; it is freed later.
func discard(p_ragdoll: Ragdoll) -> void:
	p_ragdoll.stop()
	if p_ragdoll.is_inside_tree():
		_parent.remove_child(p_ragdoll)
	_waste.append(p_ragdoll)


## Frees one that is no longer needed.
func tidy() -> void:
	if not _waste.is_empty():
		(_waste.pop_back() as Ragdoll).free()


## Makes one for the stock. Returns whether it was not full.
func restock() -> bool:
	# A level that is being loaded is soon there.
	if _stock.size() >= STOCK or not RenderLock.try_hold():
		return false
	_stock.push_front(_scene.instantiate() as Ragdoll)
	RenderLock.release()
	return true


## Number of ragdolls that wait to be freed.
func waste_count() -> int:
	return _waste.size()


## Frees everything.
func close() -> void:
	drop()
	for one: Ragdoll in _waste + _stock:
		one.free()
	_waste.clear()
	_stock.clear()


func _make(p_scene: PackedScene) -> void:
	if not RenderLock.try_hold():
		# A level has begun to be loaded since is_ready() was asked.
		_parts.push_front([&"make", _make.bind(p_scene)])
		return
	_stock.append(p_scene.instantiate() as Ragdoll)
	RenderLock.release()


func _take(p_root_mode: RagdollMotor.RootMode) -> void:
	ragdoll = _stock.pop_back()
	ragdoll.root_mode = p_root_mode


func _measure() -> void:
	_fit = ragdoll.begin_fit(card.lengths, card.hip_height)
	if _fit != null:
		_parts.push_front([&"fit", _advance_fit])


func _advance_fit() -> void:
	if not _fit.advance():
		_parts.push_front([&"fit", _advance_fit])


func _measure_rests() -> void:
	ragdoll.measure_rests()


func _stand(p_start: Callable) -> void:
	ragdoll.transform = p_start.call()


func _add() -> void:
	_parent.add_child(ragdoll)


func _check() -> void:
	if ragdoll.get_limb_order().has(-1) or not ragdoll.check():
		_fail()


func _start() -> void:
	if not ragdoll.start():
		_fail()
	elif RenderLock.is_needed():
		# Without a window nobody sees the bones move.
		BoneTransforms.rest(ragdoll.get_skeleton())


func _find_joints() -> void:
	joints = ragdoll.get_joints()


func _fail() -> void:
	has_failed = true
	_parts.clear()
