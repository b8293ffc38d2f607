@tool
@icon("res://scenes/combat/icons/gun.svg")
class_name VehicleGun
extends Gun
## A gun of a [Vehicle]: it kicks the hull, its barrel recoils, and it is dead with the vehicle.

## The vehicle that it kicks.
@export var vehicle: Vehicle = null:
	set(p_value):
		vehicle = p_value
		update_configuration_warnings()


func _ready() -> void:
	if not Engine.is_editor_hint() and vehicle != null and shells != null:
		shells.own_bodies = vehicle.own_bodies
	super()
	fired.connect(_on_fired)


func _get_configuration_warnings() -> PackedStringArray:
	if vehicle == null:
		return ["It needs the Vehicle that it kicks: choose one in the inspector."]
	return super()


func is_dead() -> bool:
	return vehicle.state.damage == VehicleState.Damage.KNOCKED_OUT


func carried_velocity() -> Vector3:
	var carried: Vector3 = vehicle.linear_velocity
	if not vehicle.freeze:
		carried += vehicle.angular_velocity.cross(global_position - vehicle.global_position)
	return carried


func kick(p_impulse: Vector3, p_place: Vector3) -> void:
	vehicle.apply_recoil(p_impulse, p_place)


func _on_fired(p_kind: Ammunition, _place: Vector3, _velocity: Vector3) -> void:
	if p_kind.kind == Ammunition.Kind.BULLET:
		return
	for child: Node in vehicle.get_children():
		if child is VehicleView:
			(child as VehicleView).show_shot()
			return
