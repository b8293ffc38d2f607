extends Node3D
## Health of a person: a thrown crate lowers it, a bar above the head shows it to everybody.

## Bones that feel a blow.
const BONES: Array[StringName] = [&"Head", &"Chest", &"Spine", &"Hips"]

## Blows below this do not hurt.
@export_range(0.0, 200.0, 1.0, "suffix:N·s") var threshold: float = 15.0
## Health that a blow of 1 N·s costs.
@export_range(0.0, 10.0, 0.1) var vulnerability: float = 0.6
## Height of the bar above the head.
@export_range(0.0, 2.0, 0.05, "suffix:m") var height: float = 0.35

## Whether it shows a bar: not where nobody sees it, such as on a server, which makes no meshes or
## textures while it loads a level (see [RenderLock]).
var has_label: bool = not RenderLock.is_needed()

var _bodies: Array[RID] = []
var _label: Label3D = null

@onready var _entity: Entity = $"../Entity"


func _ready() -> void:
	if has_label:
		_label = Label3D.new()
		_label.billboard = BaseMaterial3D.BILLBOARD_ENABLED
		_label.no_depth_test = true
		_label.pixel_size = 0.004
		_label.font_size = 48
		_label.outline_size = 12
		add_child(_label)
	# Only while there is a bar to be seen: on a server of 80 people it would be a tenth of a tick.
	set_process(false)
	_entity.started.connect(_on_started)
	_entity.field_changed.connect(_on_field_changed)


func _process(_delta: float) -> void:
	_follow_head()


func _physics_process(_delta: float) -> void:
	# A blow is spread over several contacts and bodies, in another way each time.
	var impulse: float = 0.0
	for body: RID in _bodies:
		var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(body)
		for contact: int in state.get_contact_count() if state != null else 0:
			var other: Node = state.get_contact_collider_object(contact) as Node
			if other != null and other.is_in_group(KitBlock.PROPS_GROUP):
				impulse += state.get_contact_impulse(contact).length()
	if impulse > threshold:
		_take_blow(impulse)


func _on_started() -> void:
	_on_field_changed(&"health", _entity.get_value(&"health"))
	if not _entity.is_authority():
		return
	# It starts again in each level.
	_bodies.clear()
	for bone: StringName in BONES:
		var node: Node = (get_parent() as Ragdoll).get_simulator().get_node(NodePath(bone))
		_bodies.append((node as PhysicalBone3D).get_rid())
		PhysicsServer3D.body_set_max_contacts_reported(_bodies[-1], 4)


func _take_blow(p_impulse: float) -> void:
	var health: float = _entity.get_value(&"health")
	_entity.set_value(&"health", health - (p_impulse - threshold) * vulnerability)
	_entity.send_event(&"hit", [p_impulse])


func _follow_head() -> void:
	var head: Transform3D = (get_parent() as Ragdoll).get_bone_transform(&"Head")
	global_position = head.origin + Vector3.UP * height


func _on_field_changed(p_field: StringName, p_value: float) -> void:
	if p_field == &"health" and _label != null:
		_label.text = "%.0f %%" % p_value
		_label.modulate = Color.RED.lerp(Color.GREEN, p_value / 100.0)
		_label.visible = p_value < 100.0
		set_process(_label.visible)
		if _label.visible:
			_follow_head()
