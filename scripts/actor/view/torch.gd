class_name Torch
extends Node3D
## A torch that a person can hold in the right hand: its wearer switches it, everybody sees its
## light. It needs the field [code]torch[/code] and the command [code]switch_torch[/code] in the
## person's [EntityType].
##
## While it is off there is neither a light nor work to do.

## It is taken into the hand, or put away.
signal held(p_is_held: bool)

## Field of the person: 1 while it is lit.
const FIELD: StringName = &"torch"
## Command of the person's session that switches it.
const COMMAND: StringName = &"switch_torch"
## Greatest number of torches that light, those nearest to the camera: each costs a pass over what
## it lights. The others only glow.
const MAX_LIGHTS: int = 4

## Group of those that are lit.
const _LIT: StringName = &"lit_torches"
const _HAND: StringName = &"RightHand"
## From the wrist to the middle of the fist, and length and radius of the tube, m.
const _FIST_M: float = 0.09
const _LONG_M: float = 0.17
const _THICK_M: float = 0.018

## The frame in which the nearest torches were last chosen.
static var _chosen_frame: int = -1

## Brightness, and how far it lights.
@export_range(0.0, 32.0, 0.5) var energy: float = 12.0
@export_range(1.0, 60.0, 0.5, "suffix:m") var distance: float = 30.0
## Half the angle of its beam.
@export_range(5.0, 60.0, 0.5, "suffix:°") var angle: float = 24.0
## By how much the beam points down where the arm hangs: to where one walks.
@export_range(0.0, 45.0, 0.5, "suffix:°") var tilt: float = 10.0

## Whether it shows a light: not where nobody sees it, such as on a server (see [RenderLock]).
var has_light: bool = not RenderLock.is_needed()

var _light: SpotLight3D = null
var _made: Node3D = null

@onready var _entity: Entity = $"../Entity"
@onready var _person: Ragdoll = get_parent()


func _ready() -> void:
	set_process(false)
	_entity.started.connect(_on_started)
	_entity.field_changed.connect(_on_field_changed)
	_entity.commanded.connect(_on_commanded)


func _process(_delta: float) -> void:
	_follow_hand()
	if _light != null and _chosen_frame != Engine.get_process_frames():
		_chosen_frame = Engine.get_process_frames()
		_choose_lights(get_tree().get_nodes_in_group(_LIT), get_viewport().get_camera_3d())


## Asks the server to switch it, in the name of this client.
func ask() -> void:
	_entity.send_command(COMMAND)


## Switches it for everybody, on the server.
func switch(p_is_lit: bool) -> void:
	_entity.set_value(FIELD, 1.0 if p_is_lit else 0.0)


## Whether it is lit.
func is_lit() -> bool:
	return _entity.is_started() and _entity.get_value(FIELD) > 0.5


func _follow_hand() -> void:
	var hand: Transform3D = _person.get_bone_transform(_HAND)
	global_transform = Transform3D(_beam_basis(hand), _fist(hand))


## Only those nearest to the camera light.
static func _choose_lights(p_torches: Array[Node], p_camera: Camera3D) -> void:
	if p_camera == null:
		return
	var from: Vector3 = p_camera.global_position
	p_torches.sort_custom(
		func(a: Node3D, b: Node3D) -> bool:
			return (
				a.global_position.distance_squared_to(from)
				< b.global_position.distance_squared_to(from)
			)
	)
	for place: int in p_torches.size():
		var light: SpotLight3D = (p_torches[place] as Torch)._light
		light.visible = place < MAX_LIGHTS
		# The others shine through walls: each shadow is drawn anew in every frame.
		light.shadow_enabled = place == 0


func _on_started() -> void:
	if _entity.type.find_field(FIELD) >= 0:
		_show(is_lit())


func _on_field_changed(p_field: StringName, p_value: float) -> void:
	if p_field == FIELD:
		_show(p_value > 0.5)


func _on_commanded(p_session: int, p_command: StringName, _values: PackedFloat32Array) -> void:
	# Anybody may send it, but only for the own people.
	if p_command == COMMAND and _entity.owner_session == p_session:
		switch(not is_lit())


func _show(p_is_lit: bool) -> void:
	if p_is_lit == is_in_group(_LIT):
		return
	if p_is_lit:
		add_to_group(_LIT)
	else:
		remove_from_group(_LIT)
	if has_light:
		set_process(p_is_lit)
		if p_is_lit and _made == null:
			_make()
		elif not p_is_lit and _made != null:
			_made.queue_free()
			_made = null
			_light = null
	held.emit(p_is_lit)


## Where the light goes: to the side of the thumb, as one holds a stick. In the rest pose, with the
## palms down, that is ahead.
func _beam_basis(p_hand: Transform3D) -> Basis:
	var skeleton: Skeleton3D = _person.get_skeleton()
	var rest: Basis = skeleton.get_bone_global_rest(skeleton.find_bone(_HAND)).basis
	var turn: Basis = p_hand.basis.orthonormalized() * rest.orthonormalized().inverse()
	var ahead: Vector3 = Vector3.BACK.rotated(Vector3.RIGHT, deg_to_rad(tilt))
	return Basis.looking_at(turn * ahead, turn * Vector3.UP)


func _fist(p_hand: Transform3D) -> Vector3:
	# Bones go along their own Y axis.
	return p_hand.origin + p_hand.basis.y.normalized() * _FIST_M


func _make() -> void:
	_made = Node3D.new()
	add_child(_made)
	_add_tube(_LONG_M, _THICK_M, 0.0, Color(0.05, 0.05, 0.055), 0.0)
	_add_tube(0.03, _THICK_M * 1.4, -_LONG_M / 2.0, Color(0.06, 0.06, 0.065), 0.0)
	_add_tube(0.004, _THICK_M * 1.2, -_LONG_M / 2.0 - 0.016, Color(1.0, 0.95, 0.82), 4.0)
	_light = SpotLight3D.new()
	_light.position = Vector3(0.0, 0.0, -_LONG_M / 2.0 - 0.03)
	_light.light_color = Color(1.0, 0.95, 0.82)
	_light.light_energy = energy
	_light.light_specular = 0.0
	_light.spot_range = distance
	_light.spot_angle = angle
	_light.spot_attenuation = 0.8
	_light.spot_angle_attenuation = 0.7
	_made.add_child(_light)


## A piece of the tube around the beam, at a position along it.
func _add_tube(p_long: float, p_radius: float, p_at: float, p_colour: Color, p_glow: float) -> void:
	var mesh: CylinderMesh = CylinderMesh.new()
	mesh.top_radius = p_radius
	mesh.bottom_radius = p_radius
	mesh.height = p_long
	mesh.radial_segments = 12
	mesh.rings = 0
	var material: StandardMaterial3D = StandardMaterial3D.new()
	material.albedo_color = p_colour
	material.roughness = 0.5
	material.emission_enabled = p_glow > 0.0
	material.emission = p_colour
	material.emission_energy_multiplier = p_glow
	mesh.material = material
	var shown: MeshInstance3D = MeshInstance3D.new()
	shown.mesh = mesh
	shown.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	shown.rotation.x = PI / 2.0
	shown.position.z = p_at
	_made.add_child(shown)
